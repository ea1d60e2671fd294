// SPDX-License-Identifier: Apache-2.0
// Studies of many runs, as a user sees them.
#include <gdal_priv.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <map>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "gis/access/table_in.h"
#include "gis/raster/raster_in.h"
#include "study/tiny_study.h"
#include "support/html_check.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

// A thin slab slides on a flat bed and stops after v^2 / (2 mu g): with mu even in [0.2, 0.4] its front passes x with
// probability P(mu < v^2 / (2 g d)), d the distance of x from the front at the start. The slab is so thin that pressure
// moves its front by less than a metre: sqrt(g h) t = 0.4 m. Three standard errors of 1000 members, and the probability
// of half a cell, within which the front is known.
TEST_F(Ensemble, ProbabilityOfTheSlidingBlockIsThatOfTheClosedForm) {
    constexpr double v = 20, g = 9.81, low = 0.2, high = 0.4, front = 40, cell = 1;
    constexpr int columns = 170, members = 1000;
    std::string dtm = "ncols 170\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\nNODATA_value -9999\n";
    for (int i = 0; i < columns * 2; ++i) dtm += (i + 1) % columns == 0 ? "0\n" : "0 ";
    write("flat.asc", dtm);
    write(
        "block.geojson",
        R"({"type": "FeatureCollection", "features": [{"type": "Feature", "properties": {}, "geometry": {"type": "Polygon",)"
        R"( "coordinates": [[[10, 0], [40, 0], [40, 2], [10, 2], [10, 0]]]}}]})");
    write("scene.ini",
          "[terrain]\ndtm = flat.asc\ncrs = local\n[release]\nperimeter = block.geojson\nthickness = 2e-4\n"
          "velocity = 20\ndirection = 90\n[material]\nfriction-coefficient = 0.3\n[numerics]\nboundary = wall\n"
          "minimum-depth = 1e-5\n[time]\nend = 12\n[output]\nmaps = off\ndepth-thresholds = 1e-4\n"
          "velocity-thresholds = 1\ntrace-threshold = 1e-4\nreport = off\n");
    write_study("samples = 1000\nsampling = random\nseed = 3\n",
                "[vary]\nmaterial.friction-coefficient = uniform(0.2, 0.4)\n");
    succeeded(run());
    const Raster reached = gis::read_result_raster(path("out/probability_depth_1e-04.tif"));
    int compared = 0;
    for (int column = 0; column < columns; ++column) {
        const double d = (column + 0.5) * cell - front;
        const auto exact_at = [&](double distance) {
            return std::clamp((v * v / (2 * g * distance) - low) / (high - low), 0.0, 1.0);
        };
        if (d < 40 || d > 115) continue;
        const double exact = exact_at(d), half_cell = exact_at(d - cell / 2) - exact_at(d + cell / 2);
        const double error = std::sqrt(exact * (1 - exact) / members);
        EXPECT_NEAR(reached.at(1, column), exact, 3 * error + half_cell) << "x = " << (column + 0.5) * cell;
        ++compared;
    }
    EXPECT_GT(compared, 70);
}

TEST_F(Ensemble, SameBitsForAnyNumberOfThreads) {
    write_study("samples = 12\nkeep = all\n", k_two_keys);
    for (const std::string threads : {"1", "2", "7"}) {
        succeeded(frana({"ensemble", "study.ini", "--out", "out" + threads, "--threads", threads, "--quiet"}));
    }
    expect_same("out1", "out2");
    expect_same("out1", "out7");
}

TEST_F(Ensemble, ResumesAfterAKillAndEndsInTheSameBits) {
    write_study("samples = 40\n", k_two_keys);
    succeeded(frana({"ensemble", "study.ini", "--out", "whole", "--quiet"}));
    ASSERT_EQ(stop_after(3, SIGKILL).exit_code, -SIGKILL);
    EXPECT_FALSE(fs::exists(path("out")));
    // Neither a run nor another study takes its members away.
    refusal_of(run());
    EXPECT_NE(run().err.find("--resume continues it"), std::string::npos);
    refusal_of(frana({"run", "scene.ini", "--out", "out", "--quiet"}), {"an interrupted study"});
    // A damaged record and a torn one are computed again.
    const std::vector<KeptRecord> kept = records();
    std::string bytes = read_text(path(kept.at(2).file));
    bytes[kept[0].at + 100] ^= 1;
    write(kept[0].file, bytes.substr(0, kept.back().at + kept.back().size - 1));
    succeeded(run({"--resume", "--threads", "1"}));
    expect_same("whole", "out");
    EXPECT_FALSE(fs::exists(path("out/records")));
    succeeded(run({"--resume"}));
}

TEST_F(Ensemble, ResumeRefusesMembersOfAnotherStudy) {
    write_study("samples = 60\n", k_two_keys);
    const Outcome stopped = stop_after(2, SIGTERM);
    ASSERT_EQ(stopped.exit_code, 128 + SIGTERM) << stopped.err;
    EXPECT_NE(stopped.err.find("--resume runs the others"), std::string::npos) << stopped.err;
    write_study("samples = 60\nseed = 2\n", k_two_keys);
    refusal_of(run({"--resume"}), {"are of another study"});
}

// Any member can be run again alone.
TEST_F(Ensemble, AMembersFiguresAreThoseOfARunWithItsValues) {
    write_study("samples = 4\n",
                k_two_keys + "terrain.error = gaussian-field(0.3, 40)\nrelease.volume = uniform(3000, 5000)\n");
    succeeded(run());
    const Rows rows = members();
    ASSERT_EQ(rows.size(), 4U);
    for (const auto& row : rows) {
        ASSERT_EQ(row.at("status"), "finished");
        std::vector<std::string> arguments{"run", "scene.ini", "--out", "alone", "--overwrite", "--quiet"};
        for (const auto& [key, value] : row)
            if (key.find('.') != std::string::npos) arguments.insert(arguments.end(), {"--set", key + "=" + value});
        succeeded(frana(arguments));
        const std::string summary = read_text(path("alone/summary.json"));
        const std::map<std::string, std::string> names{
            {"runout_m", "runout.horizontal_m"},    {"covered_area_m2", "covered_area_m2"},
            {"max_depth_m", "max_depth_m"},         {"max_depth_p999_m", "max_depth_p999_m"},
            {"max_velocity_ms", "max_velocity_ms"}, {"volume_m3", "volume.entered_m3"}};
        for (const auto& [figure, name] : names)
            EXPECT_EQ(std::stod(row.at(figure)), json_number(summary, name))
                << figure << ", member " << row.at("member");
    }
    EXPECT_NE(rows[0].at("terrain.error"), rows[1].at("terrain.error"));
}
// What members share is read once; a member with another file, or an error of its own, has its own ground.
TEST_F(Ensemble, MembersWithOtherFilesHaveTheirOwnGround) {
    write_dtm([](int, int column) { return 300 - 0.4 * std::min((column + 0.5) * k_cell, 200.0); }, true, "gentle.asc");
    write_polygon("wide", {{30, 50}, {80, 50}, {80, 110}, {30, 110}});
    std::string table = "terrain.dtm,release.perimeter,material.friction-angle\n";
    for (const std::string dtm : {"dtm.asc", "gentle.asc"})
        for (const std::string perimeter : {"perimeter.geojson", "wide.geojson"})
            for (const std::string angle : {"12.5", "17.5"}) table += dtm + "," + perimeter + "," + angle + "\n";
    write("table.csv", table);
    write_study("sampling = table:table.csv\n", "[set]\nterrain.error = 0.3, 40, 7\n");
    succeeded(run({"--threads", "3"}));
    std::map<std::string, std::size_t> areas;
    for (const auto& row : members()) {
        std::vector<std::string> arguments{"run",     "scene.ini",   "--out", "alone",
                                           "--quiet", "--overwrite", "--set", "terrain.error=0.3, 40, 7"};
        for (const auto& [key, value] : row)
            if (key.find('.') != std::string::npos) arguments.insert(arguments.end(), {"--set", key + "=" + value});
        succeeded(frana(arguments));
        const std::string summary = read_text(path("alone/summary.json"));
        EXPECT_EQ(std::stod(row.at("covered_area_m2")), json_number(summary, "covered_area_m2")) << row.at("member");
        EXPECT_EQ(std::stod(row.at("max_velocity_ms")), json_number(summary, "max_velocity_ms")) << row.at("member");
        ++areas[row.at("max_velocity_ms")];
    }
    EXPECT_EQ(areas.size(), 8U);
}

TEST_F(Ensemble, AllProblemsAreReportedInOnePassAndNothingIsWritten) {
    write("scene.ini", read_text(path("scene.ini")) + "formats = png\n[numerics]\naccuracy = 5 %\ncfll = 1\n");
    write_study("samples = 0\nlevls = 3\n",
                "[vary]\nmaterial.friction-angle = uniform(10, 90)\nterrain.bounds = choice(a)\n"
                "release.perimeter = choice(perimeter.geojson)\n");
    const auto before = files();
    for (const std::string command : {"ensemble", "check"}) {
        const Outcome outcome = refusal_of(refused({command, "study.ini"}));
        expect_words(outcome.err,
                     {"study.samples", "study.levls: unknown key", "vary.material.friction-angle",
                      "vary.terrain.bounds", "output.formats", "numerics.accuracy", "numerics.cfll: unknown key"});
    }
    EXPECT_EQ(files(), before);
}

TEST_F(Ensemble, ASceneThatIsMissingIsReportedWithTheOtherProblems) {
    write("study.ini", "[study]\nscene = nowhere.ini\nsamples = 0\n" + k_two_keys);
    expect_run_refused({"nowhere.ini: cannot be opened", "study.samples"});
}

TEST_F(Ensemble, AFileOfAChoiceThatCannotBeReadIsRefusedBefore) {
    write_study("samples = 4\n", "[vary]\nrelease.perimeter = choice(perimeter.geojson, nowhere.geojson)\n");
    expect_run_refused({"nowhere.geojson"});
    EXPECT_FALSE(fs::exists(path("out")));
}

// Where the bed is slippery the flow reaches cells without terrain: such members have failed.
// Where the terrain ends those fail that would come farthest, and others are held by its edge: what is said of the rest
// is a lower bound, and what all would do on the whole terrain lies below the upper one.
TEST_F(Ensemble, FailedMembersAreCountedWithTheirReason) {
    const auto slope = [](int, int column) { return 300 - 0.5 * std::min((column + 0.5) * k_cell, 200.0); };
    write("angles.csv", "material.friction-angle\n3.4\n8.3\n13.2\n18.1\n22.9\n27.8\n32.7\n37.6\n");
    const std::string head = "sampling = table:angles.csv\nkeep = failed\n", rest = "[set]\ntime.end = 40\n";
    write_dtm(slope);
    write_study(head, rest);
    succeeded(run());
    fs::rename(path("out"), path("whole"));
    write_dtm([&](int row, int column) { return column > 50 ? -9999 : slope(row, column); });
    const Outcome outcome = run();
    const Json told = parse_json(read_text(path("out/summary.json")));
    EXPECT_NE(told["warnings"][0].get<std::string>().find(told["run_troubles"]["failed"].dump() + " of 8 runs failed"),
              std::string::npos)
        << told["warnings"][0];
    GDALAllRegister();
    for (const char* name : {"probability_depth_0.1", "probability_velocity_1"}) {
        const auto band = [&](const std::string& folder, int number) {
            const GDALDatasetUniquePtr file(GDALDataset::Open(path(folder + "/" + name + ".tif").c_str()));
            std::vector<double> values(static_cast<std::size_t>(k_columns * k_rows));
            EXPECT_EQ(file->GetRasterBand(number)->RasterIO(GF_Read, 0, 0, k_columns, k_rows, values.data(), k_columns,
                                                            k_rows, GDT_Float64, 0, 0),
                      CE_None);
            return values;
        };
        const auto truth = band("whole", 1), upper = band("out", 3);
        for (std::size_t cell = 0; cell < truth.size(); ++cell) EXPECT_LE(truth[cell], upper[cell] + 1e-6) << cell;
    }
    EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
    const std::string summary = read_text(path("out/summary.json"));
    const int failed = static_cast<int>(json_number(summary, "failed"));
    EXPECT_GT(failed, 0);
    EXPECT_LT(failed, 8);
    EXPECT_EQ(json_number(summary, "finished") + failed, 8);
    for (const auto& row : members()) {
        EXPECT_EQ(row.at("status") == "failed", !row.at("reason").empty());
        if (row.at("status") == "failed") {
            EXPECT_NE(row.at("reason").find("without terrain"), std::string::npos) << row.at("reason");
            EXPECT_TRUE(fs::exists(path("out/members/member_000000" + row.at("member") + "/max_depth.tif")));
        }
    }
    EXPECT_NE(outcome.err.find("runs failed"), std::string::npos) << outcome.err;
}

TEST_F(Ensemble, AResultIsReplacedOnlyWhenAsked) {
    write_study("samples = 2\n", k_two_keys);
    succeeded(run());
    const std::string first = read_text(path("out/members.csv"));
    refusal_of(run(), {"contains a result already"});
    write("out/notes.txt", "mine");
    write_study("samples = 3\n", k_two_keys);
    refusal_of(run({"--resume"}));     // it is complete, and of another study
    refusal_of(run({"--overwrite"}));  // a file of the user's is in the way
    EXPECT_EQ(read_text(path("out/members.csv")), first);
    EXPECT_EQ(read_text(path("out/notes.txt")), "mine");
    fs::remove(path("out/notes.txt"));
    succeeded(run({"--overwrite"}));
    EXPECT_EQ(members().size(), 3U);
}

TEST_F(Ensemble, ATableOfMembersGivesTheSameMembers) {
    const std::string to_rest =
        "[set]\ntime.end = 300\ntime.stop-when-still = on\n";  // members of a table do not run on
    write_study("samples = 6\n", to_rest + k_two_keys);
    succeeded(run());
    fs::rename(path("out"), path("drawn"));
    write_study("sampling = table:drawn/members.csv\n", to_rest);
    succeeded(run());
    const Raster a = gis::read_result_raster(path("drawn/quantile_max_depth_50.tif")),
                 b = gis::read_result_raster(path("out/quantile_max_depth_50.tif"));
    for (std::size_t i = 0; i < a.values.size(); ++i)
        ASSERT_TRUE(std::isnan(a.values[i]) || a.values[i] == b.values[i]);
}

// GDAL takes a table without separators for none; `check` lists what each column is taken for.
TEST_F(Ensemble, ATableOfOneColumnAndWhatItsColumnsAreTakenFor) {
    write("one.csv", "material.friction-angle\n12\n\"15\"\n   \n");
    write_study("sampling = table:one.csv\n", "");
    succeeded(run());
    ASSERT_EQ(members().size(), 2U);  // a line of blanks is no member
    EXPECT_EQ(members()[1]["material.friction-angle"], "15");
    write("three.csv", "member,material.friction-angle,weight\n0,12,1\n1,14,2\n");
    write_study("sampling = table:three.csv\n", "");
    const Outcome outcome = succeeded(frana({"check", "study.ini", "--json"}));
    std::vector<std::pair<std::string, std::string>> uses;
    const Json document = parse_json(outcome.out);
    for (const Json& column : document["columns"])
        uses.emplace_back(column["name"].get<std::string>(), column["use"].get<std::string>());
    EXPECT_EQ(uses,
              (std::vector<std::pair<std::string, std::string>>{{"member", "a value of an earlier study, not used"},
                                                                {"material.friction-angle", "varied"},
                                                                {"weight", "weight of the member"}}));
}

TEST_F(Ensemble, CheckWarnsOfTheReleaseAsThatOfTheSceneDoes) {
    write_study("samples = 4\n", "[set]\nrelease.thickness = 90\n" + k_two_keys);
    const Outcome check = succeeded(frana({"check", "study.ini"}));
    expect_words(check.err, {"release step of", "too thick for depth-averaging"});
}

// What the pages of a run tell of a release that no outline shows has no page in a study.
TEST_F(Ensemble, AReleaseThinnerThanTheTraceIsAWarningOfItsRuns) {
    write_study("samples = 2\n", "[set]\noutput.trace-threshold = 9\n" + k_two_keys);
    succeeded(run());
    EXPECT_NE(parse_json(read_text(path("out/summary.json")))["warnings"].dump().find(
                  "of flow thinner than output.trace-threshold = 9 m"),
              std::string::npos);
}

// A single run warns that its front still moved; twelve of them said nothing.
TEST_F(Ensemble, WhatItsRunsWarnOfReachesEveryPage) {
    write_study("samples = 8\n", "[set]\ntime.end = 0.6\noutput.report = on\n" + k_two_keys);  // they run on to 6 s
    const Outcome outcome = run({"--strict"});
    EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
    const Json summary = parse_json(read_text(path("out/summary.json")));
    EXPECT_EQ(summary["run_troubles"]["cut"], 8);
    EXPECT_GT(summary["run_troubles"]["greatest_moving_fraction"].get<double>(), 0.5);
    ASSERT_FALSE(summary["warnings"].empty());
    EXPECT_NE(summary["warnings"][0].get<std::string>().find("8 of 8 runs cut while moving"), std::string::npos);
    for (const auto& row : members()) {
        EXPECT_EQ(row.at("stop_reason"), "end-time");
        EXPECT_GT(std::stod(row.at("moving_fraction")), 0.5);
        EXPECT_GE(std::stoi(row.at("warnings")), 1);
    }
    // The member that is named is the one that moves most, to the two digits of the sentence.
    double most = 0;
    std::map<std::string, double> moving;
    for (const auto& row : members())
        most = std::max(most, moving[row.at("member")] = std::stod(row.at("moving_fraction")));
    const std::string told = summary["warnings"].dump(), before = "most of all member ";
    const std::size_t named = told.rfind(before, told.find(": the flow still moves")) + before.size();
    EXPECT_NEAR(moving.at(told.substr(named, told.find(':', named) - named)), most, 0.01) << told;
    const std::string report = read_text(path("out/report.html"));
    EXPECT_LT(report.find("8 of 8 runs cut while moving"), report.find("id=\"answer\""));
    // Where they came not yet, they might have come.
    const GDALDatasetUniquePtr file(GDALDataset::Open(path("out/probability_depth_0.1.tif").c_str()));
    ASSERT_EQ(file->GetRasterCount(), 3);
    std::vector<double> p(static_cast<std::size_t>(k_columns * k_rows)), upper = p;
    for (const auto& [band, values] : {std::pair(1, &p), {3, &upper}})
        ASSERT_EQ(file->GetRasterBand(band)->RasterIO(GF_Read, 0, 0, k_columns, k_rows, values->data(), k_columns,
                                                      k_rows, GDT_Float64, 0, 0),
                  CE_None);
    std::size_t unknown = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        EXPECT_LE(p[i], upper[i]);
        unknown += p[i] == 0 && upper[i] == 1 ? 1 : 0;
    }
    EXPECT_GT(unknown, p.size() / 4);
    succeeded(run({"--overwrite"}));
    for (const auto& [strict, code] : {std::pair("--strict", 3), {"--quiet", 0}})
        EXPECT_EQ(frana({"run", "scene.ini", "--out", "one", "--overwrite", strict, "--set", "time.end=3"}).exit_code,
                  code);
}

TEST_F(Ensemble, RunsThatLeaveTheGroundAreTold) {
    write_study("samples = 4\n", "[set]\ntime.end = 30\nterrain.bounds = 527000 5094000 527100 5094150\n" + k_two_keys);
    succeeded(run());
    const Json summary = parse_json(read_text(path("out/summary.json")));
    EXPECT_EQ(summary["run_troubles"]["left_ground"], 4);
    EXPECT_NE(summary["warnings"][0].get<std::string>().find("4 of 4 runs left the domain"), std::string::npos);
    for (const auto& row : members()) EXPECT_GT(std::stod(row.at("left_domain_fraction")), 0.5);
    // All runs are open: nobody knows how far any of them would have come.
    for (const char* quantile : {"q05", "q50", "q95"})
        EXPECT_TRUE(summary["figures"]["runout_m"]["upper_bound"][quantile].is_null()) << quantile;
    const GDALDatasetUniquePtr file(GDALDataset::Open(path("out/quantile_max_depth_95.tif").c_str()));
    EXPECT_NE(std::string(file->GetRasterBand(1)->GetDescription()).find("at least; without an upper bound"),
              std::string::npos);
}

// Records are known by what they contain: in another order, and in other files.
TEST_F(Ensemble, RecordsInFilesOfTheirOwnAndInAnotherOrderAreUsed) {
    write_study("samples = 24\n", k_two_keys);
    succeeded(frana({"ensemble", "study.ini", "--out", "whole", "--quiet"}));
    (void)stop_after(6, SIGTERM);
    const std::vector<KeptRecord> kept = records();
    const std::string bytes = read_text(path(kept.at(5).file));
    const auto record = [&](std::size_t i) { return bytes.substr(kept[i].at, kept[i].size); };
    write(kept[0].file, record(3) + record(1) + record(0));
    write(fs::path(kept[0].file).replace_filename("records_00777.frana"), record(2));
    succeeded(run({"--resume"}));
    EXPECT_NE(read_text(path("out/log.txt")).find("computed 20 members"), std::string::npos);
    expect_same("whole", "out");
}

// Once and twice; after a signal the same command with --resume.
TEST_F(Ensemble, AnExtendedStudyIsThatOfAllItsMembers) {
    for (const std::string sampling : {"sobol", "random"}) {
        const std::string head = "sampling = " + sampling + "\nsamples = ";
        write_study(head + "36\n", k_two_keys);
        succeeded(frana({"ensemble", "study.ini", "--out", "whole-" + sampling, "--quiet"}));
        write_study(head + "10\n", k_two_keys);
        succeeded(run({"--overwrite"}));
        succeeded(frana({"ensemble", "out", "--extend", "12", "--quiet"}));  // named by its result
        EXPECT_EQ(members().size(), 22U);
        EXPECT_NE(read_text(path("out/log.txt")).find("computed 12 members"), std::string::npos);
        succeeded(run({"--extend", "14", "--threads", "1"}));
        expect_same("whole-" + sampling, "out");
    }
    StartedProgram program(folder_.string(), {"ensemble", "study.ini", "--out", "out", "--extend", "200"});
    EXPECT_TRUE(program.wait_until([&] { return records().size() > 36; }));
    program.send(SIGTERM);
    ASSERT_EQ(program.wait().exit_code, 128 + SIGTERM);
    EXPECT_EQ(members().size(), 36U) << "the older result stays until then";
    refusal_of(run({"--extend", "200"}), {"an interrupted study of it is kept"});
    succeeded(run({"--extend", "200", "--resume"}));
    EXPECT_EQ(members().size(), 236U);
}

TEST_F(Ensemble, WhatCannotBeExtendedIsRefusedWithTheRemedy) {
    const auto expect_refused = [&](const std::string& more, const std::string& words) {
        const auto before = files();
        expect_run_refused({words}, {"--extend", more});
        EXPECT_EQ(files(), before);
    };
    write_study("samples = 8\n", k_two_keys);
    expect_refused("4", "no complete study");
    succeeded(run());
    expect_refused("0", "is not a number of members to add");
    expect_refused("1000000", "1 to 999992");
    write_study("samples = 8\nseed = 2\n", k_two_keys);
    expect_refused("4", "are of another study");
    write_study("samples = 8\n", "[set]\ntime.end = 3\n" + k_two_keys);
    expect_refused("4", "time.end");
    write_study("samples = 9\nsampling = morris\n", k_two_keys);
    expect_refused("4", "study.samples = 12 and --overwrite");
    write_study("samples = 8\nsampling = table:out/members.csv\n", "");
    expect_refused("4", "the table gives all members");
    write_study("samples = 8\n", k_two_keys);
    fs::resize_file(path("out/records.frana"), fs::file_size(path("out/records.frana")) - 1);
    const Outcome damaged = run({"--extend", "4"});
    EXPECT_NE(damaged.exit_code, 0);
    EXPECT_EQ(members().size(), 8U);
}

TEST_F(Ensemble, UntilStopsWhereTheErrorIsSmallEnough) {
    write_study("samples = 400\nuntil = 0.07\n", k_two_keys);
    succeeded(run());
    EXPECT_EQ(members().size(), 64U);  // of independent members 0.5 / sqrt(64) = 0.0625 at most
    EXPECT_LE(json_number(read_text(path("out/summary.json")), "largest_standard_error"), 0.0625);
}

TEST_F(Ensemble, SensitivitiesTellWhichKeyDecides) {
    write_study("samples = 160\n",
                "[vary]\nmaterial.friction-angle = uniform(10, 24)\nnumerics.cfl = uniform(0.4, 0.5)\n");
    succeeded(run());
    const gis::Table table = gis::read_table(path("out/sensitivity.csv"), "table");
    bool found = false;
    for (const auto& row : table.rows) {
        if (row[0] != "covered_area_m2") continue;
        EXPECT_EQ(row[7], "polynomial chaos");
        EXPECT_GT(std::stod(row[8]), 0.7);
        if (row[1] == "not explained") {
            found = true;
            EXPECT_NEAR(std::stod(row[2]), 1 - std::stod(row[8]), 1e-12);
            continue;
        }
        const double total = std::stod(row[3]);
        const bool decides = row[1] == "material.friction-angle";
        EXPECT_EQ(total > 0.5, decides) << row[1] << ": " << total;
        EXPECT_EQ(total < 0.3, !decides) << row[1] << ": " << total;
    }
    EXPECT_TRUE(found);
    EXPECT_TRUE(fs::exists(path("out/sensitivity_material.friction-angle.tif")));
}

TEST_F(Ensemble, MorrisDesignTellsWhichKeyMovesAFigure) {
    write_scene("stop-when-still = off\n[output]\nanimation = off\nframes = off\nmap-size = 640x480\n");
    write_study("samples = 12\nsampling = morris\n",
                "[vary]\nmaterial.friction-angle = uniform(10, 24)\nnumerics.cfl = uniform(0.4, 0.5)\n");
    succeeded(run());
    const gis::Table table = gis::read_table(path("out/sensitivity.csv"), "table");
    const auto place = [&](const std::string& column) {
        return static_cast<std::size_t>(std::find(table.columns.begin(), table.columns.end(), column) -
                                        table.columns.begin());
    };
    std::map<std::string, double> effects;
    for (const auto& row : table.rows)
        if (row[0] == "covered_area_m2" && row[1] != "not explained")
            effects[row[1]] = std::stod(row.at(place("effect")));
    EXPECT_GT(effects.at("material.friction-angle"), 5 * effects.at("numerics.cfl"));
    const std::string page = read_text(path("out/report.html"));
    EXPECT_NE(page.find("material.friction-angle"), std::string::npos);
    EXPECT_TRUE(fs::exists(path("out/charts/sensitivity.png")));
}

TEST_F(Ensemble, MapsChartsAndReportAreDrawnAndRenderDrawsTheRest) {
    write_scene("stop-when-still = off\n[output]\nanimation = off\nframes = off\nmap-size = 640x480\n");
    write_study("samples = 8\n", k_two_keys);
    succeeded(run());
    for (const std::string name :
         {"maps/probability_depth_0.1.png", "maps/probability_velocity_5.png", "maps/quantile_max_depth_95.png",
          "maps/sensitivity_material.turbulence.png", "charts/exceedance.png", "charts/sensitivity.png", "report.html",
          "members.gpkg", "study.ini", "scene.ini", "dtm.tif"})
        EXPECT_TRUE(fs::exists(path("out/" + name))) << name;
    succeeded(frana({"render", "out", "--map", "quantile_arrival_time_05", "--map", "hit_count"}));
    EXPECT_TRUE(fs::exists(path("out/maps/quantile_arrival_time_05.png")));
}

// The answer first, then maps, inputs and charts; in the language of the scene, warnings too.
TEST_F(Ensemble, TheReportHasTheAnswerFirstInTheLanguageOfTheScene) {
    write_scene("stop-when-still = off\n[output]\nanimation = off\nframes = off\nmap-size = 640x480\nlanguage = it\n");
    write_study("samples = 8\nuntil = 0.001\n", k_two_keys);
    succeeded(run());
    const std::string page = read_text(path("out/report.html")), summary = read_text(path("out/summary.json"));
    for (const std::string& problem : html_problems(page)) ADD_FAILURE() << problem;
    std::size_t before = 0;
    for (const std::string id : {"answer", "maps", "inputs", "charts", "warnings"}) {
        const std::size_t at = page.find("<h2 id=\"" + id + "\"");
        ASSERT_NE(at, std::string::npos) << id;
        EXPECT_GT(at, before) << id;
        before = at;
    }
    EXPECT_LT(page.find("<img "), page.find("<h2 id=\"maps\"")) << "the probability is on the first page";
    EXPECT_NE(page.find("<html lang=\"it\">"), std::string::npos);
    std::string text = page;  // without the spaces that keep a number beside its unit
    for (std::size_t at = 0; (at = text.find("\u00A0", at)) != std::string::npos;) text.replace(at, 2, " ");
    EXPECT_NE(text.find("8 su 8, campionamento sobol, seme 1"), std::string::npos);
    EXPECT_NE(page.find("study.until = 0.001 non è raggiunto con tutte le simulazioni"), std::string::npos);
    EXPECT_EQ(page.find("Standard error"), std::string::npos);
    EXPECT_EQ(json_text(summary, "date").size(), std::string("2026-11-24").size()) << "maps show it";
    // The areas of the answer are those of the map.
    const Raster map = gis::read_result_raster(path("out/probability_depth_0.1.tif"));
    double cells = 0;
    for (const double probability : map.values) cells += probability >= 0.5;
    std::string area = std::to_string(static_cast<int>(cells * map.grid.cell_area()));
    if (area.size() > 3) area.insert(area.size() - 3, ".");
    EXPECT_GT(cells, 10);
    EXPECT_NE(text.find(area + " (95 %: da "), std::string::npos) << area;
}

// Pressure is density times the speed squared, so its thresholds are those of the speed; the classes of a scheme
// with limits of depth are those of the depth.
TEST_F(Ensemble, PressureAndIntensityHaveTheProbabilitiesOfWhatTheyAreMadeOf) {
    write_scene("stop-when-still = off\n" + k_numbers_only +
                "depth-thresholds = 0.1 0.2 0.5\nvelocity-thresholds = 4\npressure-thresholds = 32\n"
                "[material]\ndensity = 2000\n[hazard]\nscheme = own.ini\n");
    write("own.ini", own_scheme("depth > ", "0.2 m", "0.5 m"));
    write_study("samples = 12\n", k_two_keys);
    succeeded(run());
    const auto expect_alike = [&](const std::string& a, const std::string& b) {
        for (const std::string& name : {a, b}) EXPECT_TRUE(fs::exists(path("out/" + name + ".qml"))) << name;
        const Raster first = gis::read_result_raster(path("out/" + a + ".tif")),
                     second = gis::read_result_raster(path("out/" + b + ".tif"));
        double between = 0;
        for (std::size_t i = 0; i < first.values.size(); ++i) {
            ASSERT_EQ(first.values[i], second.values[i]) << a << ", cell " << i;
            between += first.values[i] > 0 && first.values[i] < 1 ? 1 : 0;
        }
        EXPECT_GT(between, 10) << a;
    };
    expect_alike("probability_pressure_32", "probability_velocity_4");  // 2000 * 4^2 / 1000
    expect_alike("probability_intensity_2", "probability_depth_0.2");
    expect_alike("probability_intensity_3", "probability_depth_0.5");
    expect_alike("probability_intensity_1", "probability_depth_0.1");  // the default of hazard.minimum-depth
}

TEST_F(Ensemble, CheckTellsMembersTimeAndMemory) {
    write_study("samples = 30\n", k_two_keys);
    const auto before = files();
    const Outcome outcome = succeeded(frana({"check", "study.ini"}));
    expect_words(outcome.out, {"is ready to run", "material.turbulence log-uniform(300, 3000)",
                               "30, sampling sobol, seed 1", "estimated time", "memory", "-ensemble"});
    EXPECT_EQ(files(), before);
}

}  // namespace
}  // namespace frana::test
