// SPDX-License-Identifier: Apache-2.0
#include "analysis/hazard_degree.h"

#include <algorithm>

#include "core/shortest_text.h"
#include "core/words/words.h"

namespace frana {
namespace {

struct NamedDegree {
    HazardDegree degree;
    const char *name, *words;
    Rgb colour;
};
/// Colours as on Swiss hazard maps.
constexpr NamedDegree k_degrees[] = {
    {HazardDegree::residual, "yellow-white", worded("Yellow-white, residual hazard"), {255, 250, 190}},
    {HazardDegree::yellow, "yellow", worded("Yellow, low hazard"), {255, 225, 60}},
    {HazardDegree::blue, "blue", worded("Blue, medium hazard"), {60, 120, 215}},
    {HazardDegree::red, "red", worded("Red, high hazard"), {215, 30, 30}}};

// As the thresholds of intensities are written, so that they can be put into a language.
const std::string k_years = " a", k_up_to = " \u2264 ", k_range = " \u2013 ", k_over = " > ";

}  // namespace

std::string name_of(HazardDegree degree) {
    return k_degrees[static_cast<int>(degree) - 1].name;
}

std::optional<HazardDegree> degree_from(const std::string& name) {
    for (const NamedDegree& one : k_degrees)
        if (name == one.name) return one.degree;
    return std::nullopt;
}

std::string intensity_name(int intensity) {
    return intensity == 1 ? worded("weak") : intensity == 2 ? worded("medium") : worded("strong");
}

HazardDegree DegreeMatrix::of(int intensity, double return_period) const {
    for (std::size_t p = 0; p < k_probabilities; ++p)
        if (return_period <= periods[p]) return degrees[static_cast<std::size_t>(intensity - 1)][p];
    return HazardDegree::residual;
}

std::string DegreeMatrix::conditions_of(HazardDegree degree) const {
    std::string text;
    const auto add = [&](const std::string& words) { text += (text.empty() ? "" : "; ") + words; };
    for (int intensity = k_intensities; intensity >= 1; --intensity) {
        const auto& row = degrees[static_cast<std::size_t>(intensity - 1)];
        for (std::size_t first = 0; first < k_probabilities; ++first) {
            if (row[first] != degree) continue;
            std::size_t last = first;
            while (last + 1 < k_probabilities && row[last + 1] == degree) ++last;
            add(intensity_name(intensity) + (first == 0 ? k_up_to : " " + shortest_text(periods[first - 1]) + k_range) +
                shortest_text(periods[last]) + k_years);
            first = last;
        }
    }
    if (degree == HazardDegree::residual) add(worded("any") + (k_over + shortest_text(periods.back()) + k_years));
    return text;
}

std::vector<HazardClass> degree_classes(const DegreeMatrix& matrix) {
    std::vector<HazardClass> classes;
    for (const NamedDegree& one : k_degrees) {
        const std::string conditions = matrix.conditions_of(one.degree);
        if (conditions.empty()) continue;
        classes.push_back(
            {static_cast<int>(one.degree), one.words, conditions, one.colour, one.degree == HazardDegree::residual});
    }
    return classes;
}

bool has_intensities(const HazardScheme& scheme) {
    const auto& classes = scheme.classes;
    return scheme.name != "austrian-torrent" && !classes.empty() && classes.back().value == k_intensities &&
           std::all_of(classes.begin(), classes.end(), [](const HazardClass& one) { return one.value >= 1; });
}

}  // namespace frana
