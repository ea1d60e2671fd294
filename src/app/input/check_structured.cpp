// SPDX-License-Identifier: Apache-2.0
#include "app/input/check_structured.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "app/text/number_text.h"
#include "gis/raster/footprint.h"
#include "models/structured/solid/drucker_prager.h"
#include "simulation/structured_check.h"
#include "simulation/structured_laws.h"

namespace frana::app {
namespace {

/// Extremes over all materials of a scene.
struct Extremes {
    double cohesion = 0;        ///< [Pa]
    double strain = 0;          ///< elastic, at the uniaxial strength [-]
    double steepest_bed = 0;    ///< greatest bed friction, as an angle [degrees]
    double bed_over_own = 0;    ///< by how much it exceeds the material's own at most [degrees]
    double solid_fraction = 0;  ///< greatest
    double least_solid_fraction = 1;

    explicit Extremes(const StructuredMaterial& m) {
        const auto degrees = [](double tangent) { return std::atan(tangent) * 180 / std::numbers::pi; };
        visit_materials(m, [&](const SolidValues& solid) {
            cohesion = std::max(cohesion, solid.cohesion);
            steepest_bed = std::max(steepest_bed, degrees(solid.bed_friction));
            bed_over_own = std::max(bed_over_own, degrees(solid.bed_friction) - degrees(solid.friction));
            solid_fraction = std::max(solid_fraction, solid.solid_fraction);
            least_solid_fraction = std::min(least_solid_fraction, solid.solid_fraction);
            if (solid.cohesion > 0 && solid.friction >= 0)
                strain = std::max(strain, structured::DruckerPrager::of(solid.friction, solid.cohesion).uniaxial() *
                                              m.modulus_reduction / m.young_modulus);
        });
    }
};

bool is_given(const SceneReading& reading, const std::string& key) {
    return reading.scene.origin_of(key) != Origin::default_value;
}

/// The greatest thickness of anything released [m].
double thickest(const ReleaseInput& release, const GridSpec& grid) {
    double most = 0;
    for (const ReleaseArea& area : release.areas) {
        if (!area.thickness_raster) {
            most = std::max(most, area.thickness);
            continue;
        }
        const Raster& thickness = *area.thickness_raster;
        gis::visit_cells(area.outline, grid, gis::Cover::centres, [&](std::int64_t row, std::int64_t column) {
            if (const double h = thickness.at(row, column); h > most) most = h;
        });
    }
    return most;
}

void warn_of_keys_without_effect(const SceneReading& reading, const StructuredMaterial& m, const Extremes& e,
                                 RunLog& log) {
    if (m.fluid_viscosity == 0) {
        for (const char* key : {"structured.mobility", "structured.viscosity-growth",
                                "structured.solids-profile-factor", "structured.velocity-profile-factor"})
            if (is_given(reading, key))
                log.warn(worded("{1} has no effect: structured.fluid-viscosity is 0", {reading.where(key)}));
    }
    const std::string confined = "structured.confined-fraction";
    if (!is_given(reading, confined) || !(m.confined_fraction > 0)) return;
    if (e.cohesion == 0)
        log.warn(worded("{1} has no effect: without structured.cohesion nothing confines fluid, and all of it is free",
                        {reading.where(confined)}));
    else if (e.least_solid_fraction == 1)
        log.warn(worded("{1} has no effect: with structured.solid-fraction = 1 there are no pores",
                        {reading.where(confined)}));
}

}  // namespace

void check_structured_values(const SceneReading& reading, const StructuredMaterial& m, const ReleaseInput& release,
                             const GridSpec& grid, RunLog& log, Problems& problems) {
    if (!m.solids) return;
    const Extremes e(m);
    for (const Problem& problem : structured_problems(m, [&](const std::string& key) { return reading.where(key); }))
        problems.add(problem);
    warn_of_keys_without_effect(reading, m, e, log);
    if (e.bed_over_own > 1e-6)
        log.warn(worded(
            "structured.bed-friction-angle is up to {1} degrees more than the material's internal-friction-angle: it "
            "would shear within itself and leave a layer on the bed, which the model does not compute. Take at most "
            "the internal angle",
            {numeral(number_text(e.bed_over_own, 3))}));
    if (e.strain > m.critical_strain)
        log.warn(worded(
            "at its strength the material has an elastic strain of {1}, more than structured.critical-strain = {2}: it "
            "loses its cohesion before it yields. Raise structured.young-modulus (and bulk-modulus) or the critical "
            "strain, or lower the cohesion",
            {numeral(number_text(e.strain, 2)), number_text(m.critical_strain, 2)}));
    // share/doc/structured.md, "Solids with confined fluid": edges on a grid.
    constexpr double k_edge = 1.53;
    const double thickness = thickest(release, grid),
                 least = k_edge * std::tan(e.steepest_bed * std::numbers::pi / 180) * grid.cell_size;
    if (thickness > 0 && thickness < least)
        log.warn(worded(
            "the release is at most {1} m thick, less than 1.53 tan({2} degrees) times the cell size, {3} m: its edges "
            "stand whatever their cohesion, and it breaks too little. Choose terrain.cell-size = {4} or less",
            {numeral(number_text(thickness, 3)), numeral(number_text(e.steepest_bed, 3)),
             numeral(number_text(least, 3)), number_text(0.5 * thickness / least * grid.cell_size, 2)}));
}

}  // namespace frana::app
