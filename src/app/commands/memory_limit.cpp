// SPDX-License-Identifier: Apache-2.0
#include "app/commands/memory_limit.h"

#include "app/commands/command_line.h"
#include "app/commands/memory_forecast.h"
#include "app/input/memory_bound.h"
#include "app/text/number_text.h"
#include "core/error.h"
#include "core/shortest_text.h"

namespace frana::app {

void apply_memory_limit(const boost::program_options::variables_map& values, RunLog& log) {
    if (const auto text = text_option(values, "memory-limit")) limit_memory(*text, log);
}

void refuse_run_of(std::int64_t needed, const SceneReading& reading, const Prepared& prepared) {
    const MemoryBound bound = usable_memory();
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
    if (static_cast<double>(most_memory_of_run(prepared, in_use, expected)) <= usable_memory().bytes) return;
    refuse_run_of(memory_of_run(prepared, in_use, expected, estimate_time(reading, prepared, expected, threads)),
                  reading, prepared);
}

void refuse_pictures_of(std::int64_t needed, const std::string& where, const std::string& size) {
    const MemoryBound bound = usable_memory();
    const double all = static_cast<double>(needed + resident_memory());
    if (all <= bound.bytes) return;
    throw Error(ErrorKind::input, Problem{"drawing needs about " + bytes_text(all) + " of memory", where, size,
                                          bound_text(bound), "Choose a smaller size"});
}

}  // namespace frana::app
