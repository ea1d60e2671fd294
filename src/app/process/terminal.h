// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace frana::app {

/// A width at which nothing is wrapped.
inline constexpr std::size_t k_any_width = 100'000;

/// Returns the columns that a text on stdout may take: those of the terminal, or of COLUMNS if the terminal does not
/// tell, or 80; `k_any_width` where stdout is no terminal, so that files and pipes do not depend on a window.
std::size_t output_width();

}  // namespace frana::app
