// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.h"
#include "core/module.h"
#include "render/canvas/furniture.h"
#include "render/canvas/page.h"
#include "render/map/legend.h"
#include "render/map/map_body.h"
#include "render/view/view3d.h"
#include "render/view/view_session.h"

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
                static_cast<float>((static_cast<double>(row) + 0.5) / static_cast<double>(rows)));
            if (row + 1 == rows || column + 1 == columns) continue;
            // Round the four; without one of them, the triangle of the others: an oblique edge of the terrain has no
            // teeth.
            std::vector<std::int64_t> corner{i, i + columns, i + columns + 1, i + 1};
            std::erase_if(corner,
                          [&](std::int64_t k) { return std::isnan(heights.values[static_cast<std::size_t>(k)]); });
            for (std::size_t k = 2; k < corner.size(); ++k)
                mesh.corners.insert(mesh.corners.end(), {corner[0], corner[k - 1], corner[k]});
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

const ViewSpec& checked(const ViewSpec& spec) {
    Problems problems;
    if (spec.terrain == nullptr || spec.terrain->grid.cell_count() < 1) {
        problems.add({"a view needs a terrain", "", "", "", ""});
    }
    if (spec.width < 320 || spec.height < 240 || spec.width > 8192 || spec.height > 8192) {
        problems.add({"the view's size is out of range", "",
                      std::to_string(spec.width) + " x " + std::to_string(spec.height),
                      "320 x 240 to 8192 x 8192 pixels", ""});
    }
    if (!(spec.vertical_exaggeration > 0 && spec.vertical_exaggeration <= 20)) {
        problems.add(
            {"the vertical exaggeration is out of range", "", number(spec.vertical_exaggeration), "over 0 to 20", ""});
    }
    if (spec.camera &&
        !(spec.camera->elevation_deg >= 1 && spec.camera->elevation_deg <= 89 && spec.camera->zoom > 0)) {
        problems.add({"the camera's position is out of range", "",
                      number(spec.camera->elevation_deg) + " degrees, zoom " + number(spec.camera->zoom),
                      "elevation 1 to 89 degrees, zoom over 0", ""});
    }
    problems.throw_if_any();
    return spec;
}

std::string direction_words(double azimuth_deg, const Words& words) {
    const long turn = std::lround(azimuth_deg - 360 * std::floor(azimuth_deg / 360)) % 360;
    return words("view azimuth {1}°", {std::to_string(turn)});
}

std::string exaggeration_words(double exaggeration, const Words& words) {
    return words("heights × {1}", {words.number(number(exaggeration))});
}

const Raster* extent_of(const ViewSpec& spec) {
    return spec.extent != nullptr ? spec.extent : spec.layer;
}

std::shared_ptr<ViewPlace> place_for(const ViewSpec& spec, std::shared_ptr<ViewPlace>& kept) {
    const bool fits = kept && kept->terrain == spec.terrain && kept->extent == extent_of(spec) &&
                      kept->exaggeration == spec.vertical_exaggeration;
    if (!fits) kept = std::make_shared<ViewPlace>(spec);
    return kept;
}

}  // namespace

ViewPlace::ViewPlace(const ViewSpec& spec)
    : terrain(spec.terrain),
      extent(extent_of(spec)),
      exaggeration(spec.vertical_exaggeration),
      ground(*spec.terrain, extent, exaggeration, spec.background) {
    std::vector<SceneSurface> surfaces{mesh_of(ground)};
    add_walls(ground, surfaces);
    scene = call_module([&] { return vtk().terrain_scene(surfaces); });
}

ViewSession::ViewSession(const ViewSpec& spec, bool for_frames, std::shared_ptr<ViewPlace>& place)
    : place_(place_for(checked(spec), place)),
      ground_(place_->ground),
      scale_(scale_of(spec, for_frames)),
      raise_by_value_(spec.thickness != nullptr && spec.thickness == spec.layer) {
    constexpr std::int64_t k_sample = 4000;  // points of a flow
    const std::vector<ScenePoint> flow = ground_.sample(extent_of(spec), k_sample);
    if (flow.empty()) {
        throw Error(ErrorKind::input,
                    Problem{"a view needs terrain where its raster is", "", "", "", "is it the right DTM?"});
    }
    layout_.camera =
        spec.camera.value_or(find_camera(has_values(spec) ? std::span(flow) : std::span<const ScenePoint>()));
    if (spec.camera) raise_over_ground(flow, spec.width / static_cast<double>(spec.height));
    arrange(spec, for_frames, !has_values(spec) && (spec.layer != nullptr || spec.dots != nullptr));
    const PageBox& picture = layout_.picture;
    const PlacedCamera camera = place_camera(layout_.camera, flow, picture.width() / picture.height());
    note_flow(flow, camera);
    call_module([&] {
        TerrainScene& scene = *place_->scene;
        scene.start(static_cast<int>(picture.width()), static_cast<int>(picture.height()));
        scene.set_camera(camera.position, camera.target, camera.opening_deg);
        scene.move_points(places_of(ground_, spec.thickness));
        constexpr Rgb k_white{255, 255, 255}, k_horizon{247, 249, 250}, k_zenith{204, 224, 242};
        scene.set_background(spec.sky ? k_horizon : k_white, spec.sky ? k_zenith : k_white);
        add_outlines(spec);
    });
}

// From behind a slope or below it a given camera would show the ground from below: raises it until half of the flow is
// visible.
void ViewSession::raise_over_ground(const std::vector<ScenePoint>& flow, double aspect) {
    constexpr double k_steepest_deg = 85, k_raise_deg = 5;
    const std::size_t step = std::max<std::size_t>(1, flow.size() / 200);
    double& elevation = layout_.camera.elevation_deg;
    for (; elevation + k_raise_deg <= k_steepest_deg; elevation += k_raise_deg) {
        const ScenePoint eye = place_camera(layout_.camera, flow, aspect).position;
        std::size_t looked = 0, hidden = 0;
        for (std::size_t i = 0; i < flow.size(); i += step, ++looked) hidden += ground_.hides(eye, flow[i]);
        if (2 * hidden <= looked) return;
    }
}

void ViewSession::arrange(const ViewSpec& spec, bool for_frames, bool nothing_to_show) {
    layout_.page = {0, 0, static_cast<double>(spec.width), static_cast<double>(spec.height)};
    const double north = layout_.north_arrow_deg = spec.convergence_deg - layout_.camera.azimuth_deg;
    const std::vector<std::string> nothing;
    for (const Crowding& crowding : k_crowdings) {
        const bool notes_at_foot = crowding.notes_at_foot;
        const LegendContent content{spec.legend_title, spec.unit, &scale_, &spec.outlines,
                                    notes_at_foot ? &nothing : &spec.side_notes};
        std::vector<std::string> foot = notes_at_foot ? spec.side_notes : nothing;
        foot.insert(foot.end(), {spec.source, spec.crs_label, spec.attribution});
        const PageStyle style(spec.width, spec.height, crowding.density, spec.least_letters);
        Sheet sheet(spec.width, spec.height);
        layout_.legend.clear();
        const double inner = spec.width - 2 * style.margin;
        const TitleResult titles =
            draw_titles(sheet, style, spec.title, spec.subtitle, for_frames, {style.margin, style.margin}, inner);
        subtitle_at_ = titles.subtitle_at;
        const double foot_top = draw_foot(sheet, style, foot, style.margin, spec.height - style.margin, inner);
        const double column = std::max(0.15 * spec.width, legend_width(content, style, sheet, 0.32 * spec.width));
        layout_.picture = {std::round(style.margin), std::round(titles.bottom + style.gap),
                           std::round(spec.width - style.margin - column - 1.6 * style.gap),
                           std::round(foot_top - style.gap)};
        const PageBox& picture = layout_.picture;
        if (picture.width() < 80 || picture.height() < 60) continue;
        sheet.frame(picture, {std::round(std::max(1.0, PageStyle(spec.width, spec.height).line(2))), k_ink});
        const double left = spec.width - style.margin - column;
        const double legend_bottom = draw_legend(content, style, {left, picture.top}, column, sheet, layout_.legend);

        const std::vector<std::string> lines =
            sheet.wrapped(direction_words(layout_.camera.azimuth_deg, spec.words) + ", " +
                              exaggeration_words(spec.vertical_exaggeration, spec.words),
                          style.small, column);
        double y = picture.bottom - Sheet::line_height(style.small) * static_cast<double>(lines.size()) +
                   0.3 * style.small.size_px;
        sheet.lines(lines, {left, y}, style.small, Across::left);
        const double reach = north_arrow_height(style) / 2;
        y -= style.gap / 2 + 2 * reach;
        draw_north_arrow(sheet, style, {left + reach, y + reach}, north);
        if (legend_bottom + style.gap > y) continue;
        if (nothing_to_show) {
            TextStyle note = style.heading;
            note.halo_px = std::max(2.0, style.length(4));
            sheet.text(spec.words("no values"),
                       {(picture.left + picture.right) / 2, (picture.top + picture.bottom) / 2}, note, Across::centre,
                       Upright::middle);
        }
        layout_.texts = sheet.texts();
        above_ = sheet.take(for_frames);
        return;
    }
    throw Error(ErrorKind::input, Problem{"the page is too small for the view's legend and notes", "",
                                          std::to_string(spec.width) + " x " + std::to_string(spec.height) + " pixels",
                                          "", "draw a larger picture, or fewer classes, outlines or notes"});
}

void ViewSession::note_flow(const std::vector<ScenePoint>& flow, const PlacedCamera& camera) {
    const PageBox& picture = layout_.picture;
    PageBox& box = layout_.flow = {1e9, 1e9, -1e9, -1e9};
    for (const ScenePoint& p : flow) {
        const Point at = camera.project(p);
        const double x = (picture.left + picture.right + at.x * picture.height()) / 2,
                     y = (picture.top + picture.bottom - at.y * picture.height()) / 2;
        box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x), std::max(box.bottom, y)};
    }
    const ScenePoint middle = flow[flow.size() / 2];
    const double away =
        std::hypot(middle.x - camera.position.x, middle.y - camera.position.y, middle.z - camera.position.z);
    metres_per_pixel_ = 2 * away * std::tan(camera.opening_deg / 2 * std::numbers::pi / 180) / picture.height();
}

void ViewSession::put_dots(const Dots& dots) {
    std::vector<ScenePoint> places;
    std::vector<Rgb> colours;
    // Slightly above the ground, whose mesh is coarser than the bed.
    const double lift = 0.35 * ground_.heights().grid.cell_size;
    for (const Dot& dot : dots.dots) {
        const ColourClass* found = scale_.find(dot.value);
        const ScenePoint place = ground_.scene(dot.place, dot.above + lift);
        if (found == nullptr || std::isnan(place.z)) continue;
        places.push_back(place);
        colours.push_back(found->colour);
    }
    place_->scene->set_dots(places, colours, std::max(1.5, dots.width_m / metres_per_pixel_));
}

void ViewSession::add_outlines(const ViewSpec& spec) {
    const PageStyle style(spec.width, spec.height);
    for (const Outline& outline : spec.outlines) {
        const double width = style.line(outline.width_px);
        for (const Polygon& polygon : outline.polygons) {
            add_line(polygon.outer, true, outline, width, spec.thickness);
            for (const Ring& hole : polygon.holes) add_line(hole, true, outline, width, spec.thickness);
        }
        for (const Polyline& line : outline.lines) {
            add_line(line, false, outline, width, spec.thickness);
        }
    }
}

void ViewSession::add_line(const Polyline& ring, bool is_ring, const Outline& outline, double width,
                           const Raster* thickness) {
    const double cell = ground_.heights().grid.cell_size;
    const std::vector<double> dashes = outline_dashes(outline, width);  // a stroke and a gap
    const double stroke = dashes.empty() ? 0 : dashes[0] * metres_per_pixel_,
                 gap = dashes.empty() ? 0 : dashes[1] * metres_per_pixel_;
    const double piece = gap > 0 ? std::min(cell, gap / 2) / 2 : cell / 2;
    Polyline line;
    for (std::size_t i = 0; i < ring.size() + (is_ring ? 1 : 0); ++i) {
        const Point to = ring[i % ring.size()];
        if (!line.empty()) {
            const Point from = line.back();
            const double length = std::hypot(to.x - from.x, to.y - from.y);
            const int parts = std::clamp(static_cast<int>(length / piece), 1, 100000);
            for (int k = 1; k < parts; ++k)
                line.push_back({from.x + (to.x - from.x) * k / parts, from.y + (to.y - from.y) * k / parts});
        }
        line.push_back(to);
    }
    for (const bool rim : {true, false}) {
        std::vector<ScenePoint> run;
        const auto end_run = [&] {
            if (run.size() > 1)
                place_->scene->add_line(run, rim ? width + 2.6 : width, rim ? Rgb{255, 255, 255} : outline.colour);
            run.clear();
        };
        double along = 0;
        for (std::size_t i = 0; i < line.size(); ++i) {
            const double above = thickness != nullptr ? cell_value(*thickness, line[i]) : 0;
            const ScenePoint p = ground_.scene(line[i], (rim ? 0.5 : 0.6) * cell + (std::isnan(above) ? 0 : above));
            if (i > 0) along += std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y);
            const bool in_gap = !rim && gap > 0 && std::fmod(along, stroke + gap) > stroke;
            if (in_gap || std::isnan(p.z))  // off the terrain
                end_run();
            else
                run.push_back(p);
        }
        end_run();
    }
}

Page ViewSession::draw(const Raster* layer, const Dots* dots, const std::string& subtitle) {
    const PageBox& picture = layout_.picture;
    auto image = std::make_shared<Image>(static_cast<int>(picture.width()), static_cast<int>(picture.height()));
    call_module([&] {
        TerrainScene& scene = *place_->scene;
        if (dots != nullptr) put_dots(*dots);
        const Image colours = ground_.colours(layer, scale_);
        scene.set_texture(colours.width, colours.height, colours.rgb);
        if (raise_by_value_) scene.move_points(places_of(ground_, layer));
        image->rgb = scene.draw(3);
    });
    Page page(static_cast<int>(layout_.page.width()), static_cast<int>(layout_.page.height()));
    page.put(image, static_cast<int>(picture.left), static_cast<int>(picture.top));
    page.put(above_);
    const PageStyle style(page.width(), page.height());
    if (!subtitle.empty()) page.put(late_subtitle(page.width(), page.height(), style, subtitle, subtitle_at_));
    return page;
}

Page ViewSeries::draw(const ViewSpec& spec, ViewLayout* layout) {
    ViewSession session(spec, false, place_);
    if (layout != nullptr) *layout = session.layout();
    return session.draw(spec.layer, spec.dots, "");
}

Page view_page(const ViewSpec& spec, ViewLayout* layout) {
    return ViewSeries().draw(spec, layout);
}

Image draw_view(const ViewSpec& spec, ViewLayout* layout) {
    return view_page(spec, layout).paint();
}

}  // namespace frana::render
