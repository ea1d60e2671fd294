// SPDX-License-Identifier: Apache-2.0
#include "app/study/pool/rounds.h"

#include <algorithm>
#include <cmath>

#include "app/study/plan/study_input.h"
#include "app/study/statistics/importance.h"
#include "app/study/statistics/outline_maps.h"

namespace frana::app::study {
bool run_importance(StudyInput& input, const std::string& folder, const std::function<bool(std::size_t)>& run_until) {
    ImportanceSampling sampling(input.reading.study);
    const RareEvent event = rare_event(input);
    for (;;) {
        if (!run_until(input.table.size())) return false;
        if (input.table.size() >= input.members()) return true;
        const StudyResult result = read_study_result(input, folder, input.table.size());
        std::vector<double> distances(input.table.size(), k_no_data);
        const std::vector<double> known = distances_from_outline(result.finished, Quantity::depth, event.threshold,
                                                                 result.grid, *cell_at(result.grid, event.place));
        for (std::size_t i = 0; i < known.size(); ++i) distances[result.finished_at[i]] = known[i];
        sampling.add_round(distances, input.table);
    }
}

}  // namespace frana::app::study
