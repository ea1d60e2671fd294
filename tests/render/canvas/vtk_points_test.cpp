// SPDX-License-Identifier: Apache-2.0
#include "render/canvas/canvas.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/error.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkXMLPolyDataReader.h"

namespace frana::render {
namespace {

TEST(VtkPoints, AreReadBackAsWritten) {
    const auto path = std::filesystem::temp_directory_path() / "frana_vtk_points.vtp";
    PointTable table;
    table.places = {{527000.125, 5094000}, {527001, 5094002.5}};
    table.add("depth_m") = {2.5, 1};
    table.add("speed_ms") = {0.1, 30};
    write_vtk_points(path.string(), table, {100, 101.5}, 12.5);

    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(path.string().c_str());
    reader->Update();
    vtkPolyData* data = reader->GetOutput();
    ASSERT_EQ(data->GetNumberOfPoints(), 2);
    EXPECT_EQ(data->GetVerts()->GetNumberOfCells(), 2);
    EXPECT_EQ(data->GetPoint(0)[0], 527000.125);  // more digits than a float has
    EXPECT_EQ(data->GetPoint(1)[2], 101.5);
    EXPECT_EQ(data->GetPointData()->GetArray("speed_ms")->GetComponent(1, 0), 30);
    EXPECT_EQ(data->GetPointData()->GetArray("depth_m")->GetComponent(0, 0), 2.5);
    EXPECT_EQ(data->GetFieldData()->GetArray("TimeValue")->GetComponent(0, 0), 12.5);
    std::filesystem::remove(path);
}

TEST(VtkPoints, AMissingFolderIsAnError) {
    EXPECT_THROW(write_vtk_points("/no/such/folder/points.vtp", {{{0, 0}}, {}}, {0}, 0), Error);
}

}  // namespace
}  // namespace frana::render
