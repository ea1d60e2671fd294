// SPDX-License-Identifier: Apache-2.0
#include "params/model_keys.h"

#include "core/json.h"

namespace frana {
namespace {

bool in_section(const std::string& name, const std::string& section) {
    return name.rfind(section + ".", 0) == 0;
}

// Keys outside [material], [zones] and [entrainment] that belong to the particles of the first model.
const std::set<std::string> k_voellmy_bingham_only{"material.preset",        "terrain.friction-zones",
                                                   "numerics.scheme",        "numerics.shape",
                                                   "numerics.transfer",      "numerics.well-balanced",
                                                   "numerics.curvature"};

void check_structured(const SceneSpec& scene, const std::string& file, Problems& problems) {
    if (!scene.structured.phases) {
        problems.add({"is missing", file + ": structured.phases", "", "fluid",
                      "Set structured.phases = fluid; blocks of solids are not available in this version"});
    }
    if (scene.numerics.cfl > 0.5) {
        problems.add({"is too long a step for material.model = structured", file + ": numerics.cfl",
                      shortest_text(scene.numerics.cfl), "greater than 0, at most 0.5", "Choose at most 0.5"});
    }
    if (scene.numerics.slope_correction == "surface") {
        problems.add({"is not a form of material.model = structured", file + ": numerics.slope-correction", "surface",
                      "auto, none, normal", "Choose normal or none"});
    }
}

}  // namespace

bool model_reads(const std::string& model, const std::string& name) {
    if (model != "structured") return !in_section(name, "structured");
    if (name == "material.model") return true;
    return !in_section(name, "material") && !in_section(name, "zones") && !in_section(name, "entrainment") &&
           k_voellmy_bingham_only.count(name) == 0;
}

void check_model(const SceneSpec& scene, const std::set<std::string>& given, const std::string& file,
                 Problems& problems) {
    const std::string& model = scene.material.model;
    for (const std::string& name : given) {
        // What a preset brought is not the scene's word: the preset itself is refused.
        if (model_reads(model, name) || scene.origin_of(name) == Origin::preset) continue;
        problems.add({"is given, but material.model = " + model + " does not read it", file + ": " + name, "", "",
                      "Remove it, or choose the other model"});
    }
    if (model == "structured") check_structured(scene, file, problems);
}

}  // namespace frana
