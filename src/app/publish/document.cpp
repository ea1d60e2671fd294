// SPDX-License-Identifier: Apache-2.0
#include "app/publish/document.h"

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "app/pictures/map_layer.h"
#include "app/store/result_files.h"
#include "app/text/text_table.h"
#include "core/files.h"
#include "core/text.h"
#include "params/keys/result_rasters.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t k_warning_letters = 1000;  // of all in an answer

/// The title of a map from the name of its file; names that no table has stay, with spaces.
std::string map_title(const std::string& name, const Words& words) {
    const std::string layer = raster_of_map(name);
    if (const ResultRaster* const row = find_result_raster(layer)) return raster_title(*row, layer, words);
    std::string title = name;
    std::replace(title.begin(), title.end(), '_', ' ');
    return title;
}

/// Puts no line break between the groups of a number, and between a number and its unit.
std::string kept_together(const std::string& text) {
    static constexpr std::string_view k_begins = "0123456789msk%P";
    std::string together;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool in_value = text[i] == ' ' && i > 0 && i + 1 < text.size() && text[i - 1] >= '0' &&
                              text[i - 1] <= '9' && k_begins.find(text[i + 1]) != std::string_view::npos;
        together += in_value ? "\u00A0" : std::string(1, text[i]);
    }
    return together;
}

Paragraph no_warnings(const Words& words, const std::string& kind) {
    return {{{words("The run gave no warnings.")}}, "", kind};
}

}  // namespace

Document& Document::paragraph(const std::string& lead, const std::string& text) {
    return add(Paragraph{{{kept_together(text)}}, lead});
}

Document& Document::warnings(const Warnings& all, const Words& words) {
    heading("warnings", words("Warnings"));
    if (all.empty()) add(no_warnings(words, "good"));
    for (const Warning& warning : all) add(Paragraph{{{valid_utf8(warning.words.in(words))}}, "", "warning"});
    return *this;
}

Document& Document::first_warnings(const Warnings& all, const Words& words) {
    if (all.empty()) return add(no_warnings(words, ""));
    // Half a warning may say the opposite.
    std::size_t told = 0, letters = 0;
    for (; told < all.size(); ++told) {
        const std::string text = valid_utf8(all[told].words.in(words));
        letters += text.size();
        if (told > 0 && letters > k_warning_letters) break;
        add(Paragraph{{{text}}, words("Warning:"), "warning"});
    }
    if (all.size() > told) paragraph(words.labelled(words("Warnings"), std::to_string(all.size())));
    return *this;
}

Document& Document::maps(const std::vector<std::string>& paths, const std::string& folder, const Words& words) {
    for (const std::string& path : paths) {
        const std::string title = map_title(fs::path(path).stem().string(), words);
        add(Figure{drawn_for_page(folder, path), title, title});
    }
    return *this;
}

Document& Document::charts(const std::vector<ChartTitle>& all, const std::string& folder, const Words& words) {
    bool any = false;
    for (const ChartTitle& chart : all) {
        const fs::path path = fs::path(folder) / "charts" / (std::string(chart.name) + ".png");
        if (!fs::exists(path)) continue;
        if (!std::exchange(any, true)) heading("charts", words("Charts"));
        const std::string title = words(chart.title);
        add(Figure{drawn_for_page(folder, path.string()), title, title});
    }
    return *this;
}

std::string drawn_for_page(const std::string& folder, const std::string& path) {
    const fs::path stem = fs::path(folder) / k_page_folder / fs::path(path).stem();
    for (const char* ending : {".svg", ".png"})
        if (const std::string own = stem.string() + ending; fs::exists(own)) return own;
    return path;
}

std::vector<std::string> pictures_in(const std::string& folder) {
    std::vector<std::string> paths;
    for (const fs::directory_entry& entry : folder_entries(fs::path(folder)))
        if (entry.path().extension() == ".png") paths.push_back(entry.path().string());
    std::sort(paths.begin(), paths.end(), precedes);
    return paths;
}

}  // namespace frana::app
