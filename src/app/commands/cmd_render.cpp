// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>

#include "app/commands/command_line.h"
#include "app/commands/forecast.h"
#include "app/pictures/animation.h"
#include "app/pictures/charts.h"
#include "app/pictures/difference_layer.h"
#include "app/pictures/map_source.h"
#include "app/pictures/result_reader.h"
#include "app/store/manifest.h"
#include "app/store/own_files.h"
#include "app/store/result_files.h"
#include "app/text/number_text.h"
#include "core/error.h"
#include "gis/raster/picture_file.h"
#include "params/grammar/value_text.h"
#include "params/keys/output_parameters.h"

namespace frana::app {
namespace {

constexpr double k_least_scale = 100, k_greatest_scale = 1e7;

void read_title_block(const Options& values, MapStyle& style, Problems& problems) {
    style.author = text_option(values, "author").value_or(style.author);
    if (const auto date = text_option(values, "date")) style.date = date_on_maps(date, style.date);
    const auto logo = text_option(values, "logo");
    if (logo) style.logo = *logo == "none" ? "" : *logo;
    if (style.logo.empty()) return;
    attempt(problems, [&] {
        (void)gis::read_logo(style.logo, logo ? "--logo" : "output.map-logo, replaced by --logo FILE or --logo none");
    });
}

void read_scale(const Options& values, MapStyle& style, Problems& problems) {
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
                      paper_names(), "Add --size A4@300"});
    }
}

/// Adds the options of `frana render` that override the style of the scene's pictures.
void add_style_options(CommandForm& form) {
    form.options.add_options()("size", one("SIZE"), size_forms().c_str())(
        "scale", one("N"),
        "maps on paper sizes: 5000 for exactly 1 : 5000 (default: "
        "a round scale, if the flow still fills the page well)")(
        "turn", one("DEGREES"),
        "maps: grid north, clockwise from up (default: 0); auto: the flow's longer axis along the page's longer side")(
        "format", many("png|pdf|svg"), "png (default), pdf, svg; repeatable")(
        "background", one("FILE"), "orthophoto or topographic raster instead of the relief")(
        "attribution", one("TEXT"), "sources of the data, at the foot")("author", one("TEXT"),
                                                                        "author and organisation, in the title block")(
        "logo", one("FILE"), "PNG or JPEG file, in the title block; none: no logo")(
        "date", one("TEXT"), "date, in the title block (default: the day of the run); none: no date")(
        "title", one("TEXT"), "title of the maps");
}

/// The problem of a value that is none of an option's words.
Problem not_one_of(const std::string& option, const std::string& value, const std::string& choices) {
    return {"is not one of the choices", "--" + option, value, choices, ""};
}

/// Overrides the style by the options; adds their problems.
void read_style(const Options& values, MapStyle& style, Problems& problems) {
    const auto given = [&](const std::string& name) { return text_option(values, name); };
    attempt(problems, [&] {
        if (const auto size = size_option(values)) style.size = *size;
    });
    if (const auto formats = text_options(values, "format"); !formats.empty()) {
        for (const std::string& one : formats) {
            const auto& known = picture_formats();
            if (std::find(known.begin(), known.end(), one) == known.end())
                problems.add(not_one_of("format", one, joined(known, ", ")));
        }
        style.formats = formats;
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
    const auto turn = given("turn");
    if (turn) style.turn_deg = number_from_text(*turn);
    if (turn && *turn != "auto" && !(std::abs(style.turn_deg.value_or(k_no_data)) <= 180))
        problems.add({"is not a turn", "--turn", *turn, "auto, or -180 to 180 degrees", "Write for example 30"});
    if (values.count("plain") > 0) style.sky = false;
    style.background = given("background").value_or(style.background);
    style.attribution = given("attribution").value_or(style.attribution);
    read_title_block(values, style, problems);
    read_scale(values, style, problems);
}

/// Throws Error(input) if the content of a map does not fit its page at the chosen scale, with a scale that
/// fits.
void refuse_scale_that_does_not_fit(const MapSource& source, const MapLayer& layer, bool by_option) {
    if (!source.style.scale) return;
    const render::FittingScale fits = render::fitting_scale(map_spec(source, layer));
    const double scale = *source.style.scale;
    if (fits.least <= scale) return;
    throw Error(ErrorKind::input, Problem{"the flow does not fit " + source.style.size.paper + " at this scale",
                                          by_option ? "--scale" : "output.map-scale", "1 : " + grouped(scale),
                                          "at least 1 : " + grouped(std::ceil(fits.least)),
                                          "Take 1 : " + grouped(fits.round) + ", or a larger sheet of paper"});
}

}  // namespace

namespace {

namespace fs = std::filesystem;

/// The requested outputs, as far as they do not depend on the files.
struct Request {
    std::optional<Language> language;  ///< none: the result's own
    bool view_3d = false, charts = false;
    std::optional<std::string> animation, out, difference;
    std::vector<std::string> maps;
    std::string animation_of = "depth";
};

Request read_request(const Options& values, Problems& problems) {
    Request request;
    const std::string view = text_option(values, "view").value_or("2d");
    if (view != "2d" && view != "3d") problems.add(not_one_of("view", view, "2d, 3d"));
    request.view_3d = view == "3d";
    request.charts = values.count("charts") > 0;
    request.animation = text_option(values, "animation");
    if (const auto language = text_option(values, "language")) {
        request.language = language_of_code(*language);
        if (!request.language) problems.add(not_one_of("language", *language, language_codes()));
    }
    request.out = text_option(values, "out");
    request.difference = text_option(values, "difference");
    request.maps = text_options(values, "map");
    if (request.difference && (request.animation || request.view_3d || request.charts))
        problems.add({"is for maps only", "--difference", *request.difference, "", "Omit the other kind of picture"});
    if (request.difference && request.maps.empty())
        problems.add({"needs the raster to compare", "--difference", *request.difference, "",
                      "Name it, for example --map max_depth"});
    if (values.count("turn") > 0 && (request.animation || request.view_3d || request.charts))
        problems.add({"is for maps only", "--turn", *text_option(values, "turn"), "", "Remove it"});
    if (request.charts && (request.animation || request.view_3d || !request.maps.empty()))
        problems.add({"cannot be combined with --map, --view or --animation", "--charts", "", "", ""});
    if (!request.animation) return request;
    const std::string ending = fs::path(*request.animation).extension().string();
    if (ending != ".mp4" && ending != ".gif")
        problems.add({"is not the name of an animation", "--animation", *request.animation, "FILE.mp4, FILE.gif", ""});
    if (!request.maps.empty()) request.animation_of = request.maps.front();
    if (request.maps.size() > 1 || (request.animation_of != "depth" && request.animation_of != "velocity" &&
                                    find_particle_quantity(request.animation_of) == nullptr))
        problems.add({"is not in the frames", "--map", joined(request.maps, ", "),
                      "depth, velocity, particles, particle_cohesion", ""});
    return request;
}

/// Called before anything is drawn or written. `animation`: 0 if none is requested.
void refuse_too_large(const Options& values, const Request& request, Size page, Size animation, std::int64_t cells) {
    Drawing drawing;
    drawing.cells = cells;
    (request.animation ? drawing.animation : drawing.page) = request.animation ? animation : page;
    drawing.views = request.view_3d;
    drawing.maps = !request.view_3d || request.animation;
    const Size size = request.animation ? animation : page;
    refuse_pictures_of(memory_of_drawing(drawing), values.count("size") > 0 ? "--size" : "output.map-size",
                       std::to_string(size.width) + "x" + std::to_string(size.height));
}

/// Logs the files for the user, and lists them in the result that contains them.
void log_written(const std::vector<std::string>& files) {
    record_files(files);
    for (const std::string& file : files) std::cout << file << '\n';
}

/// Folder of pictures or an animation, and the files that must not be written to it.
struct DrawingPlace {
    std::string folder;
    std::string option;               ///< that specifies it
    std::vector<std::string> reads;   ///< results that they may be written to
    std::vector<std::string> inputs;  ///< other files
    bool is_own = false;              ///< of the result itself: no link leads elsewhere
};

/// Prepares a folder for files, before the first is written. Throws Error, with nothing made, if one of them would
/// replace a file not made by frana or belongs to another result.
void prepare_place(const DrawingPlace& place, const std::vector<std::string>& files, Problems& problems) {
    refuse_inputs(files, place.inputs, place.option, problems);
    check_own(place.folder, files, place.option, place.reads, problems);
    problems.throw_if_any();
    if (place.is_own) make_drawing_folder(place.folder);
    begin_own(place.folder, files);
}

void render_animation(const ResultReader& result, const MapSource& source, const Request& request, Size size) {
    const AnimationRequest animation{animation_source(result, source, request.animation_of, size), request.view_3d};
    const fs::path parent = fs::path(*request.animation).parent_path();
    Problems problems;
    prepare_place({parent.empty() ? "." : parent.string(), "--animation", {result.directory()}, {}},
                  {*request.animation}, problems);
    write_animation(animation, *request.animation);
    log_written({*request.animation});
}

void draw(const MapSource& source, const std::vector<MapLayer>& layers, bool view_3d, const DrawingPlace& place) {
    const auto stem = [&](const MapLayer& layer) {
        return (fs::path(place.folder) / (layer.name + (view_3d ? "_3d" : ""))).string();
    };
    Problems problems;
    std::vector<std::string> files;
    for (const MapLayer& layer : layers)
        for (const std::string& file : picture_files(source.style, stem(layer))) files.push_back(file);
    prepare_place(place, files, problems);
    LayerDrawer drawer(source);
    for (const MapLayer& layer : layers) log_written(drawer.draw(layer, view_3d, stem(layer)));
}

/// The maps of differences; `source` becomes theirs.
std::vector<MapLayer> difference_layers(const ResultReader& result, const Request& request, MapSource& source,
                                        Problems& problems) {
    std::vector<MapLayer> layers;
    attempt(problems, [&] {
        const ResultReader other(*request.difference, result.words().language());
        for (const std::string& name : request.maps) {
            DifferenceMap map = difference_map(result, other, name);
            map.source.style = source.style;
            map.source.title = source.title;
            source = std::move(map.source);
            layers.push_back(std::move(map.layer));
        }
    });
    return layers;
}

void render_result(const Options& values, const Request& request, Problems& problems) {
    const ResultReader result((values)["operand"].as<std::string>(), request.language);
    for (const char* option : {"dtm", "unit", "above"}) {
        if (values.count(option) > 0)
            problems.add({"is for a RASTER, not for a result", std::string("--") + option, "", "", ""});
    }
    MapSource source = result.map_source();
    read_style(values, source.style, problems);
    source.title = text_option(values, "title").value_or(source.title);
    const std::string crs = result.grid().crs_wkt;
    if (!source.style.background.empty()) {
        attempt(problems, [&] { gis::check_picture(source.style.background, crs, "--background"); });
    }
    std::vector<MapLayer> layers;
    if (request.difference) {
        layers = difference_layers(result, request, source, problems);
    } else if (!request.animation && !request.charts) {
        for (const std::string& name : request.maps.empty() ? result.drawable() : request.maps) {
            attempt(problems, [&] { layers.push_back(result.map_layer(name)); });
        }
    }
    problems.throw_if_any();
    const Size animation = values.count("size") > 0 ? source.style.size : animation_size(source.style.size);
    refuse_too_large(values, request, source.style.size, animation,
                     std::max(source.extent.values.stored_cells(), source.terrain.values.stored_cells()));
    if (!layers.empty() && !request.view_3d)
        refuse_scale_that_does_not_fit(source, layers.front(), values.count("scale") > 0);
    const std::vector<std::string> inputs{source.style.background, source.style.logo};
    if (request.animation) {
        render_animation(result, source, request, animation);
    } else if (request.charts) {
        const std::string folder = request.out.value_or(result.path("charts"));
        prepare_place({folder, "--out", {result.directory()}, inputs, !request.out},
                      chart_files(result, source, folder), problems);
        log_written(draw_charts(result, source, folder, problems));
        problems.throw_if_any();
    } else {
        draw(source, layers, request.view_3d,
             {request.out.value_or(result.path("maps")), "--out", {result.directory()}, inputs, !request.out});
    }
}

void render_raster(const Options& values, const Request& request, Problems& problems) {
    const std::string file = values["operand"].as<std::string>();
    for (const char* option : {"map", "animation", "charts", "difference"}) {
        if (values.count(option) > 0)
            problems.add({"is for a result, not for a raster", std::string("--") + option, "", "", ""});
    }
    if (request.view_3d && values.count("dtm") == 0)
        problems.add({"needs a terrain", "--view", "3d", "", "Name it: --dtm RASTER"});
    MapStyle style;
    style.words = Words(request.language.value_or(process_language()));
    read_style(values, style, problems);
    const auto limit = text_option(values, "above");
    const auto above = limit ? number_from_text(*limit) : std::nullopt;
    if (limit && !above) problems.add({"is not a number", "--above", *limit, "", ""});
    problems.throw_if_any();
    ForeignMap map =
        read_foreign_map(file, text_option(values, "dtm"), text_option(values, "unit"), above, style.words);
    refuse_too_large(values, request, style.size, {}, map.layer.values.values.stored_cells());
    map.source.style = style;
    map.source.title = text_option(values, "title").value_or(map.source.title);
    if (!style.background.empty()) gis::check_picture(style.background, map.layer.values.grid.crs_wkt, "--background");
    if (!request.view_3d) refuse_scale_that_does_not_fit(map.source, map.layer, values.count("scale") > 0);
    draw(map.source, {std::move(map.layer)}, request.view_3d,
         {request.out.value_or("."),
          "--out",
          {file},
          {file, text_option(values, "dtm").value_or(""), style.logo, style.background}});
}

int cmd_render(const Options& values) {
    Problems problems;
    const Request request = read_request(values, problems);
    refuse_scene(values["operand"].as<std::string>());
    if (fs::is_regular_file(values["operand"].as<std::string>()))
        render_raster(values, request, problems);
    else
        render_result(values, request, problems);
    return static_cast<int>(ExitCode::done);
}

}  // namespace

Command command_render() {
    std::string codes;
    for (const LanguageRow& row : languages()) codes += (codes.empty() ? "" : "|") + std::string(row.code);
    CommandForm form{
        "frana render RESULT_DIR|RASTER [options]",
        "Draws maps and views of a result, or of any program's raster with --dtm, or the frames of a result as "
        "an\nanimation. Nothing is computed again. Prints the names of the files. The style of pictures is written "
        "from the scene's\noutput.map-... keys; options override them.",
        "RESULT_DIR|RASTER",
        {}};
    form.options.add_options()(
        "map", many("MAP"),
        "raster to draw, for example max_depth; depth@12.5 is the frame nearest to "
        "12.5 s, particles@12.5 its particles, particle_cohesion@12.5 the same coloured by cohesion left; "
        "repeatable (default: all)")("view", one("2d|3d"), "2d (default) or 3d")(
        "animation", one("FILE"),
        "write the frames as FILE.mp4 or FILE.gif instead of maps; --map velocity shows speeds, --map particles the "
        "particles")("charts", "draw the charts of a result instead of maps")(
        "difference", one("RESULT_DIR"), "another result: draw the difference of --map, this result minus the other")(
        "language", one(codes.c_str()),
        ("of the texts: " + language_codes() + " (default: the result's output.language; for a RASTER the locale's)")
            .c_str())("camera", one("ANGLES"), k_cameras)("exaggeration", one("FACTOR"),
                                                          "vertical exaggeration of views (default: 1)")(
        "plain", "views: white background")("dtm", one("FILE"), "terrain under a RASTER")(
        "unit", one("UNIT"), "unit of the values of a RASTER, if the file does not state it")(
        "above", one("VALUE"), "draw only the values of a RASTER above this one")(
        "out", one("FOLDER"), "folder for the pictures (default: RESULT_DIR/maps, or the current folder for a RASTER)");
    add_style_options(form);
    return {"render", "draw maps, views or an animation of a result", form, cmd_render};
}

}  // namespace frana::app
