// SPDX-License-Identifier: Apache-2.0
#include <boost/program_options/value_semantic.hpp>
#include <filesystem>
#include <iostream>

#include "app/animation.h"
#include "app/command_line.h"
#include "app/commands.h"
#include "app/result_reader.h"
#include "core/error.h"

namespace frana::app {
namespace {

CommandForm render_form() {
    namespace options = boost::program_options;
    CommandForm form{
        "frana render RESULT_DIR [options]",
        "Draws maps of an existing result into RESULT_DIR/maps, or its frames as a film. Prints the files "
        "it wrote.",
        "RESULT_DIR",
        {}};
    form.options.add_options()("map", options::value<std::vector<std::string>>(),
                               "raster to draw, for example max_depth; repeatable (default: all)")(
        "view", options::value<std::string>(), "2d (default) or 3d")(
        "animation", options::value<std::string>(),
        "write the frames as FILE.mp4 or FILE.gif instead of maps")(
        "size", options::value<std::string>(), "WIDTHxHEIGHT in pixels (default: 1600x1200, films 1280x960)");
    return form;
}

bool wants_3d(const boost::program_options::variables_map& values) {
    const std::string view = text_option(values, "view").value_or("2d");
    if (view != "2d" && view != "3d")
        throw Error(ErrorKind::input, Problem{"is not a view", "--view", view, "2d, 3d", ""});
    return view == "3d";
}

std::vector<Layer> layers_asked_for(const std::vector<std::string>& names, const ResultReader& result) {
    std::vector<Layer> layers;
    if (names.empty()) {
        for (const Layer& layer : all_layers())
            if (result.has(layer.name + ".tif")) layers.push_back(layer);
        return layers;
    }
    Problems problems;
    for (const std::string& name : names) {
        try {
            layers.push_back(layer_named(name));
        } catch (const Error& error) {
            problems.add(error);
        }
    }
    problems.throw_if_any();
    return layers;
}

void render_animation(const ResultReader& result, const MapSource& source, const std::string& file,
                      bool view_3d) {
    const std::string ending = std::filesystem::path(file).extension().string();
    if (ending != ".mp4" && ending != ".gif")
        throw Error(ErrorKind::input,
                    Problem{"is not a film's name", "--animation", file, "FILE.mp4, FILE.gif", ""});
    write_animation(source, result.raster("max_depth"), stored_frames(result.path("frames")), view_3d, file);
    std::cout << file << '\n';
}

void render_maps(const ResultReader& result, const MapSource& source, const std::vector<Layer>& layers,
                 bool view_3d) {
    std::error_code failure;
    std::filesystem::create_directories(result.path("maps"), failure);
    if (failure) {
        throw Error(ErrorKind::environment, Problem{"cannot be made: " + failure.message(),
                                                    result.path("maps"), "", "", "Check the rights"});
    }
    for (const Layer& layer : layers) {
        const std::string file = result.path("maps/" + layer.name + (view_3d ? "_3d" : "") + ".png");
        const Raster values = result.raster(layer.name);
        draw_layer(source, layer, values, view_3d, file);
        std::cout << file << '\n';
    }
}

}  // namespace

int cmd_render(const Arguments& arguments) {
    const auto values = parse_arguments(render_form(), arguments);
    if (!values) return static_cast<int>(ExitCode::done);
    const bool view_3d = wants_3d(*values);
    const auto size = size_option(*values);
    const auto film = text_option(*values, "animation");
    const auto names = text_options(*values, "map");
    if (film && !names.empty()) {
        throw Error(ErrorKind::input, Problem{"a film shows the depth frames and takes no --map", "--map",
                                              names.front(), "", "Give one of --map and --animation"});
    }
    const ResultReader result((*values)["operand"].as<std::string>());
    const std::vector<Layer> layers = layers_asked_for(names, result);
    MapSource source = result.map_source();
    source.size = size.value_or(film ? film_size(source.size) : source.size);
    if (film)
        render_animation(result, source, *film, view_3d);
    else
        render_maps(result, source, layers, view_3d);
    return static_cast<int>(ExitCode::done);
}

}  // namespace frana::app
