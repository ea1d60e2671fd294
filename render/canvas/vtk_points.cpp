// SPDX-License-Identifier: Apache-2.0
#include "render/canvas/vtk_points.h"

#include <algorithm>

#include "core/error.h"
#include "core/file_aside.h"
#include "render/canvas/vtk_errors.h"
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

void write_vtk_points(const std::string& path, const PointTable& table, const std::vector<double>& heights,
                      double time) {
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

    FileAside file(path);
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetFileName(file.partial_path().c_str());
    writer->SetInputData(data);
    const bool written = writer->Write() == 1;
    errors.throw_if_any("the file of particles cannot be written: " + path);
    if (!written) {
        throw Error(ErrorKind::environment, Problem{"the file of particles cannot be written", path, "", "",
                                                    "Check that the folder may be written and has free space"});
    }
    file.sync_to_disk();
    file.rename_into_place();
}

}  // namespace frana::render
