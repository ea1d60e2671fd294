// SPDX-License-Identifier: Apache-2.0
// Twin experiments: outlines of runs with known values, drawn as a surveyor would who errs; the intervals of the
// calibration must contain the known values.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>

#include "analysis/trace.h"
#include "app/store/interrupted_run.h"
#include "app/study/plan/sampling.h"
#include "app/study/pool/member_runs.h"
#include "app/study/publish/publish_calibration.h"
#include "gis/raster/footprint.h"
#include "gis/raster/raster_in.h"
#include "gis/vector/vector_out.h"
#include "support/tiny_scene.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t k_twins = 20, k_least_held = 17;

/// Errors of a survey: a smooth field of displacements with a standard deviation of one cell, correlated over about
/// eight cells, as an outline drawn by hand on a photograph has.
class SurveyError {
  public:
    explicit SurveyError(unsigned seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> angle(0, 2 * std::numbers::pi), part(0.5, 1.5);
        for (Wave& wave : waves_) {
            const double direction = angle(random), number = 2 * std::numbers::pi / (k_length * part(random));
            wave = {number * std::cos(direction), number * std::sin(direction), angle(random), angle(random)};
        }
    }
    [[nodiscard]] Point operator()(Point place) const {
        Point moved = place;
        const double amplitude = k_size * std::sqrt(2.0 / static_cast<double>(std::size(waves_)));
        for (const Wave& wave : waves_) {
            const double phase = wave.x * (place.x - k_west) + wave.y * (place.y - k_south);
            moved.x += amplitude * std::sin(phase + wave.first);
            moved.y += amplitude * std::sin(phase + wave.second);
        }
        return moved;
    }

  private:
    static constexpr double k_size = k_cell, k_length = 8 * k_cell;
    struct Wave {
        double x, y, first, second;
    };
    Wave waves_[12];
};

/// An outline as it was surveyed, along the edges of cells: displaced corners may make it cross itself.
MultiPolygon drawn_by(const SurveyError& error, MultiPolygon outline, const GridSpec& grid) {
    for (Polygon& polygon : outline) {
        for (Point& point : polygon.outer) point = error(point);
        for (auto& hole : polygon.holes)
            for (Point& point : hole) point = error(point);
    }
    return gis::polygonise(gis::coverage(outline, grid));
}

class Twin : public TinyScene {
  protected:
    Twin() {
        write_scene("stop-when-still = off\n" + k_numbers_only + "[scar]\nperimeter = perimeter.geojson\n");
        write(
            "study.ini",
            "[study]\nscene = scene.ini\nsamples = 160\nrefine = 0\ncoarse = 1\nseed = 3\n[objective]\njaccard = "
            "1\n[set]\n"
            "time.end = 15\n[vary]\nmaterial.friction-angle = uniform(8, 26)\nrelease.volume = uniform(2000, 8000)\n");
    }
    [[nodiscard]] std::string made(const std::string& name) const {
        fs::create_directories(fs::path(path(name)) / "records");
        return path(name);
    }
};

// One design of runs serves all twins: they differ in their truths, which are a Latin hypercube, and in their surveys.
TEST_F(Twin, IntervalsHoldTheTruth) {
    app::RunLog log(true);
    app::study::CalibrationInput input = app::study::prepare_calibration(
        app::study::read_calibration_texts(path("study.ini"), {}, log), std::nullopt, log);
    auto runs = app::study::run_calibration(input, {made("design"), 2, true}, log);
    ASSERT_TRUE(runs);

    app::study::StudySpec drawn = input.spec().study;
    drawn.samples = k_twins;
    drawn.seed = 8;
    drawn.sampling = app::study::Sampling::latin_hypercube;
    app::study::StudyInput truths = input.coarse.front();
    Problems none;
    truths.table = app::study::members_at(input.spec(), 0, app::study::draw_places(drawn), none);
    ASSERT_TRUE(app::study::MemberRunner(truths, made("truths"), 2, true).run_until(k_twins));

    const double threshold = truths.base.spec.output.trace_threshold;
    std::vector<std::size_t> held(input.spec().key_count());
    std::vector<double> width(held.size());
    const std::string records = runs->design.events.front().records;
    for (std::size_t twin = 0; twin < k_twins; ++twin) {
        const auto truth = app::study::read_record(app::record_file(path("truths"), twin));
        ASSERT_TRUE(truth && truth->finished());
        const MultiPolygon outline =
            gis::polygonise(trace_mask(truth->raster(app::study::Quantity::depth, truths.base.scene.grid), threshold));
        app::study::StudyInput surveyed = input.coarse.front();
        PolygonFeature feature;
        feature.parts = drawn_by(SurveyError(static_cast<unsigned>(twin)), outline, truths.base.scene.grid);
        surveyed.base.scar->features = {feature};
        runs->design.events = {app::study::compare_members(input, 0, surveyed, records)};
        const app::study::CalibrationResult result = app::study::calibration_result(input, *runs);
        for (std::size_t k = 0; k < held.size(); ++k) {
            const double value = truths.table.numbers[twin][k];
            const app::study::KeyPosterior& after = result.posteriors[k];
            held[k] += after.low <= value && value <= after.high ? 1 : 0;
            width[k] += after.width / static_cast<double>(k_twins);
        }
        // The survey is not exact: no member agrees with it wholly, and one near the truth agrees well.
        EXPECT_GT(result.events.front().fitted.best_score, 0.7);
        EXPECT_LT(result.events.front().fitted.best_score, 0.99);
    }
    for (std::size_t k = 0; k < held.size(); ++k) {
        EXPECT_GE(held[k], k_least_held) << input.spec().study.vary[k].key << ", mean width " << width[k];
        RecordProperty("held_" + std::to_string(k), static_cast<int>(held[k]));
        RecordProperty("width_" + std::to_string(k), std::to_string(width[k]));
    }
    // Intervals that were as wide as before would hold the truth too, and say nothing.
    EXPECT_LT(width[0], 0.5);
    EXPECT_LT(width[1], 0.8);
}

/// The whole command, from coarse cells to the scene's own, for each twin: FRANA_TWINS of them.
TEST_F(Twin, IntervalsOfTheCommandHoldTheTruth) {
    const char* const asked = std::getenv("FRANA_TWINS");
    const std::size_t twins = asked == nullptr ? 1 : static_cast<std::size_t>(std::max(1, std::atoi(asked)));
    std::size_t held = 0;
    for (std::size_t twin = 0; twin < twins; ++twin) {
        std::mt19937 random(static_cast<unsigned>(100 + twin));
        const double angle = std::uniform_real_distribution<double>(8, 26)(random),
                     volume = std::uniform_real_distribution<double>(2000, 8000)(random);
        const std::string out = "truth" + std::to_string(twin);
        const Outcome truth = frana({"run", "scene.ini", "--out", out, "--quiet", "--set", "time.end=15", "--set",
                                     "material.friction-angle=" + std::to_string(angle), "--set",
                                     "release.volume=" + std::to_string(volume)});
        ASSERT_EQ(truth.exit_code, 0) << truth.err;
        const Raster depth = gis::read_result_raster(path(out + "/max_depth.tif"));
        const MultiPolygon scar = drawn_by(SurveyError(static_cast<unsigned>(100 + twin)),
                                           gis::polygonise(trace_mask(depth, k_trace_threshold)), depth.grid);
        gis::write_outlines(path("scar.gpkg"), depth.grid.crs_wkt, {{"scar", {{scar, {}, {}}}}});
        write("study.ini", "[study]\nscene = scene.ini\nsamples = 96\nrefine = 64\nseed = " + std::to_string(twin) +
                               "\n[objective]\njaccard = 1\n[set]\ntime.end = 15\nscar.perimeter = scar.gpkg\n[vary]\n"
                               "material.friction-angle = uniform(8, 26)\nrelease.volume = uniform(2000, 8000)\n");
        const Outcome outcome = frana({"calibrate", "study.ini", "--out", "out", "--overwrite", "--quiet"});
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
        const Json friction = parse_json(read_text(path("out/calibration.json")))["intervals"][0];
        held += friction["q05"].get<double>() <= angle && angle <= friction["q95"].get<double>() ? 1 : 0;
        EXPECT_LT(friction["width_of_prior"].get<double>(), 0.9);
    }
    RecordProperty("held", static_cast<int>(held));
    if (twins >= k_twins) {
        EXPECT_GE(held * k_twins, k_least_held * twins) << held << " of " << twins;
    }
}

}  // namespace
}  // namespace frana::test
