// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/compare/ranking.h"
#include "app/pictures/map_source.h"

namespace frana::app {

/// One result or raster against one survey, and the folder of the files.
struct Pair {
    std::string operand;
    std::optional<std::string> scar;
    std::string name, folder;
};

/// Name for folders and the ranking.
std::string compared_name(const std::string& operand);

/// Beside the first of the results, whatever folder one is in.
std::string ranking_folder(const std::string& operand);

std::vector<Pair> pairs_of(const std::vector<std::string>& operands, const std::vector<std::string>& scars,
                           const std::optional<std::string>& out, Ranking& ranking);

std::vector<std::string> files_of(const Pair& pair, const MapStyle& style);

/// Checks, before anything is computed, that no input and no file of a result would be overwritten. Throws
/// Error(input).
void check_outputs(const std::vector<Pair>& pairs, const std::optional<std::string>& deposit,
                   const std::string& ranking_file);

/// The same survey may be compared again; what another one gave is not replaced unasked. Throws Error(input).
void refuse_other_survey(const std::vector<Pair>& pairs, const std::string& deposit);

/// Of a map of probability: its scores are others, so it is in no ranking. Throws Error(input).
void refuse_in_ranking(const std::vector<Pair>& pairs, const std::optional<std::string>& deposit);

}  // namespace frana::app
