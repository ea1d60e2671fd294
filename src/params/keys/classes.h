// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace frana {

/// Classes of one quantity on maps, in films and in GIS styles: from 0 to the first bound, between neighbouring bounds,
/// and above the last.
struct QuantityClasses {
    std::string name;   ///< "max-depth": key output.classes-max-depth
    std::string words;  ///< "depths", in the key's sentence
    std::string unit;   ///< rasters of this unit have the classes of its first row, unless theirs names another
    std::vector<double> bounds;  ///< greater than 0, rising
};

/// The one list of fixed classes; ResultRaster::classes names its rows. Published thresholds, between and beyond them
/// steps of 1, 2, 5:
/// - depth: 0.5 and 2 m are the Swiss limits of flood intensity, 1 m that of debris flows (BWW, BRP, BUWAL 1997);
/// - velocity: 1 m/s is the Swiss limit of debris flows (the same), above 5 m/s a landslide is extremely rapid (Cruden
///   and Varnes 1996, Landslide types and processes, TRB special report 247);
/// - pressure: 3 and 30 kPa are the Swiss limits of avalanche zones (BFF and SLF 1984, Richtlinien zur
/// Beruecksichtigung
///   der Lawinengefahr), 1 and 10 kPa the Austrian ones (Richtlinie fuer die Gefahrenzonenplanung);
/// - flux: 0.5 and 2 m2/s are the Swiss limits of flood intensity;
/// - energy head: 1.5 m is the Austrian limit of the red zone of torrents;
/// - arrival: whole minutes after the first one, as warning times are given; no published steps are known.
const std::vector<QuantityClasses>& quantity_classes();

/// The most bounds that a key accepts: more colours cannot be distinguished in a legend.
inline constexpr std::size_t k_most_class_bounds = 12;

/// output.classes and output.classes-...
struct ClassSpec {
    bool fixed = true;                        ///< false: up to the greatest value of each raster
    std::vector<std::vector<double>> bounds;  ///< in the order of quantity_classes()

    ClassSpec();
};

/// Returns {0, 0.5, ..., infinity}; empty for a name that is not in the list.
std::vector<double> fixed_classes(const ClassSpec& chosen, const std::string& quantity);

}  // namespace frana
