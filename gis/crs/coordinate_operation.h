// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <proj.h>

#include <memory>
#include <optional>
#include <string>

#include "core/grid_spec.h"
#include "gis/crs/crs_transform.h"

namespace frana::gis {

struct ProjDelete {
    void operator()(PJ_CONTEXT* context) const noexcept { proj_context_destroy(context); }
    void operator()(PJ* object) const noexcept { proj_destroy(object); }
    void operator()(PJ_OBJ_LIST* list) const noexcept { proj_list_destroy(list); }
    void operator()(PJ_OPERATION_FACTORY_CONTEXT* factory) const noexcept {
        proj_operation_factory_context_destroy(factory);
    }
};
template <class T>
using ProjPointer = std::unique_ptr<T, ProjDelete>;

/// Returns a silent context that never uses the network: a run must not depend on it.
ProjPointer<PJ_CONTEXT> make_proj_context();

/// A coordinate operation ready for use, x to the east (longitude in degrees) on both sides.
struct CoordinateOperation {
    ProjPointer<PJ> pj;
    TransformInfo info;
};

/// Returns PROJ's best operation between two CRSs (WKT) among those whose grids are installed; `degrees` is the area of
/// interest in longitude and latitude. Throws Error(input) if there is none.
CoordinateOperation choose_operation(PJ_CONTEXT* context, const std::string& from_wkt, const std::string& to_wkt,
                                     std::optional<Bounds> degrees);

}  // namespace frana::gis
