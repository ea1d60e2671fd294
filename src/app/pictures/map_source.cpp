// SPDX-License-Identifier: Apache-2.0
#include "app/pictures/map_source.h"

#include <algorithm>
#include <filesystem>
#include <memory>

#include "app/store/result_files.h"
#include "app/store/vector_layers.h"
#include "app/text/number_text.h"
#include "app/text/version.h"
#include "core/error.h"
#include "core/file_aside.h"
#include "core/utf8.h"
#include "gis/crs/crs.h"
#include "gis/crs/crs_transform.h"
#include "gis/raster/logo_in.h"
#include "gis/raster/picture_in.h"
#include "gis/raster/picture_out.h"
#include "params/grammar/value_text.h"

namespace frana::app {
namespace {

// A dark red on classes, whose colours are as bright as that of the survey elsewhere.
constexpr Rgb k_scar_on_classes{120, 0, 80};

constexpr std::size_t k_longest_source = 200, k_longest_line = 80;  // letters

/// "Release: North, South" if its areas have names, and few.
std::string release_words(const MapSource& source) {
    constexpr std::size_t k_most = 4, k_longest = 60;  // names; letters
    if (source.release_names.empty() || source.release_names.size() > k_most) return "Release";
    std::string words = "Release: ";
    for (std::size_t i = 0; i < source.release_names.size(); ++i)
        words += (i > 0 ? ", " : "") + source.release_names[i];
    return elided(valid_utf8(words), k_longest);
}

std::vector<render::Outline> outlines_of(const MapSource& source, bool classes) {
    std::vector<render::Outline> outlines = source.marks;
    if (!source.release.empty())
        outlines.push_back({release_words(source), source.release, k_release_colour, 2.5, true});
    if (!source.scar.empty()) {
        outlines.push_back({"Observed outline", source.scar, classes ? k_scar_on_classes : k_scar_colour, 3, false});
    }
    return outlines;
}

std::string attribution(const MapSource& source) {
    const std::string own =
        std::string(source.foreign ? "Drawn with " : "Simulated with ") + k_program + " " + k_version;
    std::vector<std::string> parts;
    if (!source.terrain_source.empty())
        parts.push_back("Terrain: " + elided(valid_utf8(source.terrain_source), k_longest_source));
    if (!source.style.background.empty()) {
        const std::string& licence = source.style.background_licence;
        const std::string file = std::filesystem::path(source.style.background).filename().string();
        parts.push_back("Base map: " + elided(valid_utf8(licence.empty() ? file : licence), k_longest_source));
    }
    if (const std::string by = page_attribution(source); !by.empty()) parts.push_back(by);
    parts.push_back(own);
    return joined(parts, "; ");
}

/// Organisation, author and date, and the logo, whose file has been checked.
render::TitleBlock title_block(const MapStyle& style) {
    render::TitleBlock block;
    for (const std::string& line : {style.organisation, style.author, style.date})
        if (!line.empty()) block.lines.push_back(elided(valid_utf8(line), k_longest_line));
    if (style.logo.empty()) return block;
    gis::Logo logo = gis::read_logo(style.logo, "logo");
    render::Image image;
    image.width = logo.width;
    image.height = logo.height;
    image.rgb = std::move(logo.rgb);
    block.logo = std::make_shared<const render::Image>(std::move(image));
    return block;
}

std::string time_words(double seconds) {
    return "t = " + number_text(seconds, 6) + " s";
}

/// Map and view have the same legend and texts.
template <class Spec>
Spec furnished(const MapSource& source, const MapLayer& layer) {
    Spec spec;
    spec.title = page_title(source, layer.title);
    const std::string& scenario = source.scenario.empty() ? source.subtitle : source.scenario;
    spec.subtitle = layer.time ? time_words(*layer.time) : scenario;
    if (layer.time && !scenario.empty()) spec.subtitle += ", " + scenario;
    spec.legend_title = layer.title;
    spec.unit = layer.unit;
    spec.attribution = attribution(source);
    spec.source = layer.source;
    if (layer.time) spec.source += ", " + time_words(*layer.time);
    spec.palette = layer.palette;
    spec.classes = layer.classes;
    spec.categories = layer.categories;
    spec.continuous = source.style.continuous && layer.categories.empty();
    if (source.terrain.grid.columns > 0) spec.terrain = &source.terrain;
    if (layer.dots)
        spec.dots = &*layer.dots;
    else
        spec.layer = &layer.values;
    spec.extent = source.extent.grid.columns > 0 ? &source.extent : layer.dots ? &layer.values : nullptr;
    spec.outlines = outlines_of(source, !layer.categories.empty());
    if (!layer.notes_alone) spec.side_notes = source.notes;
    spec.side_notes.insert(spec.side_notes.end(), layer.notes.begin(), layer.notes.end());
    spec.convergence_deg = source.convergence_deg;
    spec.crs_label = source.crs_label;
    spec.width = source.style.size.width;
    spec.height = source.style.size.height;
    if (!source.style.background.empty()) {
        spec.background = [path = source.style.background, crs = layer.values.grid.crs_wkt](const Bounds& box,
                                                                                            int width, int height) {
            return render::OverlayImage{width, height, gis::warp_picture(path, crs, box, width, height)};
        };
    }
    return spec;
}

gis::PicturePixels pixels(const render::Image& image) {
    return {image.width, image.height, image.rgb};
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

/// Returns the part inside the map's frame.
render::Image face_of(const render::Image& page, const render::PageBox& map) {
    const int left = static_cast<int>(map.left), top = static_cast<int>(map.top);
    render::Image face(static_cast<int>(map.width()), static_cast<int>(map.height()));
    for (int row = 0; row < face.height; ++row)
        std::copy_n(page.pixel(left, top + row), 3 * face.width, face.pixel(0, row));
    return face;
}

}  // namespace

std::string date_on_maps(const std::optional<std::string>& chosen, const std::string& of_run) {
    if (!chosen) return of_run;
    return *chosen == "none" ? "" : *chosen;
}

std::string page_title(const MapSource& source, const std::string& shown) {
    constexpr std::size_t k_longest = 120;  // letters: two lines on a small page
    return elided(valid_utf8(source.title), k_longest) + ": " + shown;
}

std::string page_attribution(const MapSource& source) {
    constexpr std::size_t k_longest = 400;
    return elided(valid_utf8(source.style.attribution), k_longest);
}

std::string map_subtitle(const MapFacts& facts) {
    const std::string model = facts.model.empty()           ? "Model unknown"
                              : facts.model == "structured" ? "Structured model"
                                                            : "Voellmy-Bingham, scheme " + facts.scheme;
    return model + ", " + number_text(facts.simulated_seconds, 3) + " s simulated";
}

std::vector<std::string> map_notes(const MapFacts& facts) {
    std::vector<std::string> notes{"Volume " + grouped(facts.volume) + " m³"};
    if (const auto& statistics = facts.statistics) {
        const Runout& run_out = statistics->run_out();
        const std::size_t flows = statistics->run_outs.size();
        notes.insert(notes.end(),
                     {"Covered " + grouped(statistics->covered_area_m2) + " m²",
                      "(deeper than " + number_text(statistics->threshold, 3) + " m)",
                      "Run-out " + grouped(run_out.horizontal_m) + " m", "Drop " + grouped(run_out.drop_m) + " m",
                      "Angle of reach " + number_text(run_out.reach_angle_deg, 3) + "°"});
        if (flows > 1) notes.push_back("(longest of " + std::to_string(flows) + " flows)");
    }
    // Warnings on the map itself, since maps are passed on without the log.
    if (facts.last_speed > k_moving_speed) notes.emplace_back("Still moving at the end");
    if (facts.volume_left > 0) notes.push_back(grouped(facts.volume_left) + " m³ left the map");
    return notes;
}

render::MapSpec map_spec(const MapSource& source, const MapLayer& layer) {
    render::MapSpec spec = furnished<render::MapSpec>(source, layer);
    spec.inset = true;
    spec.print = {source.style.size.dots_per_inch, source.style.size.paper, source.style.scale};
    spec.block = title_block(source.style);
    spec.series = render::SeriesText{page_title(source, ""),
                                     source.scenario.empty() ? source.subtitle : source.scenario, source.notes};
    // "Scene: " without what is shown.
    if (spec.series->title.ends_with(": ")) spec.series->title.resize(spec.series->title.size() - 2);
    spec.longitude_latitude = source.longitude_latitude;
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
                                              raster_file("dtm"), "", "", "Restore it, or draw maps"});
    render::ViewSpec spec = furnished<render::ViewSpec>(source, layer);
    spec.vertical_exaggeration = source.style.exaggeration;
    spec.camera = source.style.camera;
    spec.sky = source.style.sky;
    std::erase_if(spec.outlines, [](const render::Outline& one) { return one.polygons.empty() && one.lines.empty(); });
    if (layer.is_surface) spec.thickness = spec.layer;
    return spec;
}

std::vector<std::string> picture_files(const MapStyle& style, const std::string& stem, bool is_on_ground,
                                       const std::string& tif_stem) {
    std::vector<std::string> files;
    for (const std::string& format : style.formats) {
        const bool is_tif = format == "tif";
        if (is_on_ground || !is_tif) files.push_back((is_tif && !tif_stem.empty() ? tif_stem : stem) + "." + format);
    }
    return files;
}

std::vector<std::string> write_plain_picture(const render::Page& page, const MapStyle& style, const std::string& title,
                                             const std::string& stem) {
    const std::vector<std::string> files = picture_files(style, stem, false);
    PageFiles writer(page, title, style.size.dots_per_inch);
    for (const std::string& file : files) writer.write(file, std::nullopt);
    return files;
}

std::vector<std::string> LayerDrawer::draw_map(const MapLayer& layer, const std::vector<std::string>& files) {
    const render::MapSpec spec = map_spec(source_, layer);
    render::MapLayout layout;
    const render::Page page = maps_.draw(spec, &layout);
    const std::string& crs = layer.values.grid.crs_wkt;
    PageFiles writer(page, spec.title, source_.style.size.dots_per_inch);
    for (const std::string& file : files) {
        if (!file.ends_with(".tif")) {
            writer.write(file, gis::PicturePlace{ground_of_page(layout), layout.window, crs});
        } else {
            const render::Image face = face_of(writer.pixels(), layout.map);
            gis::write_picture_geotiff(
                file, pixels(face), layout.window, crs,
                {{"TITLE", spec.title}, {"SOURCE", spec.source}, {"ATTRIBUTION", spec.attribution}});
        }
    }
    return files;
}

std::vector<std::string> LayerDrawer::draw(const MapLayer& layer, bool view_3d, const std::string& stem,
                                           const std::string& tif_stem) {
    const std::string for_page = page_picture(stem);
    if (!view_3d) {
        std::vector<std::string> files = picture_files(source_.style, stem, true, tif_stem);
        if (!for_page.empty()) files.push_back(for_page);
        return draw_map(layer, files);
    }
    const render::ViewSpec spec = view_spec(source_, layer);
    const render::Page view = views_.draw(spec);
    if (!for_page.empty()) PageFiles(view, spec.title, source_.style.size.dots_per_inch).write(for_page, std::nullopt);
    return write_plain_picture(view, source_.style, spec.title, stem);
}

std::string LayerDrawer::page_picture(const std::string& stem) const {
    if (page_folder_.empty()) return {};
    return page_folder_ + "/" + std::filesystem::path(stem).filename().string() + ".png";
}

}  // namespace frana::app
