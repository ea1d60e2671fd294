// SPDX-License-Identifier: Apache-2.0
#include "render/view/view_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <utility>

#include "render/canvas/osmesa_window.h"
#include "render/canvas/vtk_errors.h"
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

}  // namespace

class ViewScene::Parts {
  public:
    Parts(const ViewGround& ground, int width, int height) : ground_(ground), window_(width, height) {
        VtkErrors errors;
        build_ground();
        build_walls();
        window_.vtk().AddRenderer(renderer_);
        errors.throw_if_any("a view's terrain could not be built");
    }
    ~Parts() { window_.vtk().RemoveRenderer(renderer_); }
    Parts(const Parts&) = delete;
    Parts& operator=(const Parts&) = delete;

    void start(const PlacedCamera& camera, int width, int height) {
        for (const auto& line : lines_) renderer_->RemoveActor(line);
        lines_.clear();
        if (dots_) renderer_->RemoveActor(dots_);
        dots_ = nullptr;
        window_.resize(width, height);
        set_camera(camera);
    }

    void set_sky(bool sky) {
        renderer_->SetGradientBackground(sky);
        renderer_->SetBackground(sky ? 0.97 : 1, sky ? 0.975 : 1, sky ? 0.98 : 1);
        renderer_->SetBackground2(0.80, 0.88, 0.95);
    }

    void set_camera(const PlacedCamera& camera) {
        vtkCamera* eye = renderer_->GetActiveCamera();
        eye->SetPosition(camera.position.x, camera.position.y, camera.position.z);
        eye->SetFocalPoint(camera.target.x, camera.target.y, camera.target.z);
        eye->SetViewUp(0, 0, 1);
        eye->SetViewAngle(camera.opening_deg);
    }

    void set_colours(std::vector<std::uint8_t> colours) {
        vtkNew<vtkImageData> image;
        image->SetDimensions(ground_.texture_columns(), ground_.texture_rows(), 1);
        image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
        std::memcpy(image->GetScalarPointer(), colours.data(), colours.size());
        texture_->SetInputData(image);
    }

    void set_thickness(const Raster* thickness) {
        const GridSpec& grid = ground_.heights().grid;
        for (std::int64_t row = 0; row < grid.rows; ++row) {
            for (std::int64_t column = 0; column < grid.columns; ++column) {
                const Point map = grid.cell_centre(row, column);
                const double above = thickness != nullptr ? cell_value(*thickness, map) : 0;
                place(row * grid.columns + column, map, std::isnan(above) ? 0 : above);
            }
        }
        points_->Modified();
    }

    void add_line(const std::vector<ScenePoint>& points, double width_px, Rgb ink) {
        vtkNew<vtkPoints> places;
        vtkNew<vtkCellArray> cells;
        cells->InsertNextCell(static_cast<int>(points.size()));
        for (const ScenePoint& p : points) cells->InsertCellPoint(places->InsertNextPoint(p.x, p.y, p.z));
        vtkNew<vtkPolyData> line;
        line->SetPoints(places);
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

    void set_dots(const std::vector<ScenePoint>& places, const std::vector<Rgb>& colours, double width_px) {
        if (dots_) renderer_->RemoveActor(dots_);
        vtkNew<vtkPoints> points;
        vtkNew<vtkCellArray> cells;
        vtkNew<vtkUnsignedCharArray> inks;
        inks->SetNumberOfComponents(3);
        for (std::size_t i = 0; i < places.size(); ++i) {
            const ScenePoint& p = places[i];
            cells->InsertNextCell({points->InsertNextPoint(p.x, p.y, p.z)});
            inks->InsertNextTuple3(colours[i].r, colours[i].g, colours[i].b);
        }
        vtkNew<vtkPolyData> cloud;
        cloud->SetPoints(points);
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

    Image draw() {
        renderer_->ResetCameraClippingRange();
        vtkCamera* eye = renderer_->GetActiveCamera();
        const int* size = window_.vtk().GetSize();
        Image image;
        std::vector<std::uint16_t> sum;
        for (const auto& sample : k_samples) {
            eye->SetWindowCenter(2 * sample[0] / size[0], 2 * sample[1] / size[1]);
            window_.render();
            image = window_.read_rgb();
            sum.resize(image.rgb.size());
            for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = static_cast<std::uint16_t>(sum[i] + image.rgb[i]);
        }
        constexpr unsigned k_count = k_samples.size();
        for (std::size_t i = 0; i < sum.size(); ++i) {
            image.rgb[i] = static_cast<std::uint8_t>((sum[i] + k_count / 2) / k_count);
        }
        return image;
    }

  private:
    void place(vtkIdType i, Point map, double above) {
        const ScenePoint p = ground_.scene(map, above);
        points_->SetPoint(i, p.x, p.y, std::isnan(p.z) ? ground_.lowest() : p.z);
    }

    void build_ground() {
        const Raster& heights = ground_.heights();
        const GridSpec& grid = heights.grid;
        const auto columns = static_cast<vtkIdType>(grid.columns), rows = static_cast<vtkIdType>(grid.rows);
        points_->SetNumberOfPoints(columns * rows);
        vtkNew<vtkFloatArray> where;  // in the texture
        where->SetNumberOfComponents(2);
        where->SetNumberOfTuples(columns * rows);
        vtkNew<vtkCellArray> triangles;
        for (vtkIdType row = 0; row < rows; ++row) {
            for (vtkIdType column = 0; column < columns; ++column) {
                const vtkIdType i = row * columns + column;
                place(i, grid.cell_centre(row, column), 0);
                where->SetTuple2(i, (static_cast<double>(column) + 0.5) / static_cast<double>(columns),
                                 1 - (static_cast<double>(row) + 0.5) / static_cast<double>(rows));
                if (row + 1 == rows || column + 1 == columns) continue;
                const std::array<vtkIdType, 4> corner{i, i + columns, i + 1, i + columns + 1};
                const auto gap = [&](vtkIdType k) { return std::isnan(heights.values[static_cast<std::size_t>(k)]); };
                if (std::none_of(corner.begin(), corner.begin() + 3, gap)) {
                    triangles->InsertNextCell({corner[0], corner[1], corner[2]});
                }
                if (std::none_of(corner.begin() + 1, corner.end(), gap)) {
                    triangles->InsertNextCell({corner[2], corner[1], corner[3]});
                }
            }
        }
        vtkNew<vtkPolyData> mesh;
        mesh->SetPoints(points_);
        mesh->SetPolys(triangles);
        mesh->GetPointData()->SetTCoords(where);
        vtkNew<vtkPolyDataMapper> mapper;
        mapper->SetInputData(mesh);
        vtkNew<vtkActor> actor;
        actor->SetMapper(mapper);
        actor->SetTexture(texture_);
        colour(*actor, {255, 255, 255});
        texture_->InterpolateOn();
        // The samples per pixel smooth distant parts; smaller copies of the texture would cost as much again.
        texture_->MipmapOff();
        texture_->SetMaximumAnisotropicFiltering(1);  // more costs several times the frame in software
        renderer_->AddActor(actor);
    }

    /// Builds walls from the edge of the terrain down to a common floor, so that its edge is a clean cut.
    void build_walls() {
        const GridSpec& grid = ground_.heights().grid;
        const Bounds box = grid.bounds();
        const double floor = ground_.lowest() - 0.04 * std::max(box.width(), box.height());
        for (int side = 0; side < 4; ++side) {
            const bool along_row = side < 2;
            const std::int64_t count = along_row ? grid.columns : grid.rows;
            const std::int64_t fixed = side % 2 == 0 ? 0 : (along_row ? grid.rows : grid.columns) - 1;
            vtkNew<vtkPoints> places;
            vtkNew<vtkCellArray> cells;
            vtkIdType last = -1;
            for (std::int64_t k = 0; k < count; ++k) {
                const std::int64_t row = along_row ? fixed : k, column = along_row ? k : fixed;
                if (!ground_.heights().has_data(row, column)) {
                    last = -1;
                    continue;
                }
                const ScenePoint p = ground_.scene(grid.cell_centre(row, column), 0);
                const vtkIdType upper = places->InsertNextPoint(p.x, p.y, p.z);
                const vtkIdType lower = places->InsertNextPoint(p.x, p.y, floor);
                if (last >= 0) cells->InsertNextCell({last, last + 1, lower, upper});
                last = upper;
            }
            vtkNew<vtkPolyData> wall;
            wall->SetPoints(places);
            wall->SetPolys(cells);
            vtkNew<vtkPolyDataMapper> mapper;
            mapper->SetInputData(wall);
            vtkNew<vtkActor> actor;
            actor->SetMapper(mapper);
            colour(*actor, along_row ? Rgb{186, 179, 170} : Rgb{168, 161, 152});
            // Terrain whose data reach the rectangle's side only in places is irregular anyway; no fragment of a wall
            // is drawn.
            if (cells->GetNumberOfCells() > count / 5) renderer_->AddActor(actor);
        }
    }

    const ViewGround& ground_;
    OsmesaWindow window_;
    vtkNew<vtkRenderer> renderer_;
    vtkNew<vtkTexture> texture_;
    vtkNew<vtkPoints> points_;
    std::vector<vtkSmartPointer<vtkActor>> lines_;
    vtkSmartPointer<vtkActor> dots_;
};

ViewScene::ViewScene(const ViewGround& ground, int width, int height)
    : parts_(std::make_unique<Parts>(ground, width, height)) {}
ViewScene::~ViewScene() = default;

void ViewScene::set_dots(const std::vector<ScenePoint>& places, const std::vector<Rgb>& colours, double width_px) {
    parts_->set_dots(places, colours, width_px);
}
void ViewScene::start(const PlacedCamera& camera, int width, int height) {
    parts_->start(camera, width, height);
}
void ViewScene::set_camera(const PlacedCamera& camera) {
    parts_->set_camera(camera);
}
void ViewScene::set_sky(bool sky) {
    parts_->set_sky(sky);
}
void ViewScene::set_colours(std::vector<std::uint8_t> colours) {
    parts_->set_colours(std::move(colours));
}
void ViewScene::set_thickness(const Raster* thickness) {
    parts_->set_thickness(thickness);
}
void ViewScene::add_line(const std::vector<ScenePoint>& points, double width_px, Rgb colour) {
    parts_->add_line(points, width_px, colour);
}

Image ViewScene::draw() {
    return parts_->draw();
}

}  // namespace frana::render
