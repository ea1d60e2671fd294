// SPDX-License-Identifier: Apache-2.0
#include "render/view/view_scene.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/canvas/drawing_modules.h"

namespace frana::render {
namespace {

/// Returns where the points of the ground are, raised by a thickness where it has values.
std::vector<ScenePoint> places_of(const ViewGround& ground, const Raster* thickness) {
    const GridSpec& grid = ground.heights().grid;
    std::vector<ScenePoint> places;
    places.reserve(static_cast<std::size_t>(grid.cell_count()));
    for (std::int64_t row = 0; row < grid.rows; ++row) {
        for (std::int64_t column = 0; column < grid.columns; ++column) {
            const Point map = grid.cell_centre(row, column);
            const double above = thickness != nullptr ? cell_value(*thickness, map) : 0;
            ScenePoint& p = places.emplace_back(ground.scene(map, std::isnan(above) ? 0 : above));
            if (std::isnan(p.z)) p.z = ground.lowest();
        }
    }
    return places;
}

SceneSurface mesh_of(const ViewGround& ground) {
    const Raster& heights = ground.heights();
    const std::int64_t columns = heights.grid.columns, rows = heights.grid.rows;
    SceneSurface mesh;
    mesh.points = places_of(ground, nullptr);
    for (std::int64_t row = 0; row < rows; ++row) {
        for (std::int64_t column = 0; column < columns; ++column) {
            const std::int64_t i = row * columns + column;
            mesh.texture_places.push_back(
                static_cast<float>((static_cast<double>(column) + 0.5) / static_cast<double>(columns)));
            mesh.texture_places.push_back(
                static_cast<float>(1 - (static_cast<double>(row) + 0.5) / static_cast<double>(rows)));
            if (row + 1 == rows || column + 1 == columns) continue;
            const std::array<std::int64_t, 4> corner{i, i + columns, i + 1, i + columns + 1};
            const auto gap = [&](std::int64_t k) { return std::isnan(heights.values[static_cast<std::size_t>(k)]); };
            if (std::none_of(corner.begin(), corner.begin() + 3, gap))
                mesh.corners.insert(mesh.corners.end(), {corner[0], corner[1], corner[2]});
            if (std::none_of(corner.begin() + 1, corner.end(), gap))
                mesh.corners.insert(mesh.corners.end(), {corner[2], corner[1], corner[3]});
        }
    }
    return mesh;
}

/// Adds walls from the edge of the terrain down to a common floor, so that its edge is a clean cut.
void add_walls(const ViewGround& ground, std::vector<SceneSurface>& surfaces) {
    const GridSpec& grid = ground.heights().grid;
    const Bounds box = grid.bounds();
    const double floor = ground.lowest() - 0.04 * std::max(box.width(), box.height());
    for (int side = 0; side < 4; ++side) {
        const bool along_row = side < 2;
        const std::int64_t count = along_row ? grid.columns : grid.rows;
        const std::int64_t fixed = side % 2 == 0 ? 0 : (along_row ? grid.rows : grid.columns) - 1;
        SceneSurface wall;
        wall.sides = 4;
        wall.colour = along_row ? Rgb{186, 179, 170} : Rgb{168, 161, 152};
        std::int64_t last = -1;
        for (std::int64_t k = 0; k < count; ++k) {
            const std::int64_t row = along_row ? fixed : k, column = along_row ? k : fixed;
            if (!ground.heights().has_data(row, column)) {
                last = -1;
                continue;
            }
            const ScenePoint p = ground.scene(grid.cell_centre(row, column), 0);
            const auto upper = std::ssize(wall.points);
            wall.points.push_back(p);
            wall.points.push_back({p.x, p.y, floor});
            if (last >= 0) wall.corners.insert(wall.corners.end(), {last, last + 1, upper + 1, upper});
            last = upper;
        }
        // Terrain whose data reach the rectangle's side only in places is irregular anyway; no fragment of a wall
        // is drawn.
        if (std::ssize(wall.corners) / wall.sides > count / 5) surfaces.push_back(std::move(wall));
    }
}

}  // namespace

ViewScene::ViewScene(const ViewGround& ground, int width, int height)
    : ground_(ground), width_(width), height_(height) {
    std::vector<SceneSurface> surfaces{mesh_of(ground)};
    add_walls(ground, surfaces);
    scene_ = call_module([&] { return vtk().terrain_scene(surfaces, width, height); });
}

void ViewScene::start(const PlacedCamera& camera, int width, int height) {
    width_ = width;
    height_ = height;
    call_module([&] { scene_->start(width, height); });
    set_camera(camera);
}

void ViewScene::set_camera(const PlacedCamera& camera) {
    call_module([&] { scene_->set_camera(camera.position, camera.target, camera.opening_deg); });
}

void ViewScene::set_sky(bool sky) {
    call_module([&] { scene_->set_sky(sky); });
}

void ViewScene::set_colours(const std::vector<std::uint8_t>& colours) {
    call_module([&] { scene_->set_texture(ground_.texture_columns(), ground_.texture_rows(), colours); });
}

void ViewScene::set_thickness(const Raster* thickness) {
    const std::vector<ScenePoint> places = places_of(ground_, thickness);
    call_module([&] { scene_->move_points(places); });
}

void ViewScene::add_line(const std::vector<ScenePoint>& points, double width_px, Rgb colour) {
    call_module([&] { scene_->add_line(points, width_px, colour); });
}

void ViewScene::set_dots(const std::vector<ScenePoint>& places, const std::vector<Rgb>& colours, double width_px) {
    call_module([&] { scene_->set_dots(places, colours, width_px); });
}

Image ViewScene::draw() {
    Image image;
    image.rgb = call_module([&] { return scene_->draw(); });
    image.width = width_;
    image.height = height_;
    return image;
}

}  // namespace frana::render
