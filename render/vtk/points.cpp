// SPDX-License-Identifier: Apache-2.0
#include "render/vtk/points.h"

#include <algorithm>

#include "core/module.h"
#include "render/vtk/vtk_errors.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkXMLPolyDataWriter.h"

namespace frana::render {
namespace {

vtkNew<vtkDoubleArray> named_array(const std::string& name, const std::vector<double>& values) {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name.c_str());
    array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
    std::copy(values.begin(), values.end(), array->GetPointer(0));
    return array;
}

}  // namespace

void write_points(const std::string& file, const std::string& name, const PointTable& table,
                  const std::vector<double>& heights, double time) {
    VtkErrors errors;
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();  // map coordinates need all digits
    vtkNew<vtkCellArray> vertices;
    for (std::size_t p = 0; p < table.places.size(); ++p) {
        const vtkIdType id = points->InsertNextPoint(table.places[p].x, table.places[p].y, heights[p]);
        vertices->InsertNextCell(1, &id);
    }
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetVerts(vertices);
    for (const PointTable::Column& column : table.columns)
        data->GetPointData()->AddArray(named_array(column.name, column.values));
    data->GetFieldData()->AddArray(named_array("TimeValue", {time}));

    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetFileName(file.c_str());
    writer->SetInputData(data);
    const bool written = writer->Write() == 1;
    errors.throw_if_any("the file of particles cannot be written: " + name);
    if (!written) {
        throw ModuleFailure({"the file of particles cannot be written", name, "", "",
                             "Check that the folder may be written and has free space"});
    }
}

}  // namespace frana::render
