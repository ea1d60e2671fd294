// SPDX-License-Identifier: Apache-2.0
#include "app/publish/html_page.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "app/text/text_file.h"
#include "core/base64.h"
#include "core/error.h"
#include "core/markup.h"

namespace frana::app {
namespace {

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

}  // namespace

HtmlPage::HtmlPage(const std::string& path, const std::string& title, const std::string& origin)
    : aside_(path), file_(aside_.partial_path(), std::ios::binary) {
    add("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>" + escaped_markup(title) +
        "</title>\n<style>" + k_style + "</style>\n</head>\n<body>\n<h1>" + escaped_markup(title) +
        "</h1>\n<p class=\"small\">" + escaped_markup(origin) + "</p>\n");
}

void HtmlPage::add_warnings(const std::vector<std::string>& warnings) {
    add("<h2 id=\"warnings\">Warnings</h2>\n");
    if (warnings.empty()) add("<p class=\"good\">The run gave no warnings.</p>\n");
    for (const std::string& warning : warnings) add("<p class=\"warning\">" + escaped_markup(warning) + "</p>\n");
}

void HtmlPage::add_picture(const std::string& path, const std::string& caption) {
    add("<figure>\n<img alt=\"" + escaped_markup(caption) + "\" src=\"data:image/png;base64,");
    add(base64(read_text_file(path)));
    add("\">\n</figure>\n");
}

void HtmlPage::finish() {
    add("</body>\n</html>\n");
    file_.close();
    if (!file_) {
        throw Error(ErrorKind::environment, Problem{std::string("cannot be written: ") + std::strerror(errno),
                                                    aside_.path(), "", "", "Check the disk's space and the rights"});
    }
    aside_.rename_into_place();
}

std::string table_row(const std::vector<std::string>& cells, const char* cell) {
    std::string html = "<tr>";
    for (const std::string& text : cells)
        html += std::string("<") + cell + ">" + escaped_markup(text) + "</" + cell + ">";
    return html + "</tr>\n";
}

}  // namespace frana::app
