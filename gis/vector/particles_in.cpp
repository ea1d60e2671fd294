// SPDX-License-Identifier: Apache-2.0
#include "gis/vector/particles_in.h"

#include <ogrsf_frmts.h>

#include "gis/access/gdal_session.h"
#include "gis/access/time_limit.h"
#include "gis/vector/vector_source.h"

namespace frana::gis {

ValuedPoints read_valued_points(const std::string& path, const std::vector<std::string>& names,
                                const std::string& where) {
    const GdalSession session;
    const ReadingOnly reading;
    const VectorSource source = vector_source(path, where);
    TimeLimit limit(source.where);
    const GDALDatasetUniquePtr dataset = open_vector(source);
    OGRLayer& layer = choose_layer(
        *dataset, source, [](OGRLayer& one) { return wkbFlatten(one.GetGeomType()) == wkbPoint; }, "points");
    std::vector<int> fields;
    for (const std::string& name : names) {
        fields.push_back(layer.GetLayerDefn()->GetFieldIndex(name.c_str()));
        if (fields.back() < 0)
            throw vector_error(source, "the layer has no such attribute", name, "Take a file that frana wrote");
    }
    ValuedPoints points;
    points.columns.resize(names.size());
    for (const auto& feature : layer) {
        limit.again();
        const OGRGeometry* geometry = feature->GetGeometryRef();
        if (geometry == nullptr || geometry->IsEmpty()) continue;
        const OGRPoint& point = *geometry->toPoint();
        points.places.push_back({point.getX(), point.getY()});
        for (std::size_t k = 0; k < fields.size(); ++k)
            points.columns[k].push_back(feature->GetFieldAsDouble(fields[k]));
    }
    require_sound(session, source, "Run the scene again");
    return points;
}

}  // namespace frana::gis
