// SPDX-License-Identifier: Apache-2.0
#include "app/pictures/map_source.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <memory>
#include <numbers>

#include "app/pictures/result_numbers.h"
#include "app/store/result_files.h"
#include "app/store/vector_layers.h"
#include "app/text/number_text.h"
#include "app/text/version.h"
#include "core/error.h"
#include "core/files.h"
#include "core/text.h"
#include "gis/crs/crs.h"
#include "gis/crs/crs_transform.h"
#include "gis/raster/picture_file.h"
#include "params/grammar/value_text.h"
#include "params/keys/result_rasters.h"
#include "render/canvas/lettering.h"
#include "render/map/map_ground.h"

namespace frana::app {

std::optional<Sentence> letter_warning() {
    const std::vector<std::string> letters = render::take_letters_without_font();
    if (letters.empty()) return std::nullopt;
    constexpr std::size_t k_named = 10;
    std::string named;
    for (std::size_t i = 0; i < letters.size() && i < k_named; ++i) named += (i > 0 ? " " : "") + letters[i];
    if (letters.size() > k_named) named += " … " + std::to_string(letters.size() - k_named);
    return worded("no installed font has the letters {1}: install fonts-noto-core or fonts-noto-cjk", {named});
}

namespace {

// A dark red on classes, whose colours are as bright as that of the survey elsewhere.
constexpr Rgb k_scar_on_classes{120, 0, 80};
constexpr Rgb k_trace_colour{60, 60, 60};

constexpr std::size_t k_longest_source = 200, k_longest_line = 80;  // letters

/// "Release: North, South" if its areas have names, and few.
std::string release_words(const MapSource& source) {
    constexpr std::size_t k_most = 4, k_longest = 60;  // names; letters
    const Words& words = source.style.words;
    const std::string release = words("Release");
    if (source.release_names.empty() || source.release_names.size() > k_most) return release;
    return elided(valid_utf8(words.labelled(release, joined(source.release_names, ", "))), k_longest);
}

std::vector<render::Outline> outlines_of(const MapSource& source, const MapLayer& layer) {
    const bool classes = !layer.categories.empty();
    std::vector<render::Outline> outlines = source.marks;
    outlines.insert(outlines.end(), layer.exposed.begin(), layer.exposed.end());
    // Buildings or zones of a whole country do not make the flow a dot.
    if (source.extent.grid.columns > 0)
        for (render::Outline& mark : outlines) mark.frames_map = false;
    if (!source.release.empty())
        outlines.push_back({release_words(source), source.release, k_release_colour, 2.5, true});
    if (!source.scar.empty()) {
        outlines.push_back({source.style.words("Observed outline"), source.scar,
                            classes ? k_scar_on_classes : k_scar_colour, 3, false});
    }
    return outlines;
}

std::string own_title(const MapSource& source) {
    constexpr std::size_t k_longest = 120;  // letters: two lines on a small page
    return elided(valid_utf8(source.title), k_longest);
}

/// Author and date, and the logo, whose file has been checked.
render::TitleBlock title_block(const MapStyle& style) {
    render::TitleBlock block;
    block.lines = block_lines(style);
    if (style.logo.empty()) return block;
    gis::Logo logo = gis::read_logo(style.logo, "logo");
    render::Image image;
    image.width = logo.width;
    image.height = logo.height;
    image.rgb = std::move(logo.rgb);
    block.logo = std::make_shared<const render::Image>(std::move(image));
    return block;
}

std::string time_words(double seconds, const Words& words) {
    return "t = " + words.number(number_text(seconds, 6)) + " s";
}

/// Map and view have the same legend and texts.
template <class Spec>
Spec furnished(const MapSource& source, const MapLayer& layer) {
    Spec spec;
    spec.words = source.style.words;
    spec.title = page_title(source, layer.title);
    const std::string scenario = scenario_line(source);
    spec.subtitle = layer.time ? time_words(*layer.time, spec.words) : scenario;
    if (layer.time && !scenario.empty()) spec.subtitle += ", " + scenario;
    spec.legend_title = layer.legend_title.empty() ? layer.title : layer.legend_title;
    spec.unit = unit_sign(layer.unit);
    spec.attribution = map_sources(source);
    spec.source = layer.source;
    if (layer.time) spec.source += ", " + time_words(*layer.time, spec.words);
    spec.palette = layer.palette;
    spec.classes = layer.classes;
    spec.categories = layer.categories;
    if (source.terrain.grid.columns > 0) spec.terrain = &source.terrain;
    if (layer.dots)
        spec.dots = &*layer.dots;
    else
        spec.layer = &layer.values;
    spec.extent = source.extent.grid.columns > 0 ? &source.extent : layer.dots ? &layer.values : nullptr;
    spec.outlines = outlines_of(source, layer);
    if (!layer.notes_alone) spec.side_notes = source.notes;
    spec.side_notes.insert(spec.side_notes.end(), layer.notes.begin(), layer.notes.end());
    spec.convergence_deg = source.convergence_deg;
    spec.crs_label = source.crs_label;
    spec.width = source.style.size.width;
    spec.height = source.style.size.height;
    if (!source.style.background.empty()) {
        spec.background = [path = source.style.background, crs = layer.values.grid.crs_wkt](const Bounds& box,
                                                                                            int width, int height) {
            return gis::warp_picture(path, crs, box, width, height);
        };
    }
    return spec;
}

int pixels_of(double length, double per_inch) {
    return static_cast<int>(std::lround(length / per_inch * k_page_picture_dpi));
}

template <class Spec>
Spec for_page(Spec spec, const MapLayer& layer, double height_mm) {
    spec.width = pixels_of(k_page_picture_width_mm, 25.4);
    spec.height = pixels_of(height_mm, 25.4);
    spec.least_letters = pixels_of(k_page_least_points, 72);
    spec.subtitle.clear();
    spec.side_notes = layer.notes_alone ? std::vector<std::string>{} : layer.notes;
    return spec;
}

/// The files of a page, each in the format of its ending. Its pixels are drawn once, if a format needs them.
class PageFiles {
  public:
    PageFiles(const render::Page& page, const std::string& title, double dots_per_inch)
        : page_(page), title_(title), dots_per_inch_(dots_per_inch) {}

    const render::Image& pixels() {
        if (!pixels_) pixels_ = page_.paint();
        return *pixels_;
    }
    void write(const std::string& file, const std::optional<gis::PicturePlace>& place) {
        if (file.ends_with(".pdf")) {
            gis::write_pdf(file, render::page_pdf(page_, dots_per_inch_, title_), place);
        } else if (file.ends_with(".svg")) {
            write_file(file, render::page_svg(page_, dots_per_inch_, title_));
        } else {
            render::write_png(file, pixels(), dots_per_inch_);
        }
    }

  private:
    const render::Page& page_;
    const std::string& title_;
    double dots_per_inch_;
    std::optional<render::Image> pixels_;
};

/// Extent of the page if the map continued to its edge.
Bounds ground_of_page(const render::MapLayout& layout) {
    const double metre = layout.metres_per_pixel;
    return {layout.window.west - layout.map.left * metre,
            layout.window.south - (layout.page.bottom - layout.map.bottom) * metre,
            layout.window.east + (layout.page.right - layout.map.right) * metre,
            layout.window.north + layout.map.top * metre};
}

}  // namespace

std::string date_on_maps(const std::optional<std::string>& chosen, const std::string& of_run) {
    if (!chosen) return of_run;
    return *chosen == "none" ? "" : *chosen;
}

std::string scenario_line(const MapSource& source) {
    // A small picture has no room for long sentences; a sheet of paper has.
    const double letters = static_cast<double>(source.style.size.width) * source.style.size.height / 4000;
    return sentences(
        source.scenario.empty() ? source.subtitle : source.scenario,
        warning_line(source.warnings, source.style.words, static_cast<std::size_t>(std::clamp(letters, 40.0, 480.0))));
}

std::string sentences(const std::string& first, const std::string& second) {
    return first.empty() || second.empty() ? first + second : first + (first.ends_with('.') ? "  " : ".  ") + second;
}

std::vector<std::string> block_lines(const MapStyle& style) {
    std::vector<std::string> lines;
    for (const std::string& line : {style.author, style.date})
        if (!line.empty()) lines.push_back(elided(valid_utf8(line), k_longest_line));
    return lines;
}

std::string page_title(const MapSource& source, const std::string& shown) {
    return source.style.words.labelled(own_title(source), shown);
}

std::string map_sources(const MapSource& source) {
    const std::string own = std::string(k_program) + " " + k_version;
    const Words& words = source.style.words;
    std::vector<std::string> parts;
    if (!source.terrain_source.empty())
        parts.push_back(words.labelled(words("Terrain"), elided(valid_utf8(source.terrain_source), k_longest_source)));
    const auto add_file = [&](const std::string& label, const std::string& file) {
        const std::string name = std::filesystem::path(file).filename().string();
        if (!file.empty()) parts.push_back(words.labelled(words(label), elided(valid_utf8(name), k_longest_source)));
    };
    add_file(worded("Base map"), source.style.background);
    add_file(worded("Surroundings"), source.style.context);
    if (const std::string by = page_attribution(source); !by.empty()) parts.push_back(by);
    parts.push_back(own);
    return joined(parts, "; ");
}

std::string page_attribution(const MapSource& source) {
    constexpr std::size_t k_longest = 400;
    return elided(valid_utf8(source.style.attribution), k_longest);
}

std::string map_subtitle(const MapFacts& facts, const Words& words) {
    const std::string model = facts.model.empty()           ? std::string("?")
                              : facts.model == "structured" ? words("Structured model")
                                                            : voellmy_bingham_words(facts.scheme);
    return model + ", t = " + words.number(number_text(facts.simulated_seconds, 3)) + " s";
}

std::vector<std::string> map_notes(const MapFacts& facts, const Words& words) {
    const auto whole = [&](double value) { return words.number(grouped(value)); };
    std::vector<std::string> notes{words.labelled(words("Volume"), whole(facts.volume) + " m³")};
    if (const auto& statistics = facts.statistics) {
        const Runout& run_out = statistics->run_out();
        const std::size_t flows = statistics->run_outs.size();
        const std::string deeper = " (> " + words.number(number_text(statistics->threshold, 3)) + " m)",
                          longest = flows > 1 ? " " + words("(longest of {1} flows)", {std::to_string(flows)}) : "";
        notes.insert(
            notes.end(),
            {words.labelled(words("Covered area") + deeper, whole(statistics->covered_area_m2) + " m²"),
             words.labelled(words("Run-out"), whole(run_out.horizontal_m) + " m" + longest),
             words.labelled(words("Drop"), whole(run_out.drop_m) + " m"),
             words.labelled(words("Angle of reach"), words.number(number_text(run_out.reach_angle_deg, 3)) + "°")});
    }
    // Warnings on the map itself, since maps are passed on without the log.
    if (facts.statistics && facts.statistics->end && facts.statistics->end->is_cut_short)
        notes.push_back(words("Still moving at the end"));
    if (facts.statistics && facts.statistics->end && facts.statistics->end->is_held)
        notes.push_back(words("Stopped by no-data"));
    if (facts.volume_left > 0)
        notes.push_back(words.labelled(words("Left the domain"), whole(facts.volume_left) + " m³"));
    return notes;
}

namespace {

/// Along the flow where that shows it a quarter larger, else north up.
MapTurn turn_for(render::MapSpec spec, const std::optional<bool>& upright) {
    const auto shorter_side = [&](const MapTurn& turn) {  // of the ground on the page [m]
        spec.turn = turn;
        const Bounds shown = render::required_window(spec);
        const double standing = std::max(shown.width(), shown.height() / std::numbers::sqrt2),
                     lying = std::max(shown.width() / std::numbers::sqrt2, shown.height());
        return !upright ? std::min(standing, lying) : *upright ? standing : lying;
    };
    constexpr double k_worth_it = 1.25;
    const MapTurn along = render::turn_along_content(spec, upright);
    return shorter_side({}) > k_worth_it * shorter_side(along) ? along : MapTurn{};
}

}  // namespace

render::MapSpec map_spec(const MapSource& source, const MapLayer& layer) {
    render::MapSpec spec = furnished<render::MapSpec>(source, layer);
    if (layer.is_ground) {
        spec.layer_frames_map = source.extent.grid.columns == 0;
        if (!source.trace.empty())
            spec.outlines.push_back({spec.words("Covered area"), source.trace, k_trace_colour, 2, false});
    }
    spec.print = {source.style.size.dots_per_inch, source.style.size.paper, source.style.scale};
    spec.block = title_block(source.style);
    spec.series = render::SeriesText{own_title(source), scenario_line(source), source.notes};
    spec.longitude_latitude = source.longitude_latitude;
    const Size& wanted = source.style.size;
    const auto upright = wanted.turns ? std::nullopt : std::optional(wanted.height > wanted.width);
    spec.turn = source.style.turn_deg ? MapTurn(*source.style.turn_deg) : turn_for(spec, upright);
    const Bounds shown = render::required_window(spec);
    const Size size = size_for_ground(source.style.size, shown.width(), shown.height());
    spec.width = size.width;
    spec.height = size.height;
    spec.print.sheet = size.paper;
    return spec;
}

render::MapSpec page_map_spec(const MapSource& source, const MapLayer& layer, double height_mm) {
    render::MapSpec spec = for_page(map_spec(source, layer), layer, height_mm);
    spec.print = {k_page_picture_dpi, "", std::nullopt};
    spec.series = render::SeriesText{spec.series->title, "", {}, false};
    return spec;
}

render::MapSpec unprinted(render::MapSpec spec) {
    spec.print = {};
    spec.block = {};
    spec.series.reset();
    return spec;
}

std::function<Point(Point)> longitude_latitude(const std::string& crs_wkt) {
    if (crs_wkt.empty()) return {};
    const auto transform =
        std::make_shared<const gis::CrsTransform>(crs_wkt, gis::crs_from_user("EPSG:4326", "EPSG:4326"));
    return [transform](Point map) { return (*transform)(map); };
}

render::ViewSpec view_spec(const MapSource& source, const MapLayer& layer) {
    if (source.terrain.grid.columns == 0)
        throw Error(ErrorKind::input, Problem{"is missing in the result, and a view needs a terrain",
                                              raster_file(RasterName::dtm), "", "", "Restore it, or draw maps"});
    render::ViewSpec spec = furnished<render::ViewSpec>(source, layer);
    spec.vertical_exaggeration = source.style.exaggeration;
    spec.camera = source.style.camera;
    spec.sky = source.style.sky;
    std::erase_if(spec.outlines, [](const render::Outline& one) { return one.polygons.empty() && one.lines.empty(); });
    if (layer.is_surface && !layer.is_normal_depth) spec.thickness = spec.layer;
    return spec;
}

std::vector<std::string> picture_files(const MapStyle& style, const std::string& stem) {
    std::vector<std::string> files;
    for (const std::string& format : style.formats) files.push_back(stem + "." + format);
    return files;
}

std::vector<std::string> write_plain_picture(const render::Page& page, const MapStyle& style, const std::string& title,
                                             const std::string& stem) {
    const std::vector<std::string> files = picture_files(style, stem);
    PageFiles writer(page, title, style.size.dots_per_inch);
    for (const std::string& file : files) writer.write(file, std::nullopt);
    return files;
}

render::Page LayerDrawer::map_page(render::MapSpec& spec, render::MapLayout& layout) {
    if (next_scale_) spec.print.scale = next_scale_;
    try {
        return maps_.draw(spec, &layout);
    } catch (const Error& error) {
        if (!warn_ || !spec.print.scale || error.kind() != ErrorKind::input) throw;
        const render::FittingScale fits = render::fitting_scale(spec);
        if (fits.least <= *spec.print.scale) throw;
        warn_(worded("output.map-scale = {1} does not hold the flow; drawn at {2}",
                     {shortest_text(*source_.style.scale), numeral("1 : " + grouped(fits.round))}));
        spec.print.scale = next_scale_ = fits.round;
    }
    return maps_.draw(spec, &layout);
}

std::vector<std::string> LayerDrawer::draw_map(const MapLayer& layer, const std::vector<std::string>& files) {
    render::MapSpec spec = map_spec(source_, layer);
    render::MapLayout layout;
    const render::Page page = map_page(spec, layout);
    const std::string& crs = layer.values.grid.crs_wkt;
    PageFiles writer(page, spec.title, source_.style.size.dots_per_inch);
    for (const std::string& file : files)
        writer.write(file, gis::PicturePlace{ground_of_page(layout), layout.window, crs, layout.turn});
    return files;
}

std::vector<std::string> LayerDrawer::draw(const MapLayer& layer, bool view_3d, const std::string& stem) {
    if (!page_folder_.empty())
        draw_for_page(layer, view_3d, page_folder_ + "/" + std::filesystem::path(stem).filename().string() + ".png");
    if (source_.style.formats.empty()) return {};
    if (!view_3d) return draw_map(layer, picture_files(source_.style, stem));
    const render::ViewSpec spec = view_spec(source_, layer);
    return write_plain_picture(views_.draw(spec), source_.style, spec.title, stem);
}

void LayerDrawer::draw_for_page(const MapLayer& layer, bool view_3d, const std::string& file) {
    const auto write = [&](const render::Page& page) { render::write_png(file, page.paint(), k_page_picture_dpi); };
    for (const double& height_mm : k_page_picture_heights_mm) {
        const bool is_first = &height_mm == std::begin(k_page_picture_heights_mm),
                   is_last = &height_mm == std::end(k_page_picture_heights_mm) - 1;
        try {
            if (view_3d) return write(views_.draw(for_page(view_spec(source_, layer), layer, height_mm)));
            const render::MapSpec spec = page_map_spec(source_, layer, height_mm);
            const Bounds shown = render::required_window(spec);
            if (is_first && shown.height() > shown.width()) continue;  // a low page would show a tall flow small
            return write(page_maps_.draw(spec));
        } catch (const Error& error) {
            if (error.kind() != ErrorKind::input || is_last) throw;
        }
    }
}

}  // namespace frana::app
