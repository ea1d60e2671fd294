// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>

#include "core/default_values.h"
#include "core/raster.h"
#include "particles/particle_set.h"

namespace frana::structured {

/// Properties of the solids at a place.
struct SolidMaterial : SolidValues {
    double pore_pressure = 0;  ///< at the start, over the weight of the saturated solids [-]

    /// Fraction of the whole volume that is confined fluid, and that is free fluid. Without cohesion no fluid is
    /// confined.
    [[nodiscard]] double confined_fluid() const noexcept {
        return solid_fraction > 0 && cohesion > 0 ? (1 - solid_fraction) * confined_fraction : 0;
    }
    [[nodiscard]] double free() const noexcept { return 1 - solid_fraction - confined_fluid(); }
};

/// Splits columns of whole thickness (fields volume, area) into solids and confined fluid: volume becomes that of the
/// solids, confined that of the fluid that the structure confines. The fraction that it does not confine is omitted: it
/// is free fluid; without solids all of it.
/// @param thinnest columns thinner than this [m] are omitted, and both their volumes shared out to the others in
/// proportion: they would be particles of next to no mass beside thick ones (share/doc/structured.md, "Solids with
/// confined fluid")
ParticleSet split_phases(const ParticleSet& columns, const std::function<SolidMaterial(Point)>& material,
                         double thinnest = 0);

/// Sets the material of particles (x, y, u, v, volume, area, confined), and all fields of a scene.
ParticleSet assign_material(const ParticleSet& placed, FieldMask fields,
                            const std::function<SolidMaterial(Point)>& material);

}  // namespace frana::structured
