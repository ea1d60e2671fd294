// SPDX-License-Identifier: Apache-2.0
#include "app/publish/publish_pictures.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <new>
#include <utility>
#include <vector>

#include "app/pictures/animation.h"
#include "app/pictures/charts.h"
#include "app/pictures/map_source.h"
#include "app/pictures/result_reader.h"
#include "app/process/terminal.h"
#include "app/publish/map_page.h"
#include "app/publish/report_answer.h"
#include "app/store/frame_store.h"
#include "app/store/own_files.h"
#include "app/store/result_files.h"
#include "app/store/scene_identity.h"
#include "app/store/vector_layers.h"
#include "core/error.h"
#include "core/module.h"
#include "core/thread_pool.h"
#include "params/grammar/value_text.h"
#include "params/keys/result_rasters.h"
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
    source.one_run = what_one_run_is(request.spec);
    if (!request.warnings.empty()) source.warnings = request.warnings;
    return source;
}

/// What one thread draws, one after the other, and what came of it: the log is not written before all have ended.
class Drawings {
  public:
    /// @param draw returns false if it was stopped before the end
    template <class Draw>
    void attempt(const std::string& what, const Draw& draw) {
        guard(what, [&] {
            if (stop_signal() == 0 && draw())
                notes_.push_back("drew " + what);
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
            warn(worded("{1} could not be drawn: {2}", {what, std::string(error.what())}));
            const auto* const known = dynamic_cast<const Error*>(&error);
            has_failed_ = has_failed_ || dynamic_cast<const std::bad_alloc*>(&error) != nullptr ||
                          (known != nullptr && known->kind() == ErrorKind::environment);
        }
    }
    void warn(const Sentence& warning) { warnings_.push_back(warning); }
    /// Adds what another thread drew.
    void add(const Drawings& other) {
        const auto append = [](auto& to, const auto& more) {
            for (const auto& one : more)
                if (std::find(to.begin(), to.end(), one) == to.end()) to.push_back(one);  // for the report, too
        };
        append(notes_, other.notes_);
        append(warnings_, other.warnings_);
        append(left_out_, other.left_out_);
        has_failed_ = has_failed_ || other.has_failed_;
    }
    [[nodiscard]] PictureOutcome outcome(RunLog& log) const {
        for (const std::string& note : notes_) log.note(note);
        Warnings warnings = warnings_;
        if (!left_out_.empty())
            warnings.push_back(
                worded("left out because of the signal: {1}; --resume draws them", {joined(left_out_, ", ")}));
        return {has_failed_, !left_out_.empty(), log.tell(warnings)};
    }

  private:
    std::vector<std::string> notes_, left_out_;
    Warnings warnings_;
    bool has_failed_ = false;
};

/// What one thread draws from: nothing that another one uses changes.
struct Drawn {
    ResultReader written;
    MapSource source;
    Drawings& drawings;

    Drawn(const PictureRequest& request, const MapSource& common, Drawings& all)
        : written(request.folder), source(common), drawings(all) {
        if (request.run != nullptr) written.take_values_of(*request.run);
        source.longitude_latitude = longitude_latitude(written.grid().crs_wkt);
    }
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

void draw_maps(const std::vector<std::string>& requested, LayerDrawer& drawer, const Drawn& from) {
    for (const std::string& name : map_choice(requested, from.written)) {
        const std::string layer = raster_of_map(name);
        const bool view_3d = layer != name;
        const ResultRaster* const row = find_result_raster(layer);
        const bool may_lack = std::find(requested.begin(), requested.end(), name) == requested.end() ||
                              (row != nullptr && row->if_it_happens);
        if (may_lack && !from.written.has(layer + ".tif")) continue;
        const std::string stem = from.written.path("maps/" + name);
        from.drawings.attempt("maps/" + name, [&] {
            drawer.draw(from.written.map_layer(layer), view_3d, stem);
            return true;
        });
    }
}

/// Draws the maps and the comparison: for themselves, for the report, or both.
void draw_maps(const PictureRequest& request, bool themselves, bool for_report, Drawn&& from) {
    if (!themselves) from.source.style.formats.clear();
    LayerDrawer drawer(from.source);
    drawer.draw_at_next_scale([&](const Sentence& warning) { from.drawings.warn(warning); });
    if (for_report) drawer.draw_for_page_too(from.written.path(k_page_folder));
    draw_maps(request.spec.output.maps, drawer, from);
    if (!request.comparison || !request.comparison->statistics) return;
    from.drawings.attempt("comparison", [&] {
        draw_comparison(*request.comparison, drawer, from.written.directory());
        return true;
    });
}

void draw_all_charts(const Drawn& from) {
    const std::string folder = from.written.path("charts");
    from.drawings.attempt("charts", [&] {
        make_drawing_folder(folder);
        Problems problems;
        draw_charts(from.written, from.source, folder, problems);
        problems.throw_if_any();
        return true;
    });
}

void draw_film(const Drawn& from) {
    if (!from.written.has(k_frame_list) || from.written.frames().empty()) return;
    from.drawings.attempt(k_animation_file, [&] {
        AnimationRequest animation{
            animation_source(from.written, from.source, "depth", animation_size(from.source.style.size))};
        animation.stop_requested = [] { return stop_signal() != 0; };
        return write_animation(animation, from.written.path(k_animation_file));
    });
}

using Job = std::function<void(Drawn&& from)>;

/// What is drawn, the longest first.
std::vector<Job> jobs_of(const PictureRequest& request) {
    const OutputSpec& output = request.spec.output;
    const bool maps = output.maps.front() != "off";
    std::vector<Job> jobs;
    if (output.animation) jobs.emplace_back([](Drawn&& from) { draw_film(from); });
    // OpenGL's views are for one thread.
    const bool has_views = std::any_of(output.maps.begin(), output.maps.end(),
                                       [](const std::string& name) { return raster_of_map(name) != name; });
    const bool report_beside = maps && output.report && !has_views;
    if (maps)
        jobs.emplace_back([&request, report = output.report && has_views](Drawn&& from) {
            draw_maps(request, true, report, std::move(from));
        });
    if (report_beside)
        jobs.emplace_back([&request](Drawn&& from) { draw_maps(request, false, true, std::move(from)); });
    if (maps && output.charts) jobs.emplace_back([](Drawn&& from) { draw_all_charts(from); });
    if (output.report)
        jobs.emplace_back([](Drawn&& from) {
            from.drawings.guard(k_map_page_file, [&] { write_map_page(from.written, from.source); });
        });
    return jobs;
}

/// Does the jobs on some threads, this one among them. Returns what came of them, in their order.
Drawings drawn_beside(const std::vector<Job>& jobs, int threads, const PictureRequest& request,
                      const MapSource& source) {
    std::vector<Drawings> all(jobs.size());
    ThreadPool(threads).for_each(jobs.size(), [&](std::size_t left) {  // the last is begun first
        const std::size_t i = jobs.size() - 1 - left;
        all[i].guard("the pictures", [&] { jobs[i](Drawn(request, source, all[i])); });
    });
    Drawings drawn;
    for (const Drawings& one : all) drawn.add(one);
    return drawn;
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
    const std::vector<Job> jobs = jobs_of(request);
    Drawings drawings;
    if (jobs.empty()) return drawings.outcome(log);
    drawings.guard("the pictures", [&] {
        ResultReader written(request.folder);
        if (request.run != nullptr) written.take_values_of(*request.run);
        if (request.spec.output.maps.front() != "off") {
            make_drawing_folder(written.path("maps"));
            if (request.spec.output.report) make_drawing_folder(written.path(k_page_folder));
        }
        const MapSource source = map_source(written, request);
        // Each has its own tiles of a large map.
        const int threads = source.terrain.values.is_tiled() ? std::min(request.threads, 2) : request.threads;
        drawings.add(drawn_beside(jobs, threads, request, source));
        if (const auto warning = letter_warning()) drawings.warn(*warning);
    });
    return drawings.outcome(log);
}

}  // namespace frana::app
