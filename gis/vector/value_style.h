// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "gis/vector/vector_style.h"

namespace frana::gis {

/// The look of the features with one value of a number attribute.
struct ValueLook {
    double value = 0;  ///< NaN: of all other features, last
    std::string label;
    VectorLook look;
};

/// Returns a style that tells features apart by an attribute.
StyleText style_of(const std::string& name, Shape shape, const std::string& attribute,
                   const std::vector<ValueLook>& looks);

}  // namespace frana::gis
