// SPDX-License-Identifier: Apache-2.0
// Calibrations, as a user sees them.
#include <gdal_priv.h>

#include <sys/mount.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>

#include "gis/access/table_in.h"
#include "gis/raster/raster_in.h"
#include "started_program.h"
#include "study/kept_records.h"
#include "study/part_of_raster.h"
#include "support/checked_scene.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

const std::string k_two_keys =
    "[vary]\nmaterial.friction-angle = uniform(10, 26)\nmaterial.turbulence = log-uniform(200, 2000)\n";
const std::string k_jaccard = "[objective]\njaccard = 1\n";

/// A folder with a tiny scene and a scar, about that of a run with a friction angle of 17 degrees.
class Calibrate : public CheckedScene {
  protected:
    Calibrate() {
        write_scene("stop-when-still = off\n" + k_numbers_only + "charts = off\n");
        write_polygon("scar", {{15, 50}, {40, 40}, {150, 38}, {155, 75}, {150, 112}, {40, 110}, {15, 100}});
        write("slope.ini", read_text(path("scene.ini")) + "[scar]\nperimeter = scar.geojson\n");
        write_study("samples = 18\n", k_jaccard + k_two_keys);
    }

    /// A scene whose scar was drawn by frana.
    void write_event(const std::string& scene, const std::string& scar, double angle,
                     const std::string& more = "") const {
        write_scene("stop-when-still = off\n" + k_numbers_only + "charts = off\n" + more);
        ran(scar, {"time.end=12", "material.friction-angle=" + std::to_string(angle)});
        write(scene, read_text(path("scene.ini")) + "[scar]\nperimeter = " + scar + "/extent.gpkg|layer=trace\n");
    }
    void write_study(const std::string& head, const std::string& rest,
                     const std::string& set = "[set]\ntime.end = 12\n") const {
        write("study.ini", "[study]\nscene = slope.ini\n" + head + set + rest);
    }
    [[nodiscard]] Outcome run(const std::vector<std::string>& more = {}, const std::string& out = "out") const {
        return frana(with_more({"calibrate", "study.ini", "--out", out, "--quiet"}, more));
    }
    [[nodiscard]] Rows table(const std::string& name) const { return rows_of(path(name)); }
    [[nodiscard]] Json calibration(const std::string& out = "out") const {
        return parse_json(read_text(path(out + "/calibration.json")));
    }
    [[nodiscard]] std::vector<KeptRecord> records() const {
        std::vector<std::string> names;
        for (const std::string& name : files())
            if (name.find("/records/record") != std::string::npos && name.find("out.partial/") != std::string::npos)
                names.push_back(name);
        return kept_records(folder_.string(), names);
    }
    [[nodiscard]] Outcome stop_after(std::size_t members, int signal_number) const {
        StartedProgram program(folder_.string(), {"calibrate", "study.ini", "--out", "out", "--threads", "2"});
        EXPECT_TRUE(program.wait_until([&] { return records().size() >= members; }));
        program.send(signal_number);
        return program.wait();
    }
    /// Everything that must not differ: all but wall times.
    [[nodiscard]] std::map<std::string, std::string> lasting(const std::string& out) const {
        std::map<std::string, std::string> content;
        for (const std::string name : {"calibration.json", "best.ini", "study.ini"})
            content[name] = read_text(path(out + "/" + name));
        for (const std::string name : {"posterior.csv", "members.csv"})
            for (auto& row : table(out + "/" + name)) {
                row.erase("engine_seconds");
                for (const auto& [key, value] : row) content[name] += key + "=" + value + ";";
            }
        return content;
    }
    void expect_same(const std::string& a, const std::string& b) const {
        const auto first = lasting(a), second = lasting(b);
        for (const auto& [name, content] : first) EXPECT_EQ(content, second.at(name)) << name;
    }
    void expect_refused(const std::vector<std::string>& words) const {
        const auto before = files();
        for (const std::string command : {"calibrate", "check"}) {
            const Outcome outcome = refusal_of(refused({command, "study.ini"}));
            for (const std::string& one : words)
                EXPECT_NE(outcome.err.find(one), std::string::npos) << command << ": " << one << "\n" << outcome.err;
        }
        EXPECT_EQ(files(), before);
    }
};

// The scar is a run of frana's: its friction is found, and `frana run` with the best scene has the score.
// Runs that were cut have the scores of unfinished flows; it was said that the survey does not determine the friction.
TEST_F(Calibrate, SaysWhatRunsThatWereCutDoToIt) {
    write_study("samples = 16\n", k_jaccard + k_two_keys,
                "[set]\ntime.end = 3\noutput.maps = on\noutput.map-formats = svg\n");
    succeeded(run());
    for (const auto& map : std::filesystem::directory_iterator(path("out/maps"))) {
        const std::string page = read_text(map.path());
        expect_words(page, {"32 of 32 runs cut while moving", "happens again"});
    }
    const Json summary = parse_json(read_text(path("out/summary.json")));
    EXPECT_EQ(summary["run_troubles"]["cut"], 32);  // 16 of the search, 16 of the forecast
    EXPECT_NE(summary["warnings"][0].get<std::string>().find("32 of 32 runs cut while moving"), std::string::npos);
    EXPECT_NE(summary["warnings"][1].get<std::string>().find("posterior"), std::string::npos);
    // The number of a member alone names two runs.
    int named = 0;
    for (const std::string warning : summary["warnings"]) {
        if (warning.find("most of all member") == std::string::npos) continue;
        ++named;
        EXPECT_NE(warning.find(" (members.csv): "), std::string::npos) << warning;
    }
    EXPECT_GT(named, 0);
    for (const auto& row : table("out/members.csv")) EXPECT_GT(std::stod(row.at("moving_fraction")), 0.5);
    // Who reads the posterior reads its doubts, an ensemble of it too.
    const std::string doubt = "32 of 32 runs cut while moving", posterior = read_text(path("out/posterior.csv"));
    EXPECT_TRUE(posterior.starts_with("# ")) << posterior.substr(0, 100);
    EXPECT_LT(posterior.find(doubt), posterior.find("\nfor,event,material"));
    write("again.ini",
          "[study]\nscene = slope.ini\nscheme = finite-volume\nsampling = table:out/posterior.csv\n[set]\ntime.end = "
          "3\n");
    EXPECT_NE(frana({"check", "again.ini"}).err.find("posterior.csv: "), std::string::npos);
    succeeded(frana({"ensemble", "again.ini", "--out", "again", "--quiet"}));
    const std::string repeated = parse_json(read_text(path("again/summary.json")))["warnings"].dump();
    EXPECT_NE(repeated.find("posterior.csv: Extent, run-out and probabilities are lower bounds: " + doubt),
              std::string::npos)
        << repeated;
    // All runs were cut: anything may have been reached.
    int maps = 0;
    for (const auto& file : std::filesystem::directory_iterator(path("out"))) {
        const std::string name = file.path().filename().string();
        if (!name.starts_with("posterior_") || file.path().extension() != ".tif") continue;
        ++maps;
        const GDALDatasetUniquePtr raster(GDALDataset::Open(file.path().c_str(), GDAL_OF_RASTER));
        ASSERT_EQ(raster->GetRasterCount(), 3) << name;
        double range[2];
        ASSERT_EQ(raster->GetRasterBand(3)->ComputeRasterMinMax(FALSE, range), CE_None);
        EXPECT_EQ(range[0], 1) << name;
    }
    EXPECT_GT(maps, 0);
    EXPECT_EQ(run({"--strict", "--overwrite"}).exit_code, 3);
}

TEST_F(Calibrate, CheckWarnsOfTheReleaseAsThatOfTheSceneDoes) {
    write_study("samples = 4\n", k_jaccard + k_two_keys, "[set]\nrelease.thickness = 90\n");
    const Outcome check = succeeded(frana({"check", "study.ini"}));
    expect_words(check.err, {"release step of", "too thick for depth-averaging"});
}

TEST_F(Calibrate, SaysThatItsRunsLeftTheGround) {
    write_study("samples = 8\n", k_jaccard + k_two_keys,
                "[set]\ntime.end = 30\nterrain.bounds = 527000 5094000 527100 5094150\n");
    succeeded(run());
    const Json summary = parse_json(read_text(path("out/summary.json")));
    EXPECT_GT(summary["run_troubles"]["left_ground"], 4);
    EXPECT_NE(summary["warnings"][0].get<std::string>().find("runs left the domain"), std::string::npos);
    EXPECT_EQ(run({"--strict", "--overwrite"}).exit_code, 3);
}

TEST_F(Calibrate, FindsTheValueThatDrewTheScarAndItsScoreIsThatOfCompare) {
    write_event("slope.ini", "truth", 17);
    write_study("samples = 40\n", k_jaccard + k_two_keys);
    succeeded(run());
    const Json json = calibration();
    EXPECT_GT(json["best_score"].get<double>(), 0.9);
    const Json& friction = json["intervals"][0];
    EXPECT_EQ(friction["key"], "material.friction-angle");
    EXPECT_LE(friction["q05"].get<double>(), 17);
    EXPECT_GE(friction["q95"].get<double>(), 17);
    EXPECT_LT(friction["width_of_prior"].get<double>(), 0.7);
    EXPECT_EQ(json["events"][0]["scheme"], "default");
    EXPECT_EQ(json["events"][0]["scheme_check"]["members"].size(), 2U) << json["events"][0];
    const Outcome best = succeeded(frana({"run", "out/best.ini", "--out", "best", "--quiet"}));
    EXPECT_NEAR(json_number(read_text(path("best/comparison.json")), "jaccard"), json["best_score"].get<double>(),
                1e-12);
    // The event again is nearer to what drew it than a new slope, whose spread is assumed.
    EXPECT_EQ(friction["for"], "this-event");
    const Json& next = json["intervals"][2];
    EXPECT_EQ(next["for"], "new-slope");
    EXPECT_EQ(next["key"], friction["key"]);
    EXPECT_GT(next["width_of_prior"].get<double>(), friction["width_of_prior"].get<double>());
    EXPECT_EQ(json["spread"][0]["from"], "assumed");
    EXPECT_NE(read_text(path("out/posterior.csv")).find("# new-slope: spread between slopes assumed"),
              std::string::npos);
    EXPECT_LT(json["events"][0]["fitted"]["standard_error"].get<double>(), 0.05);
    EXPECT_FALSE(fs::exists(path("out/records")));
}

// posterior.csv has equal draws for the event again and for a new slope: an ensemble takes those that it asks for.
TEST_F(Calibrate, ItsPosteriorIsTheInputOfAnEnsemble) {
    succeeded(run());
    const Rows rows = table("out/posterior.csv");
    ASSERT_EQ(rows.size(), 400U);
    EXPECT_EQ(std::count_if(rows.begin(), rows.end(), [](const auto& row) { return row.at("for") == "new-slope"; }),
              200);
    const auto study = [&](const std::string& head, const std::string& scene = "slope.ini") {
        write("ensemble.ini", "[study]\nscene = " + scene + "\nscheme = finite-volume\n" + head +
                                  "[set]\ntime.end = 12\noutput.depth-thresholds = 0.1\n");
    };
    const std::string by_table = "sampling = table:out/posterior.csv\n";
    study(by_table + "for = this-event\n");
    succeeded(frana({"ensemble", "ensemble.ini", "--out", "range", "--quiet"}));
    const Rows members = table("range/members.csv");
    ASSERT_EQ(members.size(), 200U);
    for (std::size_t i = 0; i < members.size(); ++i)
        for (const std::string key : {"material.friction-angle", "material.turbulence"})
            EXPECT_EQ(members[i].at(key), rows[i].at(key));
    EXPECT_NE(read_text(path("range/study.ini")).find("for = this-event"), std::string::npos);
    // Another scene takes the new slope; the event's own is told of it.
    const auto ambiguous = [&] { return frana({"check", "ensemble.ini"}).err.find("write study.for = this-event"); };
    study(by_table);
    EXPECT_NE(ambiguous(), std::string::npos);
    write("other.ini", read_text(path("slope.ini")));
    study(by_table, "other.ini");
    EXPECT_EQ(ambiguous(), std::string::npos);
    for (const auto& [head, words] :
         {std::pair<std::string, std::string>{by_table + "for = this-event north\n", "is not in the table"},
          {by_table + "for = all\n", "is not in the table"},
          {"for = new-slope\n[vary]\nmaterial.friction-angle = uniform(10, 26)\n", "has no effect without a table"}}) {
        study(head);
        refusal_of(refused({"check", "ensemble.ini"}), {words});
    }
}

TEST_F(Calibrate, SameBitsForAnyNumberOfThreads) {
    for (const std::string threads : {"1", "2", "7"}) {
        succeeded(run({"--threads", threads}, "out" + threads));
    }
    expect_same("out1", "out2");
    expect_same("out1", "out7");
}

TEST_F(Calibrate, ResumesAfterKillsInEitherStageAndEndsInTheSameBits) {
    succeeded(run({}, "whole"));
    for (const std::size_t members : {std::size_t{5}, std::size_t{13}}) {  // of the design, of those that it chose
        fs::remove_all(path("out"));
        ASSERT_EQ(stop_after(members, SIGKILL).exit_code, -SIGKILL);
        EXPECT_FALSE(fs::exists(path("out")));
        refusal_of(run(), {"--resume continues it"});
        const std::vector<KeptRecord> kept = records();
        ASSERT_GE(kept.size(), members);
        std::string bytes = read_text(path(kept[0].file));
        bytes[kept[0].at + 50] ^= 1;  // damaged; the last one of its file is torn
        write(kept[0].file, bytes.substr(0, bytes.size() - 1));
        succeeded(run({"--resume", "--threads", "1"}));
        expect_same("whole", "out");
        succeeded(run({"--resume"}));
    }
}

TEST_F(Calibrate, ResumeRefusesMembersOfAChangedStudy) {
    const Outcome stopped = stop_after(2, SIGTERM);
    ASSERT_EQ(stopped.exit_code, 128 + SIGTERM) << stopped.err;
    EXPECT_NE(stopped.err.find("--resume runs the others"), std::string::npos) << stopped.err;
    write_study("samples = 18\n", "[objective]\njaccard = 1\narea = 1\n" + k_two_keys);
    refusal_of(run({"--resume"}), {"are of another study"});
}

TEST_F(Calibrate, AllProblemsAreReportedInOnePassAndNothingIsWritten) {
    write("slope.ini", read_text(path("slope.ini")) + "[numerics]\ncfll = 1\n");
    write_study(
        "samples = 0\nrefine = 100\nkeep = all\n",
        "[objective]\njaccart = 1\n[vary]\nmaterial.friction-angle = uniform(10, 95)\nterrain.bounds = choice(a)\n"
        "scar.threshold = uniform(0.1, 0.2)\n");
    expect_refused({"study.samples", "study.refine", "study.keep", "objective.jaccart", "vary.material.friction-angle",
                    "vary.terrain.bounds", "vary.scar.threshold", "numerics.cfll: unknown key"});
}

TEST_F(Calibrate, AnEventWithoutAScarIsRefused) {
    write_scene(k_numbers_only);
    write("bare.ini", read_text(path("scene.ini")));
    write("study.ini", "[study]\nscene = slope.ini, bare.ini\nsamples = 4\n" + k_jaccard + k_two_keys);
    expect_refused({"event bare", "has nothing that [objective] compares: jaccard", "observed.perimeter in the scene"});
    write_study("samples = 4\n", "[objective]\njaccard = 1\narrival = 1\n" + k_two_keys);
    expect_refused({"objective.arrival", "no event was surveyed for it"});
    write_study("samples = 4\n", "[objective]\nspeed = 1\n[event slope]\nspeed bridge = 5\n" + k_two_keys);
    expect_refused({"the scene has no gauge of this name"});
}

// Where the bed is slippery the flow of one event reaches cells without terrain.
TEST_F(Calibrate, AnEventWhoseMembersAllFailEndsWithItsReason) {
    write_dtm([](int, int column) { return column > 16 ? -9999 : 300 - 0.5 * (column + 0.5) * k_cell; }, true,
              "short.asc");
    write("bad.ini",
          "[terrain]\ndtm = short.asc\n[release]\nperimeter = perimeter.geojson\nthickness = 2\n[material]\n"
          "friction-angle = 15\n[output]\nmaps = off\n[scar]\nperimeter = perimeter.geojson\n");
    write("study.ini",
          "[study]\nscene = slope.ini, bad.ini\nsamples = 6\n[set]\ntime.end = 12\n" + k_jaccard + k_two_keys);
    const Outcome outcome = run();
    EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
    expect_words(outcome.err, {"event bad", "without terrain"});
    EXPECT_FALSE(fs::exists(path("out")));
}

// Two events with one friction and a volume of their own each; each is predicted from the other.
TEST_F(Calibrate, EventsArePredictedFromTheOthers) {
    write_event("one.ini", "truth1", 14);
    write_event("two.ini", "truth2", 20);
    write(
        "study.ini",
        "[study]\nscene = one.ini, two.ini\nsamples = 30\n[set]\ntime.end = 12\n[objective]\njaccard = "
        "1\nrunout = 0.5\n[vary]\nmaterial.friction-angle = uniform(8, 26)\n[vary one]\nrelease.volume = uniform(3000, "
        "5000)\n[vary two]\nmaterial.turbulence = log-uniform(200, 2000)\n");
    const Outcome outcome = succeeded(frana({"calibrate", "study.ini", "--out", "out"}));
    EXPECT_NE(outcome.err.find("one: score "), std::string::npos) << outcome.err;
    const Json json = calibration();
    ASSERT_EQ(json["events"].size(), 2U);
    const double frictions[] = {14, 20};
    for (std::size_t e = 0; e < 2; ++e) {
        const Json& event = json["events"][e];
        const Json& predicted = event["leave_one_out"];
        // The other survey gives the other friction, wrong by six degrees, or any between slopes: worse than the fit.
        EXPECT_LT(predicted["mean_score"].get<double>(), event["fitted"]["mean_score"].get<double>()) << event.dump();
        EXPECT_GT(predicted["mean_score"].get<double>(), 0.3) << event.dump();
        EXPECT_NEAR(predicted["intervals"][0]["q50"].get<double>(), frictions[1 - e], 3) << event.dump();
        EXPECT_GT(event["observed_runout_m"].get<double>(), 50);
    }
    // Each event has draws of its own keys; a new slope of those that both have.
    std::map<std::string, int> counts;
    for (const auto& row : table("out/posterior.csv")) {
        const std::string name = row.at("for") == "new-slope" ? row.at("for") : row.at("event");
        ++counts[name];
        EXPECT_FALSE(row.at("material.friction-angle").empty());
        EXPECT_EQ(row.at("release.volume").empty(), name != "one");
        EXPECT_EQ(row.at("material.turbulence").empty(), name != "two");
    }
    EXPECT_EQ(counts, (std::map<std::string, int>{{"one", 200}, {"two", 200}, {"new-slope", 200}}));
    const auto check = [&](const std::string& which) {
        write("again.ini", "[study]\nscene = one.ini\nsampling = table:out/posterior.csv\nfor = " + which + "\n");
        return frana({"check", "again.ini"});
    };
    EXPECT_NE(check("this-event").err.find("is of several events"), std::string::npos);
    const Outcome of_one = succeeded(check("this-event one"));
    EXPECT_NE(of_one.out.find("release.volume"), std::string::npos) << of_one.out;
    EXPECT_EQ(check("new-slope").out.find("release.volume"), std::string::npos);
    EXPECT_TRUE(fs::exists(path("out/best_one.ini")) && fs::exists(path("out/best_two.ini")));
}

// Values at gauges, the run-out by number, outlines and deposits: each measure of the run that drew them is 0.
TEST_F(Calibrate, EveryMeasureIsZeroForTheRunThatWasSurveyed) {
    write_features("gauges", {{"Point", {{120, 75}}, named("bridge")}});
    write_event("slope.ini", "surveyed", 17, "gauges = gauges.geojson\n");
    const std::string summary = read_text(path("surveyed/summary.json"));
    double arrival = 0, speed = 0, depth = 0;
    for (const auto& row : table("surveyed/gauges.csv")) {
        speed = std::max(speed, std::stod(row.at("speed_ms")));
        depth = std::max(depth, std::stod(row.at("depth_m")));
    }
    const Raster times = gis::read_result_raster(path("surveyed/arrival_time.tif"));
    arrival = times.at((static_cast<int>(k_south) + 150 - 5094075) / 5, (527120 - 527000) / 5);
    ASSERT_GT(arrival, 0);
    ASSERT_GT(speed, 0);
    write("slope.ini", read_text(path("slope.ini")) + "deposit = surveyed/elevation_change.tif\n");
    write("study.ini",
          "[study]\nscene = slope.ini\nsamples = 4\n[set]\ntime.end = "
          "12\n[objective]\njaccard = "
          "1\narea = 1\nrunout = 1\noutline = 1\ndeposit = 1\ndeposit-depth = 1\narrival = 1\nspeed = 1\ndepth = "
          "1\n[event "
          "slope]\nrunout = " +
              std::to_string(json_number(summary, "runout.horizontal_m")) +
              "\narrival bridge = " + std::to_string(arrival) + "\nspeed bridge = " + std::to_string(speed) +
              "\ndepth bridge = " + std::to_string(depth) + "\n[vary]\nmaterial.friction-angle = choice(17, 25)\n");
    succeeded(run());
    int same = 0, other = 0;
    for (const auto& row : table("out/members.csv")) {
        const bool is_truth = row.at("material.friction-angle") == "17";
        (is_truth ? same : other) += 1;
        for (const std::string measure :
             {"jaccard", "area", "runout", "outline", "deposit", "deposit-depth", "arrival", "speed", "depth"}) {
            const double misfit = std::stod(row.at("misfit " + measure));
            // Numbers of the study have six decimals; the file of depths is Float32.
            if (is_truth)
                EXPECT_NEAR(misfit, 0, 1e-5) << measure;
            else
                EXPECT_GT(misfit, 1e-4) << measure;
            EXPECT_LE(misfit, 1) << measure;
        }
    }
    EXPECT_GT(same, 0);
    EXPECT_GT(other, 0);
    EXPECT_FALSE(calibration()["events"][0]["stated_errors"].get<bool>());

    // With stated errors run-out and gauges are a piece each, outline and deposit at least one.
    std::string study = read_text(path("study.ini"));
    for (const std::string key : {"runout = ", "arrival bridge = ", "speed bridge = ", "depth bridge = "})
        study.insert(study.find('\n', study.find("\n" + key, study.find("[event")) + 1), " +- 0.5");
    study.insert(study.find("[objective]"),
                 "observed.perimeter-error = 5\nobserved.deposit-error = 0.1\nobserved.error-length = 1000\n");
    write("study.ini", study);
    const Outcome stated = succeeded(run({}, "stated"));
    const Json event = calibration("stated")["events"][0];
    EXPECT_TRUE(event["stated_errors"].get<bool>());
    EXPECT_EQ(event["pieces"].get<double>(), 6);
    EXPECT_GE(event["error_factor"].get<double>(), 1);
}

TEST_F(Calibrate, ChartsAndReportAreDrawn) {
    write("slope.ini", [&] {
        std::string text = read_text(path("slope.ini"));
        for (const std::string off : {"maps = off\n", "charts = off\n", "report = off\n"})
            text.erase(text.find(off), off.size());
        return text.insert(text.find("[output]\n") + 9, "map-size = 640x480\nmap-formats = png, svg\n");
    }());
    succeeded(run());
    EXPECT_NE(read_text(path("out/charts/posterior.svg")).find("friction angle [°]"), std::string::npos);
    for (const std::string name :
         {"maps/posterior_slope.png", "charts/posterior.png", "report.html", "log.txt", "summary.json"})
        EXPECT_TRUE(fs::exists(path("out/" + name))) << name;
    const std::string page = read_text(path("out/report.html"));
    EXPECT_NE(page.find("Spread between slopes"), std::string::npos);
    EXPECT_EQ(json_text(read_text(path("out/summary.json")), "date").size(), std::string("2026-11-24").size());
    EXPECT_NE(page.find("src=\"data:image/"), std::string::npos);
}

TEST_F(Calibrate, CheckTellsEventsMembersTimeAndMemory) {
    const auto before = files();
    const Outcome outcome = succeeded(frana({"check", "study.ini"}));
    expect_words(outcome.out, {"is ready to run", "compared by jaccard 1", "cells of 5 m",
                               "material.turbulence log-uniform(200, 2000)",
                               "10 first, then until the intervals settle, at most 18, each for 1 event",
                               "estimated time", "memory", "-calibration"});
    EXPECT_EQ(files(), before);
}

TEST_F(Calibrate, AResultIsReplacedOnlyWhenAsked) {
    write_study("samples = 8\n", k_jaccard + k_two_keys);
    succeeded(run());
    const std::string first = read_text(path("out/posterior.csv"));
    refusal_of(run());
    write("out/notes.txt", "mine");
    write_study("samples = 9\n", k_jaccard + k_two_keys);
    refusal_of(run({"--resume"}));     // it is complete, and of another study
    refusal_of(run({"--overwrite"}));  // a file of the user's is in the way
    EXPECT_EQ(read_text(path("out/posterior.csv")), first);
    EXPECT_EQ(read_text(path("out/notes.txt")), "mine");
    fs::remove(path("out/notes.txt"));
    succeeded(run({"--overwrite"}));
    EXPECT_EQ(table("out/members.csv").size(), 18U);  // 9 of the search, 9 of the forecast
}

// What was computed before the disk was full is kept, and is not computed again.
TEST_F(Calibrate, AFullDiskLosesNoMember) {
    fs::create_directory(path("disk"));
    if (::mount("tmpfs", path("disk").c_str(), "tmpfs", 0, "size=64k") != 0)
        GTEST_SKIP() << "a small disk can be mounted by root only: " << std::strerror(errno);
    fs::create_directory(path("beside"));  // as deep: the paths in best.ini are relative
    succeeded(run({}, "beside/whole"));
    const Outcome full = run({}, "disk/out");
    EXPECT_EQ(full.exit_code, 4) << full.err;
    EXPECT_FALSE(fs::exists(path("disk/out")));
    EXPECT_EQ(::mount("tmpfs", path("disk").c_str(), "tmpfs", MS_REMOUNT, "size=64m"), 0) << std::strerror(errno);
    const Outcome resumed = run({"--resume"}, "disk/out");
    EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
    if (resumed.exit_code == 0) expect_same("beside/whole", "disk/out");
    ::umount2(path("disk").c_str(), MNT_DETACH);
}

// A table whose weights are all 0 says nothing.
TEST_F(Calibrate, AnEnsembleOfMembersWithoutWeightIsRefused) {
    write("table.csv", "weight,material.friction-angle\n0,12\n0,14\n");
    write("ensemble.ini", "[study]\nscene = slope.ini\nsampling = table:table.csv\n");
    refusal_of(frana({"ensemble", "ensemble.ini", "--out", "range"}), {"has no weight greater than 0"});
}

TEST_F(Calibrate, AnEnsembleDoesNotTakeACalibration) {
    refusal_of(frana({"ensemble", "study.ini"}), {"for `frana calibrate`"});
}

}  // namespace
}  // namespace frana::test
