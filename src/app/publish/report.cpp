// SPDX-License-Identifier: Apache-2.0
#include "app/publish/report.h"

#include <algorithm>
#include <filesystem>

#include "app/publish/html_page.h"
#include "app/publish/report_tables.h"
#include "app/store/layers.h"
#include "app/store/provenance.h"
#include "app/store/result_files.h"
#include "app/text/number_text.h"
#include "app/text/version.h"
#include "core/markup.h"
#include "params/keys/result_rasters.h"
#include "params/keys/scene_parameters.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

/// Returns a picture in the result, or one drawn for the page alone.
std::optional<std::string> drawn(const ResultDirectory& directory, const std::string& folder, const std::string& name) {
    for (const std::string& place : {folder, std::string(k_page_folder) + "/"})
        if (std::string file = directory.path(place + name + ".png"); fs::exists(file)) return file;
    return std::nullopt;
}

void add_maps(HtmlPage& page, const SceneSpec& spec, const ResultDirectory& directory) {
    page.add("<h2 id=\"maps\">Maps</h2>\n");
    bool any = false;
    std::vector<std::string> names = map_names();
    for (const std::string& name : names) {
        const auto file = drawn(directory, "maps/", name);
        if (!file) continue;
        page.add_picture(*file, name);
        any = true;
    }
    if (!any)
        page.add(spec.output.maps.front() == "off" ? "<p>The scene asks for no maps.</p>\n"
                                                   : "<p>No map could be drawn; see the warnings.</p>\n");
}

}  // namespace

void write_report(const ReportInput& input, const ResultDirectory& directory) {
    const SceneSpec& spec = input.prepared.spec;
    const std::string title = spec.output.title.value_or(scene_name(spec));
    HtmlPage page(directory.path(k_report_file), title,
                  std::string("Computed with ") + k_program + " " + k_version + ", scene " + spec.file + ", hash " +
                      provenance(input.prepared).at("SCENE_HASH"));
    page.add_warnings(input.facts.warnings);
    page.add("<h2 id=\"results\">Results</h2>\n" + results_table(input));
    if (!input.result.released.empty())
        page.add("<h2 id=\"release\">Release areas</h2>\n" + release_table(input.result));
    if (input.facts.accuracy) page.add("<h2 id=\"accuracy\">Accuracy</h2>\n" + accuracy_tables(*input.facts.accuracy));
    if (input.facts.release_ground || input.facts.path_ground)
        page.add("<h2 id=\"ground\">Ground</h2>\n" + ground_table(input.facts));
    page.add("<h2 id=\"budget\">Mass budget</h2>\n" + budget_table(input.result));
    page.add("<h2 id=\"numerics\">Numerical checks</h2>\n" + numerics_table(input));
    if (!input.hazard.empty())
        page.add("<h2 id=\"hazard\">Intensity classes</h2>\n" + hazard_table(spec, input.hazard));
    add_maps(page, spec, directory);
    page.add("<h2 id=\"series\">Time series</h2>\n" + series_charts(input));
    if (input.comparison) {
        page.add("<h2 id=\"comparison\">Comparison with the survey</h2>\n" + comparison_tables(*input.comparison));
        if (const auto file = drawn(directory, "", "comparison")) page.add_picture(*file, "comparison");
    }
    page.add("<h2 id=\"inputs\">Inputs</h2>\n" + inputs_table(input.prepared));
    page.add(
        "<h2 id=\"parameters\">Parameters</h2>\n<p class=\"small\">Bold: given in the scene, on the command "
        "line or by the material preset.</p>\n" +
        parameters_table(input.prepared));
    page.finish();
    std::error_code ignored;
    fs::remove_all(directory.path(k_page_folder), ignored);  // in a folder still being written, so it belongs to frana
}

}  // namespace frana::app
