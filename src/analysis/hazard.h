// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/colour.h"
#include "core/raster.h"
#include "core/words/words.h"

namespace frana {

/// Quantities that hazard schemes use; share/doc/hazard.md defines which maxima are taken at one moment.
struct HazardQuantities {
    const Raster& depth;     ///< greatest depth [m]; NaN: never reached, no class
    const Raster& velocity;  ///< greatest speed [m/s]
    const Raster& flux;      ///< greatest product of depth and speed at one moment [m2/s]
    const Raster& head;      ///< greatest sum of depth and v^2 / 2g at one moment [m]
    const Raster& pressure;  ///< greatest dynamic pressure [kPa]
    const Raster& deposit;   ///< depth at the end [m]
    const Raster& momentum;  ///< greatest product of depth and squared speed at one moment [m3/s2]
};

/// One of them, by its place.
enum class HazardQuantity { depth, velocity, flux, head, pressure, deposit, momentum };
struct HazardQuantityRow {
    const char *key, *unit;    ///< as conditions name it: "flux", "m2/s"
    const char *words, *sign;  ///< as people read it: "depth \u00D7 speed", "m\u00B2/s"
};
/// Returns all, in that order.
std::span<const HazardQuantityRow> hazard_quantities();

/// "depth > 1 m" or "head >= 1.5 m".
struct HazardLimit {
    HazardQuantity quantity = HazardQuantity::depth;
    double limit = 0;
    bool reached = false;  ///< whether the limit itself is enough: >=

    [[nodiscard]] bool holds(double value) const { return value > limit || (reached && value == limit); }
    /// Whether this holds wherever the other one does.
    [[nodiscard]] bool follows_from(const HazardLimit& other) const {
        return quantity == other.quantity && (holds(other.limit) || (limit == other.limit && !other.reached));
    }
};
/// Alternatives, each of which needs all of its limits. Empty: holds everywhere.
using HazardCondition = std::vector<std::vector<HazardLimit>>;

/// Whether a condition holds wherever the other one does, by their limits.
bool follows(const HazardCondition& condition, const HazardCondition& from);
/// Returns "depth > 1 m and speed > 1 m/s", as class_label() puts into a language; `holds` = false: where it does not
/// hold, "depth \u2264 1 m or speed \u2264 1 m/s".
std::string text_of(const HazardCondition& condition, bool holds = true);

struct HazardClass {
    int value = 0;             ///< 1: the lowest
    std::string name{};        ///< "High intensity"
    std::string thresholds{};  ///< "depth > 1 m and speed > 1 m/s"
    Rgb colour{};
    bool hatched = false;         ///< in areas, with white between
    HazardCondition condition{};  ///< of a scheme; that of the lowest class may be empty

    /// "High intensity: depth > 1 m and speed > 1 m/s"
    [[nodiscard]] std::string label() const { return name + ": " + thresholds; }
};

inline constexpr const char* k_intensity_title = "Intensity";  // worded
/// The source of a scheme of which nobody read one.
extern const std::string k_source_not_read;

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
/// whatever their intensity. The default is the matrix of nine fields for all processes as the canton of Bern publishes
/// it; where it divides a field between two colours, by the process, the worse one.
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

/// The matrix of a process, or of all together, which colours more.
struct ProcessMatrix {
    std::string process{};  ///< a word of k_processes; empty: the scheme has one process
    std::string source{};   ///< of the matrix, for maps
    DegreeMatrix degrees{};
};
inline constexpr const char* k_processes[] = {"all", "flood", "channel-debris-flow", "hillslope-debris-flow"};

/// What the intensities of a scenario are, or its zones. Those of share/schemes and users' own are files
/// (src/params/scene/read_scheme.h).
struct HazardScheme {
    std::string name{};                       ///< "swiss-debris-flow", of a file its name without .ini
    std::string called{};                     ///< as readers of a map know it: "Switzerland, debris flows"
    std::string heading = k_intensity_title;  ///< what its classes are
    std::string source{};                     ///< of the thresholds, for maps and reports
    std::string named_source{};               ///< also where it was not read
    std::string quote{}, read_at{};           ///< words of it and where they were read; empty: not read
    std::vector<double> periods{};            ///< return periods of the scenarios it is meant for [years]
    std::vector<HazardClass> classes{};       ///< from the lowest; each condition holds where that of the next does
    std::vector<ProcessMatrix> matrices{};    ///< of the degree of hazard; none: the scheme has no three intensities
    OwnTexts texts{};                         ///< its names in other languages
    double minimum_depth = 0;                 ///< up to which depth makes no class [m]
    /// Of a zone that people draw: smaller ones, and narrower parts, become part of their neighbours. 200 m2 is what
    /// the plugin of Ticino for hazard plans begins with (opengisch/pzp, simplify_intensity.py, read); of a width no
    /// source was.
    double least_area = 200;  ///< [m2]
    double least_width = 5;   ///< [m]

    /// Whether depths make any of its classes: a depth, an energy head or a deposit.
    [[nodiscard]] bool has_depths() const;
    /// "Classes by depth: depth > 0.1 m"; of a scheme without depths none.
    [[nodiscard]] std::vector<std::string> minimum_labels() const;
    [[nodiscard]] bool uses(HazardQuantity quantity) const;
    /// Whether words of the source were read.
    [[nodiscard]] bool is_source_read() const { return source != k_source_not_read; }
    /// Returns the matrix of a process, of the only one if none is named; null: there is none, or the process must be.
    [[nodiscard]] const ProcessMatrix* matrix_of(const std::optional<std::string>& process) const;
    [[nodiscard]] bool has_zones() const { return heading != k_intensity_title; }
};

/// Sets what people read of the classes' conditions.
void write_thresholds(HazardScheme& scheme);

/// Returns the class of every cell that the flow reached, NaN elsewhere and where the lowest class has a condition that
/// does not hold. Up to the scheme's minimum depth only limits without a depth (pressure, speed, flux) make one.
Raster hazard_classes(const HazardScheme& scheme, const HazardQuantities& quantities);

/// Returns "weak", "medium", "strong".
std::string intensity_name(int intensity);

/// A degree as a class of a map, with its colour and its conditions in words; the lowest first. Without those to which
/// nothing leads.
std::vector<HazardClass> degree_classes(const DegreeMatrix& matrix);

/// Whether the classes of a scheme are the three intensities of the matrix, or the upper two.
bool has_intensities(const HazardScheme& scheme);

}  // namespace frana
