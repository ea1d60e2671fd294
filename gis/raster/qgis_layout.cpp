// SPDX-License-Identifier: Apache-2.0
#include "gis/raster/qgis_layout.h"

#include <cpl_conv.h>
#include <cpl_string.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>
#include <utility>

#include "core/text.h"

namespace frana::gis {
namespace {

// All lengths in millimetres, of letters in points.
constexpr double k_margin = 10, k_gap = 3, k_arrow = 14, k_logo = 18, k_symbol = 9;
constexpr double k_line = 0.43;  // height of a line of one point
constexpr double k_title = 15, k_subtitle = 9, k_note = 8, k_source = 7;

/// Width of a text of one point, of a wide font (DejaVu Sans), so that those of others fit too.
double width_of(std::string_view text) {
    double width = 0;  // in ems
    for (const char c : text) {
        if ((static_cast<unsigned char>(c) & 0xC0U) == 0x80U) continue;  // a byte within a letter
        const std::string_view narrow = "iIjl.,;:'|!()/ ", wide = "mwMW@%";
        width += narrow.find(c) != std::string_view::npos ? 0.4
                 : wide.find(c) != std::string_view::npos ? 1.0
                 : c >= 'A' && c <= 'Z'                   ? 0.76
                                                          : 0.64;
    }
    return 0.3528 * width;
}

/// Breaks a text at spaces into lines that are so wide.
std::vector<std::string> lines_of(const std::string& text, double width, double points) {
    std::vector<std::string> lines;
    std::istringstream paragraphs(text);
    for (std::string paragraph; std::getline(paragraphs, paragraph);) {
        std::istringstream words(paragraph);
        std::string line;
        for (std::string word; words >> word;) {
            const std::string longer = line.empty() ? word : line + ' ' + word;
            if (!line.empty() && width_of(longer) * points > width)
                lines.push_back(std::exchange(line, word));
            else
                line = longer;
        }
        // A word that is wider than the line goes on in the next.
        const double over = std::ceil(width_of(line) * points / width);
        for (double more = 1; more < over; ++more) lines.emplace_back();
        lines.push_back(line);
    }
    return lines;
}

double height_of(const std::string& text, double width, double points) {
    return k_line * points * static_cast<double>(lines_of(text, width, points).size());
}

struct Box {
    double x, y, width, height;
};

/// Where the parts of a sheet are: the map, and a panel with legend and texts, right of it or below it.
struct Arrangement {
    double width = 0, height = 0;
    Box title{}, subtitle{}, map{}, legend{}, scale{}, notes{}, block{}, sources{};
    double points = k_note;  ///< of legend and notes
    int columns = 1;         ///< of the legend
};

/// Breaks the text of a legend for a column of it; | is a break.
std::string wrapped(std::string text, double width, double points) {
    std::replace(text.begin(), text.end(), '|', '/');
    std::string lines;
    for (const std::string& line : lines_of(text, width, points)) lines += (lines.empty() ? "" : "|") + line;
    return escaped_markup(lines);
}

/// Height of what the legend says of one layer.
double legend_height(const ProjectLayout& sheet, std::size_t layer, double width, double points) {
    const auto rows = [&](const std::string& text) {
        return static_cast<double>(lines_of(text, width - k_symbol, points).size());
    };
    if (layer >= sheet.legend.size() || sheet.legend[layer].empty()) return 0;
    double height = 2.5 + k_line * points * rows(sheet.legend[layer]);
    if (layer < sheet.classes.size())
        for (const std::string& label : sheet.classes[layer])
            height += 1.2 + std::max(3.5, k_line * points * rows(label));
    return height;
}

/// Height of the legend: QGIS fills its columns layer by layer, the least high way.
double legend_height(const ProjectLayout& sheet, double width, double points, int columns) {
    double all = 0, best = 0;
    for (std::size_t i = 0; i < sheet.legend.size(); ++i) all += legend_height(sheet, i, width / columns, points);
    if (columns == 1) return all;
    best = all;
    double first = 0;
    for (std::size_t i = 0; i < sheet.legend.size(); ++i) {
        first += legend_height(sheet, i, width / columns, points);
        best = std::min(best, std::max(first, all - first));
    }
    return best;
}

/// The parts of these sheets, as high as the longest text of each needs.
Arrangement arranged(const std::vector<ProjectLayout>& sheets) {
    const bool large = sheets.front().sheet == "A3", portrait = sheets.front().portrait;
    const double longer = large ? 420 : 297, shorter = large ? 297 : 210, side = large ? 85 : 70;
    Arrangement page;
    page.width = portrait ? shorter : longer;
    page.height = portrait ? longer : shorter;
    const double inside = page.width - 2 * k_margin;
    const auto longest = [&](auto text, double width, double points) {
        double height = 0;
        for (const ProjectLayout& sheet : sheets) height = std::max(height, height_of(text(sheet), width, points));
        return height > 0 ? height + 1 : 0;
    };
    page.title = {k_margin, k_margin, inside, longest([](auto& s) { return s.title; }, inside * 0.92, k_title)};
    page.subtitle = {k_margin, page.title.y + page.title.height, inside,
                     longest([](auto& s) { return s.subtitle; }, inside, k_subtitle)};
    const double foot = longest([](auto& s) { return s.sources; }, inside, k_source);
    page.sources = {k_margin, page.height - k_margin - foot, inside, foot};
    const double top = page.subtitle.y + page.subtitle.height + k_gap, bottom = page.sources.y - k_gap;
    const bool logo = !sheets.front().logo.empty();
    const double beside = logo ? k_logo + 2 : 0;
    page.columns = portrait ? 2 : 1;
    double legend = 0, notes = 0, block = 0;
    for (; page.points >= 5; page.points -= 0.5) {
        legend = 0;
        for (const ProjectLayout& sheet : sheets)
            legend = std::max(legend,
                              legend_height(sheet, portrait ? inside - side - k_gap : side, page.points, page.columns));
        notes = longest([](auto& s) { return s.notes; }, side, page.points);
        block = std::max(longest([](auto& s) { return s.title_block; }, side - beside, page.points), logo ? 14.0 : 0.0);
        const double panel = k_arrow + 2 + notes + k_gap + block;
        if (portrait ? std::max(legend, panel) <= (bottom - top) / 2 : legend + panel + k_gap <= bottom - top) break;
    }
    const double panel = k_arrow + 2 + notes + k_gap + block, x = page.width - k_margin - side;
    const double below = portrait ? std::max(legend, panel) : panel;
    page.map = portrait ? Box{k_margin, top, inside, bottom - below - k_gap - top}
                        : Box{k_margin, top, inside - side - k_gap, bottom - top};
    page.legend = portrait ? Box{k_margin, bottom - below, inside - side - k_gap, below}
                           : Box{x, top, side, bottom - panel - k_gap - top};
    const double y = bottom - below;
    page.scale = {x, y, side, k_arrow};
    page.notes = {x, y + k_arrow + 2, side, notes};
    page.block = {x, y + below - block, side, block};
    return page;
}

// QGIS's numbers of the kinds of items.
enum class Item { page = 65638, map = 65639, picture = 65640, label = 65641, legend = 65642, scale_bar = 65646 };

std::string uuid(int layout, int item) {
    char text[40];
    std::snprintf(text, sizeof text, "{00000000-0000-4000-8000-%06d%06d}", layout, item);
    return text;
}

std::string font(const std::string& element, double points, bool bold = false) {
    return "<" + element + " description=\"Sans Serif," + shortest_text(points) + ",-1,5," + (bold ? "75" : "50") +
           ",0,0,0,0,0\"/>";
}

class Writer {
  public:
    Writer(const std::vector<ProjectLayout>& sheets, std::size_t index)
        : at_(arranged(sheets)), layout_(sheets[index]), number_(static_cast<int>(index) + 1) {}

    [[nodiscard]] std::string text(const std::vector<LayerReference>& layers, const std::string& crs) {
        out_ << "    <Layout name=\"" << escaped_markup(layout_.title) << "\" units=\"mm\" printResolution=\"300\" "
             << "worldFileMap=\"" << uuid(number_, k_map) << "\">\n      <PageCollection>\n";
        item(Item::page, {0, 0, at_.width, at_.height}, "", "");
        out_ << "      </PageCollection>\n";
        map(layers, crs);
        label(at_.title, layout_.title, k_title, true);
        label(at_.subtitle, layout_.subtitle, k_subtitle);
        legend(layers);
        // "1 : 5 000", whatever the user makes of the map. Not its map_scale: without a CRS that counts degrees.
        label({at_.scale.x, at_.scale.y, at_.scale.width - k_arrow, 5},
              "[% '1 : ' || regexp_replace(to_string(round(1000 * item_variables('map')['map_extent_width'] / " +
                  std::to_string(at_.map.width) + ")), '(\\\\d)(?=(\\\\d{3})+$)', '\\\\1" + layout_.thousands + "') %]",
              10, true);
        scale_bar({at_.scale.x, at_.scale.y + 5, at_.scale.width - k_arrow, 9});
        item(Item::picture, {at_.scale.x + at_.scale.width - k_arrow, at_.scale.y, k_arrow, k_arrow},
             "file=\"arrows/NorthArrow_02.svg\" northMode=\"0\" mapUuid=\"" + uuid(number_, k_map) + "\"", "");
        label(at_.notes, layout_.notes, at_.points);
        Box block = at_.block;
        if (!layout_.logo.empty()) {
            item(Item::picture, {block.x, block.y, k_logo, block.height},
                 "file=\"" + escaped_markup(layout_.logo) + "\"", "");
            block.x += k_logo + 2;
            block.width -= k_logo + 2;
        }
        label(block, layout_.title_block, at_.points);
        label(at_.sources, layout_.sources, k_source);
        out_ << "    </Layout>\n";
        return out_.str();
    }

  private:
    static constexpr int k_map = 2;  ///< of the items, the page is the first

    void item(Item kind, const Box& box, const std::string& attributes, const std::string& content) {
        const auto pair = [](double a, double b) { return shortest_text(a) + "," + shortest_text(b) + ",mm"; };
        ++count_;
        out_ << "      <LayoutItem type=\"" << static_cast<int>(kind) << "\" uuid=\"" << uuid(number_, count_)
             << "\" position=\"" << pair(box.x, box.y) << "\" positionOnPage=\"" << pair(box.x, box.y) << "\" size=\""
             << pair(box.width, box.height) << "\" visibility=\"1\" opacity=\"1\" zValue=\"" << count_ << "\" "
             << attributes << ">" << content << "</LayoutItem>\n";
    }

    void label(const Box& box, const std::string& text, double points, bool bold = false) {
        if (text.empty()) return;
        item(Item::label, box, "labelText=\"" + escaped_markup(text) + "\" marginX=\"0\" marginY=\"0\"",
             font("LabelFont", points, bold));
    }

    void map(const std::vector<LayerReference>& layers, const std::string& crs) {
        const Bounds& ground = layout_.window;
        std::string content = "<Extent xmin=\"" + shortest_text(ground.west) + "\" ymin=\"" +
                              shortest_text(ground.south) + "\" xmax=\"" + shortest_text(ground.east) + "\" ymax=\"" +
                              shortest_text(ground.north) + "\"/><crs>" + crs + "</crs><LayerSet>";
        for (const LayerReference& layer : layers)
            content += "<Layer name=\"" + escaped_markup(layer.title) + "\" source=\"" + escaped_markup(layer.source) +
                       "\" provider=\"" + layer.provider + "\">" + layer.id + "</Layer>";
        item(Item::map, at_.map,
             "id=\"map\" frame=\"true\" outlineWidthM=\"0.3,mm\" background=\"true\" keepLayerSet=\"true\" "
             "followPreset=\"false\" mapRotation=\"0\"",
             content + "</LayerSet>");
    }

    void legend(const std::vector<LayerReference>& layers) {
        const double width = at_.legend.width / at_.columns - k_symbol;
        std::string content = "<styles>";
        for (const auto& [name, margin] : {std::pair{"subgroup", "marginTop=\"2.5\""},
                                           {"symbol", "marginTop=\"1\""},
                                           {"symbolLabel", "marginLeft=\"2\""}})
            content += std::string("<style name=\"") + name + "\" alignment=\"1\" " + margin + ">" +
                       font("styleFont", at_.points) + "</style>";
        content += "</styles><layer-tree-group name=\"\" checked=\"Qt::Checked\" expanded=\"1\">";
        for (std::size_t i = 0; i < layers.size() && i < layout_.legend.size(); ++i) {
            if (layout_.legend[i].empty()) continue;
            const LayerReference& layer = layers[i];
            content += "<layer-tree-layer id=\"" + layer.id + "\" name=\"" + escaped_markup(layer.title) +
                       "\" source=\"" + escaped_markup(layer.source) + "\" providerKey=\"" + layer.provider +
                       "\" checked=\"Qt::Checked\" expanded=\"1\"><customproperties>";
            const auto property = [&](const std::string& key, const std::string& value) {
                content += "<property key=\"legend/" + key + "\" value=\"" + value + "\"/>";
            };
            property("title-label", wrapped(layout_.legend[i], width, at_.points));
            // Not the first entry of a raster, which is the name of its band.
            std::string order;
            const bool raster = layer.provider == "gdal";
            for (std::size_t entry = 1; i < layout_.classes.size() && entry <= layout_.classes[i].size(); ++entry) {
                const std::string number = std::to_string(raster ? entry : entry - 1);
                order += (entry > 1 ? "," : "") + number;
                property("label-" + number, wrapped(layout_.classes[i][entry - 1], width, at_.points));
            }
            if (!order.empty()) property("node-order", order);
            content += "</customproperties></layer-tree-layer>";
        }
        item(Item::legend, at_.legend,
             "resizeToContents=\"1\" wrapChar=\"|\" columnCount=\"" + std::to_string(at_.columns) +
                 "\" splitLayer=\"0\" equalColumnWidth=\"0\" boxSpace=\"0\" symbolWidth=\"6\" symbolHeight=\"3.5\" "
                 "map_uuid=\"" +
                 uuid(number_, k_map) + "\"",
             content + "</layer-tree-group>");
    }

    /// Two segments in at most seven tenths of its box, each 1, 2 or 5 times a power of ten.
    void scale_bar(const Box& box) {
        const double longest = layout_.window.width() / at_.map.width * box.width * 0.7 / 2;  // of a segment [m]
        double segment = 1;
        for (double decade = 1e-3; decade <= longest; decade *= 10)
            for (const double step : {1.0, 2.0, 5.0})
                if (step * decade <= longest) segment = step * decade;
        item(Item::scale_bar, box,
             "style=\"Single Box\" unitType=\"meters\" unitLabel=\"m\" numMapUnitsPerScaleBarUnit=\"1\" "
             "numSegments=\"2\" numSegmentsLeft=\"0\" segmentSizeMode=\"0\" height=\"2\" boxContentSpace=\"1\" "
             "numUnitsPerSegment=\"" +
                 shortest_text(segment) + "\" mapUuid=\"" + uuid(number_, k_map) + "\"",
             font("scaleBarFont", 7));
    }

    Arrangement at_;
    const ProjectLayout& layout_;
    int number_;
    int count_ = 0;
    std::ostringstream out_;
};

}  // namespace

std::vector<std::string> legend_labels(const std::string& qml) {
    std::vector<std::string> labels;
    for (const std::string entry : {"<item ", "<category "})
        for (std::size_t at = qml.find(entry); at != std::string::npos; at = qml.find(entry, at + 1)) {
            const std::size_t begin = qml.find("label=\"", at) + 7;
            char* const label =
                CPLUnescapeString(qml.substr(begin, qml.find('"', begin) - begin).c_str(), nullptr, CPLES_XML);
            labels.emplace_back(label);
            CPLFree(label);
        }
    return labels;
}

Point frame_of(const std::vector<ProjectLayout>& sheets) {
    const Box map = arranged(sheets).map;
    return {map.width, map.height};
}

std::string layout_element(const std::vector<ProjectLayout>& sheets, std::size_t index,
                           const std::vector<LayerReference>& layers, const std::string& crs) {
    return Writer(sheets, index).text(layers, crs);
}

}  // namespace frana::gis
