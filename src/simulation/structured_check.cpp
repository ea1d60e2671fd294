// SPDX-License-Identifier: Apache-2.0
#include "simulation/structured_check.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "simulation/structured_laws.h"

namespace frana {
namespace {

std::string text(double value, int digits) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%.*g", digits, value);
    return buffer;
}

}  // namespace

std::vector<Problem> structured_problems(const StructuredMaterial& material,
                                         const std::function<std::string(const std::string&)>& where) {
    std::vector<Problem> problems;
    if (!material.solids) return problems;
    // Softer material strains more until it yields, and damage counts strain.
    const double most = std::max(1.0, greatest_modulus_reduction(material));
    if (material.modulus_reduction > 1 && material.modulus_reduction > most) {
        problems.push_back(
            {"softens the material so much that it would break by that", where("structured.modulus-reduction"),
             text(material.modulus_reduction, 4), most > 1 ? "at most " + text(most, 3) : "1, none: it is soft already",
             "Lower it: at its strength the material would have an elastic strain of over a twentieth of "
             "structured.critical-strain"});
    }
    double lightest = HUGE_VAL;
    visit_materials(material, [&](const SolidValues& solid) { lightest = std::min(lightest, solid.grain_density); });
    if (has_fluid(material) && !(lightest > material.fluid_density)) {
        problems.push_back(
            {"is not denser than the fluid: the solids would float, which the laws of drag and buoyancy do not "
             "describe",
             where("structured.grain-density"), text(lightest, 5) + " kg/m3",
             "more than structured.fluid-density, " + text(material.fluid_density, 5) + " kg/m3",
             "Correct one of them; rock has some 2650"});
    }
    return problems;
}

}  // namespace frana
