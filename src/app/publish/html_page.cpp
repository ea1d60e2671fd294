// SPDX-License-Identifier: Apache-2.0
#include "app/publish/html_page.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <ostream>

#include "app/store/result_files.h"
#include "app/text/text_file.h"
#include "core/error.h"
#include "core/files.h"
#include "core/text.h"
#include "gis/raster/picture_file.h"

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
@media screen and (max-width: 40rem) { .answer table { font-size: .7rem; }
  .answer th, .answer td { overflow-wrap: normal; padding: .15rem .2rem; } }
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

namespace fs = std::filesystem;

// Of all pictures of a page: with base64 a third more, so that with texts and charts it stays below 4 MB.
constexpr std::size_t k_picture_bytes = 250'000, k_all_picture_bytes = 2'400'000;
constexpr int k_picture_columns = 1600;
constexpr std::size_t k_foot_letters = 60;

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

std::string element(const std::string& name, const std::string& kind, const std::string& html) {
    return "<" + name + (kind.empty() ? "" : " class=\"" + kind + "\"") + ">" + html + "</" + name + ">";
}

std::string html_of(const Cell& cell) {
    const std::string swatch =
        cell.swatch.empty() ? "" : "<span class=\"swatch\" style=\"background:" + cell.swatch + "\"></span>";
    return element("td", cell.kind,
                   swatch + (swatch.empty() || cell.text.empty() ? "" : " ") + escaped_markup(cell.text));
}

/// Writes blocks as HTML.
class Renderer {
  public:
    Renderer(std::ostream& out, std::size_t most_bytes) : out_(out), most_bytes_(most_bytes) {}

    void operator()(const std::vector<Block>& blocks) const {
        for (const Block& block : blocks) std::visit(*this, block.value);
    }
    void operator()(const Heading& one) const {
        const std::string text = escaped_markup(one.text);
        out_ << (one.id.empty() ? "<h3>" + text + "</h3>\n" : "<h2 id=\"" + one.id + "\">" + text + "</h2>\n");
    }
    void operator()(const Paragraph& one) const {
        std::string html = one.lead.empty() ? "" : "<b>" + escaped_markup(one.lead) + "</b>";
        for (const Span& span : one.text) {
            if (!html.empty() && !span.text.empty() && !html.ends_with("\n")) html += " ";
            const std::string text = escaped_markup(span.text);
            html += span.link.empty() ? text : "<a href=\"" + span.link + "\">" + text + "</a>.";
        }
        out_ << element("p", one.kind, html) << "\n";
    }
    void operator()(const List& one) const {
        out_ << "<ul>\n";
        for (const std::string& item : one.items) out_ << element("li", "", escaped_markup(item)) << "\n";
        out_ << "</ul>\n";
    }
    void operator()(const Table& one) const {
        out_ << (one.kind().empty() ? "<table>\n" : "<table class=\"" + one.kind() + "\">\n");
        std::string head;
        for (const std::string& text : one.heads())
            head += text.empty() ? "<td></td>" : "<th scope=\"col\">" + escaped_markup(text) + "</th>";
        if (!head.empty()) out_ << "<thead>" << element("tr", "", head) << "</thead>\n";
        out_ << "<tbody>\n";
        for (const auto& [kind, cells] : one.rows()) {
            std::string row;
            for (const Cell& cell : cells) row += html_of(cell);
            out_ << element("tr", kind, row) << "\n";
        }
        out_ << "</tbody>\n</table>\n";
    }
    void operator()(const Figure& one) const {
        if (!one.svg.empty() || one.file.ends_with(".svg"))
            drawing(one.svg.empty() ? read_text_file(one.file) : one.svg, one);
        else
            picture(one);
    }
    void operator()(const Group& one) const {
        const bool is_folded = one.kind == "folded";
        out_ << (is_folded               ? "<details>\n<summary>" + escaped_markup(one.title) + "</summary>\n"
                 : one.kind == "columns" ? "<div class=\"columns\">\n"
                                         : "<div>\n");
        (*this)(one.content);
        out_ << (is_folded ? "</details>\n" : "</div>\n");
    }
    void operator()(const AnswerEnd&) const { out_ << "</section>\n"; }

  private:
    /// A JPEG of at most so many bytes if the file is larger.
    void picture(const Figure& one) const {
        const gis::PagePicture embedded = gis::page_picture(one.file, k_picture_columns, most_bytes_);
        // A picture drawn for the page has its size in print, which its scale needs.
        const bool for_page = fs::path(one.file).parent_path().filename() == k_page_folder;
        out_ << "<figure>\n<img " << (for_page ? "class=\"page\" " : "") << "alt=\"" << escaped_markup(one.alt)
             << "\" width=\"" << embedded.width << "\" height=\"" << embedded.height
             << "\" src=\"data:" << embedded.mime << ";base64," << base64(embedded.bytes) << "\">\n"
             << element("figcaption", "", escaped_markup(one.caption)) << "\n</figure>\n";
    }
    /// The element, a picture by its role, gets a name for those who cannot see it.
    void drawing(const std::string& svg, const Figure& one) const {
        const std::string tag = "<svg ";
        const std::size_t at = svg.find(tag);
        const std::string named = at == std::string::npos
                                      ? svg
                                      : svg.substr(at, tag.size()) + "class=\"page\" aria-label=\"" +
                                            escaped_markup(one.alt) + "\" " + svg.substr(at + tag.size());
        out_ << "<figure>\n"
             << named << element("figcaption", "", escaped_markup(one.caption)) << "\n"
             << "</figure>\n";
    }

    std::ostream& out_;
    std::size_t most_bytes_;
};

std::size_t count_of_files(const std::vector<Block>& blocks) {
    std::size_t count = 0;
    for (const Block& block : blocks) {
        if (const Figure* const figure = std::get_if<Figure>(&block.value)) count += figure->file.empty() ? 0 : 1;
        if (const Group* const group = std::get_if<Group>(&block.value)) count += count_of_files(group->content);
    }
    return count;
}

std::string html_head(const PageHead& head) {
    // The title at the foot of each printed page, where a browser can.
    const std::string foot =
        "@page { @bottom-left { content: " + css_text(elided(shown_text(head.title), k_foot_letters)) + "; } }\n";
    const char* const section = head.opening == Opening::title    ? ""
                                : head.opening == Opening::answer ? "<section class=\"answer plain\">\n"
                                                                  : "<section class=\"answer\">\n";
    return "<!DOCTYPE html>\n<html lang=\"" + language_code(head.words.language()) +
           "\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width, "
           "initial-scale=1\">\n<title>" +
           escaped_markup(head.title) + "</title>\n<style>" + k_page_style + foot + "</style>\n</head>\n<body>\n" +
           section + "<h1>" + escaped_markup(head.title) + "</h1>\n" +
           element("p", "small", escaped_markup(head.origin)) + "\n";
}

}  // namespace

void write_page(const std::string& folder, const PageHead& head, const Document& document) {
    FileAside aside((fs::path(folder) / k_report_file).string());
    std::ofstream file(aside.partial_path(), std::ios::binary);
    file << html_head(head);
    // All share the bytes that a page may have.
    const std::size_t pictures = std::max<std::size_t>(1, count_of_files(document.blocks()));
    Renderer{file, std::min(k_picture_bytes, k_all_picture_bytes / pictures)}(document.blocks());
    file << "</body>\n</html>\n";
    file.close();
    if (!file) {
        throw Error(ErrorKind::environment, Problem{std::string("cannot be written: ") + std::strerror(errno),
                                                    aside.path(), "", "", "Check the disk's space and the rights"});
    }
    aside.rename_into_place();
    std::error_code ignored;
    fs::remove_all(fs::path(folder) / k_page_folder, ignored);
}

}  // namespace frana::app
