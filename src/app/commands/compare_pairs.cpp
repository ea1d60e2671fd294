// SPDX-License-Identifier: Apache-2.0
#include "app/commands/compare_pairs.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/compare/comparison.h"
#include "app/compare/probability_comparison.h"
#include "app/pictures/result_reader.h"
#include "app/store/json_file.h"
#include "app/store/kept_files.h"
#include "app/store/own_files.h"
#include "app/store/result_files.h"
#include "core/error.h"
#include "params/keys/picture_parameters.h"

namespace frana::app {
namespace {

namespace fs = std::filesystem;

bool names_same_file(const std::string& recorded, const std::string& given) {
    std::error_code error;
    return recorded == given || fs::weakly_canonical(recorded, error) == fs::weakly_canonical(given, error);
}

}  // namespace

std::string compared_name(const std::string& operand) {
    if (!fs::is_directory(operand)) return fs::path(operand).stem().string();
    const fs::path folder = fs::absolute(ResultReader(operand).directory()).lexically_normal();
    return (folder.has_filename() ? folder : folder.parent_path()).filename().string();
}

std::string ranking_folder(const std::string& operand) {
    const fs::path first = fs::is_directory(operand) ? fs::path(ResultReader(operand).directory()) : fs::path(operand);
    const fs::path folder = fs::absolute(first).lexically_normal();
    const fs::path beside = (folder.has_filename() ? folder : folder.parent_path()).parent_path();
    const fs::path near = beside.lexically_relative(fs::current_path());
    return near.empty() || *near.begin() == ".." ? beside.string() : near.string();
}

std::vector<Pair> pairs_of(const std::vector<std::string>& operands, const std::vector<std::string>& scars,
                           const std::optional<std::string>& out, Ranking& ranking) {
    std::vector<std::optional<std::string>> surveyed(scars.begin(), scars.end());
    if (surveyed.empty()) surveyed.emplace_back();
    if (operands.size() == 1 && surveyed.size() == 1) {
        const std::string& only = operands.front();
        const std::string usual = fs::is_directory(only) ? ResultReader(only).directory() : ".";
        return {{only, surveyed.front(), "", out.value_or(usual)}};
    }
    std::vector<Pair> pairs;
    const std::string folder = out.value_or(ranking_folder(operands.front()));
    for (const std::string& operand : operands) {
        for (const auto& scar : surveyed) {
            const std::string name =
                ranking.folder_for(compared_name(operand), scar ? fs::path(*scar).stem().string() : "deposit");
            pairs.push_back({operand, scar, name, (fs::path(folder) / name).lexically_normal().string()});
        }
    }
    return pairs;
}

std::vector<std::string> files_of(const Pair& pair, const MapStyle& style) {
    std::vector<std::string> files = comparison_files(pair.folder);
    for (const std::string& picture : comparison_pictures(style, pair.folder)) files.push_back(picture);
    return files;
}

void check_outputs(const std::vector<Pair>& pairs, const std::optional<std::string>& deposit,
                   const std::string& ranking_file) {
    KeptFiles kept;
    MapStyle any;
    any.formats = picture_formats();
    for (const Pair& pair : pairs) {
        if (fs::is_directory(pair.operand)) {
            const std::string result = ResultReader(pair.operand).directory();
            kept.add_result(result, comparison_files(result));
        }
    }
    for (const Pair& pair : pairs) {  // whatever their names
        if (!fs::is_directory(pair.operand)) kept.add(pair.operand);
        kept.add(pair.scar.value_or(""));
    }
    kept.add(deposit.value_or(""));
    Problems problems;
    for (const Pair& pair : pairs) {
        const std::vector<std::string> files = files_of(pair, any);
        kept.check(files, "--out", problems);
        problems.throw_if_any();  // one problem per file
        check_own(pair.folder, files, "--out", {pair.operand}, problems);
    }
    if (pairs.size() > 1) {
        kept.check({ranking_file}, "--out", problems);
        std::vector<std::string> reads;
        for (const Pair& pair : pairs) reads.push_back(pair.operand);
        check_own(fs::path(ranking_file).parent_path().string(), {ranking_file}, "--out", reads, problems);
    }
    problems.throw_if_any();
}

void refuse_other_survey(const std::vector<Pair>& pairs, const std::string& deposit) {
    Problems problems;
    for (const Pair& pair : pairs) {
        const std::optional<Json> older = read_json_file((fs::path(pair.folder) / k_comparison_file).string());
        if (!older) continue;
        const std::string observed = value_in<std::string>(*older, "/observed").value_or(""),
                          of_deposit = value_in<std::string>(*older, "/deposit/observed").value_or("");
        if (names_same_file(observed, pair.scar.value_or("")) && names_same_file(of_deposit, deposit)) continue;
        problems.add({"contains the comparison with another survey", "--out", pair.folder,
                      observed.empty() ? of_deposit : observed,
                      "Choose another folder with --out, or add --overwrite"});
    }
    problems.throw_if_any();
}

void refuse_in_ranking(const std::vector<Pair>& pairs, const std::optional<std::string>& deposit) {
    for (const Pair& pair : pairs) {
        if (!is_probability(pair.operand)) continue;
        if (pairs.size() > 1)
            throw Error(ErrorKind::input,
                        Problem{"is a map of probability, which cannot be ranked", "RESULT_DIR|RASTER", pair.operand,
                                "", "Compare it alone, with one --observed"});
        if (deposit)
            throw Error(ErrorKind::input, Problem{"cannot be compared with a map of probability", "--deposit", *deposit,
                                                  "", "Name the surveyed outline: --observed VECTOR"});
    }
}

}  // namespace frana::app
