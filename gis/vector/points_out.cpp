// SPDX-License-Identifier: Apache-2.0
#include "gis/vector/points_out.h"

#include <ogrsf_frmts.h>

#include <cmath>
#include <memory>

#include "gis/vector/geopackage.h"

namespace frana::gis {
namespace {

bool write_layer(GDALDataset& dataset, OGRSpatialReference* crs, const std::string& name, const PointTable& table) {
    OGRLayer* layer = dataset.CreateLayer(name.c_str(), crs, wkbPoint, nullptr);
    if (!layer) return false;
    for (const PointTable::Column& column : table.columns) {
        OGRFieldDefn field(column.name.c_str(), OFTReal);
        if (layer->CreateField(&field) != OGRERR_NONE) return false;
    }
    for (std::size_t p = 0; p < table.places.size(); ++p) {
        OGRFeature row(layer->GetLayerDefn());
        for (std::size_t c = 0; c < table.columns.size(); ++c) {
            const double value = table.columns[c].values[p];
            if (!std::isnan(value)) row.SetField(static_cast<int>(c), value);
        }
        row.SetGeometryDirectly(std::make_unique<OGRPoint>(table.places[p].x, table.places[p].y).release());
        if (layer->CreateFeature(&row) != OGRERR_NONE) return false;
    }
    return true;
}

}  // namespace

void write_points(const std::string& gpkg_path, const std::string& crs_wkt, const std::string& layer_name,
                  const PointTable& table) {
    write_geopackage(gpkg_path, crs_wkt, [&](GDALDataset& dataset, OGRSpatialReference* crs) {
        // One transaction: otherwise every row would be written to disk separately.
        return dataset.StartTransaction() == OGRERR_NONE && write_layer(dataset, crs, layer_name, table) &&
               write_layer_styles(dataset, {{layer_name, style_of(layer_name, Shape::point, {})}}) &&
               dataset.CommitTransaction() == OGRERR_NONE;
    });
}

}  // namespace frana::gis
