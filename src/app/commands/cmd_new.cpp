// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <iostream>

#include "app/commands/command_line.h"
#include "app/commands/commands.h"
#include "app/commands/scene_draft.h"
#include "app/input/share_directory.h"
#include "app/text/text_file.h"
#include "core/error.h"
#include "params/grammar/absolute_path.h"
#include "params/keys/materials.h"
#include "params/keys/scene_parameters.h"

namespace frana::app {

namespace fs = std::filesystem;

namespace {

/// Throws Error(input) for a word that is no preset.
std::string preset_of(const std::string& word) {
    std::string names;
    for (const MaterialPreset& preset : material_presets(materials_directory())) {
        if (preset.name == word) return word;
        names += (names.empty() ? "" : ", ") + preset.name;
    }
    throw Error(ErrorKind::input, Problem{"is not a material preset", "--preset", word, names, ""});
}

/// What is still to be given in a draft; empty: nothing.
std::string open_keys(const SceneDraft& draft) {
    std::string keys;
    if (draft.thickness.empty()) keys = "release.thickness";
    if (draft.preset.empty()) keys += std::string(keys.empty() ? "" : " and ") + "material.preset";
    return keys;
}

/// The thickness as the scene will have it: its files relative to the scene's folder. Throws Error(input).
std::string thickness_of(const std::string& text, const fs::path& folder) {
    const std::vector<Parameter>& parameters = scene_parameters();
    const Parameter& key = *find_parameter(parameters, "release.thickness");
    SceneSpec spec;
    if (const auto refusal = key.read(spec, text))
        throw Error(ErrorKind::input,
                    Problem{refusal->what, "--thickness", text, key.limits + " [" + key.unit + "]", refusal->remedy});
    key.map_files(spec, [&](const std::string& file) {
        return relative_path(absolute_path(file, fs::current_path().string()), folder.string());
    });
    return key.write(spec).value_or(text);
}

}  // namespace

CommandForm new_form() {
    CommandForm form{"frana new DTM PERIMETER [options]",
                     "Writes a commented scene to begin with: the twenty keys that matter, with what the two files "
                     "contain. It leaves\nthickness and material open unless --thickness and --preset give them.",
                     "DTM PERIMETER",
                     {}};
    form.repeats = true;
    form.options.add_options()("out", one("FILE"), "scene file to write (default: scene.ini)")(
        "thickness", one("METRES"), "of the release: a number, attribute:NAME, raster:FILE, difference:PRE,POST")(
        "preset", one("NAME"), "of the material: one of `frana materials`")("overwrite", "replace an existing file");
    return form;
}

int cmd_new(const Arguments& arguments) {
    const auto values = parse_arguments(new_form(), arguments);
    if (!values) return static_cast<int>(ExitCode::done);
    const auto files = text_options(*values, "operand");
    if (files.size() != 2)
        throw Error(ErrorKind::input, Problem{"needs two files: the DTM and the perimeter of the release",
                                              "command line", "", "", "Usage: " + new_form().usage});
    const fs::path scene = fs::absolute(text_option(*values, "out").value_or("scene.ini")).lexically_normal();
    if (fs::exists(scene) && values->count("overwrite") == 0)
        throw Error(ErrorKind::input,
                    Problem{"exists already", "--out", scene.string(), "", "Choose another name, or add --overwrite"});
    const auto thickness = text_option(*values, "thickness");
    const fs::path folder = scene.parent_path();
    SceneDraft draft = draft_of(files[0], files[1]);
    draft.dtm = relative_path(absolute_path(files[0], fs::current_path().string()), folder.string());
    draft.perimeter = relative_path(absolute_path(files[1], fs::current_path().string()), folder.string());
    if (const auto preset = text_option(*values, "preset")) draft.preset = preset_of(*preset);
    if (thickness) draft.thickness = thickness_of(*thickness, folder);
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
        throw Error(ErrorKind::environment, Problem{"the folder cannot be made: " + error.message(), "--out",
                                                    folder.string(), "", "Choose another place"});
    write_text_file(scene.string(), draft_text(draft));
    std::cerr << "frana: wrote " << scene.string()
              << "\nfrana: next: " << (open_keys(draft).empty() ? "" : "give " + open_keys(draft) + " in it, then ")
              << "frana check " << scene.string() << '\n';
    return static_cast<int>(ExitCode::done);
}

}  // namespace frana::app
