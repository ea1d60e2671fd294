// SPDX-License-Identifier: Apache-2.0
#include "app/publish/report.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "app/publish/report_tables.h"
#include "app/store/layers.h"
#include "app/store/provenance.h"
#include "app/store/result_files.h"
#include "app/text/number_text.h"
#include "app/text/version.h"
#include "core/file_aside.h"
#include "core/markup.h"
#include "params/keys/result_rasters.h"
#include "params/keys/scene_parameters.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

// Plain on the screen, black on white on paper; no table row and no picture is divided by a page break.
constexpr const char* k_style = R"(
:root { color-scheme: light; }
body { font: 15px/1.45 "DejaVu Sans", Verdana, sans-serif; color: #1a1a1a; background: #fff;
  max-width: 60rem; margin: 1.5rem auto; padding: 0 1rem; }
h1 { font-size: 1.6rem; margin-bottom: .2rem; } h2 { font-size: 1.2rem; margin-top: 2rem;
  border-bottom: 1px solid #999; } h3 { font-size: 1rem; }
table { border-collapse: collapse; width: 100%; font-size: .85rem; }
th, td { text-align: left; vertical-align: top; padding: .2rem .5rem; border-bottom: 1px solid #ddd;
  overflow-wrap: anywhere; }
td.n { text-align: right; white-space: nowrap; font-variant-numeric: tabular-nums; }
table.keys { table-layout: fixed; } table.keys th { width: 22%; } table.keys th:nth-child(2) { width: 27%; }
table.keys th:nth-child(3) { width: 9%; } table.keys th:nth-child(4) { width: 11%; }
table.keys th:last-child { width: auto; }
tr.given td { font-weight: bold; } tr.given td:last-child { font-weight: normal; } figure { margin: 0; }
 .small { font-size: .8rem; color: #444; }
.warning { border-left: .4rem solid #d55e00; background: #fdf1e7; padding: .4rem .8rem; margin: .4rem 0; }
.good { border-left: .4rem solid #009e73; background: #eaf7f2; padding: .4rem .8rem; }
img, svg { width: 100%; height: auto; border: 1px solid #ccc; margin: .4rem 0; }
svg { max-width: 46rem; }
.swatch { display: inline-block; width: 1em; height: 1em; border: 1px solid #666; vertical-align: -.15em; }
@media print { body { max-width: none; margin: 0; font-size: 10pt; } h2 { break-after: avoid; }
  tr, img, svg, figure, .warning { break-inside: avoid; } a { color: inherit; text-decoration: none; } }
@page { margin: 15mm; }
)";

std::string file_bytes(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Writes a page piece by piece, so that memory contains one picture at a time.
class Page {
  public:
    explicit Page(const std::string& path) : aside_(path), file_(aside_.partial_path(), std::ios::binary) {}

    void add(const std::string& text) { file_ << text; }
    void add_picture(const std::string& path, const std::string& caption) {
        add("<figure>\n<img alt=\"" + escaped_markup(caption) + "\" src=\"data:image/png;base64,");
        add(base64(file_bytes(path)));
        add("\">\n</figure>\n");
    }
    void finish() {
        file_.close();
        if (!file_) {
            throw Error(ErrorKind::environment,
                        Problem{std::string("cannot be written: ") + std::strerror(errno), aside_.path(), "", "",
                                "Check the disk's space and the rights"});
        }
        aside_.rename_into_place();
    }

  private:
    FileAside aside_;
    std::ofstream file_;
};

void add_warnings(Page& page, const std::vector<std::string>& warnings) {
    page.add("<h2 id=\"warnings\">Warnings</h2>\n");
    if (warnings.empty()) page.add("<p class=\"good\">The run gave no warnings.</p>\n");
    for (const std::string& warning : warnings) page.add("<p class=\"warning\">" + escaped_markup(warning) + "</p>\n");
}

/// Returns a picture in the result, or one drawn for the page alone.
std::optional<std::string> drawn(const ResultDirectory& directory, const std::string& folder, const std::string& name) {
    for (const std::string& place : {folder, std::string(k_page_folder) + "/"})
        if (std::string file = directory.path(place + name + ".png"); fs::exists(file)) return file;
    return std::nullopt;
}

void add_maps(Page& page, const SceneSpec& spec, const ResultDirectory& directory) {
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

std::string base64(const std::string& bytes) {
    static constexpr char k_signs[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        unsigned group = 0;
        for (std::size_t k = 0; k < 3; ++k)
            group = group << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k) text += k <= count ? k_signs[group >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

void write_report(const ReportInput& input, const ResultDirectory& directory) {
    const SceneSpec& spec = input.prepared.spec;
    const std::string title = spec.output.title.value_or(scene_name(spec));
    Page page(directory.path(k_report_file));
    page.add("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>" + escaped_markup(title) +
             "</title>\n<style>" + k_style + "</style>\n</head>\n<body>\n<h1>" + escaped_markup(title) +
             "</h1>\n<p class=\"small\">Computed with " + k_program + " " + k_version + ", scene " +
             escaped_markup(spec.file) + ", hash " + provenance(input.prepared).at("SCENE_HASH") + "</p>\n");
    add_warnings(page, input.facts.warnings);
    page.add("<h2 id=\"results\">Results</h2>\n" + results_table(input));
    if (input.facts.accuracy) page.add("<h2 id=\"accuracy\">Accuracy</h2>\n" + accuracy_tables(*input.facts.accuracy));
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
    page.add("</body>\n</html>\n");
    page.finish();
    std::error_code ignored;
    fs::remove_all(directory.path(k_page_folder), ignored);  // in a folder still being written, so it belongs to frana
}

}  // namespace frana::app
