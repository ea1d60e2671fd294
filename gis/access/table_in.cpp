// SPDX-License-Identifier: Apache-2.0
#include "gis/access/table_in.h"

#include <cpl_csv.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <ogrsf_frmts.h>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <memory>

#include "core/error.h"
#include "core/text.h"
#include "gis/access/file_access.h"
#include "gis/access/gdal_session.h"

namespace frana::gis {

std::string date_text(double seconds) {
    using namespace std::chrono;
    constexpr sys_days k_origin = year{2000} / January / 1;
    const auto passed = milliseconds(std::llround(seconds * 1000));
    const days whole = floor<days>(passed);
    const year_month_day date{k_origin + whole};
    const hh_mm_ss<milliseconds> time{passed - whole};
    char text[80];
    std::snprintf(text, sizeof text, "%04d-%02u-%02uT%02lld:%02lld:%02lld.%03lldZ", static_cast<int>(date.year()),
                  static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                  static_cast<long long>(time.hours().count()), static_cast<long long>(time.minutes().count()),
                  static_cast<long long>(time.seconds().count()), static_cast<long long>(time.subseconds().count()));
    return text;
}

namespace {

constexpr std::size_t k_most_rows = 10'000'000;

std::string cell_of(const std::string& line) {
    const std::size_t first = line.find_first_not_of(" \t\""), last = line.find_last_not_of(" \t\r\"");
    return first == line.npos ? "" : line.substr(first, last - first + 1);
}

/// The lines before a header, without their "# "; `rest` is what follows them.
std::vector<std::string> remarks_before(std::istream& file, std::string& rest) {
    std::vector<std::string> remarks;
    std::string line;
    while (file.peek() == '#' && std::getline(file, line)) remarks.push_back(cell_of(line.substr(1)));
    if (!remarks.empty()) rest.assign(std::istreambuf_iterator<char>(file), {});
    return remarks;
}

/// A copy of a file in memory, where GDAL reads it.
class MemoryFile {
  public:
    explicit MemoryFile(std::string content)
        : content_(std::move(content)),
          path_("/vsimem/frana_table_" + std::to_string(reinterpret_cast<std::uintptr_t>(this))) {
        VSIFCloseL(
            VSIFileFromMemBuffer(path_.c_str(), reinterpret_cast<GByte*>(content_.data()), content_.size(), FALSE));
    }
    ~MemoryFile() { VSIUnlink(path_.c_str()); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;
    [[nodiscard]] const std::string& path() const { return path_; }

  private:
    std::string content_, path_;
};

/// A table with one column, which GDAL takes for no table: it has no separator.
Table table_of_one_column(const std::string& path) {
    Table table;
    std::ifstream file(path);
    std::string line;
    while (file.peek() == '#') std::getline(file, line);
    if (!std::getline(file, line) || cell_of(line).empty() || line.find_first_of(",;\t") != line.npos ||
        valid_utf8(line) != line)
        return table;
    table.columns.push_back(cell_of(line));
    while (table.rows.size() < k_most_rows && std::getline(file, line)) table.rows.push_back({cell_of(line)});
    return table;
}

struct CloseFile {
    void operator()(VSILFILE* file) const noexcept { VSIFCloseL(file); }
};

}  // namespace

void refuse_surplus_fields(const std::string& path, const std::string& place) {
    const std::unique_ptr<VSILFILE, CloseFile> file(VSIFOpenL(path.c_str(), "rb"));
    const char* const header = file ? CPLReadLineL(file.get()) : nullptr;
    if (!header) return;
    const char separator = CSVDetectSeperator(header);
    if (VSIFSeekL(file.get(), 0, SEEK_SET) != 0) return;
    const auto fields = [&] { return CPLStringList(CSVReadParseLine2L(file.get(), separator), TRUE); };
    const int columns = fields().size();
    for (std::size_t line = 2; line < k_most_rows; ++line) {
        const CPLStringList row = fields();
        if (row.List() == nullptr) return;
        int count = row.size();
        while (count > columns && row[count - 1][0] == '\0') --count;  // separators at the end of the line
        if (count <= columns) continue;
        std::string text;
        for (int i = 0; i < count; ++i) text += (i > 0 ? std::string(1, separator) : "") + row[i];
        throw Error(ErrorKind::input,
                    Problem{"line " + std::to_string(line) + " has " + std::to_string(count) + " fields under " +
                                std::to_string(columns) + (columns == 1 ? " column" : " columns"),
                            place, text, std::to_string(columns),
                            separator == ',' ? "Write decimals after a point, not a comma, or put semicolons between "
                                               "the fields"
                                             : "Correct the line"});
    }
}

Table read_table(const std::string& path, const Place& where) {
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
    const auto refuse_access = [&] {
        if (const auto cause = pop_access_problem())
            throw Error(ErrorKind::input, Problem{cause->what, place, cause->value, "", cause->remedy});
    };
    if (refuse_special_file(path.c_str())) refuse_access();
    // "CSV:" makes the driver accept names without .csv.
    const char* const drivers[] = {"CSV", nullptr};
    const char* const options[] = {"HEADERS=YES", "AUTODETECT_TYPE=NO", "KEEP_GEOM_COLUMNS=YES", nullptr};
    std::ifstream file(path, std::ios::binary);
    std::string rest;
    const std::vector<std::string> remarks = remarks_before(file, rest);
    const MemoryFile without_remarks(std::move(rest));
    const std::string& read = remarks.empty() ? path : without_remarks.path();
    refuse_surplus_fields(read, place);
    const GDALDatasetUniquePtr dataset(
        GDALDataset::Open(("CSV:" + read).c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, drivers, options));
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
    refuse_access();
    if (!layer) table = table_of_one_column(path);
    if (table.rows.empty()) {
        throw Error(ErrorKind::input,
                    Problem{"the file is not a table with a header and rows", place, "", "",
                            "Give a CSV: a line with the names of the columns, then a line for each row"});
    }
    table.remarks = remarks;
    return table;
}

}  // namespace frana::gis
