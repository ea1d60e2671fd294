// SPDX-License-Identifier: Apache-2.0
#include "params/structured_parameters.h"

#include "params/declare.h"

namespace frana {

using declare::choice;
using declare::number;
using declare::Range;

void add_structured(std::vector<Parameter>& list) {
    Parameter phases = choice("structured.phases", FRANA_MEMBER(structured.phases), {"fluid"},
                              "What the release is: fluid alone, or blocks of solids with the fluid they confine.",
                              {"solids-and-fluid"});
    phases.absent = "required with material.model = structured";
    list.push_back(phases);
    list.push_back(number("structured.fluid-density", FRANA_MEMBER(structured.fluid_density), "kg/m3",
                          Range{500, 2500}, "Density of the fluid."));
    list.push_back(number("structured.manning", FRANA_MEMBER(structured.manning), "s/m^(1/3)", Range{0, 1},
                          "Manning's n of the ground under free fluid; 0: smooth."));
    list.push_back(number("structured.fluid-viscosity", FRANA_MEMBER(structured.fluid_viscosity), "Pa s",
                          Range{0, 1e4},
                          "Dynamic viscosity of the fluid: shear in the plane and at the bed; 0: none."));
    list.push_back(number("structured.velocity-shape", FRANA_MEMBER(structured.velocity_shape), "", Range{0, 10},
                          "Shape of the velocity over depth, chi, in the viscous shear at the bed."));
    list.push_back(number("structured.dry-depth", FRANA_MEMBER(structured.dry_depth), "m", Range{1e-8, 0.1},
                          "Depth under which free fluid does not move."));
}

}  // namespace frana
