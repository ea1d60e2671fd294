// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>

#include "core/default_values.h"
#include "core/raster.h"
#include "particles/particle_set.h"

namespace frana::structured {

/// Point n of the R2 sequence in the unit square (Roberts 2018; paper, equation 88): frac(1/2 + n / g),
/// frac(1/2 + n / g^2) with g the real root of g^3 = g + 1. Any first n points fill the square evenly.
Point r2_point(std::int64_t n);

/// Solids with confined fluid as particles of equal solid volume, in each cell as many as its depth requires, at the
/// places of the R2 sequence. The remainder of a cell is added to the next (row by row in alternating direction, so
/// that the next is a neighbour); at the end all volumes are scaled so that both sums equal those of the rasters
/// exactly. Sets the fields volume (of solids), confined and area.
/// @param solid_depth, confined_depth vertical thickness of solids and of confined fluid [m], NaN or <= 0: none
/// @param per_column particles in the cell with the greatest depth of solids
ParticleSet place_by_depth(const Raster& solid_depth, const Raster& confined_depth, int per_column);

/// Replaces solids on a lattice (fields volume, confined, area, u, v) by place_by_depth: the same volumes in each cell
/// except the remainder passed to the next, and the mean velocity there.
ParticleSet place_again(const ParticleSet& placed, const GridSpec& grid, int per_column);

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
