// SPDX-License-Identifier: Apache-2.0
#include "app/pictures/result_numbers.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "app/store/result_files.h"
#include "app/text/number_text.h"
#include "core/error.h"
#include "core/text.h"
#include "params/grammar/value_text.h"
#include "params/keys/scene_spec.h"
#include "simulation/run_summary.h"
#include "simulation/simulation.h"

namespace frana::app {
namespace {

constexpr double k_many = 0.05;  // fraction of the runs from which a study's first line tells

Sentence count(std::size_t number) {
    return numeral(std::to_string(number));
}

Sentence percent(double fraction) {
    return numeral(number_text(100 * fraction, 2));
}

constexpr std::size_t k_shown = 80;  // characters shown of an invalid line

class Row {
  public:
    Row(const std::vector<std::string>& names, const std::string& line, const std::string& path)
        : names_(names), path_(path), words_(words_of(trimmed(line))) {
        for (const std::string& word : words_) {
            if (words_.size() == names_.size() && number_from_text(word)) continue;
            throw Error(ErrorKind::input,
                        Problem{"a row is not a list of numbers, one for each column", path_,
                                elided(valid_utf8(line), k_shown), joined(names_, ","), "The file is damaged"});
        }
    }
    [[nodiscard]] std::optional<double> find(const std::string& name) const {
        const auto found = std::find(names_.begin(), names_.end(), name);
        if (found == names_.end()) return std::nullopt;
        return number_from_text(words_.at(static_cast<std::size_t>(found - names_.begin())));
    }
    [[nodiscard]] double value(const std::string& name) const {
        if (const auto number = find(name)) return *number;
        throw Error(ErrorKind::input,
                    Problem{"has no column " + name, path_, elided(valid_utf8(joined(names_, ",")), k_shown), "",
                            "The file is damaged or not from a run"});
    }

  private:
    const std::vector<std::string>& names_;
    const std::string& path_;
    std::vector<std::string> words_;
};

}  // namespace

bool Troubles::are_first() const noexcept {
    if (each_counts) return unfinished() > 0;
    return static_cast<double>(unfinished()) > k_many * static_cast<double>(runs);
}

Sentence headline(const Troubles& t) {
    std::vector<Sentence> parts;
    if (t.cut > 0)
        parts.push_back(worded("{1} of {2} runs cut while moving (≤ {3} % of volume)",
                               {count(t.cut), count(t.runs), percent(t.most_moving)}));
    if (t.left > 0)
        parts.push_back(worded("{1} of {2} runs left the domain (≤ {3} % of volume)",
                               {count(t.left), count(t.runs), percent(t.most_left)}));
    if (t.held > 0) parts.push_back(worded("{1} of {2} runs stopped by no-data", {count(t.held), count(t.runs)}));
    if (t.failed > 0) parts.push_back(worded("{1} of {2} runs failed", {count(t.failed), count(t.runs)}));
    return worded("Extent, run-out and probabilities are lower bounds: {1}", {listed(parts)});
}

Json json_of(const Troubles& t) {
    return {{"all", t.runs},
            {"cut", t.cut},
            {"left_ground", t.left},
            {"held_by_no_data", t.held},
            {"failed", t.failed},
            {"warned", t.warned},
            {"flew", t.flew},
            {"lower_bounds", t.open},
            {"each_counts", t.each_counts},
            {"greatest_moving_fraction", t.most_moving},
            {"greatest_left_domain_fraction", t.most_left}};
}

std::optional<Troubles> troubles_in(const Json& summary) {
    const auto whole = [&](const char* key) {
        return static_cast<std::size_t>(
            value_in<std::int64_t>(summary, std::string("/run_troubles/") + key).value_or(0));
    };
    if (!value_in<std::int64_t>(summary, "/run_troubles/all")) return std::nullopt;
    Troubles t;
    t.runs = whole("all");
    t.cut = whole("cut");
    t.left = whole("left_ground");
    t.failed = whole("failed");
    t.warned = whole("warned");
    t.open = whole("lower_bounds");
    t.held = whole("held_by_no_data");
    t.flew = whole("flew");
    t.most_moving = value_in<double>(summary, "/run_troubles/greatest_moving_fraction").value_or(0);
    t.most_left = value_in<double>(summary, "/run_troubles/greatest_left_domain_fraction").value_or(0);
    t.each_counts = value_in<bool>(summary, "/run_troubles/each_counts").value_or(false);
    return t;
}

namespace {

struct SentenceWriter {
    Json json{};

    void operator()(std::uint8_t kind, const std::string& text, std::vector<Sentence>& values) {
        if (kind == 0) {
            json = text;
        } else if (kind == 1) {
            json = {{"number", text}};
        } else {
            json = Json::array({text});
            for (const Sentence& value : values) json.push_back(json_of(value));
        }
    }
};

struct SentenceReader {
    const Json& json;

    void operator()(std::uint8_t& kind, std::string& text, std::vector<Sentence>& values) const {
        const Json& first = json.is_array() && !json.empty() ? json.front() : json;
        kind = json.is_array() ? 2 : json.is_object() ? 1 : 0;
        text = first.is_string() ? first.get<std::string>() : value_in<std::string>(first, "/number").value_or("");
        for (std::size_t i = 1; json.is_array() && i < json.size(); ++i) values.push_back(sentence_in(json[i]));
    }
};

}  // namespace

Json json_of(Sentence sentence) {
    SentenceWriter writer;
    sentence.serialise(writer);
    return std::move(writer.json);
}

Sentence sentence_in(const Json& json) {
    Sentence sentence;
    SentenceReader reader{json};
    sentence.serialise(reader);
    return sentence;
}

Json json_of(const Warnings& warnings) {
    Json all = Json::array();
    for (const Warning& warning : warnings) {
        Json& one = all.emplace_back(Json{{"words", json_of(warning.words)}, {"limits_use", warning.limits_use}});
        if (warning.place) one["place"] = {warning.place->x, warning.place->y};
    }
    return all;
}

Warnings warnings_in(const Json& summary) {
    Warnings warnings;
    const auto list = summary.find("warning_values");
    for (const Json& one : list != summary.end() && list->is_array() ? *list : Json::array()) {
        Warning& warning = warnings.emplace_back();
        warning.words = sentence_in(one.is_object() ? one.value("words", Json()) : Json());
        warning.limits_use = value_in<bool>(one, "/limits_use").value_or(false);
        const auto east = value_in<double>(one, "/place/0"), north = value_in<double>(one, "/place/1");
        if (east && north) warning.place = Point{*east, *north};
    }
    return warnings;
}

std::string warning_line(const Warnings& warnings, const Words& words, std::size_t longest) {
    constexpr std::size_t k_least = 100;  // letters of a sentence that still says something
    if (warnings.empty()) return "";
    if (longest < k_least) return words("Warning:") + " " + k_summary_file;
    std::string text = valid_utf8(warnings.front().words.in(words));
    if (const std::string begin = elided(text, longest); begin != text)  // at a space
        text = begin.substr(0, begin.rfind(' ')) + " \u2026";
    std::size_t told = 1;
    for (; told < warnings.size(); ++told) {
        const std::string next = "; " + valid_utf8(warnings[told].words.in(words));
        if (text.size() + next.size() > longest) break;
        text += next;
    }
    const std::string rest =
        told == warnings.size() ? "" : " " + std::to_string(told) + "/" + std::to_string(warnings.size()) + ":";
    return words("Warning:") + rest + " " + text;
}

RunEnd run_end(const RunResult& result) {
    const double fastest = result.series.empty() ? 0 : result.series.back().max_speed;
    return run_end(describe(result.stop_reason), result.simulated_seconds, fastest, result.moving_fraction_limit,
                   result.settling && result.settling->front_is_final, result.settling ? result.settling->deposit : 0);
}

RunEnd run_end(const std::string& reason, double seconds, double fastest, double moving_fraction, bool front_is_final,
               double deposit_change) {
    StopReason known = StopReason::still;
    for (int i = 0; i <= static_cast<int>(StopReason::volume_drift); ++i)
        if (const auto one = static_cast<StopReason>(i); reason == describe(one)) known = one;
    const MotionAtEnd motion = motion_at_end(known, fastest, moving_fraction, front_is_final, deposit_change);
    return {reason, seconds, fastest, moving_fraction, motion.front, motion.deposit};
}

Sentence creeping_sentence(const RunEnd& end) {
    return worded("run-out and area final; {1} % still moves, at {2} m/s",
                  {numeral(number_text(100 * end.moving_fraction, 2)), numeral(number_text(end.fastest, 2))});
}

std::string end_sentence(const RunEnd& end, const Words& words) {
    return "t = " + words.number(number_text(end.seconds, 3)) + " s: " + words(end.reason) + ", " +
           words.labelled(words("speed"), words.number(number_text(end.fastest, 2)) + " m/s");
}

SeriesEnds read_series_ends(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::string header, first, last, line;
    std::getline(file, header);
    bool whole = true;
    while (std::getline(file, line)) {
        whole = !file.eof();  // a last line without its end is incomplete
        if (first.empty()) first = line;
        last = line;
    }
    if (!whole || first.empty())
        throw Error(ErrorKind::input, Problem{whole ? "has no rows" : "is cut off in the middle of a row", path, "", "",
                                              "The file is damaged"});
    const std::vector<std::string> names = words_of(trimmed(header));
    const Row begin(names, first, path), end(names, last, path);
    SeriesEnds ends;
    ends.simulated_seconds = end.value("time_s");
    ends.volume_left = end.value("volume_left_m3");
    ends.last_speed = end.value("max_speed_ms");
    const auto entered = end.find("volume_entered_m3");  // older results have none
    ends.volume = entered ? *entered : begin.value("volume_m3") + begin.value("volume_left_m3");
    return ends;
}

std::optional<MainStatistics> read_main_statistics(const std::string& result_folder) {
    const std::string path = (std::filesystem::path(result_folder) / k_summary_file).string();
    if (!std::filesystem::exists(path)) return std::nullopt;
    const std::optional<Json> summary = read_json_file(path);
    if (!summary)
        throw Error(ErrorKind::input, Problem{"is incomplete", path, "", "", "Restore it, or compute the scene again"});
    MainStatistics statistics;
    const auto read = [&](const std::string& name, double& value) {
        const std::optional<double> number = value_in<double>(*summary, name);
        value = number.value_or(0);
        return number.has_value();
    };
    const auto read_runout = [&](const std::string& place) {
        Runout& one = statistics.run_outs.emplace_back();
        return read(place + "/horizontal_m", one.horizontal_m) && read(place + "/drop_m", one.drop_m) &&
               read(place + "/reach_angle_deg", one.reach_angle_deg);
    };
    if (!read("/trace_threshold_m", statistics.threshold) || !read("/covered_area_m2", statistics.covered_area_m2) ||
        !read_runout("/runout"))
        return std::nullopt;
    // The first of the flows is the one in "runout". Results of older programs do not list them.
    for (std::size_t i = 0; summary->contains(Json::json_pointer("/flows/" + std::to_string(i))); ++i) {
        const std::string flow = "/flows/" + std::to_string(i);
        if (i > 0 && !read_runout(flow)) return std::nullopt;
        Runout& one = statistics.run_outs.back();
        read(flow + "/covered_area_m2", one.covered_area_m2);
        for (const auto& [name, point] : {std::pair{"/top", &one.top}, std::pair{"/tip", &one.tip}}) {
            read(flow + name + "_x", point->x);
            read(flow + name + "_y", point->y);
        }
    }
    const auto reason = value_in<std::string>(*summary, "/stop_reason_text");
    const std::string series = (std::filesystem::path(result_folder) / k_series_file).string();
    if (reason && std::filesystem::exists(series)) {
        const SeriesEnds ends = read_series_ends(series);
        statistics.end = run_end(*reason, ends.simulated_seconds, ends.last_speed,
                                 value_in<double>(*summary, "/moving_fraction").value_or(0),
                                 value_in<bool>(*summary, "/settling/front_is_final").value_or(false),
                                 value_in<double>(*summary, "/settling/deposit_change").value_or(0));
        statistics.end->is_held = value_in<bool>(*summary, "/held_by_no_data").value_or(false);
    }
    return statistics;
}

std::vector<Point> flow_tops(const std::optional<MainStatistics>& statistics) {
    std::vector<Point> tops;
    if (!statistics) return tops;
    for (const Runout& one : statistics->run_outs)
        if (one.covered_area_m2 > 0) tops.push_back(one.top);
    return tops;
}

namespace {

/// A value named in the line.
struct Named {
    const char* key;
    const char* words;
    const char* unit;
    const char* absent;         ///< in its place; null: nothing
    const char* by_place = "";  ///< key of values that replace it by place
    bool not_if_zero = false;
};

constexpr Named k_voellmy_bingham[] = {
    {"material.friction-angle", worded("friction angle"), "\u00B0", nullptr, "zones.friction-angle"},
    {"material.friction-coefficient", worded("friction coefficient"), "", nullptr, "zones.friction-coefficient"},
    {"material.turbulence", worded("turbulence"), " m/s\u00B2", worded("no turbulence"), "zones.turbulence"},
    {"material.yield-stress", worded("yield stress"), " Pa", nullptr, "", true},
    {"material.density", worded("density"), " kg/m\u00B3", nullptr},
};
constexpr Named k_structured[] = {
    {"structured.cohesion", worded("cohesion"), " Pa", nullptr},
    {"structured.internal-friction-angle", worded("internal friction angle"), "\u00B0", nullptr},
    {"structured.bed-friction-angle", worded("friction angle at the bed"), "\u00B0", nullptr},
    {"structured.grain-density", worded("density of the grains"), " kg/m\u00B3", nullptr},
    {"structured.solid-fraction", worded("fraction of solids"), "", nullptr},
};

/// In groups of three digits where it has more than three, as the volume before it.
std::string value_text(double value) {
    return std::abs(value) < 1000 ? number_text(value) : grouped(value);
}

std::string what_fails(const ScenarioFacts& facts, const Words& words) {
    constexpr std::size_t k_most = 4, k_longest = 60;  // names; letters
    const bool released = facts.value("release.thickness") || facts.value("release.perimeter");
    std::string text = released ? words("Release") : words("Inflow");
    if (!facts.release_names.empty() && facts.release_names.size() <= k_most)
        text += " " + elided(valid_utf8(joined(facts.release_names, ", ")), k_longest);
    return text;
}

template <class Table>
void add_values(const ScenarioFacts& facts, const Table& table, const Words& words, std::vector<std::string>& parts) {
    const auto friction_table = facts.value("material.friction-table");
    if (friction_table)
        parts.push_back(words("friction table") + " " + std::filesystem::path(*friction_table).stem().string());
    for (const Named& one : table) {
        if (friction_table && gives_by_table(one.key)) continue;
        const bool varies = *one.by_place != '\0' && facts.value(one.by_place);
        auto text = facts.value(one.key);
        if (text == "off") text.reset();
        constexpr double k_none = std::numeric_limits<double>::quiet_NaN();
        const double number = text ? number_from_text(*text).value_or(k_none) : k_none;
        if (varies || (text && std::isnan(number)))
            parts.push_back(words("{1} by place", {words(one.words)}));
        else if (text && !(one.not_if_zero && number == 0))
            parts.push_back(words(one.words) + " " + words.number(value_text(number)) + one.unit +
                            (facts.density_by_default && std::string_view(one.key) == "material.density"
                                 ? " (" + words("default") + ")"
                                 : ""));
        else if (!text && one.absent != nullptr)
            parts.push_back(words(one.absent));
    }
}

}  // namespace

std::string voellmy_bingham_words(const std::string& scheme) {
    return scheme.empty() || scheme == word_of(Numerics{}.scheme, k_schemes) ? "Voellmy-Bingham"
                                                                             : "Voellmy-Bingham, " + scheme;
}

std::string scenario_words(const ScenarioFacts& facts, const Words& words) {
    const auto model = facts.value("material.model");
    std::vector<std::string> parts;
    if (!model) {
        parts.emplace_back("?");
    } else if (*model == "structured") {
        parts.push_back(words("Structured model"));
        add_values(facts, k_structured, words, parts);
    } else {
        parts.push_back(voellmy_bingham_words(facts.value("numerics.scheme").value_or("")));
        const std::string laws = facts.value("material.bed-friction").value_or("voellmy");
        if (laws != "voellmy") parts.push_back(laws);
        add_values(facts, k_voellmy_bingham, words, parts);
    }
    const std::string line =
        words.labelled(what_fails(facts, words), words.number(grouped(facts.volume)) + " m\u00B3; ") +
        joined(parts, ", ");
    if (facts.end) return line + ". " + end_sentence(*facts.end, words);
    return line + ", t = " + words.number(number_text(facts.simulated_seconds, 3)) + " s";
}

}  // namespace frana::app
