// SPDX-License-Identifier: Apache-2.0
#include "gis/vector/vector_style.h"

#include <cmath>
#include <sstream>

#include "core/text.h"

namespace frana::gis {
namespace {

constexpr double k_letters_pt = 9;
constexpr double k_pixels_per_mm = 1 / 0.28;  // SLD's unit is the pixel of 0.28 mm

std::string qml_colour(Rgb c) {
    return std::to_string(c.r) + "," + std::to_string(c.g) + "," + std::to_string(c.b) + ",255";
}

std::string property(const char* key, const std::string& value) {
    return std::string("          <prop k=\"") + key + "\" v=\"" + value + "\"/>\n";
}

std::string symbol(Shape shape, const VectorLook& look, std::size_t number = 0) {
    const std::string colour = qml_colour(look.colour), width = shortest_text(look.width_mm),
                      dashes = look.dashed ? "dash" : "solid";
    std::string kind, layer, properties;
    if (shape == Shape::area) {
        kind = "fill";
        layer = "SimpleFill";
        properties = property("style", "no") + property("outline_color", colour) + property("outline_style", dashes) +
                     property("outline_width", width) + property("outline_width_unit", "MM");
    } else if (shape == Shape::line) {
        kind = "line";
        layer = "SimpleLine";
        properties = property("line_color", colour) + property("line_style", dashes) + property("line_width", width) +
                     property("line_width_unit", "MM");
    } else {
        kind = "marker";
        layer = "SimpleMarker";
        properties = property("name", "circle") + property("color", colour) + property("outline_style", "no") +
                     property("size", width) + property("size_unit", "MM");
    }
    return "      <symbol type=\"" + kind + "\" name=\"" + std::to_string(number) +
           "\" alpha=\"1\" clip_to_extent=\"1\" force_rhr=\"0\">\n" + "        <layer class=\"" + layer +
           "\" pass=\"0\" locked=\"0\" enabled=\"1\">\n" + properties + "        </layer>\n      </symbol>\n";
}

/// Outside the outline, beside the line or over the point, with a white halo.
std::string labels(Shape shape, const VectorLook& look) {
    const int placement = shape == Shape::area ? 1 : shape == Shape::line ? 2 : 0;  // QGIS: over, along, around point
    std::ostringstream out;
    out << "  <labeling type=\"simple\">\n    <settings>\n      <text-style fieldName=\"" << escaped_markup(look.label)
        << "\" isExpression=\"0\" fontSize=\"" << k_letters_pt << "\" fontSizeUnit=\"Point\" textColor=\""
        << qml_colour(look.colour) << "\" namedStyle=\"Regular\">\n"
        << "        <text-buffer bufferDraw=\"1\" bufferSize=\"0.8\" bufferSizeUnits=\"MM\" "
        << "bufferColor=\"255,255,255,255\" bufferOpacity=\"1\"/>\n      </text-style>\n"
        << "      <placement placement=\"" << placement << "\" placementFlags=\"10\" dist=\"1\" distUnits=\"MM\"/>\n"
        << "      <rendering drawLabels=\"1\" obstacle=\"0\"/>\n    </settings>\n  </labeling>\n";
    return out.str();
}

std::string css(const char* name, const std::string& value) {
    return std::string("<CssParameter name=\"") + name + "\">" + value + "</CssParameter>";
}

/// @param filter with the name of the rule; empty: all features
std::string sld_rule(Shape shape, const VectorLook& look, const std::string& filter = "") {
    std::string text = "        <Rule>\n" + filter + "          ";
    if (shape == Shape::point) {
        text += "<PointSymbolizer><Graphic><Mark><WellKnownName>circle</WellKnownName><Fill>" +
                css("fill", hex(look.colour)) + "</Fill></Mark><Size>" +
                shortest_text(look.width_mm * k_pixels_per_mm) + "</Size></Graphic></PointSymbolizer>\n";
    } else {
        const char* const element = shape == Shape::area ? "PolygonSymbolizer" : "LineSymbolizer";
        const double width = look.width_mm * k_pixels_per_mm;
        text +=
            std::string("<") + element + "><Stroke>" + css("stroke", hex(look.colour)) +
            css("stroke-width", shortest_text(width)) +
            (look.dashed ? css("stroke-dasharray", shortest_text(4 * width) + " " + shortest_text(2 * width)) : "") +
            "</Stroke></" + element + ">\n";
    }
    if (!look.label.empty())
        text += "          <TextSymbolizer><Label><ogc:PropertyName>" + escaped_markup(look.label) +
                "</ogc:PropertyName></Label><Font>" + css("font-size", "12") + "</Font><Halo><Radius>2</Radius><Fill>" +
                css("fill", "#ffffff") + "</Fill></Halo><Fill>" + css("fill", hex(look.colour)) +
                "</Fill></TextSymbolizer>\n";
    return text + "        </Rule>\n";
}

std::string sld_filter(const std::string& attribute, const ValueLook& one) {
    const std::string name = "          <Name>" + escaped_markup(one.label) + "</Name>\n          ";
    if (std::isnan(one.value)) return name + "<ElseFilter/>\n";
    return name + "<ogc:Filter><ogc:PropertyIsEqualTo><ogc:PropertyName>" + escaped_markup(attribute) +
           "</ogc:PropertyName><ogc:Literal>" + shortest_text(one.value) +
           "</ogc:Literal></ogc:PropertyIsEqualTo></ogc:Filter>\n";
}

/// QGIS takes the empty value as all others, NULL among them.
std::string qml_category(std::size_t number, const ValueLook& one) {
    const bool is_rest = std::isnan(one.value);
    return "      <category symbol=\"" + std::to_string(number) + "\" value=\"" +
           (is_rest ? "" : shortest_text(one.value)) + "\" type=\"" + (is_rest ? "string" : "double") + "\" label=\"" +
           escaped_markup(one.label) + "\" render=\"true\"/>\n";
}

}  // namespace

std::string qml_document(const std::string& content, bool has_labels) {
    return std::string("<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>\n") +
           "<qgis version=\"3.22.0\" styleCategories=\"Symbology" + (has_labels ? "|Labeling" : "") + "\"" +
           (has_labels ? " labelsEnabled=\"1\"" : "") + ">\n" + content + "  <blendMode>0</blendMode>\n</qgis>\n";
}

std::string sld_document(const std::string& name, const std::string& title, const std::string& rules) {
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
           "<StyledLayerDescriptor version=\"1.0.0\" xmlns=\"http://www.opengis.net/sld\" "
           "xmlns:ogc=\"http://www.opengis.net/ogc\">\n  <NamedLayer>\n    <Name>" +
           escaped_markup(name) + "</Name>\n    <UserStyle>\n      <Title>" + escaped_markup(title) +
           "</Title>\n      <FeatureTypeStyle>\n" + rules +
           "      </FeatureTypeStyle>\n    </UserStyle>\n  </NamedLayer>\n</StyledLayerDescriptor>\n";
}

StyleText style_of(const std::string& name, Shape shape, const VectorLook& look) {
    const bool has_labels = !look.label.empty();
    const std::string renderer =
        "  <renderer-v2 type=\"singleSymbol\" symbollevels=\"0\" enableorderby=\"0\" forceraster=\"0\">\n"
        "    <symbols>\n" +
        symbol(shape, look) + "    </symbols>\n  </renderer-v2>\n";
    return {qml_document(renderer + (has_labels ? labels(shape, look) : ""), has_labels),
            sld_document(name, name, sld_rule(shape, look))};
}

StyleText style_of(const std::string& name, Shape shape, const std::string& attribute,
                   const std::vector<ValueLook>& looks) {
    std::string categories, symbols, rules;
    for (std::size_t i = 0; i < looks.size(); ++i) {
        categories += qml_category(i, looks[i]);
        symbols += symbol(shape, looks[i].look, i);
        rules += sld_rule(shape, looks[i].look, sld_filter(attribute, looks[i]));
    }
    return {
        qml_document("  <renderer-v2 type=\"categorizedSymbol\" attr=\"" + escaped_markup(attribute) +
                     "\" symbollevels=\"0\" enableorderby=\"0\" forceraster=\"0\">\n    <categories>\n" + categories +
                     "    </categories>\n    <symbols>\n" + symbols + "    </symbols>\n  </renderer-v2>\n"),
        sld_document(name, name, rules)};
}

StyleText titled(StyleText style, const std::string& title, const AttributeTitles& attributes) {
    const std::string begin = "<Title>", end = "</Title>", root_end = "</qgis>", categories = "styleCategories=\"";
    if (const std::size_t at = style.sld.find(begin); at != std::string::npos) {
        const std::size_t from = at + begin.size();
        style.sld.replace(from, style.sld.find(end, from) - from, escaped_markup(title));
    }
    const std::size_t place = style.qml.rfind(root_end);
    if (place == std::string::npos || attributes.empty()) return style;
    std::string aliases = "  <aliases>\n";
    for (const auto& [name, text] : attributes)
        aliases += "    <alias field=\"" + escaped_markup(name) + "\" name=\"" + escaped_markup(text) + "\"/>\n";
    style.qml.insert(place, aliases + "  </aliases>\n");
    if (const std::size_t at = style.qml.find(categories); at != std::string::npos)
        style.qml.insert(at + categories.size(), "Fields|");
    return style;
}

}  // namespace frana::gis
