// SPDX-License-Identifier: Apache-2.0
#include "app/study/statistics/outline_maps.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "analysis/trace.h"
#include "app/study/member_record.h"
#include "app/study/statistics/sensitivity.h"

namespace frana::app::study {
namespace {

/// Distances are computed block by block with so many cells around it: the ground between flows far apart costs
/// nothing.
constexpr std::int64_t k_block = 1024, k_far = 512;

/// Of a cell and a member: the signed distance from the outline in cells, up to k_far exact, and inside in its place by
/// how much the value exceeds the threshold.
struct Place {
    double distance = 0, output = 0;
};

/// @param window of the cells and k_far around them, as far as any member comes
std::vector<Place> places_in_outline(const MemberRecord& record, const GridSpec& grid, const CellWindow& window,
                                     Quantity quantity, double threshold, const std::vector<std::size_t>& cells) {
    const auto columns = static_cast<std::size_t>(window.columns + 2);  // with a border where nothing comes
    std::vector<double> excess(columns * static_cast<std::size_t>(window.rows + 2));
    std::vector<char> inside(excess.size());
    const auto place = [&](std::int64_t row, std::int64_t column) {
        return static_cast<std::size_t>(row - window.row + 1) * columns +
               static_cast<std::size_t>(column - window.column + 1);
    };
    const std::vector<float>& of_member = record.of(quantity);
    record.for_each_cell(grid, [&](std::int64_t row, std::int64_t column, std::size_t index) {
        if (row < window.row || column < window.column || row >= window.row + window.rows ||
            column >= window.column + window.columns)
            return;
        const double more = static_cast<double>(of_member[index]) - threshold;
        excess[place(row, column)] = more;
        inside[place(row, column)] = more > 0 ? 1 : 0;
    });
    const std::vector<double> all = distances_from_rim(inside, columns);
    std::vector<Place> places;
    for (const std::size_t cell : cells) {
        const std::size_t at =
            place(static_cast<std::int64_t>(cell) / grid.columns, static_cast<std::int64_t>(cell) % grid.columns);
        places.push_back({all[at], inside[at] != 0 ? excess[at] : all[at]});
    }
    return places;
}

/// Divides cells into lots that lie in one block each, of at most `most`.
std::vector<std::vector<std::size_t>> lots_of(const std::vector<std::size_t>& cells, const GridSpec& grid,
                                              std::size_t most) {
    std::map<std::pair<std::int64_t, std::int64_t>, std::vector<std::size_t>> blocks;
    for (const std::size_t cell : cells) {
        const auto at = static_cast<std::int64_t>(cell);
        blocks[{at / grid.columns / k_block, at % grid.columns / k_block}].push_back(cell);
    }
    std::vector<std::vector<std::size_t>> lots;
    for (const auto& [place, all] : blocks)
        for (std::size_t first = 0; first < all.size(); first += most)
            lots.emplace_back(all.begin() + static_cast<std::ptrdiff_t>(first),
                              all.begin() + static_cast<std::ptrdiff_t>(std::min(first + most, all.size())));
    return lots;
}

/// The block of such a lot and k_far around it, within `limits`.
CellWindow window_around(const std::vector<std::size_t>& cells, const GridSpec& grid, const CellWindow& limits) {
    const auto at = static_cast<std::int64_t>(cells.front());
    const auto part = [](std::int64_t cell, std::int64_t first, std::int64_t count) {
        const std::int64_t block = cell / k_block * k_block;
        const std::int64_t low = std::max(first, block - k_far),
                           high = std::min(first + count, block + k_block + k_far);
        return std::pair(low, high - low);
    };
    CellWindow window;
    std::tie(window.row, window.rows) = part(at / grid.columns, limits.row, limits.rows);
    std::tie(window.column, window.columns) = part(at % grid.columns, limits.column, limits.columns);
    return window;
}

/// Quantiles of the normal distribution at the ranks of members.
class NormalScores {
  public:
    explicit NormalScores(std::size_t members) : members_(members) {
        std::vector<double> places;
        for (std::size_t i = 1; i < 2 * members; ++i)
            places.push_back(static_cast<double>(i) / static_cast<double>(2 * members));
        quantiles_ = openturns().quantiles({Law::normal, {0, 1}, {}, {}, {}}, places);
    }
    /// Less the quantile at the fraction of outputs that are not greater than 0; empty if all are or none is. Equal
    /// outputs share a rank.
    [[nodiscard]] std::vector<double> of(const std::vector<double>& output) const {
        std::vector<double> sorted = output, scores;
        std::sort(sorted.begin(), sorted.end());
        const auto below = [&](double value) {
            return static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), value) - sorted.begin());
        };
        const auto up_to = [&](double value) {
            return static_cast<std::size_t>(std::upper_bound(sorted.begin(), sorted.end(), value) - sorted.begin());
        };
        const std::size_t outside = up_to(0);
        if (outside == 0 || outside == members_) return {};
        for (const double one : output)
            scores.push_back(quantiles_[below(one) + up_to(one) - 1] - quantiles_[2 * outside - 1]);
        return scores;
    }

  private:
    std::size_t members_;
    std::vector<double> quantiles_;  ///< at 1 / (2 n), 2 / (2 n) ...
};

/// A sum that has more than this of the variance of the members alone is not worth its words.
constexpr double k_least_gain = 0.9;
/// Members that would exceed, or not, as polynomials tell: with fewer a sum is often beyond 0 or 1.
constexpr double k_least_expected = 3;

}  // namespace

std::vector<EmulatedProbability> emulated_probabilities(const Emulation& emulation, const FinishedMembers& members,
                                                        const std::vector<std::vector<double>>& outputs) {
    const NormalScores normal(members.size());
    std::vector<std::vector<double>> scores;
    std::vector<std::size_t> known;
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        std::vector<double> one = normal.of(outputs[i]);
        if (one.empty()) continue;
        scores.push_back(std::move(one));
        known.push_back(i);
    }
    const std::vector<Chaos> polynomials = openturns().chaos(emulation.members, scores, emulation.sample);
    const MeanEstimate estimate(members);
    const auto count = static_cast<double>(members.size());
    std::vector<EmulatedProbability> all(outputs.size());
    std::vector<double> residuals, values(members.size());
    for (std::size_t i = 0; i < known.size(); ++i) {
        const Chaos& chaos = polynomials[i];
        if (chaos.elsewhere.empty()) continue;
        residuals.clear();
        for (std::size_t m = 0; m < members.size(); ++m) residuals.push_back(scores[i][m] - chaos.left_out[m]);
        std::sort(residuals.begin(), residuals.end());
        const auto count_above = [&](double prediction) {  // most predictions are far from 0
            if (prediction + residuals.back() <= 0) return 0.0;
            if (prediction + residuals.front() > 0) return count;
            return static_cast<double>(residuals.end() -
                                       std::upper_bound(residuals.begin(), residuals.end(), -prediction));
        };
        EmulatedProbability& p = all[known[i]];
        double spread = 0;  // of I round g
        for (const double prediction : chaos.elsewhere) {
            const double g = count_above(prediction) / count;
            p.by_sample += g;
            spread += g * (1 - g);
        }
        p.by_sample /= static_cast<double>(chaos.elsewhere.size());
        spread /= static_cast<double>(chaos.elsewhere.size());
        for (std::size_t m = 0; m < members.size(); ++m) {
            const double exceeds = scores[i][m] > 0 ? 1 : 0;  // its own residual is not one of the others'
            values[m] = p.by_sample + exceeds - (count_above(chaos.left_out[m]) - exceeds) / (count - 1);
        }
        p.estimate = estimate.mean(values);
        const double least = std::sqrt(spread / count);  // where few members differ from g their scatter is chance
        if (p.estimate.error >= least) continue;
        p.estimate.error = least;
        p.estimate.margin = (members.replicates.empty() ? k_normal : k_student[k_replicates - 2]) * least;
    }
    return all;
}

std::vector<double> distances_from_outline(const FinishedMembers& members, Quantity quantity, double threshold,
                                           const GridSpec& grid, std::size_t cell) {
    const auto at = static_cast<std::int64_t>(cell);
    const CellWindow window =
        window_of_both(reached_window(members, grid), {at / grid.columns, at % grid.columns, 1, 1});
    std::vector<double> all;
    for (const RecordPlace& record : members.records)
        all.push_back(
            places_in_outline(require_record(record), grid, window, quantity, threshold, {cell}).front().distance);
    return all;
}

bool OutlineMaps::pays() const noexcept {
    return error_ratio < k_least_gain;
}

void OutlineMaps::improve(ErrorSummary& errors) const {
    for (const Cell& one : cells) {
        if (!pays()) return;
        errors.remove(one.plain);
        errors.add(one.emulated);
    }
}

void OutlineMaps::improve(Raster& probability, Raster& margin) const {
    for (const Cell& one : cells) {
        if (!pays()) return;
        probability.values[one.cell] = std::clamp(one.emulated.value, 0.0, 1.0);
        margin.values[one.cell] = std::min(1.0, one.emulated.margin);
    }
}

OutlineMaps outline_maps(const FinishedMembers& members, const Emulation& emulation, Quantity quantity,
                         double threshold, const GridSpec& grid, bool wants_fractions) {
    OutlineMaps maps;
    if (wants_fractions) maps.fractions.assign(emulation.members.nominal.size(), Raster(grid, k_no_data));
    const MeanEstimate estimate(members);
    std::map<std::size_t, Estimate> rim;  // cells that some members reach and others do not
    for_each_reached_cell(members, quantity, grid, [&](std::size_t cell, std::span<const float> values) {
        const auto exceeds = [&](float value) { return static_cast<double>(value) > threshold; };
        const auto count = static_cast<std::size_t>(std::count_if(values.begin(), values.end(), exceeds));
        if (count > 0 && count < values.size()) rim.emplace(cell, estimate.probability(values, threshold));
    });
    std::vector<std::size_t> all_cells;
    for (const auto& [cell, p] : rim) all_cells.push_back(cell);
    const CellWindow reached = reached_window(members, grid);
    const std::size_t numbers = members.size() + emulation.sample.places.size(),
                      at_once = std::max<std::size_t>(1, CellStore::k_budget_bytes / (sizeof(double) * numbers));
    double squares = 0, plain = 0;
    for (const std::vector<std::size_t>& cells : lots_of(all_cells, grid, at_once)) {
        const CellWindow window = window_around(cells, grid, reached);
        std::vector<std::vector<double>> distances(cells.size()), outputs(cells.size());
        for (const RecordPlace& record : members.records) {
            const std::vector<Place> places =
                places_in_outline(require_record(record), grid, window, quantity, threshold, cells);
            for (std::size_t i = 0; i < cells.size(); ++i) {
                distances[i].push_back(places[i].distance);
                outputs[i].push_back(places[i].output);
            }
        }
        if (wants_fractions) {
            const std::vector<Chaos> all = openturns().chaos(emulation.members, distances, {});
            for (std::size_t i = 0; i < cells.size(); ++i)
                for (std::size_t k = 0; k < maps.fractions.size() && all[i].q2 >= k_least_q2; ++k)
                    maps.fractions[k].values[cells[i]] = all[i].first_order[k];
        }
        if (emulation.sample.places.empty()) continue;
        const std::vector<EmulatedProbability> probabilities = emulated_probabilities(emulation, members, outputs);
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const EmulatedProbability& p = probabilities[i];
            const double expected = static_cast<double>(members.size()) * std::min(p.by_sample, 1 - p.by_sample);
            if (expected < k_least_expected) continue;
            maps.cells.push_back({cells[i], p.estimate, rim.at(cells[i])});
            squares += p.estimate.error * p.estimate.error;
            plain += maps.cells.back().plain.error * maps.cells.back().plain.error;
        }
    }
    if (plain > 0) maps.error_ratio = std::sqrt(squares / plain);
    return maps;
}

}  // namespace frana::app::study
