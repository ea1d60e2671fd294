// SPDX-License-Identifier: Apache-2.0
#include "params/keys/output_parameters.h"

#include <limits>

#include "core/words/words.h"
#include "params/grammar/value_text.h"
#include "params/keys/declare.h"
#include "params/keys/result_rasters.h"

namespace frana {
namespace {

using declare::choice;
using declare::holds;
using declare::number;
using declare::on_off;
using declare::Range;
using declare::text;
using declare::word_list;

constexpr Range k_map_scales{100, 10'000'000};

/// A text that a given function must be able to read.
template <class Member, class Understood>
Parameter understood_text(const std::string& name, Member member, const std::string& limits, const std::string& remedy,
                          const std::string& meaning, Understood understood, const std::string& absent = {}) {
    Parameter result = text(name, member, "text", meaning, absent);
    result.limits = limits;
    result.read = [member, remedy, understood](SceneSpec& scene,
                                               const std::string& value) -> std::optional<ValueProblem> {
        if (!understood(value)) return ValueProblem{"is not understood", remedy};
        member(scene) = value;
        return std::nullopt;
    };
    return result;
}

}  // namespace

const std::vector<std::string>& picture_formats() {
    static const std::vector<std::string> k_formats{"png", "pdf", "svg"};
    return k_formats;
}

void add_pictures(std::vector<Parameter>& list) {
    list.push_back(understood_text(
        "output.map-size", FRANA_MEMBER(output.map_size), size_forms(), "Write for example 1600x1200 or A4@300",
        "Size of maps, views and charts, in pixels or as a page; auto: A4. A page without a direction is upright for "
        "maps of a flow taller than wide.",
        [](const std::string& value) { return size_from_text(value).has_value(); }));
    list.push_back(
        declare::without(word_list("output.map-formats", FRANA_MEMBER(output.map_formats), {}, picture_formats(),
                                   "File formats of each map: picture, geospatial PDF page, SVG drawing."),
                         {{"tif", "Write pdf, which has a place on the ground too"}}));
    list.push_back(
        holds("raster",
              text("output.map-background", FRANA_MEMBER(output.map_background), "file",
                   "Orthophoto or topographic raster (bytes) under maps and views, in its own CRS.", "shaded relief")));
    list.push_back(holds("points, lines or polygons",
                         text("output.map-context", FRANA_MEMBER(output.map_context), "file",
                              "Roads, rivers, buildings drawn on maps and views, in their own CRS.", "none")));
    list.push_back(number("output.map-scale", FRANA_MEMBER(output.map_scale), "", k_map_scales,
                          "Scale of maps on paper sizes (A4, A3): 5000 for 1 : 5000.",
                          "the least round one at which the flow fits the page"));
    list.push_back(number("output.map-turn", FRANA_MEMBER(output.map_turn), "degrees", {-180, 180},
                          "Grid north on maps, clockwise from straight up: 0 is north up.",
                          "along the flow where that shows it a quarter larger, else 0"));
    list.push_back(text("output.map-author", FRANA_MEMBER(output.map_author), "text",
                        "Author and organisation, in the title block of maps.", "none"));
    list.push_back(holds("raster", text("output.map-logo", FRANA_MEMBER(output.map_logo), "file",
                                        "Logo in the title block of maps: a PNG or JPEG file.", "none")));
    list.push_back(text("output.map-date", FRANA_MEMBER(output.map_date), "text",
                        "Date in the title block of maps; none: no date.", "the day of the run"));
    list.push_back(text("output.map-attribution", FRANA_MEMBER(output.map_attribution), "text",
                        "Sources of the data and author, at the foot of every picture.", "the program alone"));
    std::vector<std::string> codes{k_language_of_locale};
    for (const LanguageRow& one : languages()) codes.emplace_back(one.code);
    list.push_back(choice("output.language", FRANA_MEMBER(output.language), codes,
                          "Language of maps, charts, legends and the report; auto: that of the locale (LC_ALL, "
                          "LC_MESSAGES, LANG), English if it is none of these."));
    list.push_back(text("output.title", FRANA_MEMBER(output.title), "text", "Title of the maps.", "the scene's name"));
    list.push_back(on_off("output.charts", FRANA_MEMBER(output.charts),
                          "Draw charts, unless maps are off: profiles, time series, scores over the threshold."));
}

namespace {

using declare::data_file;
using declare::rising_numbers;

}  // namespace

void add_extra_output(std::vector<Parameter>& list) {
    list.push_back(choice("output.extent", FRANA_MEMBER(output.extent), {"auto", "map", "reached"},
                          "What the rasters of a finished result cover: the whole map, or the rectangle round "
                          "everything released, reached or surveyed, with a margin; auto: reached on maps of over " +
                              std::to_string(k_largest_whole_map / 1'000'000) + " million cells."));
    list.push_back(on_off("output.report", FRANA_MEMBER(output.report),
                          "Write report.html (all of the result in one file) and map.html (a map to click)."));
    list.push_back(
        holds("points", text("output.gauges", FRANA_MEMBER(output.gauges), "file",
                             "Points where depth and speed are recorded over time, in their own CRS.", "none")));
    list.push_back(
        holds("lines", text("output.cross-sections", FRANA_MEMBER(output.sections), "file",
                            "Lines through which the discharge is recorded over time, in their own CRS.", "none")));
    list.push_back(number("output.sample-interval", FRANA_MEMBER(output.sample_interval), "s", Range{0, 1e6, true},
                          "Simulated time between rows of gauges and cross-sections.", "every step"));
    list.push_back(holds(
        "lines", text("output.profiles", FRANA_MEMBER(output.profiles), "file",
                      "Lines along which profiles of the results are written, in their own CRS; the profile along "
                      "the flow path is always written.",
                      "none")));
    list.push_back(
        holds("points, lines or polygons",
              text("output.exposure", FRANA_MEMBER(output.exposure), "file",
                   "Buildings, roads, people: points, lines or areas in their own CRS, for each of which the "
                   "greatest depth, speed and pressure and the arrival are written.",
                   "none")));
    list.push_back(text("output.exposure-name", FRANA_MEMBER(output.exposure_name), "text",
                        "Column of output.exposure with the name of each feature.", "number of the feature"));
    list.push_back(text("output.exposure-count", FRANA_MEMBER(output.exposure_count), "text",
                        "Column of output.exposure with how many each feature stands for (people, dwellings).",
                        "each counts as one"));
    const auto thresholds = [&](const char* key, auto member, const char* unit) {
        list.push_back(rising_numbers(key, member, unit,
                                      "`frana ensemble`: maxima whose probability of being exceeded is mapped."));
    };
    thresholds("output.depth-thresholds", FRANA_MEMBER(output.depth_thresholds), "m");
    thresholds("output.velocity-thresholds", FRANA_MEMBER(output.velocity_thresholds), "m/s");
    thresholds("output.pressure-thresholds", FRANA_MEMBER(output.pressure_thresholds), "kPa");
    thresholds("output.momentum-flux-thresholds", FRANA_MEMBER(output.momentum_flux_thresholds), "m3/s2");
    std::vector<std::string> words;
    for (const ResultRaster& row : result_rasters())
        if (!row.asked_by.empty() && (words.empty() || words.back() != row.asked_by)) words.push_back(row.asked_by);
    Parameter rasters = declare::word_list(
        "output.rasters", FRANA_MEMBER(output.rasters), {}, words,
        "Rasters beside those that every run writes: depth times speed, energy head, depth times speed squared, normal "
        "stress in the plane.");
    rasters.absent = "none";
    list.push_back(rasters);
}

void add_hazard(std::vector<Parameter>& list) {
    list.push_back(
        data_file("hazard.scheme", FRANA_MEMBER(hazard.scheme), "a name of `frana schemes`, or a file FILE.ini",
                  "Scheme of intensity classes for hazard.tif; sources in share/doc/hazard.md.", "no classes"));
    Parameter process =
        choice("hazard.process", FRANA_MEMBER(hazard.process), {std::begin(k_processes), std::end(k_processes)},
               "Process whose matrix gives a region's degrees of hazard, of those that the scheme has.");
    process.absent = "the scheme's only one";
    list.push_back(process);
    list.push_back(declare::decides_map(
        number("hazard.minimum-depth", FRANA_MEMBER(hazard.minimum_depth), "m", Range{1e-6, 100},
               "Depth above which ground has a class by depth; classes by pressure have no such limit.",
               "output.trace-threshold")));
}

void add_exposure(std::vector<Parameter>& list) {
    list.push_back(holds(
        "table", text("exposure.fragility", FRANA_MEMBER(exposure.fragility), "file",
                      "CSV with the states of damage of the features of output.exposure, and how likely each is at "
                      "an intensity: gives the expected damage.",
                      "no damage")));
    list.push_back(text("exposure.value", FRANA_MEMBER(exposure.value), "text",
                        "Column of output.exposure with what each feature is worth.", "each is worth 1"));
    list.push_back(text("exposure.class", FRANA_MEMBER(exposure.kind), "text",
                        "Column of output.exposure that names the class of exposure.fragility.",
                        "the file has one class for all"));
}

void add_survey(std::vector<Parameter>& list) {
    list.push_back(
        holds("lines or points",
              text("observed.front", FRANA_MEMBER(observed.front), "file",
                   "Surveyed lines of a front, or points of a deposit's tip, in their own CRS.", "no comparison")));
    list.push_back(
        holds("raster or polygons",
              text("observed.deposit", FRANA_MEMBER(observed.deposit), "file",
                   "Surveyed deposit: polygons, or a raster of elevation after minus before.", "no comparison")));
}

}  // namespace frana
