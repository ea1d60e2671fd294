// SPDX-License-Identifier: Apache-2.0
#include "core/words/word_row.h"

namespace frana {

std::vector<std::span<const WordRow>> word_tables() {
    return {map_words(),          raster_words(),         class_words(),         physics_words(),
            answer_words(),       table_words(),          score_words(),         chart_words(),
            study_words(),        region_words(),         input_warning_words(), result_warning_words(),
            study_report_words(), calibration_words(),    attribute_words(),     term_words(),
            accuracy_words(),     input_words(),          preset_words(),        key_words_site(),
            key_words_material(), key_words_structured(), key_words_method(),    key_words_output(),
            key_words_pictures(), key_words_absent(),     ground_warning_words()};
}

}  // namespace frana
