// SPDX-License-Identifier: Apache-2.0
#include "app/publish/publish_project.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/pictures/map_layer.h"
#include "app/pictures/map_source.h"
#include "app/pictures/result_reader.h"
#include "app/store/result_files.h"
#include "app/store/vector_layers.h"
#include "app/text/number_text.h"
#include "app/text/text_file.h"
#include "core/error.h"
#include "gis/raster/qgis_project.h"
#include "gis/raster/raster_out.h"
#include "gis/raster/styles.h"
#include "gis/vector/vector_in.h"
#include "params/grammar/value_text.h"
#include "params/keys/result_rasters.h"
#include "render/map/map_ground.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

constexpr double k_millisecond = 1e-3;              // the step of QGIS's times, whose ranges contain their ends
const char* const k_shown = RasterName::max_depth;  // the map that is visible at first; of a study the first map

/// The rasters that frames have.
std::vector<const ResultRaster*> frame_rasters(const ResultReader& result) {
    std::vector<const ResultRaster*> rows;
    if (!result.has(k_frame_list)) return rows;
    for (const ResultRaster& row : result_rasters())
        if ((row.kind == ResultRaster::Kind::frame || row.in_frames) &&
            fs::exists(result.frames().front().raster_file(row.name)))
            rows.push_back(&row);
    return rows;
}

class ProjectWriter {
  public:
    ProjectWriter(const std::string& folder, const std::string& title) : result_(folder), title_(title) {}

    void write() {
        gis::QgisProject project{title_, result_.grid().crs_wkt, result_.grid().bounds(), {}, frame_step()};
        const gis::ProjectGroup lines = outlines(), rasters = maps();
        for (const gis::ProjectGroup& group : {lines, rasters})
            if (!group.layers.empty()) project.groups.push_back(group);
        // A layer for each frame: of depth alone, else they hide the maps among them.
        for (const ResultRaster* row : frame_rasters(result_))
            if (row->name == "depth") project.groups.push_back(frames(*row));
        if (result_.has(raster_file(RasterName::dtm)))
            project.groups.push_back({words_("Terrain"),
                                      {{named(words_("Terrain")),
                                        raster_file(RasterName::dtm),
                                        "",
                                        gis::Shape::area,
                                        gis::relief_style(RasterName::dtm, words_("Terrain")).qml,
                                        true,
                                        {},
                                        source_.terrain_source}}});
        add_layouts(lines, rasters, project);
        gis::write_qgis_project(result_.path(k_project_file), project);
    }

  private:
    /// Layers of several runs may be in one project: the name of each contains that of its run.
    [[nodiscard]] std::string named(const std::string& what) const { return what + " – " + title_; }

    [[nodiscard]] gis::ProjectGroup outlines() const {
        gis::ProjectGroup group{named(words_("Outlines")), {}};
        for (const VectorLayer& row : vector_layers()) {
            if (!result_.has_layer(row.file, row.name)) continue;
            // Of two surveys that of the later comparison.
            if (row.file == k_outlines_file && result_.has_layer(k_comparison_outline, row.name)) continue;
            const bool visible = row.file == k_outlines_file || row.file == k_comparison_outline ||
                                 row.file == k_gauge_places || row.file == k_exposure_file;
            group.layers.push_back({named(layer_title(row, words_)),
                                    row.file,
                                    row.name,
                                    row.shape,
                                    style_in(row, words_).qml,
                                    visible,
                                    {}});
        }
        return group;
    }

    [[nodiscard]] gis::ProjectGroup maps() const {
        gis::ProjectGroup group{named(words_("Maps")), {}};
        for (const auto& [file, title] : {std::pair{k_degree_zones_file, worded("Degree of hazard")},
                                          std::pair{k_hazard_zones_file, worded("Intensity")}})
            if (result_.has(file))
                group.layers.push_back({named(words_(title)),
                                        file,
                                        fs::path(file).stem().string(),
                                        gis::Shape::area,
                                        style_beside(file),
                                        false,
                                        {}});
        const std::vector<std::string> names = result_.drawable();
        const bool has_shown = std::find(names.begin(), names.end(), k_shown) != names.end();
        for (const std::string& name : names) {
            const ResultRaster& row = *find_result_raster(name);
            std::string title = with_unit(raster_title(row, name, words_), row.unit);
            if (row.kind == ResultRaster::Kind::classes) {
                const gis::RasterText text = gis::read_raster_text(result_.path(raster_file(name)));
                if (const auto own = text.metadata.find("HAZARD_TITLE"); own != text.metadata.end() && name == "hazard")
                    title = words_(own->second);
                const std::string scheme = scheme_title(text.metadata, words_of_scheme(text.metadata, words_));
                if (!scheme.empty()) title += ", " + scheme;
            }
            const bool visible = has_shown ? name == k_shown : name == names.front();
            group.layers.push_back(
                {named(title), raster_file(name), "", gis::Shape::area, style_beside(raster_file(name)), visible, {}});
        }
        return group;
    }

    /// A sheet for each map, of the scene's paper or A4, upright or not: as the flow fits at the greater scale, or by
    /// its shape.
    void add_layouts(const gis::ProjectGroup& lines, const gis::ProjectGroup& rasters, gis::QgisProject& project) {
        render::MapSpec content;
        if (source_.terrain.grid.columns > 0) content.terrain = &source_.terrain;
        if (source_.extent.grid.columns > 0) content.extent = &source_.extent;
        for (const MultiPolygon& area : {source_.release, source_.scar})
            content.outlines.push_back({"", area, {}, 1, false});
        if (content.terrain == nullptr && content.extent == nullptr) content.window = result_.grid().bounds();
        const Bounds shown = render::required_window(content);
        gis::ProjectLayout sheet;
        sheet.sheet = source_.style.size.paper.starts_with("A3") ? "A3" : "A4";
        sheet.subtitle = scenario_line(source_);
        sheet.notes = joined(source_.notes, "\n") + '\n' + source_.crs_label;
        sheet.title_block = joined(block_lines(source_.style), "\n");
        sheet.logo = source_.style.logo;
        sheet.sources = map_sources(source_);
        sheet.thousands = row_of(words_.language()).thousands;
        std::vector<gis::ProjectLayout> sheets;
        for (const gis::ProjectLayer& map : rasters.layers) {
            if (!map.layer.empty()) continue;  // zones: their raster has a sheet
            sheets.push_back(sheet_of(map, sheet, lines, project.groups.back()));
        }
        if (sheets.empty()) return;
        const auto turned = [&](bool portrait) {
            for (gis::ProjectLayout& one : sheets) one.portrait = portrait;
            return window_on(sheets, content);
        };
        const auto [across, across_scale] = turned(false);
        const auto [upright, upright_scale] = turned(true);
        const bool portrait = std::pair(upright_scale, shown.width()) < std::pair(across_scale, shown.height());
        for (gis::ProjectLayout& one : sheets) {
            one.portrait = portrait;
            one.window = portrait ? upright : across;
        }
        project.layouts = std::move(sheets);
    }

    /// The sheet of one map: what it shows, from the uppermost down to the relief.
    [[nodiscard]] gis::ProjectLayout sheet_of(const gis::ProjectLayer& map, gis::ProjectLayout sheet,
                                              const gis::ProjectGroup& lines, const gis::ProjectGroup& lowest) const {
        const std::string of_run = named("");
        const auto show = [&](const gis::ProjectLayer& layer, bool in_legend) {
            const std::string title = layer.title.substr(0, layer.title.size() - of_run.size());
            // Points and areas of one file look the same.
            const bool told = std::find(sheet.legend.begin(), sheet.legend.end(), title) != sheet.legend.end();
            sheet.layers.push_back(layer.title);
            sheet.legend.push_back(in_legend && !told ? title : "");
            sheet.classes.push_back(gis::legend_labels(layer.style));
        };
        for (const gis::ProjectLayer& line : lines.layers)
            if (line.visible) show(line, true);
        show(map, true);
        sheet.title = page_title(source_, sheet.legend.back());
        for (const std::string& note : needed_notes(result_.path(map.file), words_)) sheet.notes += '\n' + note;
        const gis::ProjectLayer& ground = lowest.layers.front();
        if (ground.file == raster_file(RasterName::dtm)) show(ground, false);
        return sheet;
    }

    /// Returns the ground in the sheets' frame, and n of 1 : n: the least round one, or the scene's if that is greater.
    [[nodiscard]] std::pair<Bounds, double> window_on(const std::vector<gis::ProjectLayout>& sheets,
                                                      render::MapSpec content) const {
        constexpr double k_pixels = 10;  // per mm
        const Point frame = gis::frame_of(sheets);
        const auto at_scale = [&](std::optional<double> scale) {
            content.print = {k_pixels * 25.4, sheets.front().sheet, scale};
            const Bounds ground = render::map_window(content, static_cast<int>(std::lround(k_pixels * frame.x)),
                                                     static_cast<int>(std::lround(k_pixels * frame.y)));
            return std::pair{ground, ground.width() / frame.x * 1000};
        };
        const auto least = at_scale(std::nullopt);
        return source_.style.scale.value_or(0) > least.second ? at_scale(source_.style.scale) : least;
    }

    /// Of the controller [s]: what the scene asks for.
    [[nodiscard]] double frame_step() const {
        const double asked = result_.scene_number("time.frame-interval", 0);
        return asked > 0 ? asked : 1;
    }

    /// When each frame is shown [s]: from its time, which is that of the first time step after a multiple of the
    /// controller's step, to the next multiple, so that the controller shows one frame at a time. The last one, at the
    /// end of the run, has a step of its own.
    [[nodiscard]] std::vector<std::pair<double, double>> shown_times() const {
        const double step = frame_step();
        std::vector<double> multiples;
        for (const StoredFrame& frame : result_.frames()) {
            const double own = std::floor(frame.time / step + 1e-9);
            multiples.push_back(multiples.empty() ? own : std::max(own, multiples.back() + 1));
        }
        std::vector<std::pair<double, double>> times;
        for (std::size_t i = 0; i < multiples.size(); ++i) {
            const double next = i + 1 < multiples.size() ? multiples[i + 1] : multiples[i] + 1;
            const double begin = multiples[i] == 0 ? 0 : multiples[i] * step + k_millisecond;
            times.emplace_back(std::max(result_.frames()[i].time, begin), next * step - k_millisecond);
        }
        return times;
    }

    /// Hidden, since all are visible until QGIS's temporal controller runs.
    [[nodiscard]] gis::ProjectGroup frames(const ResultRaster& row) const {
        gis::ProjectGroup group{named(words_(row.title) + ", t [s]"), {}, false, false};
        const std::vector<StoredFrame>& all = result_.frames();
        const std::string style = style_beside(frame_style(row.name) + ".tif");
        const std::vector<std::pair<double, double>> times = shown_times();
        for (std::size_t i = 0; i < all.size(); ++i) {
            const std::string file =
                std::string(k_frame_folder) + "/" + fs::path(all[i].raster_file(row.name)).filename().string();
            group.layers.push_back({named(with_unit(words_(row.title), row.unit) + ", " +
                                          words_.number(number_text(all[i].time, 6)) + " s"),
                                    file, "", gis::Shape::area, style, true, times[i]});
        }
        return group;
    }

    [[nodiscard]] std::string style_beside(const std::string& file) const {
        const std::string path = fs::path(result_.path(file)).replace_extension(".qml").string();
        std::string style = read_text_file(path);
        if (style.empty() && fs::exists(path))  // else QGIS would show the layer in grey
            throw Error(ErrorKind::environment, Problem{"the style cannot be read", path, "", "", "Check the rights"});
        return style;
    }

    ResultReader result_;
    Words words_ = result_.words();
    std::string title_;
    MapSource source_ = result_.map_source();
};

}  // namespace

void publish_project(const std::string& folder, const std::string& title) {
    ProjectWriter(folder, title).write();
}

void publish_frame_styles(const std::string& folder) {
    const ResultReader result(folder);
    for (const ResultRaster* row : frame_rasters(result))
        gis::write_styles(
            result.path(frame_style(row->name) + ".tif"),
            gis::class_stops(palette(row->palette), result.greatest(row->name).classes, row->unit, result.words()),
            row->unit, gis::StyleKind::classed, result.words()(row->title));
}

}  // namespace frana::app
