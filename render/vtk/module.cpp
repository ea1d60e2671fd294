// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

#include "core/module.h"
#include "render/vtk/functions.h"
#include "render/vtk/osmesa_window.h"
#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkFlyingEdges2D.h"
#include "vtkIdList.h"
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
#include "vtkStripper.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"

namespace frana::render {
namespace {

/// Places of samples around a pixel's middle.
constexpr std::array<std::array<double, 2>, 3> k_samples{{{-1.0 / 3, 0}, {0, 1.0 / 3}, {1.0 / 3, -1.0 / 3}}};

constexpr double k_full = 255;

void colour(vtkActor& actor, Rgb c) {
    actor.GetProperty()->SetColor(c.r / k_full, c.g / k_full, c.b / k_full);
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
    explicit VtkScene(const std::vector<SceneSurface>& surfaces) : window_(1, 1) {
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

    void set_background(Rgb below, Rgb above) override {
        renderer_->SetGradientBackground(!(below == above));
        renderer_->SetBackground(below.r / k_full, below.g / k_full, below.b / k_full);
        renderer_->SetBackground2(above.r / k_full, above.g / k_full, above.b / k_full);
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

    [[nodiscard]] std::vector<std::uint8_t> draw(std::size_t samples) override {
        renderer_->ResetCameraClippingRange();
        vtkCamera* eye = renderer_->GetActiveCamera();
        const int* size = window_.vtk().GetSize();
        return window_.mean_picture(samples, [&](std::size_t sample) {
            if (samples > 1)
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
std::unique_ptr<TerrainScene> terrain_scene(const std::vector<SceneSurface>& surfaces) {
    return std::make_unique<VtkScene>(surfaces);
}

/// See VtkFunctions.
std::vector<std::vector<ScenePoint>> level_lines(const std::vector<double>& values, int columns, int rows,
                                                 const std::vector<double>& levels) {
    VtkErrors errors;
    vtkNew<vtkDoubleArray> scalars;
    scalars->SetArray(const_cast<double*>(values.data()), static_cast<vtkIdType>(values.size()), 1);  // not owned
    vtkNew<vtkImageData> image;
    image->SetDimensions(columns, rows, 1);
    image->GetPointData()->SetScalars(scalars);
    vtkNew<vtkFlyingEdges2D> edges;
    edges->SetInputData(image);
    edges->SetNumberOfContours(static_cast<int>(levels.size()));
    for (std::size_t i = 0; i < levels.size(); ++i) edges->SetValue(static_cast<int>(i), levels[i]);
    vtkNew<vtkStripper> joined;
    joined->SetInputConnection(edges->GetOutputPort());
    joined->SetMaximumLength(std::numeric_limits<int>::max());
    joined->Update();
    // An open line is found in two parts. To join them takes the square of their number.
    constexpr vtkIdType k_many = 5000;
    if (joined->GetOutput()->GetNumberOfLines() < k_many) {
        joined->JoinContiguousSegmentsOn();
        joined->Update();
    }
    errors.throw_if_any("lines of equal height could not be drawn");
    vtkPolyData* found = joined->GetOutput();
    std::vector<std::vector<ScenePoint>> lines;
    vtkNew<vtkIdList> line;
    for (found->GetLines()->InitTraversal(); found->GetLines()->GetNextCell(line) != 0;) {
        lines.emplace_back();
        for (vtkIdType i = 0; i < line->GetNumberOfIds(); ++i) {
            const vtkIdType id = line->GetId(i);
            const double* p = found->GetPoint(id);
            lines.back().push_back({p[0], p[1], found->GetPointData()->GetScalars()->GetComponent(id, 0)});
        }
    }
    return lines;
}

}  // namespace
}  // namespace frana::render

FRANA_MODULE(frana::render::VtkFunctions,
             {.level_lines = frana::render::level_lines, .terrain_scene = frana::render::terrain_scene})
