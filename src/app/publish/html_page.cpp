// SPDX-License-Identifier: Apache-2.0
#include "app/publish/html_page.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "app/pictures/map_layer.h"
#include "app/store/manifest.h"
#include "app/store/replace_result.h"
#include "app/store/result_files.h"
#include "app/text/text_file.h"
#include "core/error.h"
#include "core/files.h"
#include "core/text.h"
#include "gis/raster/picture_in.h"
#include "params/keys/result_rasters.h"

namespace frana::app {
namespace {

/// The style of frana's pages: plain on the screen, black on white on A4. On paper the first section fills its page,
/// two maps have room on a page, no row of a table and no picture is divided by a page break, heads of tables are
/// repeated, and what is folded is left out. No picture is higher than half a page, so that a page whose next picture
/// does not fit is more than half full.
constexpr const char* k_page_style = R"(
:root { color-scheme: light; }
* { box-sizing: border-box; }
body { font: 15px/1.45 "DejaVu Sans", Verdana, Arial, sans-serif; color: #1a1a1a; background: #fff;
  max-width: 60rem; margin: 1.5rem auto; padding: 0 1rem; }
h1 { font-size: 1.6rem; line-height: 1.2; margin: 0 0 .2rem; }
h2 { font-size: 1.2rem; margin: 2rem 0 .6rem; border-bottom: 1px solid #999; }
h3 { font-size: 1rem; margin: 1.2rem 0 .4rem; }
h1, h2, h3, p, figcaption, summary { overflow-wrap: anywhere; }
table { border-collapse: collapse; width: 100%; font-size: .85rem; margin: .4rem 0; }
th, td { text-align: left; vertical-align: top; padding: .2rem .5rem; border-bottom: 1px solid #ddd;
  overflow-wrap: anywhere; }
th { font-weight: bold; border-bottom-color: #888; }
.n { text-align: right; font-variant-numeric: tabular-nums; }
td.n { white-space: nowrap; } td.u { overflow-wrap: normal; } td.u { padding-left: 0; }
.soft { color: #555; }
table.keys { table-layout: fixed; } table.keys th { width: 18%; } table.keys th:nth-child(2) { width: 19%; }
table.keys th:nth-child(3) { width: 9%; } table.keys th:last-child { width: auto; }
tr.given td { font-weight: bold; } tr.given td:last-child { font-weight: normal; }
.answer p { margin: .4rem 0; }
.columns { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(22rem, 100%), 1fr)); gap: .4rem 1.6rem;
  align-items: start; }
.columns > * { min-width: 0; }
figure { margin: .6rem 0; } figcaption { font-size: .85rem; color: #333; }
.small { font-size: .8rem; color: #444; }
.warning { border-left: .4rem solid #d55e00; background: #fdf1e7; padding: .3rem .8rem; margin: .4rem 0; }
.good { border-left: .4rem solid #009e73; background: #eaf7f2; padding: .3rem .8rem; }
img, svg { display: block; width: 100%; height: auto; border: 1px solid #ccc; }
.swatch { display: inline-block; width: 1em; height: 1em; border: 1px solid #666; vertical-align: -.15em; }
summary { cursor: pointer; font-weight: bold; margin: .6rem 0; }
@page { size: A4; margin: 13mm 15mm 16mm; font: 7.5pt "DejaVu Sans", Verdana, sans-serif; color: #555;
  @bottom-right { content: counter(page) " / " counter(pages); } }
@media print {
  body { max-width: none; margin: 0; padding: 0; font-size: 8.5pt; line-height: 1.35; }
  h1 { font-size: 15pt; } h2 { font-size: 11.5pt; margin: 5mm 0 2mm; } h3 { font-size: 9pt; margin: 3mm 0 1mm; }
  h1, h2, h3 { break-after: avoid; }
  table { font-size: 7.5pt; margin: 1mm 0; } th, td { padding: .5mm 1.5mm; }
  table.keys { font-size: 6.3pt; line-height: 1.2; } table.keys td { padding: .2mm 1mm; }
  thead { display: table-header-group; }
  tr, .columns, figure, img, svg, .warning { break-inside: avoid; }
  p { orphans: 3; widows: 3; }
  .small, figcaption { font-size: 7.5pt; }
  .columns { grid-template-columns: 1fr 1fr; gap: 1mm 6mm; }
  figure { margin: 1.5mm 0; }
  figure svg { width: auto; max-width: 100%; max-height: 44mm; }
  figure img { width: auto; max-width: 100%; max-height: 110mm; }
  .warning, .good { background: none; border-left-width: 1.5mm; padding: .3mm 2mm; margin: 1mm 0; }
  details { display: none; }
  a { color: inherit; text-decoration: none; }
  .answer { display: flex; flex-direction: column; min-height: 265mm; }
  .answer.plain { display: block; min-height: 0; }
  .answer p { margin: 1mm 0; }
  .answer figure { flex: 1 1 95mm; min-height: 95mm; max-height: 140mm; display: flex; flex-direction: column; }
  .answer figure img { flex: 1 1 0; min-height: 0; max-height: none; object-fit: contain; border: 0; }
  figure svg.page { width: 180mm; max-width: none; max-height: none; }
  figure img.page, .answer figure img.page { flex: none; width: 180mm; max-width: none; max-height: none; border: 0; }
}
)";

std::string cell(const char* open, const std::string& text, const char* close) {
    return open + escaped_markup(text) + close;
}

std::string value_cells(const std::string& name, const std::string& value, const std::string& unit) {
    return cell("<td>", name, "</td>") + cell("<td class=\"n\">", value, "</td>") +
           cell("<td class=\"u\">", unit, "</td>");
}

}  // namespace

HtmlTable::HtmlTable(const std::vector<std::string>& heads) {
    for (const std::string& head : heads)
        head_ += head.empty() ? "<td></td>" : cell("<th scope=\"col\">", head, "</th>");
    if (!heads.empty()) head_ = "<thead><tr>" + head_ + "</tr></thead>\n";
}

HtmlTable& HtmlTable::row(const std::vector<std::string>& cells, const std::string& kind) {
    rows_ += kind.empty() ? "<tr>" : "<tr class=\"" + kind + "\">";
    for (const std::string& text : cells) rows_ += cell("<td>", text, "</td>");
    rows_ += "</tr>\n";
    return *this;
}

HtmlTable& HtmlTable::number(const std::string& name, const std::string& value, const std::string& unit,
                             const std::vector<std::string>& more) {
    rows_ += "<tr>" + value_cells(name, value, unit);
    for (const std::string& text : more) rows_ += cell("<td class=\"soft\">", text, "</td>");
    rows_ += "</tr>\n";
    return *this;
}

HtmlTable& HtmlTable::number_with(const std::string& name, const std::string& value, const std::string& unit,
                                  const std::string& cells) {
    rows_ += "<tr>" + value_cells(name, value, unit) + cells + "</tr>\n";
    return *this;
}

HtmlTable& HtmlTable::raw(const std::string& html) {
    rows_ += html;
    return *this;
}

std::string HtmlTable::html(const std::string& kind) const {
    return (kind.empty() ? "<table>\n" : "<table class=\"" + kind + "\">\n") + head_ + "<tbody>\n" + rows_ +
           "</tbody>\n</table>\n";
}

std::string small_print(const std::string& text) {
    return "<p class=\"small\">" + escaped_markup(text) + "</p>\n";
}

namespace {

namespace fs = std::filesystem;

// Of all pictures of a page: with base64 a third more, so that with texts and charts it stays below 4 MB.
constexpr std::size_t k_all_picture_bytes = 2'400'000;
constexpr int k_picture_columns = 1600;
constexpr std::size_t k_foot_letters = 60;
constexpr std::size_t k_warning_letters = 1000;  // of all in an answer

/// Charts of studies and calibrations, by the names of their files.
struct ChartTitle {
    const char *name, *title;
};
constexpr ChartTitle k_chart_titles[] = {
    {"exceedance", worded("exceedance")},
    {"sensitivity", worded("sensitivity of the results")},
    {"convergence", worded("convergence of the probabilities")},
    {"response", worded("score over pairs of values")},
    {"posterior", worded("values before and after the calibration")},
    {"forecast", worded("fitted, and predicted from the other events")},
};

/// The title of a map or chart from the name of its file; names that no table has stay, with spaces.
std::string picture_title(const std::string& name, const Words& words) {
    const std::string layer = raster_of_map(name);
    if (const ResultRaster* const row = find_result_raster(layer)) return raster_title(*row, layer, words);
    for (const ChartTitle& chart : k_chart_titles)
        if (name == chart.name) return words(chart.title);
    std::string title = name;
    std::replace(title.begin(), title.end(), '_', ' ');
    return title;
}

/// A text as a string of CSS: whatever it contains, it ends neither the string nor the style.
std::string css_text(const std::string& text) {
    std::string quoted = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte >= 0x80 || std::isalnum(byte) != 0 || c == ' ') {
            quoted += c;
        } else {
            char code[8];
            std::snprintf(code, sizeof code, "\\%02x ", static_cast<unsigned>(byte));
            quoted += code;
        }
    }
    return quoted + "\"";
}

std::string begin_of(const std::string& name) {
    return "<!--part " + name + "-->";
}
std::string end_of(const std::string& name) {
    return "<!--end of " + name + "-->";
}

}  // namespace

HtmlPage::HtmlPage(const std::string& path, const std::string& title, const std::string& origin, const Words& words,
                   Opening opening)
    : folder_(fs::path(path).parent_path().string()),
      aside_(path),
      file_(aside_.partial_path(), std::ios::binary),
      words_(words),
      picture_bytes_(k_picture_bytes) {
    // The title at the foot of each printed page, where a browser can.
    const std::string foot =
        "@page { @bottom-left { content: " + css_text(elided(shown_text(title), k_foot_letters)) + "; } }\n";
    add("<!DOCTYPE html>\n<html lang=\"" + language_code(words.language()) +
        "\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width, "
        "initial-scale=1\">\n<title>" +
        escaped_markup(title) + "</title>\n<style>" + k_page_style + foot + "</style>\n</head>\n<body>\n" +
        (opening == Opening::title    ? ""
         : opening == Opening::answer ? "<section class=\"answer plain\">\n"
                                      : "<section class=\"answer\">\n") +
        "<h1>" + escaped_markup(title) + "</h1>\n<p class=\"small\">" + escaped_markup(origin) + "</p>\n");
}

void HtmlPage::expect_pictures(std::size_t count) {
    picture_bytes_ = std::min(k_picture_bytes, k_all_picture_bytes / std::max<std::size_t>(1, count));
}

void HtmlPage::add_heading(const std::string& id, const std::string& text) {
    add("<h2 id=\"" + id + "\">" + escaped_markup(text) + "</h2>\n");
}

void HtmlPage::add_warnings(const std::vector<Sentence>& warnings) {
    add_heading("warnings", words_("Warnings"));
    if (warnings.empty()) add("<p class=\"good\">" + escaped_markup(words_("The run gave no warnings.")) + "</p>\n");
    for (const Sentence& warning : warnings)
        add("<p class=\"warning\">" + escaped_markup(valid_utf8(warning.in(words_))) + "</p>\n");
}

void HtmlPage::add_picture(const std::string& path, const std::string& caption, const std::string& alt) {
    add(figure_html(path, caption, alt, picture_bytes_));
}

void HtmlPage::add_pictures(const std::vector<std::string>& paths, const std::string& kind) {
    for (const std::string& path : paths) {
        const std::string title = picture_title(fs::path(path).stem().string(), words_),
                          alt = words_.labelled(kind, title), own = drawn_for_page(folder_, path);
        if (own.ends_with(".svg"))
            add(svg_figure(read_text_file(own), title, alt));
        else
            add_picture(own, title, alt);
    }
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

std::string figure_html(const std::string& path, const std::string& caption, const std::string& alt,
                        std::size_t most_bytes) {
    const gis::PagePicture picture = gis::page_picture(path, k_picture_columns, most_bytes);
    // A picture drawn for the page has its size in print, which its scale needs.
    const bool for_page = fs::path(path).parent_path().filename() == k_page_folder;
    return std::string("<figure>\n<img ") + (for_page ? "class=\"page\" " : "") + "alt=\"" + escaped_markup(alt) +
           "\" width=\"" + std::to_string(picture.width) + "\" height=\"" + std::to_string(picture.height) +
           "\" src=\"data:" + picture.mime + ";base64," + base64(picture.bytes) + "\">\n<figcaption>" +
           escaped_markup(caption) + "</figcaption>\n</figure>\n";
}

std::string svg_figure(const std::string& svg, const std::string& caption, const std::string& alt) {
    // The element, a picture by its role, gets a name for those who cannot see it.
    const std::string tag = "<svg ";
    const std::size_t at = svg.find(tag);
    const std::string named = at == std::string::npos
                                  ? svg
                                  : svg.substr(at, tag.size()) + (caption.empty() ? "" : "class=\"page\" ") +
                                        "aria-label=\"" + escaped_markup(alt) + "\" " + svg.substr(at + tag.size());
    return "<figure>\n" + named +
           (caption.empty() ? "" : "<figcaption>" + escaped_markup(caption) + "</figcaption>\n") + "</figure>\n";
}

std::string drawn_for_page(const std::string& folder, const std::string& path) {
    const fs::path stem = fs::path(folder) / k_page_folder / fs::path(path).stem();
    for (const char* ending : {".svg", ".png"})
        if (const std::string own = stem.string() + ending; fs::exists(own)) return own;
    return path;
}

void remove_page_pictures(const std::string& folder) {
    std::error_code ignored;
    fs::remove_all(fs::path(folder) / k_page_folder, ignored);
}

std::string first_warnings(const std::vector<Sentence>& warnings, const Words& words) {
    if (warnings.empty()) return "<p>" + escaped_markup(words("The run gave no warnings.")) + "</p>\n";
    std::string html;
    // Whole sentences, as many as leave room for the answer: half a warning may say the opposite.
    std::size_t told = 0, letters = 0;
    for (; told < warnings.size(); ++told) {
        const std::string text = valid_utf8(warnings[told].in(words));
        letters += text.size();
        if (told > 0 && letters > k_warning_letters) break;
        html +=
            "<p class=\"warning\"><b>" + escaped_markup(words("Warning:")) + "</b> " + escaped_markup(text) + "</p>\n";
    }
    if (warnings.size() > told)
        html += "<p>" + escaped_markup(words("{1} warnings in all, see below.", {std::to_string(warnings.size())})) +
                "</p>\n";
    return html;
}

std::vector<std::string> pictures_in(const std::string& folder) {
    std::vector<std::string> paths;
    for (const fs::directory_entry& entry : folder_entries(fs::path(folder)))
        if (entry.path().extension() == ".png") paths.push_back(entry.path().string());
    std::sort(paths.begin(), paths.end());
    return paths;
}

std::string page_part(const std::string& name, const std::string& html) {
    return begin_of(name) + "\n" + html + end_of(name) + "\n";
}

std::optional<std::string> with_part(const std::string& page, const std::string& name, const std::string& html) {
    const std::size_t begin = page.find(begin_of(name));
    if (begin == std::string::npos) return std::nullopt;
    const std::size_t content = begin + begin_of(name).size(), end = page.find(end_of(name), content);
    if (end == std::string::npos) return std::nullopt;
    return page.substr(0, content) + "\n" + html + page.substr(end);
}

Words words_of_page(const std::string& page) {
    const std::string before = "<html lang=\"";
    const std::size_t at = page.find(before);
    if (at == std::string::npos) return {};
    return Words(language_of_code(page.substr(at + before.size(), 2)).value_or(Language::english));
}

bool renew_page(const std::string& folder, const std::function<std::vector<PagePart>(const Words&)>& parts) {
    const std::string path = (std::filesystem::path(folder) / k_report_file).string();
    if (!std::filesystem::exists(path)) return true;
    std::string page = read_text_file(path);
    for (const PagePart& part : parts(words_of_page(page))) {
        if (auto renewed = with_part(page, part.name, part.html))
            page = std::move(*renewed);
        else if (!part.optional)
            return false;
    }
    const bool in_making = std::filesystem::exists(std::filesystem::path(folder) / k_building_file);
    if (!in_making) begin_own(folder, {path});
    write_text_file(path, page);
    if (!in_making) record_files({path});
    return true;
}

}  // namespace frana::app
