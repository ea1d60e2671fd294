// SPDX-License-Identifier: Apache-2.0
#include "app/publish/publish_pictures.h"

#include <algorithm>
#include <filesystem>
#include <future>
#include <new>
#include <utility>

#include "app/pictures/animation.h"
#include "app/pictures/charts.h"
#include "app/pictures/map_source.h"
#include "app/pictures/result_reader.h"
#include "app/process/terminal.h"
#include "app/publish/map_page.h"
#include "app/store/frame_store.h"
#include "app/store/own_files.h"
#include "app/store/result_files.h"
#include "app/store/scene_identity.h"
#include "app/store/vector_layers.h"
#include "core/error.h"
#include "core/module.h"
#include "params/grammar/value_text.h"
#include "params/keys/result_rasters.h"
#include "params/keys/scene_parameters.h"
#include "render/animation/movie.h"
#include "render/map/map_body.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

std::string title_of(const SceneSpec& spec) {
    return spec.output.title.value_or(scene_name(spec));
}

MapSource map_source(const ResultReader& written, const PictureRequest& request) {
    MapSource source = written.map_source(request.statistics);
    if (!request.date.empty()) source.style.date = date_on_maps(request.spec.output.map_date, request.date);
    source.title = title_of(request.spec);  // the folder does not have its name yet
    if (!request.warnings.empty()) source.warnings = request.warnings;
    return source;
}

/// Draws pictures one after the other.
class Drawings {
  public:
    explicit Drawings(RunLog& log) : log_(log) {}

    /// @param draw returns false if it was stopped before the end
    template <class Draw>
    void attempt(const std::string& what, const Draw& draw) {
        guard(what, [&] {
            if (stop_signal() == 0 && draw())
                log_.note("drew " + what);
            else
                left_out_.push_back(what);
        });
    }
    /// Whatever drawing throws is a warning. Memory and disk may be there for --resume; no other failure goes away.
    template <class Work>
    void guard(const std::string& what, const Work& work) {
        try {
            work();
        } catch (const std::exception& error) {
            log_.warn(worded("{1} could not be drawn: {2}", {what, std::string(error.what())}));
            const auto* const known = dynamic_cast<const Error*>(&error);
            has_failed_ = has_failed_ || dynamic_cast<const std::bad_alloc*>(&error) != nullptr ||
                          (known != nullptr && known->kind() == ErrorKind::environment);
        }
    }
    [[nodiscard]] PictureOutcome outcome() const {
        if (!left_out_.empty())
            log_.warn(worded("left out because of the signal: {1}; --resume draws them", {joined(left_out_, ", ")}));
        return {has_failed_, !left_out_.empty()};
    }

  private:
    RunLog& log_;
    std::vector<std::string> left_out_;
    bool has_failed_ = false;
};

/// Returns "max_depth", "max_depth_3d" and so on, as requested by the scene.
std::vector<std::string> map_choice(const std::vector<std::string>& requested, const ResultReader& written) {
    std::vector<std::string> names;
    for (const std::string& word : requested)
        for (const std::string& name : word == "on" ? usual_maps() : std::vector<std::string>{word})
            if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    // A hazard scheme requests its map.
    if (written.has(raster_file("hazard")) && std::find(names.begin(), names.end(), "hazard") == names.end())
        names.emplace_back("hazard");
    return names;
}

void draw_maps(const std::vector<std::string>& requested, const ResultReader& written, LayerDrawer& drawer,
               Drawings& drawings) {
    if (requested.front() == "off") return;
    for (const std::string& name : map_choice(requested, written)) {
        const std::string layer = raster_of_map(name);
        const bool view_3d = layer != name;
        const ResultRaster* const row = find_result_raster(layer);
        const bool may_lack = std::find(requested.begin(), requested.end(), name) == requested.end() ||
                              (row != nullptr && row->if_it_happens);
        if (may_lack && !written.has(layer + ".tif")) continue;
        const std::string stem = written.path("maps/" + name);
        drawings.attempt("maps/" + name, [&] {
            make_drawing_folder(written.path("maps"));
            drawer.draw(written.map_layer(layer), view_3d, stem);
            return true;
        });
    }
}

void draw_all_charts(const ResultReader& written, const MapSource& source, Drawings& drawings) {
    const std::string folder = written.path("charts");
    drawings.attempt("charts", [&] {
        make_drawing_folder(folder);
        Problems problems;
        draw_charts(written, source, folder, problems);
        problems.throw_if_any();
        return true;
    });
}

/// Draws the film on a thread of its own, beside the maps: it shares nothing with them. Whether it came to its end; an
/// invalid one: there is none to draw.
std::future<bool> begin_animation(const ResultReader& written, const MapSource& source) {
    if (!written.has(k_frame_list) || written.frames().empty()) return {};
    AnimationRequest animation{animation_source(written, source, "depth", animation_size(source.style.size))};
    animation.stop_requested = [] { return stop_signal() != 0; };
    return std::async(std::launch::async, [animation = std::move(animation), path = written.path(k_animation_file)] {
        return write_animation(animation, path);
    });
}

/// Whether a run needs the library that draws pictures.
bool draws(const SceneSpec& scene) {
    const OutputSpec& output = scene.output;
    return output.animation || output.maps.front() != "off";
}

}  // namespace

void load_drawing(bool pictures, bool films, Loading loading) {
    if (pictures) loading == Loading::now ? static_cast<void>(render::vtk()) : require_module("vtk");
    if (films) loading == Loading::now ? static_cast<void>(render::libav()) : require_module("libav");
}

void load_drawing(const SceneSpec& scene, Loading loading) {
    load_drawing(draws(scene), scene.output.animation, loading);
}

std::int64_t drawing_library_bytes(const SceneSpec& scene) {
    constexpr std::int64_t k_vtk_bytes = 66'000'000, k_libav_bytes = 21'000'000;
    return (draws(scene) ? k_vtk_bytes : 0) + (scene.output.animation ? k_libav_bytes : 0);
}

PictureOutcome draw_pictures(const PictureRequest& request, RunLog& log) {
    const OutputSpec& output = request.spec.output;
    Drawings drawings(log);
    const bool maps = output.maps.front() != "off";
    if (!maps && !output.animation && !output.report) return drawings.outcome();
    drawings.guard("the pictures", [&] {
        ResultReader written(request.folder);
        if (request.run != nullptr) written.take_values_of(*request.run);
        const MapSource source = map_source(written, request);
        std::future<bool> film;
        if (output.animation) drawings.guard(k_animation_file, [&] { film = begin_animation(written, source); });
        if (output.report) drawings.guard(k_map_page_file, [&] { write_map_page(written, source); });
        LayerDrawer drawer(source);
        drawer.draw_at_next_scale([&](const Sentence& warning) { log.warn(warning); });
        if (output.report && maps) {
            const std::string folder = written.path(k_page_folder);
            make_drawing_folder(folder);
            drawer.draw_for_page_too(folder);
        }
        draw_maps(output.maps, written, drawer, drawings);
        if (maps && request.comparison && request.comparison->statistics) {
            drawings.attempt("comparison", [&] {
                draw_comparison(*request.comparison, drawer, written.directory());
                return true;
            });
        }
        if (maps && output.charts) draw_all_charts(written, source, drawings);
        if (film.valid()) drawings.attempt(k_animation_file, [&] { return film.get(); });
        if (const auto warning = letter_warning()) log.warn(*warning);
    });
    return drawings.outcome();
}

}  // namespace frana::app
