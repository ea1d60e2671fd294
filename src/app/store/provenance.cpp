// SPDX-License-Identifier: Apache-2.0
#include "app/store/provenance.h"

#include "app/text/text_hash.h"
#include "app/text/version.h"
#include "core/utf8.h"
#include "params/scene/write_scene.h"

namespace frana::app {

std::string echoed_scene(const Prepared& prepared) {
    SceneSpec spec = prepared.spec;
    // The echo is in another folder: values derived from the scene file's own name must be written out.
    spec.output.title = spec.output.title.value_or(scene_name(spec));
    // The directory contains this result now; a repeated run uses its own unless specified.
    spec.output.directory.reset();
    return scene_text(spec, prepared.resolved);
}

std::map<std::string, std::string> provenance(const Prepared& prepared) {
    return {{"PROGRAM", k_program},
            {"VERSION", k_version},
            {"SCENE", valid_utf8(scene_name(prepared.spec))},
            {"SCENE_HASH", text_hash(echoed_scene(prepared))},
            {"TIFFTAG_SOFTWARE", std::string(k_program) + " " + k_version}};
}

}  // namespace frana::app
