// SPDX-License-Identifier: Apache-2.0
#include "app/pictures/require_cells.h"

#include "app/text/number_text.h"
#include "core/error.h"
#include "core/shortest_text.h"

namespace frana::app {
namespace {

std::string cells_text(const GridSpec& grid) {
    return std::to_string(grid.columns) + " x " + std::to_string(grid.rows) + " cells of " +
           shortest_text(grid.cell_size) + " from " + extent_text(grid.bounds());
}

}  // namespace

void require_cells(const GridSpec& grid, const std::string& file, const GridSpec& expected, const std::string& other) {
    if (grid.same_cells(expected)) return;
    throw Error(ErrorKind::input, Problem{"does not have the cells of " + other, file, cells_text(grid),
                                          cells_text(expected), "One of the two is not from this run"});
}

}  // namespace frana::app
