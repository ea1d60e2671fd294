// SPDX-License-Identifier: Apache-2.0
#include "gis/vector/style_titles.h"

#include "core/markup.h"

namespace frana::gis {

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
