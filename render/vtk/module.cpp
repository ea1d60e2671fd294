// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cstring>

#include "core/module.h"
#include "render/vtk/functions.h"
#include "render/vtk/osmesa_window.h"
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"

namespace frana::render {
namespace {

/// Three samples per pixel, averaged: smooth edges with the memory of one picture.
constexpr std::array<std::array<double, 2>, 3> k_samples{{{-1.0 / 3, 0}, {0, 1.0 / 3}, {1.0 / 3, -1.0 / 3}}};

void colour(vtkActor& actor, Rgb c) {
    actor.GetProperty()->SetColor(c.r / 255.0, c.g / 255.0, c.b / 255.0);
    actor.GetProperty()->LightingOff();
}

vtkNew<vtkPoints> points_of(const std::vector<ScenePoint>& places) {
    vtkNew<vtkPoints> points;
    points->SetNumberOfPoints(static_cast<vtkIdType>(places.size()));
    vtkIdType i = 0;
    for (const ScenePoint& p : places) points->SetPoint(i++, p.x, p.y, p.z);
    return points;
}

/// The ground in perspective, drawn by VTK.
class VtkScene : public TerrainScene {
  public:
    VtkScene(const std::vector<SceneSurface>& surfaces, int width, int height) : window_(width, height) {
        VtkErrors errors;
        texture_->InterpolateOn();
        // The samples per pixel smooth distant parts; smaller copies of the texture would cost as much again.
        texture_->MipmapOff();
        texture_->SetMaximumAnisotropicFiltering(1);  // more costs several times the frame in software
        for (const SceneSurface& surface : surfaces) add(surface);
        window_.vtk().AddRenderer(renderer_);
        errors.throw_if_any("a view's terrain could not be built");
    }
    ~VtkScene() override { window_.vtk().RemoveRenderer(renderer_); }
    VtkScene(const VtkScene&) = delete;
    VtkScene& operator=(const VtkScene&) = delete;

    void start(int width, int height) override {
        for (const auto& line : lines_) renderer_->RemoveActor(line);
        lines_.clear();
        if (dots_) renderer_->RemoveActor(dots_);
        dots_ = nullptr;
        window_.resize(width, height);
    }

    void set_sky(bool sky) override {
        renderer_->SetGradientBackground(sky);
        renderer_->SetBackground(sky ? 0.97 : 1, sky ? 0.975 : 1, sky ? 0.98 : 1);
        renderer_->SetBackground2(0.80, 0.88, 0.95);
    }

    void set_camera(const ScenePoint& position, const ScenePoint& target, double opening_deg) override {
        vtkCamera* eye = renderer_->GetActiveCamera();
        eye->SetPosition(position.x, position.y, position.z);
        eye->SetFocalPoint(target.x, target.y, target.z);
        eye->SetViewUp(0, 0, 1);
        eye->SetViewAngle(opening_deg);
    }

    void set_texture(int columns, int rows, const std::vector<std::uint8_t>& rgb) override {
        vtkNew<vtkImageData> image;
        image->SetDimensions(columns, rows, 1);
        image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
        std::memcpy(image->GetScalarPointer(), rgb.data(), rgb.size());
        texture_->SetInputData(image);
    }

    void move_points(const std::vector<ScenePoint>& points) override {
        vtkIdType i = 0;
        for (const ScenePoint& p : points) first_points_->SetPoint(i++, p.x, p.y, p.z);
        first_points_->Modified();
    }

    void add_line(const std::vector<ScenePoint>& points, double width_px, Rgb ink) override {
        vtkNew<vtkCellArray> cells;
        cells->InsertNextCell(static_cast<int>(points.size()));
        for (std::size_t i = 0; i < points.size(); ++i) cells->InsertCellPoint(static_cast<vtkIdType>(i));
        vtkNew<vtkPolyData> line;
        line->SetPoints(points_of(points));
        line->SetLines(cells);
        vtkNew<vtkPolyDataMapper> mapper;
        mapper->SetInputData(line);
        vtkNew<vtkActor> actor;
        actor->SetMapper(mapper);
        colour(*actor, ink);
        actor->GetProperty()->SetLineWidth(static_cast<float>(width_px));
        renderer_->AddActor(actor);
        lines_.emplace_back(actor);
    }

    void set_dots(const std::vector<ScenePoint>& places, const std::vector<Rgb>& colours, double width_px) override {
        if (dots_) renderer_->RemoveActor(dots_);
        vtkNew<vtkCellArray> cells;
        vtkNew<vtkUnsignedCharArray> inks;
        inks->SetNumberOfComponents(3);
        for (std::size_t i = 0; i < places.size(); ++i) {
            cells->InsertNextCell({static_cast<vtkIdType>(i)});
            inks->InsertNextTuple3(colours[i].r, colours[i].g, colours[i].b);
        }
        vtkNew<vtkPolyData> cloud;
        cloud->SetPoints(points_of(places));
        cloud->SetVerts(cells);
        cloud->GetPointData()->SetScalars(inks);
        vtkNew<vtkPolyDataMapper> mapper;
        mapper->SetInputData(cloud);
        mapper->SetColorModeToDirectScalars();
        dots_ = vtkSmartPointer<vtkActor>::New();
        dots_->SetMapper(mapper);
        dots_->GetProperty()->LightingOff();
        dots_->GetProperty()->SetPointSize(static_cast<float>(width_px));
        if (!places.empty()) renderer_->AddActor(dots_);
    }

    [[nodiscard]] std::vector<std::uint8_t> draw() override {
        renderer_->ResetCameraClippingRange();
        vtkCamera* eye = renderer_->GetActiveCamera();
        const int* size = window_.vtk().GetSize();
        return window_.mean_picture(3, k_samples.size(), [&](std::size_t sample) {
            eye->SetWindowCenter(2 * k_samples[sample][0] / size[0], 2 * k_samples[sample][1] / size[1]);
        });
    }

  private:
    void add(const SceneSurface& surface) {
        vtkNew<vtkPoints> points = points_of(surface.points);
        vtkNew<vtkCellArray> polygons;
        const auto sides = static_cast<std::size_t>(surface.sides);
        for (std::size_t i = 0; i + sides <= surface.corners.size(); i += sides) {
            polygons->InsertNextCell(surface.sides);
            for (std::size_t k = i; k < i + sides; ++k)
                polygons->InsertCellPoint(static_cast<vtkIdType>(surface.corners[k]));
        }
        vtkNew<vtkPolyData> mesh;
        mesh->SetPoints(points);
        mesh->SetPolys(polygons);
        vtkNew<vtkPolyDataMapper> mapper;
        mapper->SetInputData(mesh);
        vtkNew<vtkActor> actor;
        actor->SetMapper(mapper);
        colour(*actor, surface.colour);
        if (!surface.texture_places.empty()) {
            vtkNew<vtkFloatArray> where;
            where->SetNumberOfComponents(2);
            where->SetNumberOfTuples(static_cast<vtkIdType>(surface.points.size()));
            std::copy(surface.texture_places.begin(), surface.texture_places.end(), where->GetPointer(0));
            mesh->GetPointData()->SetTCoords(where);
            actor->SetTexture(texture_);
        }
        if (!first_points_) first_points_ = points;
        renderer_->AddActor(actor);
    }

    OsmesaWindow window_;
    vtkNew<vtkRenderer> renderer_;
    vtkNew<vtkTexture> texture_;
    vtkSmartPointer<vtkPoints> first_points_;
    std::vector<vtkSmartPointer<vtkActor>> lines_;
    vtkSmartPointer<vtkActor> dots_;
};

/// See VtkFunctions.
std::unique_ptr<TerrainScene> terrain_scene(const std::vector<SceneSurface>& surfaces, int width, int height) {
    return std::make_unique<VtkScene>(surfaces, width, height);
}

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

/// A window keeps eight bytes and more for each of its pixels: those of large pages are not kept.
constexpr std::int64_t k_most_kept_pixels = 4'000'000;

/// See VtkFunctions. Edges are smooth.
std::vector<std::uint8_t> draw_triangles(const Triangles& triangles, const PixelWindow& part) {
    VtkErrors errors;
    // The window of the last picture, whose shaders need not be compiled again.
    static thread_local std::unique_ptr<OsmesaWindow> kept;
    auto own = kept ? std::move(kept) : std::make_unique<OsmesaWindow>(part.width, part.height);
    OsmesaWindow& window = *own;
    window.resize(part.width, part.height);
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

    const double middle_x = part.left + part.width / 2.0, middle_y = part.bottom + part.height / 2.0;
    auto picture = window.mean_picture(4, k_pixel_samples.size(), [&](std::size_t sample) {
        const double x = middle_x + k_pixel_samples[sample][0], y = middle_y + k_pixel_samples[sample][1];
        camera->SetFocalPoint(x, y, 0);
        camera->SetPosition(x, y, 1);
    });
    window.vtk().RemoveRenderer(renderer);
    errors.throw_if_any("a picture's lines could not be drawn");
    if (static_cast<std::int64_t>(part.width) * part.height <= k_most_kept_pixels) kept = std::move(own);
    return picture;
}

}  // namespace
}  // namespace frana::render

FRANA_MODULE(frana::render::VtkFunctions,
             {.draw_triangles = frana::render::draw_triangles, .terrain_scene = frana::render::terrain_scene})
