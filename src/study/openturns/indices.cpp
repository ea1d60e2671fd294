// SPDX-License-Identifier: Apache-2.0
#include "study/openturns/indices.h"

#include <openturns/MartinezSensitivityAlgorithm.hxx>
#include <openturns/TBB.hxx>

namespace frana::study {
namespace {

OT::Sample sample_of(const std::vector<std::vector<double>>& rows) {
    OT::Sample sample(rows.size(), rows.front().size());
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (std::size_t k = 0; k < rows[i].size(); ++k) sample(i, k) = rows[i][k];
    return sample;
}

}  // namespace

std::vector<KeySensitivity> indices(const DesignPoints& points, const std::vector<double>& output, std::size_t groups,
                                    bool with_intervals) {
    OT::TBB::SetThreadsNumber(1);
    const std::size_t keys = points.nominal.size(), rows = output.size();
    OT::Sample values(rows, 1);
    for (std::size_t i = 0; i < rows; ++i) values(i, 0) = output[i];
    // One output at a time: with several, every question for one of them computes all.
    OT::MartinezSensitivityAlgorithm algorithm(sample_of(points.numbers), values, groups);
    algorithm.setUseAsymptoticDistribution(true);
    const OT::Point first = algorithm.getFirstOrderIndices(), total = algorithm.getTotalOrderIndices();
    std::vector<KeySensitivity> all(keys);
    for (std::size_t k = 0; k < keys; ++k)
        all[k] = {Interval{first[k], first[k], first[k]}, Interval{total[k], total[k], total[k]}, {}, "Martinez"};
    if (!with_intervals) return all;
    const OT::Interval of_first = algorithm.getFirstOrderIndicesInterval(),
                       of_total = algorithm.getTotalOrderIndicesInterval();
    for (std::size_t k = 0; k < keys; ++k) {
        all[k].first_order = Interval{first[k], of_first.getLowerBound()[k], of_first.getUpperBound()[k]};
        all[k].total = Interval{total[k], of_total.getLowerBound()[k], of_total.getUpperBound()[k]};
    }
    return all;
}

}  // namespace frana::study
