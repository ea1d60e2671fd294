// SPDX-License-Identifier: Apache-2.0
#include "gis/raster/qgis_layout.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "core/text.h"

namespace frana::gis {
namespace {

// All lengths in millimetres.
constexpr double k_margin = 10, k_gap = 3, k_heading = 8, k_least_subtitle = 13, k_foot = 7, k_arrow = 14;

struct Box {
    double x, y, width, height;
};

/// Where the parts of a sheet are: the map, and a panel with legend and texts, right of it or below it.
struct Arrangement {
    double width, height;
    double subtitle;         ///< height
    Box map, legend, panel;  ///< panel: scale, north, values, title block
};

Arrangement arranged(const ProjectLayout& layout) {
    const std::string& sheet = layout.sheet;
    const bool portrait = layout.portrait;
    const double longer = sheet == "A3" ? 420 : 297, shorter = sheet == "A3" ? 297 : 210;
    Arrangement page{portrait ? shorter : longer, portrait ? longer : shorter, 0, {}, {}, {}};
    const double inside = page.width - 2 * k_margin;
    // At 9 points a letter is about 1.7 mm wide and a line 4 mm high; words wrap before a line is full.
    constexpr double k_letter = 1.7, k_line = 4;
    const double lines = std::ceil(1.05 * k_letter * static_cast<double>(layout.subtitle.size()) / inside);
    page.subtitle = std::max(k_least_subtitle, k_line * lines + 1);
    const double top = k_margin + k_heading + page.subtitle + k_gap;
    const double bottom = page.height - k_margin - k_foot - k_gap, side = sheet == "A3" ? 85 : 70;
    const double panel = 62;  // height of the texts beside or below the legend
    if (portrait) {
        page.map = {k_margin, top, inside, bottom - panel - k_gap - top};
        page.legend = {k_margin, bottom - panel, inside - side - k_gap, panel};
        page.panel = {page.width - k_margin - side, bottom - panel, side, panel};
    } else {
        page.map = {k_margin, top, inside - side - k_gap, bottom - top};
        page.legend = {page.width - k_margin - side, top, side, bottom - panel - k_gap - top};
        page.panel = {page.width - k_margin - side, bottom - panel, side, panel};
    }
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

/// Breaks a text, which may contain entities, at spaces into lines of so many letters; | is a break.
std::string wrapped(const std::string& markup, std::size_t letters) {
    std::string lines;
    std::size_t space = std::string::npos, length = 0;
    for (const char c : markup) {
        const bool is_letter = (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
        if (is_letter && ++length > letters && space != std::string::npos) {
            lines[space] = '|';
            length = lines.size() - space;
            space = std::string::npos;
        }
        if (c == ' ') space = lines.size();
        lines += c == '|' ? '/' : c;
    }
    return lines;
}

class Writer {
  public:
    Writer(const ProjectLayout& layout, int number) : layout_(layout), number_(number) {}

    [[nodiscard]] std::string text(const std::vector<LayerReference>& layers, const std::string& crs) {
        const Arrangement at = arranged(layout_);
        const Box& panel = at.panel;
        out_ << "    <Layout name=\"" << escaped_markup(layout_.title) << "\" units=\"mm\" printResolution=\"300\" "
             << "worldFileMap=\"" << uuid(number_, k_map) << "\">\n      <PageCollection>\n";
        item(Item::page, {0, 0, at.width, at.height}, "", "");
        out_ << "      </PageCollection>\n";
        map(at.map, layers, crs);
        label({k_margin, k_margin, at.width - 2 * k_margin, k_heading}, layout_.title, 15, true);
        label({k_margin, k_margin + k_heading, at.width - 2 * k_margin, at.subtitle}, layout_.subtitle, 9);
        legend(at.legend, layers);
        // "1 : 5 000", whatever the user makes of the map. Not its map_scale: without a CRS that counts degrees.
        label({panel.x, panel.y, panel.width - k_arrow, 5},
              "[% '1 : ' || format_number(1000 * item_variables('map')['map_extent_width'] / " +
                  std::to_string(at.map.width) + ", 0) %]",
              10, true);
        scale_bar({panel.x, panel.y + 5, panel.width - k_arrow, 9});
        item(Item::picture, {panel.x + panel.width - k_arrow, panel.y, k_arrow, k_arrow},
             "file=\"arrows/NorthArrow_02.svg\" northMode=\"0\" mapUuid=\"" + uuid(number_, k_map) + "\"", "");
        const double block = layout_.title_block.empty() && layout_.logo.empty() ? 0 : 14;
        const double logo = layout_.logo.empty() ? 0 : 18;
        label({panel.x, panel.y + k_arrow + 2, panel.width, panel.height - k_arrow - 2 - block}, layout_.notes, 8);
        if (logo > 0)
            item(Item::picture, {panel.x, panel.y + panel.height - block, logo, block},
                 "file=\"" + escaped_markup(layout_.logo) + "\"", "");
        label({panel.x + logo + (logo > 0 ? 2 : 0), panel.y + panel.height - block, panel.width - logo, block},
              layout_.title_block, 8);
        label({k_margin, at.height - k_margin - k_foot, at.width - 2 * k_margin, k_foot}, layout_.sources, 7);
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

    void map(const Box& box, const std::vector<LayerReference>& layers, const std::string& crs) {
        const Bounds& ground = layout_.window;
        std::string content = "<Extent xmin=\"" + shortest_text(ground.west) + "\" ymin=\"" +
                              shortest_text(ground.south) + "\" xmax=\"" + shortest_text(ground.east) + "\" ymax=\"" +
                              shortest_text(ground.north) + "\"/><crs>" + crs + "</crs><LayerSet>";
        for (const LayerReference& layer : layers)
            content += "<Layer name=\"" + escaped_markup(layer.title) + "\" source=\"" + escaped_markup(layer.source) +
                       "\" provider=\"" + layer.provider + "\">" + layer.id + "</Layer>";
        item(Item::map, box,
             "id=\"map\" frame=\"true\" outlineWidthM=\"0.3,mm\" background=\"true\" keepLayerSet=\"true\" "
             "followPreset=\"false\" mapRotation=\"0\"",
             content + "</LayerSet>");
    }

    void legend(const Box& box, const std::vector<LayerReference>& layers) {
        constexpr double k_letter = 1.6, k_symbol = 9;
        const int columns = layout_.portrait ? 2 : 1;
        const auto letters = static_cast<std::size_t>((box.width / columns - k_symbol) / k_letter);
        std::string content = "<styles>";
        for (const auto& [name, margin] : {std::pair{"subgroup", "marginTop=\"2.5\""},
                                           {"symbol", "marginTop=\"1\""},
                                           {"symbolLabel", "marginLeft=\"2\""}})
            content += std::string("<style name=\"") + name + "\" alignment=\"1\" " + margin + ">" +
                       font("styleFont", 8) + "</style>";
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
            property("title-label", wrapped(escaped_markup(layout_.legend[i]), letters));
            // Not the first entry of a raster, which is the name of its band.
            std::string order;
            for (std::size_t entry = 1; entry <= layer.classes.size(); ++entry) {
                order += (entry > 1 ? "," : "") + std::to_string(entry);
                property("label-" + std::to_string(entry), wrapped(layer.classes[entry - 1], letters));
            }
            if (!order.empty()) property("node-order", order);
            content += "</customproperties></layer-tree-layer>";
        }
        item(Item::legend, box,
             "resizeToContents=\"1\" wrapChar=\"|\" columnCount=\"" + std::to_string(columns) +
                 "\" splitLayer=\"0\" equalColumnWidth=\"0\" boxSpace=\"0\" symbolWidth=\"6\" symbolHeight=\"3.5\" "
                 "map_uuid=\"" +
                 uuid(number_, k_map) + "\"",
             content + "</layer-tree-group>");
    }

    /// Two segments in at most seven tenths of its box, each 1, 2 or 5 times a power of ten.
    void scale_bar(const Box& box) {
        const Point frame = frame_of(layout_);
        const double longest = layout_.window.width() / frame.x * box.width * 0.7 / 2;  // of a segment [m]
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

    const ProjectLayout& layout_;
    int number_;
    int count_ = 0;
    std::ostringstream out_;
};

}  // namespace

Point frame_of(const ProjectLayout& layout) {
    const Box map = arranged(layout).map;
    return {map.width, map.height};
}

std::string layout_element(const ProjectLayout& layout, const std::vector<LayerReference>& layers,
                           const std::string& crs, int number) {
    return Writer(layout, number).text(layers, crs);
}

}  // namespace frana::gis
