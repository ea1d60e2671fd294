// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace frana {

/// numerics.flight-slope, in the scene's file and for scenes that are made without one [degrees].
inline constexpr double k_flight_slope_degrees = 70;

}  // namespace frana
