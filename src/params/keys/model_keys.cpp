// SPDX-License-Identifier: Apache-2.0
#include "params/keys/model_keys.h"

#include "core/shortest_text.h"

namespace frana {
namespace {

bool in_section(const std::string& name, const std::string& section) {
    return name.rfind(section + ".", 0) == 0;
}

// Keys outside [material], [zones] and [entrainment] for the particles of the first model only.
const std::set<std::string> k_voellmy_bingham_only{
    "material.preset",        "terrain.friction-zones", "numerics.scheme", "numerics.shape",       "numerics.transfer",
    "numerics.well-balanced", "numerics.curvature",     "numerics.flight", "numerics.flight-slope"};

// Keys of [structured] that pure fluid reads too.
const std::set<std::string> k_fluid_keys{"structured.phases",          "structured.fluid-density",
                                         "structured.fluid-viscosity", "structured.velocity-profile-factor",
                                         "structured.manning",         "structured.dry-depth",
                                         "structured.zones",           "structured.initial-fluid-depth"};

bool has_solids(const SceneSpec& scene) {
    return scene.structured.phases == "solids-and-fluid";
}

void check_solids(const SceneSpec& scene, const std::set<std::string>& given, const std::string& file,
                  Problems& problems) {
    const StructuredSpec& s = scene.structured;
    for (const char* key : {"structured.cohesion", "structured.internal-friction-angle"}) {
        if (given.count(key) == 0)
            problems.add({"is missing", file + ": " + key, "", "", "structured.phases = solids-and-fluid needs it"});
    }
    if (!(s.young_modulus < 9 * s.bulk_modulus)) {
        problems.add({"makes the material unstable", file + ": structured.young-modulus",
                      shortest_text(s.young_modulus) + " Pa",
                      "less than 9 times structured.bulk-modulus, " + shortest_text(9 * s.bulk_modulus) + " Pa",
                      "Lower it or raise the bulk modulus"});
    }
    const auto& thickness = scene.release.thickness;
    if (thickness && thickness->kind == ThicknessSpec::Kind::phases && given.count("structured.solid-fraction") > 0) {
        problems.add({"is given twice", file + ": structured.solid-fraction", "", "",
                      "Remove it: release.thickness = " + text_of(*thickness) + " determines it"});
    }
    if (scene.numerics.particles_per_cell < 9) {
        problems.add({"is too small for the neighbour sums of solids", file + ": numerics.particles-per-cell",
                      std::to_string(scene.numerics.particles_per_cell), "9, 16", "Set it to 9"});
    }
}

void check_structured(const SceneSpec& scene, const std::set<std::string>& given, const std::string& file,
                      Problems& problems) {
    if (!scene.structured.phases) {
        problems.add({"is missing", file + ": structured.phases", "", "fluid, solids-and-fluid",
                      "State the content of the release"});
    }
    if (courant_number(scene) > 0.5) {
        problems.add({"is too large for material.model = structured", file + ": numerics.cfl",
                      shortest_text(courant_number(scene)), "greater than 0, at most 0.5", "Choose at most 0.5"});
    }
    if (scene.numerics.slope_correction == "surface") {
        problems.add({"is not available for material.model = structured", file + ": numerics.slope-correction",
                      "surface", "auto, none, normal", "Choose normal or none"});
    }
    if (has_solids(scene)) check_solids(scene, given, file, problems);
}

}  // namespace

bool model_reads(const SceneSpec& scene, const std::string& name) {
    if (scene.material.model != "structured") return !in_section(name, "structured");
    if (in_section(name, "structured")) return k_fluid_keys.count(name) > 0 || has_solids(scene);
    if (name == "material.model") return true;
    return !in_section(name, "material") && !in_section(name, "zones") && !in_section(name, "entrainment") &&
           k_voellmy_bingham_only.count(name) == 0;
}

void check_model(const SceneSpec& scene, const std::set<std::string>& given, const std::string& file,
                 Problems& problems) {
    const bool structured = scene.material.model == "structured";
    for (const std::string& name : given) {
        // Keys of a preset are not keys of the scene: the preset itself is refused.
        if (model_reads(scene, name) || scene.origin_of(name) == Origin::preset) continue;
        const bool solids_key = structured && in_section(name, "structured");
        const std::string reader = solids_key ? "structured.phases = " + scene.structured.phases.value_or("(missing)")
                                              : "material.model = " + scene.material.model;
        problems.add({"is given, but " + reader + " does not use it", file + ": " + name, "", "",
                      solids_key ? "Remove it, or set structured.phases = solids-and-fluid"
                                 : "Remove it, or choose the other model"});
    }
    if (structured) check_structured(scene, given, file, problems);
    const auto& thickness = scene.release.thickness;
    if (thickness && thickness->kind == ThicknessSpec::Kind::phases && !(structured && has_solids(scene))) {
        problems.add({"gives solids and fluid separately, but the scene's material does not",
                      file + ": release.thickness", text_of(*thickness), "",
                      "Set structured.phases = solids-and-fluid, or give the sum as raster:FILE"});
    }
}

}  // namespace frana
