// SPDX-License-Identifier: Apache-2.0
#include "app/publish/report.h"

#include <algorithm>
#include <filesystem>

#include "app/publish/html_page.h"
#include "app/publish/html_table.h"
#include "app/publish/publish_hazard.h"
#include "app/publish/report_answer.h"
#include "app/publish/report_charts.h"
#include "app/publish/report_comparison.h"
#include "app/publish/report_exposure.h"
#include "app/publish/report_maps.h"
#include "app/publish/report_tables.h"
#include "app/store/provenance.h"
#include "app/store/result_files.h"
#include "app/text/version.h"
#include "core/markup.h"
#include "params/keys/scene_parameters.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

std::string headed(const std::string& heading, const std::string& html) {
    return "<div>\n<h3>" + escaped_markup(heading) + "</h3>\n" + html + "</div>\n";
}

std::string hazard_heading(const SceneSpec& spec, const Words& words) {
    const std::optional<HazardScheme> scheme = hazard_scheme_of(spec);
    return scheme && scheme->title != k_intensity_title ? words(scheme->title) : words("Intensity classes");
}

void add_maps(HtmlPage& page, const ReportInput& input, const std::vector<ReportMap>& maps) {
    const Words& words = input.words;
    page.add_heading("maps", words("Maps"));
    if (maps.empty())
        page.add(small_print(input.prepared.spec.output.maps.front() == "off"
                                 ? words("The scene asks for no maps.")
                                 : words("No map could be drawn; see the warnings.")));
    if (maps.size() == 1) page.add(small_print(words("The only map is on the first page.")));
    for (std::size_t i = 1; i < maps.size(); ++i) page.add_picture(maps[i].file, maps[i].caption, maps[i].alt);
    if (!input.hazard.empty())
        page.add(
            headed(hazard_heading(input.prepared.spec, words), hazard_table(input.prepared.spec, input.hazard, words)));
}

void add_details(HtmlPage& page, const ReportInput& input) {
    const Words& words = input.words;
    page.add_heading("series", words("Course of the flow"));
    page.add(series_charts(input));
    page.add_heading("values", words("Values in detail"));
    page.add(headed(words("High values"), high_values_table(input)));
    if (!input.result.released.empty()) page.add(headed(words("Release areas"), release_table(input.result, words)));
    if (input.facts.accuracy) page.add(headed(words("Accuracy"), accuracy_tables(*input.facts.accuracy, words)));
    if (input.facts.release_ground || input.facts.path_ground)
        page.add(headed(words("Ground"), ground_table(input.facts, words)));
    page.add("<div class=\"columns\">\n" + headed(words("Mass budget"), budget_table(input.result, words)) +
             headed(words("Numerical checks"), numerics_table(input)) + "</div>\n" + terms_note(input));
}

void add_keys(HtmlPage& page, const ReportInput& input) {
    const Words& words = input.words;
    page.add_heading("parameters", words("Keys used"));
    page.add(small_print(
                 words("Bold: given in the scene, on the command line or by the material preset. Keys that the scene "
                       "does not use are left out.")) +
             parameters_table(input.prepared, true, words) + "<details>\n<summary>" +
             escaped_markup(words("All keys")) + "</summary>\n" + parameters_table(input.prepared, false, words) +
             "</details>\n");
}

}  // namespace

void write_report(const ReportInput& input, const ResultDirectory& directory) {
    const SceneSpec& spec = input.prepared.spec;
    const Words& words = input.words;
    const std::string title = spec.output.title.value_or(scene_name(spec));
    const std::vector<ReportMap> maps = report_maps(input, directory);
    HtmlPage page(directory.path(k_report_file), title,
                  words("Computed with {1}, scene {2}, hash {3}",
                        {std::string(k_program) + " " + k_version, fs::path(spec.file).filename().string(),
                         provenance(input.prepared).at("SCENE_HASH")}),
                  words, maps.empty() ? Opening::answer : Opening::answer_with_picture);
    page.expect_pictures(maps.size() + 1);
    page.add(answer_sentences(input));
    if (!maps.empty()) page.add_picture(maps.front().file, maps.front().caption, maps.front().alt);
    page.add(answer_tables(input));
    page.end_answer();
    add_maps(page, input, maps);
    page.add(
        page_part(k_comparison_section,
                  comparison_section(input.comparison,
                                     drawn_for_page(directory.folder(), directory.path("comparison.png")), words)));
    page.add(exposure_section(input.facts.exposure, words));
    add_details(page, input);
    if (!input.facts.warnings.empty()) page.add_warnings(warnings_of(input));
    page.add_heading("inputs", words("Inputs"));
    page.add(inputs_table(input.prepared, words));
    add_keys(page, input);
    page.finish();
    remove_page_pictures(directory.folder());
}

}  // namespace frana::app
