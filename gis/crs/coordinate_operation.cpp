// SPDX-License-Identifier: Apache-2.0
#include "gis/crs/coordinate_operation.h"

#include <utility>

#include "core/error.h"
#include "gis/crs/crs.h"

namespace frana::gis {
namespace {

constexpr double k_least_area_degrees = 0.005;  // some 500 m: small compared with any operation's area

ProjPointer<PJ> make_crs(PJ_CONTEXT* context, const std::string& wkt) {
    ProjPointer<PJ> crs(proj_create(context, wkt.c_str()));
    if (!crs) {
        throw Error(ErrorKind::input, Problem{"PROJ does not know this coordinate reference system", "", crs_name(wkt),
                                              "", "Name it by its EPSG code"});
    }
    return crs;
}

/// Returns the geographic CRS of a projected one where it is that of `to` but for the order of its axes, else null. The
/// operation to that is a formula, for which PROJ need not search its database.
ProjPointer<PJ> own_degrees(PJ_CONTEXT* context, const PJ* from, const PJ* to) {
    const PJ_TYPE type = proj_get_type(to);
    if (proj_get_type(from) != PJ_TYPE_PROJECTED_CRS || type != PJ_TYPE_GEOGRAPHIC_2D_CRS) return nullptr;
    ProjPointer<PJ> own(proj_crs_get_geodetic_crs(context, from));
    const bool same =
        own && proj_get_type(own.get()) == type &&
        proj_is_equivalent_to_with_ctx(context, own.get(), to, PJ_COMP_EQUIVALENT_EXCEPT_AXIS_ORDER_GEOGCRS) != 0;
    return same ? std::move(own) : nullptr;
}

ProjPointer<PJ_OBJ_LIST> operations(PJ_CONTEXT* context, const PJ* from, const PJ* to, std::optional<Bounds> degrees,
                                    PROJ_GRID_AVAILABILITY_USE grids) {
    const ProjPointer<PJ_OPERATION_FACTORY_CONTEXT> factory(proj_create_operation_factory_context(context, nullptr));
    proj_operation_factory_context_set_spatial_criterion(context, factory.get(),
                                                         PROJ_SPATIAL_CRITERION_PARTIAL_INTERSECTION);
    proj_operation_factory_context_set_grid_availability_use(context, factory.get(), grids);
    if (degrees) {
        // For an area without extent PROJ considers every operation equally near, including those for other countries.
        degrees->west -= k_least_area_degrees;
        degrees->south -= k_least_area_degrees;
        degrees->east += k_least_area_degrees;
        degrees->north += k_least_area_degrees;
        // PROJ represents an area across the antimeridian by west > east.
        if (degrees->east > 180) degrees->east -= 360;
        if (degrees->west < -180) degrees->west += 360;
        proj_operation_factory_context_set_area_of_interest(context, factory.get(), degrees->west, degrees->south,
                                                            degrees->east, degrees->north);
    }
    return ProjPointer<PJ_OBJ_LIST>(proj_create_operations(context, from, to, factory.get()));
}

/// Whether only formulas are involved (a projection and its inverse), no change of datum.
bool exact(PJ_CONTEXT* context, const PJ* operation) {
    if (proj_get_type(operation) == PJ_TYPE_CONVERSION) return true;
    if (proj_get_type(operation) != PJ_TYPE_CONCATENATED_OPERATION) return false;
    for (int i = 0; i < proj_concatoperation_get_step_count(context, operation); ++i) {
        const ProjPointer<PJ> step(proj_concatoperation_get_step(context, operation, i));
        if (!step || !exact(context, step.get())) return false;
    }
    return true;
}

ProjPointer<PJ> first_operation(PJ_CONTEXT* context, const ProjPointer<PJ_OBJ_LIST>& list) {
    const bool some = list && proj_list_get_count(list.get()) > 0;
    return ProjPointer<PJ>(some ? proj_list_get(context, list.get(), 0) : nullptr);
}

/// Returns the first grid file that an operation needs and that is not installed.
std::string missing_grid(PJ_CONTEXT* context, const PJ* operation) {
    for (int i = 0; i < proj_coordoperation_get_grid_used_count(context, operation); ++i) {
        const char* name = nullptr;
        int available = 0;
        if (proj_coordoperation_get_grid_used(context, operation, i, &name, nullptr, nullptr, nullptr, nullptr, nullptr,
                                              &available) &&
            !available && name) {
            return name;
        }
    }
    return {};
}

std::string name_of(const PJ* operation) {
    const char* name = proj_get_name(operation);
    return name ? name : "unnamed";
}

}  // namespace

ProjPointer<PJ_CONTEXT> make_proj_context() {
    ProjPointer<PJ_CONTEXT> context(proj_context_create());
    proj_log_level(context.get(), PJ_LOG_NONE);
    proj_context_set_enable_network(context.get(), 0);
    return context;
}

CoordinateOperation choose_operation(PJ_CONTEXT* context, const std::string& from_wkt, const std::string& to_wkt,
                                     std::optional<Bounds> degrees) {
    const ProjPointer<PJ> from = make_crs(context, from_wkt);
    ProjPointer<PJ> to = make_crs(context, to_wkt);
    if (ProjPointer<PJ> own = own_degrees(context, from.get(), to.get())) to = std::move(own);
    const ProjPointer<PJ> usable = first_operation(
        context,
        operations(context, from.get(), to.get(), degrees, PROJ_GRID_AVAILABILITY_DISCARD_OPERATION_IF_MISSING_GRID));
    CoordinateOperation chosen;
    if (usable) chosen.pj.reset(proj_normalize_for_visualization(context, usable.get()));
    if (!chosen.pj) {
        throw Error(ErrorKind::input, Problem{"there is no transformation between the two coordinate reference systems",
                                              "", crs_name(from_wkt) + " to " + crs_name(to_wkt), "",
                                              "Check that both are valid for this part of the world"});
    }
    chosen.info.operation = name_of(usable.get());
    const bool by_formula = exact(context, usable.get());
    chosen.info.accuracy_m = by_formula ? 0 : proj_coordoperation_get_accuracy(context, usable.get());
    if (by_formula) return chosen;
    const ProjPointer<PJ> wished =
        first_operation(context, operations(context, from.get(), to.get(), degrees, PROJ_GRID_AVAILABILITY_IGNORED));
    if (wished && !proj_coordoperation_is_instantiable(context, wished.get())) {
        const double accuracy = proj_coordoperation_get_accuracy(context, wished.get());
        chosen.info.needs_missing_grid =
            chosen.info.accuracy_m < 0 || (accuracy >= 0 && accuracy < chosen.info.accuracy_m);
        if (chosen.info.needs_missing_grid) {
            chosen.info.missing_grid = missing_grid(context, wished.get());
            chosen.info.missing_accuracy_m = accuracy;
        }
    }
    return chosen;
}

}  // namespace frana::gis
