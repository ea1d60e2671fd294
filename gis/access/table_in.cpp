// SPDX-License-Identifier: Apache-2.0
#include "gis/access/table_in.h"

#include <cpl_vsi.h>
#include <ogrsf_frmts.h>

#include "core/error.h"
#include "gis/access/access_problem.h"
#include "gis/access/gdal_session.h"
#include "gis/access/local_files.h"
#include "gis/access/network.h"
#include "gis/access/time_limit.h"

namespace frana::gis {
namespace {

constexpr std::size_t k_most_rows = 10'000'000;

}  // namespace

Table read_table(const std::string& path, const std::string& where) {
    const GdalSession session;
    const ReadingOnly reading;
    (void)pop_access_problem();
    const std::string place = where + ": " + path;
    if (const auto remedy = network_remedy(path))
        throw Error(ErrorKind::input, Problem{"the file is read over the network", place, "", "", *remedy});
    TimeLimit limit(place);
    VSIStatBufL status;
    if (VSIStatL(path.c_str(), &status) != 0) {
        throw Error(ErrorKind::input, Problem{"the file does not exist", place, "", "",
                                              "Check the path: a scene's is relative to the scene file, an "
                                              "option's to the current folder"});
    }
    // "CSV:" makes the driver accept names without .csv.
    const char* const drivers[] = {"CSV", nullptr};
    const char* const options[] = {"HEADERS=YES", "AUTODETECT_TYPE=NO", "KEEP_GEOM_COLUMNS=YES", nullptr};
    (void)refuse_special_file(path.c_str());
    const GDALDatasetUniquePtr dataset(
        GDALDataset::Open(("CSV:" + path).c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, drivers, options));
    OGRLayer* layer = dataset && dataset->GetLayerCount() == 1 ? dataset->GetLayer(0) : nullptr;
    Table table;
    if (layer) {
        const OGRFeatureDefn& fields = *layer->GetLayerDefn();
        for (int i = 0; i < fields.GetFieldCount(); ++i) table.columns.push_back(fields.GetFieldDefn(i)->GetNameRef());
        for (const auto& feature : *layer) {
            limit.again();
            if (table.rows.size() >= k_most_rows)
                throw Error(ErrorKind::input,
                            Problem{"the table is too long", place, "", std::to_string(k_most_rows) + " rows",
                                    "Cut it, or use fewer rows"});
            std::vector<std::string>& row = table.rows.emplace_back();
            for (int i = 0; i < fields.GetFieldCount(); ++i) row.push_back(feature->GetFieldAsString(i));
        }
    }
    if (const auto cause = pop_access_problem())
        throw Error(ErrorKind::input, Problem{cause->what, place, cause->value, "", cause->remedy});
    if (table.rows.empty()) {
        throw Error(ErrorKind::input, Problem{"the file is not a table with a header and rows", place, "", "",
                                              "Give a CSV: time,discharge,velocity and one row per time"});
    }
    return table;
}

}  // namespace frana::gis
