// SPDX-License-Identifier: Apache-2.0
#include "app/publish/html_page.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "app/pictures/class_words.h"
#include "app/publish/page_style.h"
#include "app/store/result_files.h"
#include "app/text/text_file.h"
#include "core/base64.h"
#include "core/error.h"
#include "core/folder_entries.h"
#include "core/markup.h"
#include "core/utf8.h"
#include "gis/raster/page_picture.h"
#include "params/keys/result_rasters.h"

namespace frana::app {
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

}  // namespace frana::app
