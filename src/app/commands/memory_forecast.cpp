// SPDX-License-Identifier: Apache-2.0
#include "app/commands/memory_forecast.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/commands/command_line.h"
#include "app/input/memory_bound.h"
#include "app/pictures/animation.h"
#include "app/store/frame_store.h"
#include "app/text/number_text.h"
#include "core/error.h"
#include "core/text.h"

namespace frana::app {
namespace {

// All measured, with GDAL 3.6, VTK 9.1 and Mesa 22, on maps of 2000 to 20 000 000 cells and pages of 0.3 to 64 million
// pixels. Results and temporary data while files are written and pictures drawn, after the engine's memory was freed.
constexpr std::int64_t k_result_cell_bytes = 120;
// Code and tables of the drawing libraries; drawn parts of a map and a view, which remain while more are drawn; relief
// and mesh.
constexpr std::int64_t k_picture_bytes = 98'000'000, k_map_pixel_bytes = 56, k_view_pixel_bytes = 34,
                       k_drawn_cell_bytes = 28;
// The pictures that an encoder keeps in its look-ahead and look-back; a view's animation has two pictures in progress.
constexpr std::int64_t k_animation_bytes = 10'000'000, k_animation_pixel_bytes = 15;
// A step's row in memory, during formatting, and while charts are drawn from the file's text.
constexpr std::int64_t k_step_bytes = 180, k_step_text_bytes = 450, k_step_chart_bytes = 1500;
// Code and tables of computing and writing.
constexpr std::int64_t k_computing_bytes = 30'000'000;
// Frames waiting for the disk contain both quantities; particles eight numbers each, VTK's and GDAL's copies.
constexpr std::int64_t k_frame_cell_bytes = 40, k_frame_particle_bytes = 330;
// Per cell of a large map, in all rasters together, where nothing is stored.
constexpr std::int64_t k_table_millibytes = 100;
// Particles split where the flow is thin; a trial without splitting does not predict it.
constexpr double k_unseen_growth = 1.5;

std::int64_t pixels(Size size) {
    return static_cast<std::int64_t>(size.width) * size.height;
}

bool draws_maps(const Prepared& prepared) {
    return prepared.spec.output.maps.front() != "off";
}

// Returns the pictures that publish() draws.
Drawing drawing_of(const Prepared& prepared, std::int64_t cells) {
    const OutputSpec& output = prepared.spec.output;
    const Size page = size_from_text(output.map_size).value_or(Size{});
    Drawing drawing;
    drawing.cells = cells;
    if (draws_maps(prepared) || prepared.scar) drawing.page = page;
    drawing.views = std::any_of(output.maps.begin(), output.maps.end(),
                                [](const std::string& name) { return name == "on" || name.ends_with("_3d"); });
    drawing.maps = prepared.scar || output.charts ||
                   !std::all_of(output.maps.begin(), output.maps.end(),
                                [](const std::string& name) { return name.ends_with("_3d"); });
    if (output.animation && prepared.scene.time.frame_interval > 0) drawing.animation = animation_size(page);
    return drawing;
}

struct Course {
    std::int64_t particles = 0;
    double steps = 0;
};

std::int64_t memory_of(const Prepared& prepared, std::int64_t in_use, const RunEstimate& expected,
                       const Course& course) {
    const OutputSpec& output = prepared.spec.output;
    const std::int64_t cells = expected.stored_cells;
    const auto steps = static_cast<std::int64_t>(std::min(course.steps, 1e12));
    std::int64_t engine = expected.memory_bytes + steps * k_step_bytes +
                          expected.bytes_of_particles(std::max<std::int64_t>(0, course.particles - expected.particles));
    if (prepared.scene.time.frame_interval > 0) engine += cells * k_frame_cell_bytes;
    if (prepared.scene.time.frame_interval > 0 && particle_formats(output.formats).any())
        engine += course.particles * k_frame_particle_bytes;
    const std::int64_t results = cells * k_result_cell_bytes;
    const bool charts = output.charts && draws_maps(prepared);
    const std::int64_t writing = results + steps * k_step_text_bytes,
                       drawing = results + memory_of_drawing(drawing_of(prepared, cells)) +
                                 steps * (charts ? k_step_chart_bytes : k_step_bytes);
    // Tables of tiles, of which a raster of a large map consists.
    const std::int64_t tables =
        cells < prepared.scene.grid.cell_count() ? prepared.scene.grid.cell_count() * k_table_millibytes / 1000 : 0;
    return in_use + k_computing_bytes + tables + std::max({engine, writing, drawing});
}

// No speed exceeds that of free fall: a step is at least the time to cross a cell at that speed plus the waves'.
double most_steps(const Prepared& prepared, const RunEstimate& expected) {
    const Scene& scene = prepared.scene;
    double least = std::numeric_limits<double>::infinity(), greatest = -least;
    scene.terrain.values.for_each_stored([&](std::size_t, double z) {
        if (std::isnan(z)) return;
        least = std::min(least, z);
        greatest = std::max(greatest, z);
    });
    double speed = std::sqrt(2 * scene.numerics.gravity * std::max(0.0, greatest - least));
    double begun = 0;
    for (const ReleaseArea& area : scene.release) begun = std::max(begun, area.speed);
    speed = std::hypot(speed, begun);
    return scene.time.end / expected.first_step_seconds +
           scene.time.end * speed / (courant_number(scene.numerics, scene.material) * scene.grid.cell_size);
}

}  // namespace

std::int64_t memory_of_drawing(const Drawing& drawing) {
    if (pixels(drawing.page) == 0 && pixels(drawing.animation) == 0) return 0;
    const std::int64_t of_pixel = (drawing.maps ? k_map_pixel_bytes : 0) + (drawing.views ? k_view_pixel_bytes : 0);
    // The animation is drawn after the maps, in the memory they leave: 32 MB more than these alone, measured.
    std::int64_t bytes = k_picture_bytes + drawing.cells * k_drawn_cell_bytes +
                         std::max(pixels(drawing.page), pixels(drawing.animation)) * of_pixel;
    if (pixels(drawing.animation) > 0) bytes += k_animation_bytes + pixels(drawing.animation) * k_animation_pixel_bytes;
    return bytes;
}

std::int64_t memory_of_run(const Prepared& prepared, std::int64_t in_use, const RunEstimate& expected,
                           const std::optional<TimeEstimate>& trial) {
    Course course;
    course.steps = most_steps(prepared, expected);
    if (trial) {
        course.particles = std::max(trial->particles_peak, expected.particles);
        course.steps = std::min(course.steps, trial->steps);
    } else {
        const double growth = prepared.scene.structured ? 1 : k_unseen_growth;
        course.particles = static_cast<std::int64_t>(growth * static_cast<double>(expected.particles));
    }
    return memory_of(prepared, in_use, expected, course);
}

std::int64_t most_memory_of_run(const Prepared& prepared, std::int64_t in_use, const RunEstimate& expected) {
    if (prepared.scene.terrain.values.is_tiled()) return std::numeric_limits<std::int64_t>::max();  // no bound is known
    // Particles that merging leaves in every cell of the map.
    constexpr std::int64_t k_crowd = 3;
    const std::int64_t crowded =
        prepared.scene.structured
            ? 0
            : prepared.scene.grid.cell_count() * std::max(4, prepared.scene.numerics.particles_per_cell) * k_crowd;
    const std::int64_t nodes = prepared.scene.grid.cell_count() * expected.bytes_per_node;
    return nodes + memory_of(prepared, in_use, expected,
                             {std::max(expected.particles, crowded), most_steps(prepared, expected)});
}

Session session_of(const boost::program_options::variables_map& values, RunLog& log) {
    const auto text = text_option(values, "memory-limit");
    return {text ? memory_limit_from_text(*text, log) : 0};
}

void refuse_run_of(std::int64_t needed, const SceneReading& reading, const Prepared& prepared) {
    const MemoryBound bound = usable_memory(reading.session);
    if (static_cast<double>(needed) <= bound.bytes) return;
    throw Error(ErrorKind::input,
                Problem{"a run of this scene needs about " + bytes_text(static_cast<double>(needed)) + " of memory",
                        reading.where("terrain.cell-size"), shortest_text(prepared.scene.grid.cell_size) + " m",
                        bound_text(bound),
                        "Choose a larger terrain.cell-size, a part of the DTM with terrain.bounds, a smaller "
                        "output.map-size or no pictures, or provide more memory"});
}

void refuse_run_beyond_memory(const SceneReading& reading, const Prepared& prepared, std::int64_t in_use,
                              const RunEstimate& expected, int threads) {
    if (static_cast<double>(most_memory_of_run(prepared, in_use, expected)) <= usable_memory(reading.session).bytes)
        return;
    refuse_run_of(memory_of_run(prepared, in_use, expected, estimate_time(reading, prepared, expected, threads)),
                  reading, prepared);
}

void refuse_pictures_of(std::int64_t needed, const std::string& where, const std::string& size) {
    const MemoryBound bound = machine_memory();
    const double all = static_cast<double>(needed + resident_memory());
    if (all <= bound.bytes) return;
    throw Error(ErrorKind::input, Problem{"drawing needs about " + bytes_text(all) + " of memory", where, size,
                                          bound_text(bound), "Choose a smaller size"});
}

}  // namespace frana::app
