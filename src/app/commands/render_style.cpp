// SPDX-License-Identifier: Apache-2.0
#include "app/commands/render_style.h"

#include <algorithm>
#include <cmath>

#include "app/text/number_text.h"
#include "gis/raster/logo_in.h"
#include "params/grammar/picture_text.h"
#include "params/grammar/value_text.h"
#include "params/keys/picture_parameters.h"

namespace frana::app {
namespace {

constexpr double k_least_scale = 100, k_greatest_scale = 1e7;

void read_title_block(const boost::program_options::variables_map& values, MapStyle& style, Problems& problems) {
    style.author = text_option(values, "author").value_or(style.author);
    style.organisation = text_option(values, "organisation").value_or(style.organisation);
    if (const auto date = text_option(values, "date")) style.date = date_on_maps(date, style.date);
    const auto logo = text_option(values, "logo");
    if (logo) style.logo = *logo == "none" ? "" : *logo;
    if (style.logo.empty()) return;
    try {
        (void)gis::read_logo(style.logo, logo ? "--logo" : "output.map-logo, replaced by --logo FILE or --logo none");
    } catch (const Error& error) {
        problems.add(error);
    }
}

void read_scale(const boost::program_options::variables_map& values, MapStyle& style, Problems& problems) {
    const auto text = text_option(values, "scale");
    if (!text) {
        // The scene's scale is for its own paper size.
        if (!is_paper(style.size)) style.scale.reset();
        return;
    }
    style.scale = number_from_text(*text);
    if (!style.scale || *style.scale < k_least_scale || *style.scale > k_greatest_scale) {
        problems.add(
            {"is not a scale", "--scale", *text, "the n of 1 : n, 100 to 10 000 000", "Write for example 5000"});
    } else if (!is_paper(style.size)) {
        problems.add({"needs a paper size: pixels have no scale until they are printed", "--scale", *text,
                      "A4, A3, A4-portrait, A3-portrait", "Add --size A4@300"});
    }
}

}  // namespace

void add_style_options(CommandForm& form) {
    form.options.add_options()("size", one("SIZE"), k_sizes)("scale", one("N"),
                                                             "maps on paper sizes: 5000 for exactly 1 : 5000 (default: "
                                                             "a round scale, if the flow still fills the page well)")(
        "format", many("png|pdf|svg|tif"),
        "png (default), pdf, svg, tif (the area inside the frame, georeferenced); repeatable")(
        "legend", one("classed|continuous"), "classed (default) or continuous")(
        "background", one("FILE"), "orthophoto or topographic raster instead of the relief")(
        "background-licence", one("TEXT"), "owner and licence of the background, at the foot")(
        "attribution", one("TEXT"), "sources of the data, at the foot")(
        "author", one("TEXT"), "author, in the title block")("organisation", one("TEXT"),
                                                             "organisation, in the title block")(
        "logo", one("FILE"), "PNG or JPEG file, in the title block; none: no logo")(
        "date", one("TEXT"), "date, in the title block (default: the day of the run); none: no date")(
        "title", one("TEXT"), "title of the maps");
}

Problem not_one_of(const std::string& option, const std::string& value, const std::string& choices) {
    return {"is not one of the choices", "--" + option, value, choices, ""};
}

/// Overrides the style by the options; adds their problems.
void read_style(const boost::program_options::variables_map& values, MapStyle& style, Problems& problems) {
    const auto given = [&](const std::string& name) { return text_option(values, name); };
    try {
        if (const auto size = size_option(values)) style.size = *size;
    } catch (const Error& error) {
        problems.add(error);
    }
    if (const auto formats = text_options(values, "format"); !formats.empty()) {
        for (const std::string& one : formats) {
            const auto& known = picture_formats();
            if (std::find(known.begin(), known.end(), one) == known.end())
                problems.add(not_one_of("format", one, joined(known, ", ")));
        }
        style.formats = formats;
    }
    if (const auto legend = given("legend")) {
        if (*legend != "classed" && *legend != "continuous")
            problems.add(not_one_of("legend", *legend, "classed, continuous"));
        style.continuous = *legend == "continuous";
    }
    if (const auto camera = given("camera")) {
        const auto place = camera_from_text(*camera);
        if (!place)
            problems.add({"is not a camera", "--camera", *camera, k_cameras, "Write for example 210,30,1.5"});
        else
            style.camera = render::Camera{place->azimuth, place->elevation, place->zoom};
    }
    if (const auto factor = given("exaggeration")) {
        const auto number = number_from_text(*factor);
        if (!number || *number < 0.1 || *number > 20)
            problems.add({"is not a vertical exaggeration", "--exaggeration", *factor, "0.1 to 20", ""});
        style.exaggeration = number.value_or(1);
    }
    if (values.count("plain") > 0) style.sky = false;
    style.background = given("background").value_or(style.background);
    style.background_licence = given("background-licence").value_or(style.background_licence);
    style.attribution = given("attribution").value_or(style.attribution);
    read_title_block(values, style, problems);
    read_scale(values, style, problems);
}

namespace {

/// The other sheets of paper, from small to large.
std::string sheets_that_fit(const MapSource& source, const MapLayer& layer, double scale) {
    std::string fitting;
    for (const char* sheet : {"A4", "A4-portrait", "A3", "A3-portrait"}) {
        MapSource other = source;
        const auto size = size_from_text(std::string(sheet) + "@" + number_text(source.style.size.dots_per_inch));
        if (!size || sheet == source.style.size.paper) continue;
        other.style.size = *size;
        if (render::fitting_scale(map_spec(other, layer)).least <= scale)
            fitting += (fitting.empty() ? "" : ", ") + std::string(sheet);
    }
    return fitting;
}

}  // namespace

void refuse_scale_that_does_not_fit(const MapSource& source, const MapLayer& layer, bool by_option) {
    if (!source.style.scale) return;
    const render::FittingScale fits = render::fitting_scale(map_spec(source, layer));
    const double scale = *source.style.scale;
    if (fits.least <= scale) return;
    const std::string sheets = sheets_that_fit(source, layer, scale);
    throw Error(ErrorKind::input,
                Problem{"the flow does not fit " + source.style.size.paper + " at this scale",
                        by_option ? "--scale" : "output.map-scale", "1 : " + grouped(scale),
                        "at least 1 : " + grouped(std::ceil(fits.least)),
                        "Take 1 : " + grouped(fits.round) +
                            (sheets.empty() ? "; no other sheet fits at 1 : " + grouped(scale)
                                            : ", or for 1 : " + grouped(scale) + " the size " + sheets)});
}

}  // namespace frana::app
