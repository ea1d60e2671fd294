// SPDX-License-Identifier: Apache-2.0
#include "app/publish/publish_project.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "app/pictures/map_layer.h"
#include "app/pictures/result_reader.h"
#include "app/store/result_files.h"
#include "app/store/vector_layers.h"
#include "app/text/number_text.h"
#include "gis/raster/qgis_project.h"
#include "gis/raster/raster_out.h"
#include "gis/raster/styles.h"
#include "gis/vector/vector_in.h"
#include "params/keys/result_rasters.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

constexpr double k_millisecond = 1e-3;    // the step of QGIS's times, whose ranges contain their ends
const char* const k_shown = "max_depth";  // the map that is visible at first; of a study the first map

std::string text_of_file(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

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

std::string titled_with_unit(const std::string& title, const std::string& unit) {
    return unit.empty() || unit == "-" ? title : title + " [" + unit + "]";
}

class ProjectWriter {
  public:
    ProjectWriter(const std::string& folder, const std::string& title) : result_(folder), title_(title) {}

    void write() {
        gis::QgisProject project{title_, result_.grid().crs_wkt, result_.grid().bounds(), {}, frame_step()};
        for (const gis::ProjectGroup& group : {outlines(), maps()})
            if (!group.layers.empty()) project.groups.push_back(group);
        for (const ResultRaster* row : frame_rasters(result_)) project.groups.push_back(frames(*row));
        if (result_.has(raster_file("dtm")))
            project.groups.push_back({words_("Terrain"),
                                      {{named(words_("Terrain")),
                                        raster_file("dtm"),
                                        "",
                                        gis::Shape::area,
                                        gis::relief_style("dtm", words_("Terrain")).qml,
                                        true,
                                        {}}}});
        gis::write_qgis_project(result_.path(k_project_file), project);
    }

  private:
    /// Layers of several runs may be in one project: the name of each contains that of its run.
    [[nodiscard]] std::string named(const std::string& what) const { return what + " – " + title_; }

    [[nodiscard]] gis::ProjectGroup outlines() const {
        gis::ProjectGroup group{named(words_("Outlines")), {}};
        for (const VectorLayer& row : vector_layers()) {
            if (!result_.has_layer(row.file, row.name)) continue;
            const bool visible =
                row.file == k_outlines_file || row.file == k_gauge_places || row.file == k_exposure_file;
            group.layers.push_back(
                {named(words_(row.title)), row.file, row.name, row.shape, style_in(row, words_).qml, visible, {}});
        }
        return group;
    }

    [[nodiscard]] gis::ProjectGroup maps() const {
        gis::ProjectGroup group{named(words_("Maps")), {}};
        for (const auto& [file, title] : {std::pair{k_degree_zones_file, worded("Zones of hazard")},
                                          std::pair{k_hazard_zones_file, worded("Zones of intensity")}})
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
            std::string title = titled_with_unit(raster_title(row, name, words_), row.unit);
            if (row.kind == ResultRaster::Kind::classes) {
                const gis::RasterText text = gis::read_raster_text(result_.path(raster_file(name)));
                if (const auto own = text.metadata.find("HAZARD_TITLE"); own != text.metadata.end() && name == "hazard")
                    title = words_(own->second);
                const std::string scheme = scheme_title(text.metadata, words_of_scheme(text.metadata, words_));
                if (!scheme.empty()) title = words_("{1}, scheme {2}", {title, scheme});
            }
            const bool visible = has_shown ? name == k_shown : name == names.front();
            group.layers.push_back(
                {named(title), raster_file(name), "", gis::Shape::area, style_beside(raster_file(name)), visible, {}});
        }
        return group;
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
        gis::ProjectGroup group{named(words_("{1} over time", {words_(row.title)})), {}, false, false};
        const std::vector<StoredFrame>& all = result_.frames();
        const std::string style = style_beside(frame_style(row.name) + ".tif");
        const std::vector<std::pair<double, double>> times = shown_times();
        for (std::size_t i = 0; i < all.size(); ++i) {
            const std::string file =
                std::string(k_frame_folder) + "/" + fs::path(all[i].raster_file(row.name)).filename().string();
            group.layers.push_back({named(titled_with_unit(words_(row.title), row.unit) + ", " +
                                          words_.number(number_text(all[i].time, 6)) + " s"),
                                    file, "", gis::Shape::area, style, true, times[i]});
        }
        return group;
    }

    [[nodiscard]] std::string style_beside(const std::string& file) const {
        return text_of_file(fs::path(result_.path(file)).replace_extension(".qml").string());
    }

    ResultReader result_;
    Words words_ = result_.words();
    std::string title_;
};

}  // namespace

void publish_project(const std::string& folder, const std::string& title) {
    ProjectWriter(folder, title).write();
}

void publish_frame_styles(const std::string& folder) {
    const ResultReader result(folder);
    for (const ResultRaster* row : frame_rasters(result)) {
        // Only classes up to the maximum need the values.
        const ClassSpec chosen = result.classes();
        const bool known = !row->bounds.empty() || (chosen.fixed && !row->classes.empty());
        const std::vector<double> bounds =
            known ? class_bounds(*row, chosen, 0) : result.map_layer(row->name + "@0").classes;
        gis::write_styles(result.path(frame_style(row->name) + ".tif"),
                          gis::class_stops(palette(row->palette), bounds, row->unit, result.words()), row->unit,
                          gis::StyleKind::classed, result.words()(row->title));
    }
}

}  // namespace frana::app
