// SPDX-License-Identifier: Apache-2.0
#include "core/words/word_row.h"

namespace frana {

std::vector<std::span<const WordRow>> word_tables() {
    return {map_words(),           raster_words(),         class_words(),        physics_words(),    answer_words(),
            table_words(),         score_words(),          chart_words(),        study_words(),      region_words(),
            input_warning_words(), result_warning_words(), study_report_words(), calibration_words()};
}

}  // namespace frana
