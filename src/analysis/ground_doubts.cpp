// SPDX-License-Identifier: Apache-2.0
#include "analysis/ground_doubts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <vector>

#include "analysis/ground_statistics.h"

namespace frana {
namespace {

// The cells of the path within a square of 2 `by` + 1 cells round any of these, by sums over the corners of squares.
Raster widened(const std::vector<std::size_t>& cells, std::int64_t by, const Raster& path) {
    const GridSpec& grid = path.grid;
    const std::int64_t width = grid.columns + 1;
    std::vector<std::int32_t> squares(static_cast<std::size_t>(width * (grid.rows + 1)));
    const auto corner = [&](std::int64_t row, std::int64_t column) -> std::int32_t& {
        return squares[static_cast<std::size_t>(row * width + column)];
    };
    for (const std::size_t cell : cells) {
        const auto row = static_cast<std::int64_t>(cell) / grid.columns,
                   column = static_cast<std::int64_t>(cell) % grid.columns;
        const std::int64_t top = std::max<std::int64_t>(row - by, 0), bottom = std::min(row + by + 1, grid.rows),
                           left = std::max<std::int64_t>(column - by, 0),
                           right = std::min(column + by + 1, grid.columns);
        ++corner(top, left);
        --corner(top, right);
        --corner(bottom, left);
        ++corner(bottom, right);
    }
    Raster wide(grid);
    for (std::int64_t row = 0; row < grid.rows; ++row) {
        std::int32_t sum = 0;
        for (std::int64_t column = 0; column < grid.columns; ++column) {
            sum += corner(row, column);
            corner(row, column) = sum + (row > 0 ? corner(row - 1, column) : 0);
            if (corner(row, column) > 0 && path.at(row, column) > 0) wide.at(row, column) = 1;
        }
    }
    return wide;
}

/// The part of the path that the flow takes: where water from its highest cells runs, over what dams it up, and as wide
/// to both sides as the mass where it starts. The start is marked with 2. Finds narrow dams across it.
Raster taken_path(const Raster& ground, const Raster& path, double cell_size, std::optional<GroundDoubts::Dam>& dam) {
    constexpr double k_dam = 5, k_narrow = 30, k_narrow_cells = 2.5;  // [m]
    const GridSpec& grid = ground.grid;
    const auto centre_of = [&](std::size_t cell) {
        const auto at = static_cast<std::int64_t>(cell);
        return grid.cell_centre(at / grid.columns, at % grid.columns);
    };
    std::set<std::tuple<double, std::size_t, std::size_t>> front;  // elevation, order, cell: where it came first
    std::size_t order = 0;
    constexpr auto k_untouched = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> from(static_cast<std::size_t>(grid.cell_count()),
                                  k_untouched);  // the cell that water came from
    std::vector<std::size_t> taken;
    double starts = 0;
    path.values.for_each_stored([&](std::size_t cell, double on) {
        if (!(on > 1) || std::isnan(ground.values[cell])) return;
        starts += 1;
        front.emplace(ground.values[cell], ++order, cell);
        from[cell] = cell;
    });
    const auto side = static_cast<std::int64_t>(std::clamp(std::sqrt(starts) / 2, 2.0, 30.0));
    const auto beside = [&](std::size_t cell, const auto& visit) {
        const auto row = static_cast<std::int64_t>(cell) / grid.columns,
                   column = static_cast<std::int64_t>(cell) % grid.columns;
        for (std::int64_t r = std::max<std::int64_t>(row - 1, 0); r <= std::min(row + 1, grid.rows - 1); ++r)
            for (std::int64_t c = std::max<std::int64_t>(column - 1, 0); c <= std::min(column + 1, grid.columns - 1);
                 ++c)
                visit(ground.index(r, c));
    };
    const double narrow = std::max(k_narrow / cell_size, k_narrow_cells) * grid.cell_size;  // of the grid's unit
    double floor = HUGE_VAL, level = HUGE_VAL;  // of the water where it is dammed up
    // The lowest first, as water rises: it leaves the path at its lowest end.
    for (bool ends = false; !front.empty() && !ends;) {
        const auto [z, at, cell] = front.extract(front.begin()).value();
        if (z < floor) {
            const Point here = centre_of(cell);
            std::size_t crest = cell;
            const auto is_near = [&](Point p) { return std::hypot(here.x - p.x, here.y - p.y) <= narrow; };
            while (ground.values[crest] < level && from[crest] != crest && is_near(centre_of(from[crest])))
                crest = from[crest];
            if (ground.values[crest] >= level && level - floor > std::max(k_dam, dam ? dam->height : 0))
                dam = {level - floor, centre_of(crest)};
            floor = level = z;
        }
        level = std::max(level, z);
        taken.push_back(cell);
        beside(cell, [&](std::size_t i) {
            if (std::isnan(ground.values[i])) return;
            ends = ends || !(path.values[i] > 0);
            if (from[i] != k_untouched) return;
            from[i] = cell;
            front.emplace(ground.values[i], ++order, i);
        });
    }
    return widened(taken, side, path);
}

// Longer ones are plains and lakes.
constexpr std::int64_t k_longest_run = 64;

/// One direction over a raster, so that rows and columns share their code.
class Lines {
  public:
    Lines(const Raster& raster, bool along_rows)
        : raster_(raster),
          step_(along_rows ? 1 : raster.grid.columns),
          across_(along_rows ? raster.grid.columns : 1),
          count_(along_rows ? raster.grid.rows : raster.grid.columns),
          length_(along_rows ? raster.grid.columns : raster.grid.rows) {}

    [[nodiscard]] std::int64_t count() const noexcept { return count_; }
    [[nodiscard]] std::int64_t length() const noexcept { return length_; }
    [[nodiscard]] std::size_t cell(std::int64_t line, std::int64_t place) const noexcept {
        return static_cast<std::size_t>(line * across_ + place * step_);
    }
    [[nodiscard]] double operator()(std::int64_t line, std::int64_t place) const {
        return raster_.values[cell(line, place)];
    }

  private:
    const Raster& raster_;
    std::int64_t step_, across_, count_, length_;
};

Point centre_of(const GridSpec& grid, std::size_t cell) {
    const auto at = static_cast<std::int64_t>(cell);
    return grid.cell_centre(at / grid.columns, at % grid.columns);
}

/// Runs of equal cells on slopes: what lies before one is lower and what follows higher, or the reverse.
struct Runs {
    std::map<std::int64_t, std::int64_t> lengths;  ///< number by length
    std::vector<char> edge;     ///< of each cell to the next: 1 a step, 0 none within a run, -1 neither
    std::vector<char> terrace;  ///< 1: in a run of two or more cells between two steps
    std::vector<double> steps;  ///< at the ends of these [m]

    Runs(const Raster& ground, const Raster& path, bool along_rows) : edge(cells(ground), -1), terrace(cells(ground)) {
        const Lines z(ground, along_rows), on(path, along_rows);
        for (std::int64_t line = 0; line < z.count(); ++line) {
            for (std::int64_t first = 0, next = 0; first < z.length(); first = next) {
                const double value = z(line, first);
                next = first + 1;
                while (next < z.length() && z(line, next) == value) ++next;
                if (first == 0 || next == z.length() || next - first > k_longest_run) continue;
                if (!(on(line, (first + next) / 2) > 0)) continue;
                const double before = value - z(line, first - 1), after = z(line, next) - value;
                if (!(before * after > 0)) continue;
                ++lengths[next - first];
                edge[z.cell(line, first - 1)] = edge[z.cell(line, next - 1)] = 1;
                for (std::int64_t i = first; i + 1 < next; ++i) edge[z.cell(line, i)] = 0;
                const double lower = std::min(std::abs(before), std::abs(after));
                if (next - first < 2 || lower < k_terrace_step) continue;
                steps.push_back(lower);
                for (std::int64_t i = first; i < next; ++i) terrace[z.cell(line, i)] = 1;
            }
        }
    }
    static std::size_t cells(const Raster& ground) { return static_cast<std::size_t>(ground.grid.cell_count()); }

    /// Mean length, without those that two equal blocks side by side make.
    [[nodiscard]] double mean() const {
        std::int64_t all = 0, below = 0, cells = 0, count = 0;
        for (const auto& [length, number] : lengths) all += number;
        double longest = 0;
        for (const auto& [length, number] : lengths) {
            if (2 * below < all) longest = std::max(2.0, 1.5 * static_cast<double>(length));
            below += number;
        }
        for (const auto& [length, number] : lengths) {
            if (static_cast<double>(length) > longest) continue;
            cells += length * number;
            count += number;
        }
        return count > 0 ? static_cast<double>(cells) / static_cast<double>(count) : 1;
    }
    /// Agreement of the steps of each line with those of the line beside it (Cohen's kappa): 1 for copied cells.
    [[nodiscard]] double agreement(const Raster& ground, bool along_rows) const {
        const Lines z(ground, along_rows);
        double both = 0, neither = 0, first = 0, second = 0, all = 0;
        for (std::int64_t line = 0; line + 1 < z.count(); ++line) {
            for (std::int64_t i = 0; i < z.length(); ++i) {
                const int a = edge[z.cell(line, i)], b = edge[z.cell(line + 1, i)];
                if (a < 0 || b < 0) continue;
                all += 1;
                first += a;
                second += b;
                both += a * b;
                neither += (1 - a) * (1 - b);
            }
        }
        if (!(all > 0)) return 0;
        const double chance = (first * second + (all - first) * (all - second)) / (all * all);
        return chance < 1 ? ((both + neither) / all - chance) / (1 - chance) : 0;
    }
};

double fraction(std::int64_t part, std::int64_t all) {
    return all > 0 ? static_cast<double>(part) / static_cast<double>(all) : 0;
}

/// The cells looked at.
class Path {
  public:
    explicit Path(const Raster& path) {
        path.values.for_each_stored([&](std::size_t cell, double on) {
            if (on > 0) cells_.push_back(cell);
        });
    }
    [[nodiscard]] const std::vector<std::size_t>& cells() const noexcept { return cells_; }
    [[nodiscard]] std::int64_t size() const noexcept { return static_cast<std::int64_t>(cells_.size()); }

  private:
    std::vector<std::size_t> cells_;
};

/// Level in both directions: the cell has an equal one beside it and an equal one above or below.
bool is_level(const Raster& ground, std::size_t cell) {
    const auto at = static_cast<std::int64_t>(cell);
    const std::int64_t row = at / ground.grid.columns, column = at % ground.grid.columns;
    const double z = ground.values[cell];
    const auto same = [&](std::int64_t r, std::int64_t c) {
        return r >= 0 && c >= 0 && r < ground.grid.rows && c < ground.grid.columns && ground.at(r, c) == z;
    };
    return (same(row, column - 1) || same(row, column + 1)) && (same(row - 1, column) || same(row + 1, column));
}

/// Whether a step is one that elevations are rounded to, in metres or feet.
bool is_round(double step) {
    constexpr double k_foot = 0.3048;
    for (const double unit : {1.0, k_foot})
        for (const double round : {0.25, 0.5, 1.0, 2.0, 2.5, 5.0, 10.0, 20.0, 25.0, 50.0, 100.0})
            if (std::abs(step - round * unit) < 1e-3 * step) return true;
    return false;
}

/// Finds blocks, by steps that run straight through many rows and columns, or else level ground between steps: it was
/// rounded if these are of a round number of metres or feet, and copied if not.
void find_level_ground(const Raster& ground, const Path& path, const Runs& east, const Runs& south,
                       GroundDoubts& doubts) {
    constexpr double k_least_block = 1.2, k_least_agreement = 0.7, k_least_share = 0.1;
    GroundDoubts::Blocks blocks{east.mean(), south.mean(), 0};
    const bool straight = blocks.columns >= k_least_block && blocks.rows >= k_least_block &&
                          east.agreement(ground, true) >= k_least_agreement &&
                          south.agreement(ground, false) >= k_least_agreement;
    std::int64_t level = 0, between_steps = 0;
    GroundDoubts::Terraces terraces;
    for (const std::size_t cell : path.cells()) {
        if (!is_level(ground, cell)) continue;
        ++level;
        if (!east.terrace[cell] && !south.terrace[cell]) continue;
        if (between_steps++ == 0) terraces.place = centre_of(ground.grid, cell);
    }
    blocks.share = fraction(level, path.size());
    terraces.share = fraction(between_steps, path.size());
    std::vector<double> steps = east.steps;
    steps.insert(steps.end(), south.steps.begin(), south.steps.end());
    if (!straight && terraces.share < k_least_share) return;
    terraces.step = percentile(std::move(steps), 0.5);
    if (!straight && is_round(terraces.step)) {
        doubts.terraces = terraces;
        return;
    }
    // A slope that falls along one of the two has no steps along the other.
    if (east.lengths.empty()) blocks.columns = blocks.rows;
    if (south.lengths.empty()) blocks.rows = blocks.columns;
    doubts.blocks = blocks;
}

/// A step over two cells, as interpolation leaves it, between smooth ground.
struct Step {
    double across = 0, along = 0;  ///< place [cells]
    double height = 0;             ///< [m]
    bool on_path = false;
};

std::vector<Step> steps_across(const Lines& z, const Lines& on, double least) {
    constexpr double k_over_bend = 4;
    const auto rise = [&](std::int64_t line, std::int64_t i) { return z(line, i + 1) - z(line, i - 1); };
    const auto height = [&](std::int64_t line, std::int64_t i) {
        return rise(line, i) - (rise(line, i - 2) + rise(line, i + 2)) / 2;
    };
    std::vector<Step> steps;
    for (std::int64_t line = 0; line < z.count(); ++line) {
        for (std::int64_t i = 4; i + 4 < z.length(); ++i) {
            const double here = height(line, i);
            if (!(std::abs(here) >= least)) continue;
            if (std::abs(here) < std::abs(height(line, i - 1)) || !(std::abs(here) > std::abs(height(line, i + 1))))
                continue;
            if (std::abs(rise(line, i + 2) - rise(line, i - 2)) * k_over_bend > std::abs(here)) continue;
            const bool on_path = on(line, i) > 0 || on(line, i - 1) > 0;  // a wall is beside it
            steps.push_back({static_cast<double>(i), static_cast<double>(line), here, on_path});
        }
    }
    return steps;
}

/// The longest row of steps of about one height on a line across + slope along = offset, of which some are on the path.
std::optional<GroundDoubts::Seam> row_of_steps(const std::vector<Step>& steps, double slope, double offset) {
    constexpr double k_wide = 1.5, k_gap = 3, k_filled = 0.7, k_change = 0.35;
    constexpr double k_least = 32, k_least_along_grid = 24;  // which is less often by chance
    std::optional<GroundDoubts::Seam> longest;
    double first = 0, last = -HUGE_VAL, sum = 0, change = 0, before = 0;
    std::int64_t count = 0, on_path = 0;
    const auto finish = [&] {
        const double length = last - first + 1, least = std::abs(slope) * length < 1 ? k_least_along_grid : k_least;
        if (on_path > 0 && length >= least && static_cast<double>(count) > k_filled * length &&
            change < k_change * std::abs(sum) && (!longest || length > longest->length)) {
            const double middle = (first + last) / 2;
            longest = {std::abs(sum) / static_cast<double>(count), length, {offset + slope * middle, middle}};
        }
    };
    for (const Step& step : steps) {  // in the order of `along`
        if (std::abs(step.across - slope * step.along - offset) > k_wide) continue;
        if (step.along - last > k_gap || step.height * before < 0) {
            finish();
            first = step.along;
            sum = change = 0;
            count = on_path = 0;
        } else {
            change += std::abs(step.height - before);
        }
        last = step.along;
        before = step.height;
        sum += step.height;
        ++count;
        on_path += step.on_path ? 1 : 0;
    }
    finish();
    return longest;
}

/// Finds a seam across the lines of one direction, askew to it between tiles in another coordinate system. The line on
/// which most steps lie is sought among all (Hough's transform).
void find_seam(const Raster& ground, const Raster& path, double cell_size, bool along_rows, GroundDoubts& doubts) {
    constexpr int k_slopes = 128;  // of 45 degrees to either side
    constexpr std::size_t k_most_others = 5;
    const Lines z(ground, along_rows), on(path, along_rows);
    const std::vector<Step> steps = steps_across(z, on, 1 + 0.1 * cell_size);
    std::pair<int, std::int64_t> best{};
    std::size_t most = 0, looked_at = 0;
    std::vector<std::size_t> counts(static_cast<std::size_t>(z.length() + 2 * z.count() + 1));  // by offset
    for (int s = -k_slopes; s <= k_slopes; ++s) {
        std::fill(counts.begin(), counts.end(), 0);
        looked_at = 0;
        for (const Step& step : steps) {
            if (!step.on_path) continue;
            ++looked_at;
            const std::int64_t offset = std::llround(step.across - s * step.along / k_slopes);
            if (const std::size_t count = ++counts[static_cast<std::size_t>(offset + z.count())]; count > most) {
                most = count;
                best = {s, offset};
            }
        }
    }
    if (most == 0 || looked_at > k_most_others * most) return;  // steps all over are rough ground
    auto seam = row_of_steps(steps, static_cast<double>(best.first) / k_slopes, static_cast<double>(best.second));
    if (!seam) return;
    seam->place = centre_of(ground.grid, z.cell(std::llround(seam->place.y), std::llround(seam->place.x)));
    doubts.seam = seam;
}

/// Connected cells of one value and the ground around them.
struct Patch {
    std::vector<std::size_t> cells;
    std::int64_t around = 0, beyond = 0;  ///< neighbours outside; of these: higher by more than the limit
};

/// @param deep its neighbours are higher by more [m]
Patch patch_at(const Raster& ground, std::size_t start, double deep, std::vector<char>& seen) {
    constexpr std::size_t k_most_cells = 20'000;
    Patch patch{{start}};
    seen[start] = 1;
    const double value = ground.values[start];
    for (std::size_t i = 0; i < patch.cells.size() && patch.cells.size() < k_most_cells; ++i) {
        const auto at = static_cast<std::int64_t>(patch.cells[i]);
        const std::int64_t row = at / ground.grid.columns, column = at % ground.grid.columns;
        for (const auto& [r, c] :
             {std::pair{row - 1, column}, {row + 1, column}, {row, column - 1}, {row, column + 1}}) {
            if (r < 0 || c < 0 || r >= ground.grid.rows || c >= ground.grid.columns) continue;
            const std::size_t cell = ground.index(r, c);
            const double step = ground.values[cell] - value;
            if (step == 0) {
                if (!seen[cell]) patch.cells.push_back(cell);
                seen[cell] = 1;
            } else if (!std::isnan(step)) {
                ++patch.around;
                patch.beyond += step > deep;
            }
        }
    }
    return patch;
}

void find_pits(const Raster& ground, const Path& path, double cell_size, GroundDoubts& doubts) {
    constexpr double k_deep = 10, k_deep_cells = 1.5, k_most_of_rim = 0.8;
    const double deep = std::max(k_deep, k_deep_cells * cell_size);
    std::vector<char> seen(Runs::cells(ground));
    std::map<double, GroundDoubts::Pits> by_value;
    for (const std::size_t cell : path.cells()) {
        const auto column = static_cast<std::int64_t>(cell) % ground.grid.columns;
        if (seen[cell] || column == 0) continue;
        if (!(ground.values[cell - 1] > ground.values[cell] + deep)) continue;
        const Patch patch = patch_at(ground, cell, deep, seen);
        if (patch.cells.size() < 2) continue;  // a needle
        if (static_cast<double>(patch.beyond) < k_most_of_rim * static_cast<double>(patch.around)) continue;
        GroundDoubts::Pits& pits = by_value[ground.values[cell]];
        if (pits.cells == 0) pits = {ground.values[cell], 0, 0, centre_of(ground.grid, cell)};
        pits.cells += static_cast<std::int64_t>(patch.cells.size());
    }
    for (auto& [value, pits] : by_value) {
        if (doubts.pits && doubts.pits->cells >= pits.cells) continue;
        pits.share = std::min(1.0, fraction(pits.cells, path.size()));
        doubts.pits = pits;
    }
}

/// Height above or below what lies before and after it, of the line through the cell where this is least: 0 on crests
/// and in gullies, which are straight over a few cells.
double height_of(const Raster& ground, std::int64_t row, std::int64_t column) {
    constexpr std::int64_t k_side = 2;
    if (row < k_side || column < k_side || row + k_side >= ground.grid.rows || column + k_side >= ground.grid.columns)
        return k_no_data;
    double least = HUGE_VAL;
    for (const auto& [r, c] : {std::pair{0, 1}, {1, 0}, {1, 1}, {1, -1}}) {
        std::array<double, 2 * k_side + 1> line{};
        for (std::int64_t i = -k_side; i <= k_side; ++i)
            line[static_cast<std::size_t>(i + k_side)] = ground.at(row + i * r, column + i * c);
        if (std::any_of(line.begin(), line.end(), [](double z) { return std::isnan(z); })) return k_no_data;
        const double here = line[k_side];
        std::nth_element(line.begin(), line.begin() + k_side, line.end());
        least = std::min(least, std::abs(here - line[k_side]));
    }
    return least;
}

void find_rough(const Raster& ground, const Path& path, double cell_size, GroundDoubts& doubts) {
    constexpr double k_least_height = 1.5, k_height_cells = 0.25, k_least_share = 0.06;  // crags of lava have 0.03
    const double limit = std::max(k_least_height, k_height_cells * cell_size);
    std::vector<double> heights;
    std::int64_t looked_at = 0;
    double highest = 0;
    GroundDoubts::Rough rough;
    for (const std::size_t cell : path.cells()) {
        const auto at = static_cast<std::int64_t>(cell);
        const double height = height_of(ground, at / ground.grid.columns, at % ground.grid.columns);
        looked_at += std::isnan(height) ? 0 : 1;
        if (!(height > limit)) continue;
        heights.push_back(height);
        if (height > highest) rough.place = centre_of(ground.grid, cell);
        highest = std::max(highest, height);
    }
    rough.share = fraction(static_cast<std::int64_t>(heights.size()), looked_at);
    if (rough.share < k_least_share) return;
    rough.height = percentile(std::move(heights), 0.5);
    doubts.rough = rough;
}

}  // namespace

GroundDoubts ground_doubts(const Raster& ground, const Raster& path, double cell_size) {
    GroundDoubts doubts;
    const Path on(path);
    const Runs east(ground, path, true), south(ground, path, false);
    find_level_ground(ground, on, east, south, doubts);
    find_pits(ground, on, cell_size, doubts);
    if (doubts.blocks || doubts.terraces) return doubts;  // whose steps look like seams and roughness
    const Path taken(taken_path(ground, path, cell_size, doubts.dam));
    find_rough(ground, taken, cell_size, doubts);
    if (doubts.rough) doubts.dam.reset();  // of trees
    for (const bool along_rows : {true, false})
        if (!doubts.seam && !doubts.dam) find_seam(ground, path, cell_size, along_rows, doubts);
    return doubts;
}

Raster reachable_ground(const Raster& ground, const Raster& start, double friction) {
    const GridSpec& grid = ground.grid;
    Raster reached(grid);
    std::vector<std::size_t> front;
    double top = -HUGE_VAL;
    std::int64_t north = grid.rows, south = 0, west = grid.columns, east = 0;
    start.values.for_each_stored([&](std::size_t cell, double metres) {
        if (!(metres > 0) || std::isnan(ground.values[cell])) return;
        top = std::max(top, ground.values[cell] + metres);
        const auto at = static_cast<std::int64_t>(cell);
        north = std::min(north, at / grid.columns);
        south = std::max(south, at / grid.columns);
        west = std::min(west, at % grid.columns);
        east = std::max(east, at % grid.columns);
        reached.values[cell] = 2;
        front.push_back(cell);
    });
    while (!front.empty()) {
        const auto at = static_cast<std::int64_t>(front.back());
        front.pop_back();
        const std::int64_t row = at / grid.columns, column = at % grid.columns;
        for (std::int64_t r = std::max<std::int64_t>(row - 1, 0); r <= std::min(row + 1, grid.rows - 1); ++r) {
            for (std::int64_t c = std::max<std::int64_t>(column - 1, 0); c <= std::min(column + 1, grid.columns - 1);
                 ++c) {
                const std::size_t cell = ground.index(r, c);
                const auto away = [](std::int64_t least, std::int64_t i, std::int64_t most) {
                    return static_cast<double>(std::max({least - i, std::int64_t{0}, i - most}));
                };
                const double distance = grid.cell_size * std::hypot(away(north, r, south), away(west, c, east));
                if (reached.values[cell] > 0 || !(ground.values[cell] <= top - friction * distance)) continue;
                reached.values[cell] = 1;
                front.push_back(cell);
            }
        }
    }
    return reached;
}

}  // namespace frana
