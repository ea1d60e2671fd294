// SPDX-License-Identifier: Apache-2.0
#include "gis/raster/styles.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <sstream>

#include "core/file_aside.h"
#include "core/markup.h"
#include "core/shortest_text.h"

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
    const double least = stops.empty() ? 0 : stops.front().value, most = stops.empty() ? 1 : stops.back().value;
    out << "<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>\n"
        << "<qgis version=\"3.22.0\" styleCategories=\"Symbology\">\n  <pipe>\n"
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
        << "  </pipe>\n  <blendMode>0</blendMode>\n</qgis>\n";
    return out.str();
}

std::string sld(const std::string& name, const std::vector<ColourStop>& stops, const std::string& unit,
                StyleKind kind) {
    std::ostringstream out;
    const std::string title = name + (unit.empty() ? "" : " [" + unit + "]");
    out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        << "<StyledLayerDescriptor version=\"1.0.0\" xmlns=\"http://www.opengis.net/sld\" "
        << "xmlns:ogc=\"http://www.opengis.net/ogc\">\n"
        << "  <NamedLayer>\n    <Name>" << escaped_markup(name) << "</Name>\n    <UserStyle>\n      <Title>"
        << escaped_markup(title) << "</Title>\n      <FeatureTypeStyle>\n        <Rule>\n          <RasterSymbolizer>\n"
        << "            <ColorMap type=\"" << sld_map_type(kind) << "\">\n";
    for (std::size_t i = 0; i < stops.size(); ++i) {
        // The same open end as in the QGIS style, as the largest Float32 number.
        const bool last_class = kind == StyleKind::classed && i + 1 == stops.size();
        out << "              <ColorMapEntry quantity=\"" << (last_class ? "3.4e+38" : shortest_text(stops[i].value))
            << "\" color=\"" << hex(stops[i].colour) << "\" opacity=\"" << (stops[i].transparent ? 0 : 1)
            << "\" label=\"" << escaped_markup(stops[i].label) << "\"/>\n";
    }
    out << "            </ColorMap>\n          </RasterSymbolizer>\n        </Rule>\n      "
           "</FeatureTypeStyle>\n"
        << "    </UserStyle>\n  </NamedLayer>\n</StyledLayerDescriptor>\n";
    return out.str();
}

// Half transparent, so that the ground below the zones is visible.
constexpr double k_zone_opacity = 0.6;

std::string polygon_qml(const std::string& attribute, const std::vector<ColourStop>& stops) {
    std::ostringstream out, symbols;
    out << "<!DOCTYPE qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'>\n"
        << "<qgis version=\"3.22.0\" styleCategories=\"Symbology\">\n"
        << "  <renderer-v2 type=\"categorizedSymbol\" attr=\"" << escaped_markup(attribute)
        << "\" symbollevels=\"0\" enableorderby=\"0\" forceraster=\"0\">\n    <categories>\n";
    for (std::size_t i = 0; i < stops.size(); ++i) {
        out << "      <category symbol=\"" << i << "\" value=\"" << shortest_text(stops[i].value)
            << "\" type=\"double\" label=\"" << escaped_markup(stops[i].label) << "\" render=\"true\"/>\n";
        const Rgb c = stops[i].colour;
        symbols << "      <symbol type=\"fill\" name=\"" << i << "\" alpha=\"" << k_zone_opacity
                << "\" clip_to_extent=\"1\" force_rhr=\"0\">\n        <layer class=\"SimpleFill\" pass=\"0\" "
                << "locked=\"0\" enabled=\"1\">\n          <prop k=\"color\" v=\"" << int(c.r) << ',' << int(c.g) << ','
                << int(c.b) << ",255\"/>\n          <prop k=\"style\" v=\"solid\"/>\n"
                << "          <prop k=\"outline_style\" v=\"no\"/>\n        </layer>\n      </symbol>\n";
    }
    out << "    </categories>\n    <symbols>\n"
        << symbols.str() << "    </symbols>\n  </renderer-v2>\n  <blendMode>0</blendMode>\n</qgis>\n";
    return out.str();
}

std::string polygon_sld(const std::string& name, const std::string& attribute, const std::vector<ColourStop>& stops) {
    std::ostringstream out;
    out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        << "<StyledLayerDescriptor version=\"1.0.0\" xmlns=\"http://www.opengis.net/sld\" "
        << "xmlns:ogc=\"http://www.opengis.net/ogc\">\n  <NamedLayer>\n    <Name>" << escaped_markup(name)
        << "</Name>\n    <UserStyle>\n      <FeatureTypeStyle>\n";
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
    out << "      </FeatureTypeStyle>\n    </UserStyle>\n  </NamedLayer>\n</StyledLayerDescriptor>\n";
    return out.str();
}

}  // namespace

std::vector<ColourStop> class_stops(const Palette& palette, const std::vector<double>& bounds, const std::string& unit,
                                    bool zero_is_blank) {
    std::vector<ColourStop> stops;
    if (zero_is_blank && !bounds.empty())
        stops.push_back({bounds.front(), {255, 255, 255}, shortest_text(bounds.front()), true});
    const std::size_t classes = bounds.size() < 2 ? 0 : bounds.size() - 1;
    for (std::size_t i = 0; i < classes; ++i) {
        const double t = classes == 1 ? 0 : static_cast<double>(i) / static_cast<double>(classes - 1);
        stops.push_back(
            {bounds[i + 1], colour_at(palette, t),
             shortest_text(bounds[i]) + " \u2013 " + shortest_text(bounds[i + 1]) + (unit.empty() ? "" : " " + unit)});
    }
    return stops;
}

void write_styles(const std::string& tif_path, const std::vector<ColourStop>& stops, const std::string& unit,
                  StyleKind kind) {
    const std::filesystem::path tif(tif_path);
    std::filesystem::path beside = tif;
    write_file(beside.replace_extension(".qml").string(), qml(stops, unit, kind));
    write_file(beside.replace_extension(".sld").string(), sld(tif.stem().string(), stops, unit, kind));
}

void write_polygon_styles(const std::string& gpkg_path, const std::string& attribute,
                          const std::vector<ColourStop>& stops) {
    const std::filesystem::path file(gpkg_path);
    std::filesystem::path beside = file;
    write_file(beside.replace_extension(".qml").string(), polygon_qml(attribute, stops));
    write_file(beside.replace_extension(".sld").string(), polygon_sld(file.stem().string(), attribute, stops));
}

}  // namespace frana::gis
