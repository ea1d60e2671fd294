// SPDX-License-Identifier: Apache-2.0
#include "particle_points.h"

#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <numeric>

namespace frana::test {

double Points::sum(const std::string& name) const {
    const std::vector<double>& values = columns.at(name);
    return std::accumulate(values.begin(), values.end(), 0.0);
}

Points read_points(const std::string& path) {
    GDALAllRegister();
    Points points;
    const GDALDatasetUniquePtr dataset(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR, nullptr, nullptr, nullptr));
    OGRLayer* layer = dataset ? dataset->GetLayerByName("particles") : nullptr;
    EXPECT_TRUE(layer) << path;
    if (!layer) return points;
    for (int i = 0; i < layer->GetLayerDefn()->GetFieldCount(); ++i)
        points.names.emplace_back(layer->GetLayerDefn()->GetFieldDefn(i)->GetNameRef());
    for (const auto& row : *layer) {
        points.columns["x"].push_back(row->GetGeometryRef()->toPoint()->getX());
        points.columns["y"].push_back(row->GetGeometryRef()->toPoint()->getY());
        for (const std::string& name : points.names)
            points.columns[name].push_back(row->GetFieldAsDouble(name.c_str()));
    }
    return points;
}

}  // namespace frana::test
