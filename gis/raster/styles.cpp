// SPDX-License-Identifier: Apache-2.0
#include "gis/raster/styles.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <sstream>

#include "core/files.h"
#include "core/text.h"

namespace frana::gis {
namespace {

const char* qgis_ramp_type(StyleKind kind) {
    switch (kind) {
        case StyleKind::ramp:
            return "INTERPOLATED";
        case StyleKind::classed:
            return "DISCRETE";
        case StyleKind::exact:
            return "EXACT";
    }
    return "";
}

const char* sld_map_type(StyleKind kind) {
    switch (kind) {
        case StyleKind::ramp:
            return "ramp";
        case StyleKind::classed:
            return "intervals";
        case StyleKind::exact:
            return "values";
    }
    return "";
}

std::string qml(const std::vector<ColourStop>& stops, const std::string& unit, StyleKind kind) {
    std::ostringstream out;
    const double least = stops.empty() ? 0 : stops.front().value;
    double most = stops.empty() ? 1 : stops.back().value;
    if (std::isinf(most)) most = stops.size() > 1 ? stops[stops.size() - 2].value : 1;
    out << "  <pipe>\n"
        << "    <rasterrenderer type=\"singlebandpseudocolor\" band=\"1\" opacity=\"1\" alphaBand=\"-1\" "
        << "nodataColor=\"\" classificationMin=\"" << shortest_text(kind == StyleKind::classed ? 0 : least)
        << "\" classificationMax=\"" << shortest_text(most) << "\">\n"
        << "      <rastershader>\n        <colorrampshader colorRampType=\"" << qgis_ramp_type(kind)
        << "\" classificationMode=\"1\" clip=\"0\" labelPrecision=\"4\">\n";
    for (std::size_t i = 0; i < stops.size(); ++i) {
        // QGIS leaves values above the last class uncoloured; its maps always end in infinity.
        const bool last_class = kind == StyleKind::classed && i + 1 == stops.size();
        out << "          <item value=\"" << (last_class ? "inf" : shortest_text(stops[i].value)) << "\" color=\""
            << hex(stops[i].colour) << "\" alpha=\"" << (stops[i].transparent ? 0 : 255) << "\" label=\""
            << escaped_markup(stops[i].label) << "\"/>\n";
    }
    out << "          <rampLegendSettings suffix=\"" << escaped_markup(unit.empty() ? "" : " " + unit) << "\"/>\n"
        << "        </colorrampshader>\n      </rastershader>\n    </rasterrenderer>\n"
        << "    <brightnesscontrast/>\n    <huesaturation/>\n    <rasterresampler maxOversampling=\"1\"/>\n"
        << "  </pipe>\n";
    return qml_document(out.str());
}

std::string sld(const std::string& name, const std::string& title, const std::vector<ColourStop>& stops,
                const std::string& unit, StyleKind kind) {
    std::ostringstream out;
    out << "        <Rule>\n          <RasterSymbolizer>\n            <ColorMap type=\"" << sld_map_type(kind)
        << "\">\n";
    for (std::size_t i = 0; i < stops.size(); ++i) {
        // The same open end as in the QGIS style, as the largest Float32 number.
        const bool last_class = kind == StyleKind::classed && i + 1 == stops.size();
        out << "              <ColorMapEntry quantity=\"" << (last_class ? "3.4e+38" : shortest_text(stops[i].value))
            << "\" color=\"" << hex(stops[i].colour) << "\" opacity=\"" << (stops[i].transparent ? 0 : 1)
            << "\" label=\"" << escaped_markup(stops[i].label) << "\"/>\n";
    }
    out << "            </ColorMap>\n          </RasterSymbolizer>\n        </Rule>\n";
    return sld_document(name, title + (unit.empty() ? "" : " [" + unit + "]"), out.str());
}

// Half transparent, so that the ground below the zones is visible.
constexpr double k_zone_opacity = 0.6;

// Pale yellow lines would not be seen on white.
constexpr Rgb k_hatch{230, 180, 0};

/// @param brush of QGIS
std::string fill_layer(Rgb c, const char* brush) {
    std::ostringstream out;
    out << "        <layer class=\"SimpleFill\" pass=\"0\" locked=\"0\" enabled=\"1\">\n          <prop k=\"color\" "
           "v=\""
        << int(c.r) << ',' << int(c.g) << ',' << int(c.b) << ",255\"/>\n          <prop k=\"style\" v=\"" << brush
        << "\"/>\n          <prop k=\"outline_style\" v=\"no\"/>\n        </layer>\n";
    return out.str();
}

std::string polygon_qml(const std::string& attribute, const std::vector<ColourStop>& stops) {
    std::ostringstream out, symbols;
    out << "  <renderer-v2 type=\"categorizedSymbol\" attr=\"" << escaped_markup(attribute)
        << "\" symbollevels=\"0\" enableorderby=\"0\" forceraster=\"0\">\n    <categories>\n";
    for (std::size_t i = 0; i < stops.size(); ++i) {
        out << "      <category symbol=\"" << i << "\" value=\"" << shortest_text(stops[i].value)
            << "\" type=\"double\" label=\"" << escaped_markup(stops[i].label) << "\" render=\"true\"/>\n";
        const Rgb c = stops[i].colour;
        symbols << "      <symbol type=\"fill\" name=\"" << i << "\" alpha=\"" << k_zone_opacity
                << "\" clip_to_extent=\"1\" force_rhr=\"0\">\n"
                << (stops[i].hatched ? fill_layer({255, 255, 255}, "solid") + fill_layer(k_hatch, "b_diagonal")
                                     : fill_layer(c, "solid"))
                << "      </symbol>\n";
    }
    out << "    </categories>\n    <symbols>\n" << symbols.str() << "    </symbols>\n  </renderer-v2>\n";
    return qml_document(out.str());
}

std::string polygon_sld(const std::string& name, const std::string& title, const std::string& attribute,
                        const std::vector<ColourStop>& stops) {
    std::ostringstream out;
    for (const ColourStop& stop : stops) {
        out << "        <Rule>\n          <Name>" << escaped_markup(stop.label) << "</Name>\n          <ogc:Filter>\n"
            << "            <ogc:PropertyIsEqualTo><ogc:PropertyName>" << escaped_markup(attribute)
            << "</ogc:PropertyName><ogc:Literal>" << shortest_text(stop.value)
            << "</ogc:Literal></ogc:PropertyIsEqualTo>\n          </ogc:Filter>\n"
            << "          <PolygonSymbolizer>\n            <Fill>\n              <CssParameter name=\"fill\">"
            << hex(stop.colour) << "</CssParameter>\n              <CssParameter name=\"fill-opacity\">"
            << k_zone_opacity << "</CssParameter>\n            </Fill>\n          </PolygonSymbolizer>\n"
            << "        </Rule>\n";
    }
    return sld_document(name, title, out.str());
}

}  // namespace

std::vector<ColourStop> class_stops(const Palette& palette, const std::vector<double>& bounds, const std::string& unit,
                                    const Words& words, bool zero_is_blank) {
    std::vector<ColourStop> stops;
    const auto number = [&](double value) { return words.number(shortest_text(value)); };
    if (zero_is_blank && !bounds.empty())
        stops.push_back({bounds.front(), {255, 255, 255}, number(bounds.front()), true});
    const std::size_t classes = bounds.size() < 2 ? 0 : bounds.size() - 1;
    for (std::size_t i = 0; i < classes; ++i) {
        const double t = classes == 1 ? 0 : static_cast<double>(i) / static_cast<double>(classes - 1);
        const std::string range = std::isinf(bounds[i])       ? "< " + number(bounds[i + 1])
                                  : std::isinf(bounds[i + 1]) ? "> " + number(bounds[i])
                                                              : number(bounds[i]) + " \u2013 " + number(bounds[i + 1]);
        stops.push_back({bounds[i + 1], colour_at(palette, t), range + (unit.empty() ? "" : " " + unit)});
    }
    return stops;
}

void write_styles(const std::string& tif_path, const std::vector<ColourStop>& stops, const std::string& unit,
                  StyleKind kind, const std::string& title) {
    const std::string name = std::filesystem::path(tif_path).stem().string();
    write_style(tif_path, {qml(stops, unit, kind), sld(name, title.empty() ? name : title, stops, unit, kind)});
}

StyleText polygon_style(const std::string& name, const std::string& title, const std::string& attribute,
                        const std::vector<ColourStop>& stops) {
    return {polygon_qml(attribute, stops), polygon_sld(name, title, attribute, stops)};
}

StyleText relief_style(const std::string& name, const std::string& title) {
    // Elevations are resampled, not the shades: otherwise a project of another CRS shows the edges of all cells.
    // Between bilinear ones each cell has one slope, and a sheet is a mosaic. Less contrast: sunny slopes are not
    // bleached.
    return {
        qml_document("  <pipe>\n    <provider><resampling enabled=\"true\" zoomedInResamplingMethod=\"cubic\" "
                     "zoomedOutResamplingMethod=\"bilinear\" maxOversampling=\"2\"/></provider>\n"
                     "    <resamplingStage>provider</resamplingStage>\n"
                     "    <rasterrenderer type=\"hillshade\" band=\"1\" azimuth=\"315\" angle=\"45\" zfactor=\"1\" "
                     "multidirection=\"0\" opacity=\"1\" alphaBand=\"-1\" nodataColor=\"\"/>\n"
                     "    <brightnesscontrast brightness=\"40\" contrast=\"-20\"/>\n    <huesaturation/>\n  </pipe>\n"),
        sld_document(name, title,
                     "        <Rule>\n          <RasterSymbolizer>\n            <ShadedRelief/>\n          "
                     "</RasterSymbolizer>\n        </Rule>\n")};
}

void write_style(const std::string& path, const StyleText& style) {
    std::filesystem::path beside = path;
    write_file(beside.replace_extension(".qml").string(), style.qml);
    write_file(beside.replace_extension(".sld").string(), style.sld);
}

}  // namespace frana::gis
