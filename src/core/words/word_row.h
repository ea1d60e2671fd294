// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

namespace frana {

/// A text in each language. {1}, {2}, ... are the places of values, the same in all languages.
struct WordRow {
    const char* english;
    const char* italian;
    const char* german;
    const char* french;
    const char* spanish;
};

// The tables, one for each area. An English text is in one of them only.
std::span<const WordRow> map_words();             ///< maps and views: furniture, notes, marks
std::span<const WordRow> raster_words();          ///< titles of rasters
std::span<const WordRow> class_words();           ///< classes of hazard schemes and comparisons
std::span<const WordRow> physics_words();         ///< laws, materials, ends of a run
std::span<const WordRow> answer_words();          ///< the answer and the maps of a report
std::span<const WordRow> table_words();           ///< tables of a report
std::span<const WordRow> score_words();           ///< scores of a comparison
std::span<const WordRow> chart_words();           ///< charts, plates and films
std::span<const WordRow> study_words();           ///< studies, calibrations, layers of GIS projects
std::span<const WordRow> region_words();          ///< maps and degrees of hazard of regions
std::span<const WordRow> attribute_words();       ///< attributes of vector layers
std::span<const WordRow> term_words();            ///< physics and numerics of a run
std::span<const WordRow> accuracy_words();        ///< numerics.accuracy
std::span<const WordRow> input_words();           ///< input files
std::span<const WordRow> preset_words();          ///< sources and remarks of share/materials
std::span<const WordRow> input_warning_words();   ///< warnings of inputs, and how warnings are put together
std::span<const WordRow> result_warning_words();  ///< warnings of results
std::span<const WordRow> ground_warning_words();  ///< warnings of terrain and slopes
std::span<const WordRow> study_report_words();    ///< reports of studies and regions
std::span<const WordRow> calibration_words();     ///< reports of calibrations, scores of probabilities

// What the keys of a scene mean (src/params/keys/key_words.h), by section.
std::span<const WordRow> key_words_site();        ///< terrain, release, inflow
std::span<const WordRow> key_words_material();    ///< material, zones, entrainment
std::span<const WordRow> key_words_structured();  ///< the structured model
std::span<const WordRow> key_words_method();      ///< numerics, time
std::span<const WordRow> key_words_output();      ///< output, hazard, observed
std::span<const WordRow> key_words_pictures();    ///< output: maps, views, films, charts
std::span<const WordRow> key_words_absent();      ///< effects of keys that are not given

/// Returns all tables.
std::vector<std::span<const WordRow>> word_tables();

}  // namespace frana
