// SPDX-License-Identifier: Apache-2.0
#include "analysis/hazard.h"

#include <algorithm>
#include <cmath>

#include "core/reached_raster.h"
#include "core/text.h"
#include "core/words/words.h"

namespace frana {
namespace {

constexpr std::array<HazardQuantityRow, 7> k_quantities{{
    {"depth", "m", worded("depth"), "m"},
    {"velocity", "m/s", worded("speed"), "m/s"},
    {"flux", "m2/s", worded("depth \u00D7 speed"), "m\u00B2/s"},
    {"head", "m", worded("energy head"), "m"},
    {"pressure", "kPa", worded("pressure"), "kPa"},
    {"deposit", "m", worded("deposit"), "m"},
    {"momentum-flux", "m3/s2", worded("momentum flux"), "m\u00B3/s\u00B2"},
}};

const HazardQuantityRow& row_of(HazardQuantity quantity) {
    return k_quantities.at(static_cast<std::size_t>(quantity));
}

std::string text_of(const HazardLimit& one, bool holds) {
    const HazardQuantityRow& row = row_of(one.quantity);
    const char* const sign = holds ? (one.reached ? " \u2265 " : " > ") : (one.reached ? " < " : " \u2264 ");
    return row.words + (sign + shortest_text(one.limit)) + " " + row.sign;
}

bool is_depth(const HazardLimit& one) {
    return one.quantity == HazardQuantity::depth || one.quantity == HazardQuantity::head ||
           one.quantity == HazardQuantity::deposit;
}

bool names_depth(const std::vector<HazardLimit>& all) {
    return std::any_of(all.begin(), all.end(), is_depth);
}

/// Returns the number of the highest class whose condition holds; none: not even that of the lowest.
/// @param with_depths whether depths make classes here
template <class ValueOf>
std::optional<std::size_t> class_at(const HazardScheme& scheme, bool with_depths, const ValueOf& value_of) {
    for (std::size_t i = scheme.classes.size(); i-- > 0;) {
        const HazardCondition& condition = scheme.classes[i].condition;
        if (condition.empty() ? with_depths : std::any_of(condition.begin(), condition.end(), [&](const auto& all) {
                return (with_depths || !names_depth(all)) &&
                       std::all_of(all.begin(), all.end(),
                                   [&](const HazardLimit& one) { return one.holds(value_of(one.quantity)); });
            }))
            return i;
    }
    return std::nullopt;
}

}  // namespace

const std::string k_source_not_read = worded("customary limits, source not read");

std::span<const HazardQuantityRow> hazard_quantities() {
    return k_quantities;
}

bool follows(const HazardCondition& condition, const HazardCondition& from) {
    return condition.empty() || (!from.empty() && std::all_of(from.begin(), from.end(), [&](const auto& given) {
               return std::any_of(condition.begin(), condition.end(), [&](const auto& all) {
                   return std::all_of(all.begin(), all.end(), [&](const HazardLimit& one) {
                       return std::any_of(given.begin(), given.end(),
                                          [&](const HazardLimit& known) { return one.follows_from(known); });
                   });
               });
           }));
}

std::string text_of(const HazardCondition& condition, bool holds) {
    const bool is_mixed = condition.size() > 1 && std::any_of(condition.begin(), condition.end(),
                                                              [](const auto& all) { return all.size() > 1; });
    if (!holds && is_mixed) return worded("all else");  // would need brackets
    std::string text;
    for (const auto& all : condition) {
        if (!text.empty()) text += holds ? " or " : " and ";
        std::string part;
        for (const HazardLimit& one : all) part += (part.empty() ? "" : holds ? " and " : " or ") + text_of(one, holds);
        text += part;
    }
    return text;
}

void write_thresholds(HazardScheme& scheme) {
    auto& classes = scheme.classes;
    for (std::size_t i = 0; i < classes.size(); ++i) {
        const HazardCondition& own = classes[i].condition;
        classes[i].thresholds =
            own.empty() && i + 1 < classes.size() ? text_of(classes[i + 1].condition, false) : text_of(own);
    }
}

bool HazardScheme::has_depths() const {
    return uses(HazardQuantity::depth) || uses(HazardQuantity::head) || uses(HazardQuantity::deposit);
}

std::vector<std::string> HazardScheme::minimum_labels() const {
    if (!has_depths()) return {};
    return {worded("Classes by depth") + (": " + text_of(HazardLimit{HazardQuantity::depth, minimum_depth}, true))};
}

const ProcessMatrix* HazardScheme::matrix_of(const std::optional<std::string>& process) const {
    if (!process && matrices.size() == 1) return &matrices.front();
    const auto found = std::find_if(matrices.begin(), matrices.end(),
                                    [&](const ProcessMatrix& one) { return process && one.process == *process; });
    return found == matrices.end() ? nullptr : &*found;
}

bool HazardScheme::uses(HazardQuantity quantity) const {
    for (const HazardClass& kind : classes)
        for (const auto& all : kind.condition)
            for (const HazardLimit& one : all)
                if (one.quantity == quantity) return true;
    return false;
}

Raster hazard_classes(const HazardScheme& scheme, const HazardQuantities& quantities) {
    const std::array<const Raster*, 7> rasters{&quantities.depth,   &quantities.velocity, &quantities.flux,
                                               &quantities.head,    &quantities.pressure, &quantities.deposit,
                                               &quantities.momentum};
    Raster classes = reached_raster(quantities.depth.grid, k_no_data);
    const bool has_depths = scheme.has_depths();
    quantities.depth.values.for_each_stored([&](std::size_t cell, double depth) {
        if (std::isnan(depth)) return;
        const auto kind = class_at(scheme, !has_depths || depth > scheme.minimum_depth, [&](HazardQuantity quantity) {
            return rasters.at(static_cast<std::size_t>(quantity))->values[cell];
        });
        if (kind) classes.values[cell] = scheme.classes[*kind].value;
    });
    return classes;
}

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
    return !scheme.matrices.empty() && !scheme.classes.empty() && scheme.classes.back().value == k_intensities;
}

}  // namespace frana
