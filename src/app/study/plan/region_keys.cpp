// SPDX-License-Identifier: Apache-2.0
#include "app/study/plan/read_study.h"

#include "app/study/plan/entry_reader.h"
#include "app/study/plan/sampling.h"
#include "core/text.h"
#include "params/grammar/value_text.h"
#include "params/keys/declare.h"
#include "params/keys/parameter.h"

namespace frana::app::study {
namespace {

using RegionKey = ParameterOf<StudySpec>;

constexpr std::int64_t k_widest_window = 1'000'000;

RegionSpec& region_of(StudySpec& study) {
    if (!study.region) study.region.emplace();
    return *study.region;
}
const RegionSpec& region_of(const StudySpec& study) {
    static const RegionSpec k_none;
    return study.region ? *study.region : k_none;
}
/// A member of the study's region.
template <class Member>
auto of_region(Member member) {
    return [member](auto& study) -> auto& {
        return member(region_of(study));
    };
}

template <class Member>
RegionKey column_key(const char* name, Member member, const char* meaning) {
    auto key = declare::text<StudySpec>(name, of_region(member), "text", meaning);
    key.limits = "a column of release.perimeter";
    return key;
}

RegionKey window_key() {
    auto key = declare::number<StudySpec>(
        "region.window", of_region(FRANA_MEMBER(window)), "m", NumberRange{1, static_cast<double>(k_widest_window)},
        "Terrain of a slope: that under its energy line (auto), or so many metres round its polygon.");
    key.limits = "auto, or metres from 1 to " + std::to_string(k_widest_window);
    key.read = [of_number = key.read](StudySpec& study, const std::string& text) {
        if (text != "auto") return of_number(study, text);
        study.region->window.reset();
        return std::optional<ValueProblem>();
    };
    key.write = [of_number = key.write](const StudySpec& study) { return of_number(study).value_or("auto"); };
    return key;
}

}  // namespace

const std::vector<RegionKey>& region_keys() {
    static const std::vector<RegionKey> k_keys{
        study_key("scene", "region", "The scene of every slope."),
        study_key("scheme", "region"),
        study_key("keep", "region"),
        column_key("region.name", FRANA_MEMBER(name), "What each slope is called."),
        column_key("region.group", FRANA_MEMBER(group), "What each slope belongs to: a catchment, a commune."),
        column_key("region.scenario", FRANA_MEMBER(scenario),
                   "Which of several events each polygon is; each has maps of its own."),
        column_key("region.return-period", FRANA_MEMBER(return_period),
                   "Return period in years, for the degree of hazard."),
        window_key()};
    return k_keys;
}

std::string region_text(const StudySpec& study) {
    std::string text = "# A region as used; `frana batch` on this file repeats it.\n\n[region]\n" +
                       keys_text(region_keys(), study, "region") + settings_text("set", study.set);
    if (!study.region->columns.empty()) text += "\n[columns]\n";
    for (const RegionSpec::Column& one : study.region->columns) text += one.key + " = " + one.column + "\n";
    return text;
}

}  // namespace frana::app::study
