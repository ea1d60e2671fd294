// SPDX-License-Identifier: Apache-2.0
#include "app/ensemble/study_result.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "app/store/saved_work.h"

namespace frana::app {
namespace {

void add_finished(const StudyInput& input, const std::string& folder, std::size_t member, std::size_t place,
                  study::FinishedMembers& to, std::vector<std::size_t>& places) {
    to.records.push_back(record_file(folder, member));
    to.weights.push_back(input.table.weights[member]);
    if (input.table.groups > 0) to.groups.push_back(member % input.table.groups);
    places.push_back(place);
}

void scale_weights(study::FinishedMembers& members) {
    const double sum = std::accumulate(members.weights.begin(), members.weights.end(), 0.0);
    for (double& weight : members.weights) weight /= sum;
}

/// Groups of Saltelli's design of which every member finished; each gets the next number.
std::map<std::size_t, std::size_t> whole_groups(const StudyInput& input, const StudyResult& result) {
    std::map<std::size_t, std::size_t> counts, numbers;
    for (const std::size_t place : result.finished_at) ++counts[result.members[place].member % input.table.groups];
    for (const auto& [group, count] : counts)
        if (count == input.table.keys.size() + 2) numbers.emplace(group, numbers.size());
    return numbers;
}

void choose_design(const StudyInput& input, const std::string& folder, StudyResult& result) {
    const study::SampleTable& table = input.table;
    result.points.nominal = table.nominal;
    if (table.groups > 0) {
        const auto groups = whole_groups(input, result);
        for (const std::size_t place : result.finished_at) {
            const std::size_t member = result.members[place].member;
            if (groups.count(member % table.groups) > 0)
                add_finished(input, folder, member, place, result.design, result.design_at);
        }
        result.groups = groups.size();
    } else {
        result.design = result.finished;
        result.design_at = result.finished_at;
    }
    for (const std::size_t place : result.design_at)
        result.points.numbers.push_back(table.numbers[result.members[place].member]);
}

}  // namespace

bool StudyResult::equal_weights() const {
    return std::all_of(finished.weights.begin(), finished.weights.end(),
                       [&](double weight) { return weight == finished.weights.front(); });
}

std::vector<double> StudyResult::figure(std::size_t index) const {
    std::vector<double> values;
    for (const std::size_t place : finished_at) values.push_back(members[place].figures[index].value);
    return values;
}

const std::vector<study::Figure>& StudyResult::figures() const {
    static const std::vector<study::Figure> k_none;
    return finished_at.empty() ? k_none : members[finished_at.front()].figures;
}

StudyResult read_study_result(const StudyInput& input, const std::string& folder, std::size_t count) {
    StudyResult result;
    for (std::size_t member = 0; member < count; ++member) {
        const std::string file = record_file(folder, member);
        auto record = study::read_record(file);
        if (!record)
            throw Error(ErrorKind::environment, Problem{"the record of a member cannot be read", file, "", "",
                                                        "--resume computes that member again"});
        result.members.push_back({member, record->failure, std::move(record->figures), record->engine_seconds});
        if (record->finished())
            add_finished(input, folder, member, result.members.size() - 1, result.finished, result.finished_at);
    }
    scale_weights(result.finished);
    choose_design(input, folder, result);
    result.grid = input.base.scene.grid;
    return result;
}

std::vector<FigureSensitivity> sensitivities(const StudyResult& result) {
    std::vector<FigureSensitivity> all;
    if (result.design_at.size() < 2 || !result.equal_weights()) return all;
    const study::RankCorrelations correlations(result.points);
    for (std::size_t f = 0; f < result.figures().size(); ++f) {
        std::vector<double> output;
        for (const std::size_t place : result.design_at) output.push_back(result.members[place].figures[f].value);
        FigureSensitivity one{result.figures()[f], {}};
        one.keys = result.groups > 0 ? study::sobol_indices(result.points, {output}, result.groups).front()
                                     : correlations.with(output);
        all.push_back(std::move(one));
    }
    return all;
}

double weighted_mean(const std::vector<double>& values, const std::vector<double>& weights) {
    return std::inner_product(values.begin(), values.end(), weights.begin(), 0.0);
}

double figure_quantile(const std::vector<double>& values, const std::vector<double>& weights, double q) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
    double sum = 0;
    for (const std::size_t i : order)
        if ((sum += weights[i]) >= q - 1e-12) return values[i];
    return values[order.back()];
}

}  // namespace frana::app
