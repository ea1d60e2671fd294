// SPDX-License-Identifier: Apache-2.0
#include "params/keys/picture_parameters.h"

#include "core/words/language.h"
#include "params/grammar/picture_text.h"
#include "params/keys/declare.h"

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
    static const std::vector<std::string> k_formats{"png", "pdf", "svg", "tif"};
    return k_formats;
}

void add_pictures(std::vector<Parameter>& list) {
    list.push_back(understood_text("output.map-size", FRANA_MEMBER(output.map_size), k_sizes,
                                   "Write for example 1600x1200 or A4@300",
                                   "Size of maps, views and charts, in pixels or as a page.",
                                   [](const std::string& value) { return size_from_text(value).has_value(); }));
    list.push_back(word_list(
        "output.map-formats", FRANA_MEMBER(output.map_formats), {}, picture_formats(),
        "File formats of each map: picture, geospatial PDF page, SVG drawing, GeoTIFF of the area inside the frame."));
    list.push_back(choice("output.map-legend", FRANA_MEMBER(output.map_legend), {"classed", "continuous"},
                          "Colours in classes, or continuous."));
    list.push_back(
        holds("raster",
              text("output.map-background", FRANA_MEMBER(output.map_background), "file",
                   "Orthophoto or topographic raster (bytes) under maps and views, in its own CRS.", "shaded relief")));
    list.push_back(text("output.map-background-licence", FRANA_MEMBER(output.map_background_licence), "text",
                        "Owner and licence of output.map-background, at the foot of maps and views.",
                        "the name of its file"));
    list.push_back(number("output.map-scale", FRANA_MEMBER(output.map_scale), "", k_map_scales,
                          "Scale of maps on paper sizes (A4, A3): 5000 for 1 : 5000.",
                          "the least round one at which the flow fits the page"));
    list.push_back(text("output.map-author", FRANA_MEMBER(output.map_author), "text",
                        "Author, in the title block of maps.", "none"));
    list.push_back(text("output.map-organisation", FRANA_MEMBER(output.map_organisation), "text",
                        "Organisation, in the title block of maps.", "none"));
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
    list.push_back(number("output.view-exaggeration", FRANA_MEMBER(output.view_exaggeration), "", Range{0.1, 20},
                          "Vertical exaggeration of 3-D views."));
    list.push_back(choice("output.view-background", FRANA_MEMBER(output.view_background), {"sky", "plain"},
                          "Background of 3-D views: a blue sky, or white."));
    list.push_back(understood_text(
        "output.view-camera", FRANA_MEMBER(output.view_camera), k_cameras, "Write for example 210, 30, 1.5",
        "Camera of 3-D views: viewing direction [degrees from grid north], downward angle [degrees], zoom.",
        [](const std::string& value) { return camera_from_text(value).has_value(); }, "from the flow path"));
    list.push_back(on_off("output.charts", FRANA_MEMBER(output.charts),
                          "Draw charts, unless maps are off: profiles, time series, scores over the threshold."));
}

}  // namespace frana
