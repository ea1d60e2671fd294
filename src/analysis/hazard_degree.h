// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "analysis/hazard.h"

namespace frana {

/// Degree of hazard: what an intensity means together with how often it comes. Greater is worse.
enum class HazardDegree { residual = 1, yellow, blue, red };

/// Returns "red"; of the residual one "yellow-white".
std::string name_of(HazardDegree degree);
/// Returns the degree of such a name.
std::optional<HazardDegree> degree_from(const std::string& name);

/// Intensities of the matrix, and probabilities by their return period.
inline constexpr int k_intensities = 3;  ///< 1 weak, 2 medium, 3 strong
inline constexpr std::size_t k_probabilities = 3;

/// Degrees for three intensities and three probabilities (high, medium, low). Rarer events are a residual hazard,
/// whatever their intensity. The default is the Swiss matrix of nine fields for all processes as the canton of Bern
/// publishes it; where it divides a field between two colours, by the process, the worse one. share/doc/region.md has
/// the matrices of single processes.
struct DegreeMatrix {
    /// Longest return period of each probability [years], rising.
    std::array<double, k_probabilities> periods{30, 100, 300};
    /// By intensity, from weak; by probability, from high.
    std::array<std::array<HazardDegree, k_probabilities>, k_intensities> degrees{
        {{HazardDegree::blue, HazardDegree::blue, HazardDegree::yellow},
         {HazardDegree::red, HazardDegree::blue, HazardDegree::blue},
         {HazardDegree::red, HazardDegree::red, HazardDegree::red}}};

    /// @param intensity 1 to 3
    /// @param return_period [years], greater than 0
    [[nodiscard]] HazardDegree of(int intensity, double return_period) const;
    /// Returns what leads to a degree: "strong <= 300 a; medium <= 30 a", a: years. Empty: nothing does.
    [[nodiscard]] std::string conditions_of(HazardDegree degree) const;
};

/// Returns "weak", "medium", "strong".
std::string intensity_name(int intensity);

/// A degree as a class of a map, with its colour and its conditions in words; the lowest first. Without those to which
/// nothing leads.
std::vector<HazardClass> degree_classes(const DegreeMatrix& matrix);

/// Whether the classes of a scheme are the three intensities of the matrix, or the upper two.
bool has_intensities(const HazardScheme& scheme);

}  // namespace frana
