// SPDX-License-Identifier: Apache-2.0
#include "render/vtk/triangles.h"

#include <array>

#include "render/vtk/osmesa_window.h"
#include "render/vtk/vtk_errors.h"
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

namespace frana::render {
namespace {

/// Sampling points of the page inside a pixel: each row and each column of an 8 x 8 grid once. Averaging these pictures
/// smooths edges with the memory of a single one.
constexpr std::array<std::array<double, 2>, 8> k_pixel_samples{{{-0.4375, -0.1875},
                                                                {-0.3125, 0.3125},
                                                                {-0.1875, -0.4375},
                                                                {-0.0625, 0.0625},
                                                                {0.0625, 0.4375},
                                                                {0.1875, -0.3125},
                                                                {0.3125, 0.1875},
                                                                {0.4375, -0.0625}}};

}  // namespace

std::vector<std::uint8_t> draw_triangles(const Triangles& triangles, const PixelWindow& part) {
    VtkErrors errors;
    OsmesaWindow window(part.width, part.height);
    const auto n_corners = static_cast<vtkIdType>(triangles.colours.size());
    vtkNew<vtkFloatArray> positions;
    positions->SetNumberOfComponents(3);
    positions->SetNumberOfTuples(n_corners);
    vtkNew<vtkUnsignedCharArray> shades;
    shades->SetNumberOfComponents(4);
    shades->SetNumberOfTuples(n_corners);
    vtkNew<vtkCellArray> cells;
    for (vtkIdType i = 0; i < n_corners; ++i) {
        const auto k = static_cast<std::size_t>(i);
        // Later triangles are nearer to the viewer, so that the depth test lets them cover earlier ones.
        const vtkIdType triangle = i / 3;
        const double height = 0.9 * static_cast<double>(triangle) / static_cast<double>(n_corners);
        positions->SetTuple3(i, triangles.corners[2 * k], triangles.corners[2 * k + 1], height);
        for (int band = 0; band < 4; ++band) {
            shades->SetTypedComponent(
                i, band, static_cast<unsigned char>(triangles.colours[k] >> (8U * static_cast<unsigned>(band))));
        }
        if (i % 3 == 0) cells->InsertNextCell({i, i + 1, i + 2});
    }
    vtkNew<vtkPoints> points;
    points->SetData(positions);
    vtkNew<vtkPolyData> mesh;
    mesh->SetPoints(points);
    mesh->SetPolys(cells);
    mesh->GetPointData()->SetScalars(shades);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(mesh);
    mapper->SetColorModeToDirectScalars();
    mapper->SetScalarModeToUsePointData();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    actor->ForceOpaqueOn();  // drawn in order and blended; the translucent pass would blend regardless of order
    vtkNew<vtkRenderer> renderer;
    renderer->SetBackground(0, 0, 0);
    renderer->SetBackgroundAlpha(0);
    renderer->AddActor(actor);
    window.vtk().AddRenderer(renderer);
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(part.height / 2.0);
    camera->SetClippingRange(0.5, 1.05);

    std::vector<std::uint16_t> sum(4 * static_cast<std::size_t>(part.width) * static_cast<std::size_t>(part.height));
    const double middle_x = part.left + part.width / 2.0, middle_y = part.bottom + part.height / 2.0;
    std::vector<std::uint8_t> picture;
    for (const auto& sample : k_pixel_samples) {
        const double x = middle_x + sample[0], y = middle_y + sample[1];
        camera->SetFocalPoint(x, y, 0);
        camera->SetPosition(x, y, 1);
        window.render();
        picture = window.read_rgba();
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = static_cast<std::uint16_t>(sum[i] + picture[i]);
    }
    const unsigned n_samples = k_pixel_samples.size();
    for (std::size_t i = 0; i < sum.size(); ++i) {
        picture[i] = static_cast<std::uint8_t>((sum[i] + n_samples / 2) / n_samples);
    }
    window.vtk().RemoveRenderer(renderer);
    errors.throw_if_any("a picture's lines could not be drawn");
    return picture;
}

}  // namespace frana::render
