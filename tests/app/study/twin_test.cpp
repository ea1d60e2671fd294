// SPDX-License-Identifier: Apache-2.0
// Twin experiments: outlines of runs with known values, drawn as a surveyor would who errs; the intervals of the
// calibration must contain the known values.
#include <ogr_geometry.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>
#include <set>

#include "analysis/trace.h"
#include "app/study/plan/sampling.h"
#include "app/study/publish/publish_calibration.h"
#include "gis/raster/footprint.h"
#include "gis/raster/raster_in.h"
#include "gis/vector/vector_out.h"
#include "support/tiny_scene.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

/// Errors of a survey: a Gaussian field of displacements, as a sum of random waves (Shinozuka 1971), of the correlation
/// exp(-s^2 / (2 a^2)), a = 4 cells, whose integral is sqrt(2 pi) a.
class SurveyError {
  public:
    /// @param size standard deviation across the outline [m]
    SurveyError(unsigned seed, double size) : size_(size) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> angle(0, 2 * std::numbers::pi);
        std::normal_distribution<double> number(0, 1 / k_alike);
        for (Wave& wave : waves_) wave = {number(random), number(random), angle(random), angle(random)};
    }
    [[nodiscard]] Point operator()(Point place) const {
        Point moved = place;
        const double amplitude = size_ * std::sqrt(2.0 / static_cast<double>(std::size(waves_)));
        for (const Wave& wave : waves_) {
            const double phase = wave.x * (place.x - k_west) + wave.y * (place.y - k_south);
            moved.x += amplitude * std::sin(phase + wave.first);
            moved.y += amplitude * std::sin(phase + wave.second);
        }
        return moved;
    }
    static constexpr double k_alike = 4 * k_cell;
    static inline const double k_length = std::sqrt(2 * std::numbers::pi) * k_alike;

  private:
    struct Wave {
        double x, y, first, second;
    };
    double size_;
    Wave waves_[64];
};

/// An outline wider by a distance everywhere.
MultiPolygon widened(const MultiPolygon& outline, double by) {
    OGRMultiPolygon all;
    for (const Polygon& polygon : outline) {
        OGRPolygon one;
        OGRLinearRing ring;
        for (const Point& point : polygon.outer) ring.addPoint(point.x, point.y);
        ring.closeRings();
        one.addRing(&ring);
        all.addGeometry(&one);
    }
    const std::unique_ptr<OGRGeometry> wide(all.Buffer(by));
    wide->segmentize(k_cell / 2);
    MultiPolygon result;
    const auto add = [&](const OGRPolygon& polygon) {
        Polygon& one = result.emplace_back();
        for (const OGRPoint& point : *polygon.getExteriorRing()) one.outer.push_back({point.getX(), point.getY()});
    };
    if (wkbFlatten(wide->getGeometryType()) == wkbPolygon)
        add(*wide->toPolygon());
    else
        for (const OGRPolygon* polygon : *wide->toMultiPolygon()) add(*polygon);
    return result;
}

/// An outline as it was surveyed, along the edges of cells: displaced corners may make it cross itself.
MultiPolygon drawn_by(const SurveyError& error, MultiPolygon outline, const GridSpec& grid) {
    for (Polygon& polygon : outline) {
        for (Point& point : polygon.outer) point = error(point);
        for (auto& hole : polygon.holes)
            for (Point& point : hole) point = error(point);
    }
    return gis::polygonise(gis::coverage(outline, grid));
}

/// In what the surveyed world differs from the one that is calibrated.
struct World {
    std::string name;
    double wider = 0;                   ///< the outline, everywhere [cells]
    std::vector<std::string> set = {};  ///< keys of the surveyed run alone
    std::string stated = "";            ///< lines of the calibration's [set]
};

/// Where a twin's truth is in its posterior, by key.
struct TwinResult {
    std::vector<double> rank;    ///< probability below the truth
    std::vector<double> spread;  ///< standard deviation of the posterior, in the distribution's places
    std::vector<double> error;   ///< posterior mean minus truth, likewise
    std::size_t members = 0;
    double chi_square = 0, unshifted = 0, pieces = 0, scatter = 0;
    std::vector<std::string> told;  ///< kinds of doubts
};

constexpr double k_angles[] = {8, 26}, k_volumes[] = {2000, 8000};

class Twin : public TinyScene {
  protected:
    Twin() { write_scene("stop-when-still = off\n" + k_numbers_only); }

    /// @param noise standard deviation of the survey [cells]
    [[nodiscard]] TwinResult calibrated(unsigned twin, double noise, std::int64_t most, const World& world = {}) const {
        std::mt19937 random(100 + twin);
        std::uniform_real_distribution<double> place(0, 1);
        const double truth[] = {place(random), place(random)};
        const std::string out = "truth" + std::to_string(twin);
        std::vector<std::string> arguments{
            "run",
            "scene.ini",
            "--out",
            out,
            "--overwrite",
            "--quiet",
            "--set",
            "numerics.scheme=finite-volume",
            "--set",
            "time.end=15",
            "--set",
            "material.friction-angle=" + std::to_string(k_angles[0] + truth[0] * (k_angles[1] - k_angles[0])),
            "--set",
            "release.volume=" + std::to_string(k_volumes[0] + truth[1] * (k_volumes[1] - k_volumes[0]))};
        for (const std::string& one : world.set) {
            arguments.emplace_back("--set");
            arguments.push_back(one + (one.starts_with("terrain.error") ? ", " + std::to_string(twin) : ""));
        }
        succeeded(frana(arguments));
        const Raster depth = gis::read_result_raster(path(out + "/max_depth.tif"));
        const SurveyError error(1000 + twin, noise * k_cell);
        MultiPolygon trace = gis::polygonise(trace_mask(depth, k_trace_threshold));
        if (world.wider != 0) trace = widened(trace, world.wider * k_cell);
        gis::write_shapes(path("scar.gpkg"), depth.grid.crs_wkt,
                          {{"scar", {{{drawn_by(error, trace, depth.grid), {}, {}}, {}, {}}}}});
        write("study.ini", "[study]\nscene = scene.ini\nscheme = finite-volume\nsamples = " + std::to_string(most) +
                               "\nseed = " + std::to_string(twin) +
                               "\n[objective]\njaccard = 1\n[set]\ntime.end = 15\nobserved.perimeter = scar.gpkg\n"
                               "observed.perimeter-error = " +
                               std::to_string(noise * k_cell) + "\nobserved.error-length = " +
                               std::to_string(SurveyError::k_length) + "\n" + world.stated +
                               "[vary]\nmaterial.friction-angle = uniform(8, 26)\n"
                               "release.volume = uniform(2000, 8000)\n");
        app::RunLog log(true);
        app::study::StudyInput input = app::study::prepare_study(
            app::study::read_study_texts(path("study.ini"), app::study::StudyKind::calibration, {}, log), std::nullopt,
            log);
        const std::string folder = path("members" + std::to_string(twin) + "_" + std::to_string(noise) + world.name);
        fs::create_directories(folder);
        const auto runs = app::study::run_calibration(input, {folder, 2, true}, log);
        const app::study::CalibrationResult result = app::study::calibration_result(input, *runs);
        const app::study::EventRuns& event = runs->events[0];
        TwinResult twin_result;
        twin_result.members = event.searched;
        twin_result.chi_square = event.agreements[result.events[0].best].chi_square;
        twin_result.unshifted = twin_result.chi_square;
        for (std::size_t i = 0; i < event.searched; ++i)
            twin_result.unshifted = std::fmin(twin_result.unshifted, event.agreements[i].unshifted);
        twin_result.pieces = event.pieces;
        twin_result.scatter = event.scatter;
        for (const auto& doubt : result.doubts) twin_result.told.push_back(doubt.kind);
        const app::study::KeyDraws& after = result.events[0].after;
        for (std::size_t k = 0; k < 2; ++k) {
            double below = 0, mean = 0, square = 0;
            for (std::size_t i = 0; i < after.weights.size(); ++i) {
                const double weight = after.weights[i], at = after.sample.places[i][k];
                below += at < truth[k] ? weight : 0;
                mean += weight * at;
                square += weight * at * at;
            }
            twin_result.rank.push_back(below);
            twin_result.spread.push_back(std::sqrt(square - mean * mean));
            twin_result.error.push_back(mean - truth[k]);
        }
        fs::remove_all(folder);
        return twin_result;
    }
};

/// Probability that the ranks of n uniform values are at least so uneven (Kolmogorov and Smirnov, asymptotic with
/// Stephens' correction).
double uniform_probability(std::vector<double> ranks) {
    std::sort(ranks.begin(), ranks.end());
    const auto n = static_cast<double>(ranks.size());
    double greatest = 0;
    for (std::size_t i = 0; i < ranks.size(); ++i)
        greatest =
            std::max({greatest, static_cast<double>(i + 1) / n - ranks[i], ranks[i] - static_cast<double>(i) / n});
    const double x = greatest * (std::sqrt(n) + 0.12 + 0.11 / std::sqrt(n));
    double sum = 0;
    for (int j = 1; j <= 100; ++j) sum += 2 * (j % 2 == 1 ? 1 : -1) * std::exp(-2.0 * j * j * x * x);
    return std::clamp(sum, 0.0, 1.0);
}

// Members run in batches: what a batch reached must not decide which cells of a surveyed deposit count.
TEST_F(Twin, AllBatchesAreComparedOverTheSameCells) {
    ran("long", {"time.end=15", "material.friction-angle=8"});
    write_polygon("small", {{20, 60}, {40, 60}, {40, 90}, {20, 90}});
    write("study.ini",
          "[study]\nscene = scene.ini\nsamples = 4\n[objective]\njaccard = 1\ndeposit-depth = 1\n[set]\ntime.end = 15\n"
          "observed.perimeter = small.geojson\nobserved.deposit = long/final_depth.tif\n"
          "observed.perimeter-error = 5\nobserved.deposit-error = 0.2\nobserved.error-length = 20\n"
          "[vary]\nmaterial.friction-angle = uniform(8, 26)\n");
    app::RunLog log(true);
    const app::study::StudyInput input = app::study::prepare_study(
        app::study::read_study_texts(path("study.ini"), app::study::StudyKind::calibration, {}, log), std::nullopt,
        log);
    const app::Prepared& base = input.own[0].base;
    const auto survey = [&](const CellWindow& reached) {
        return app::study::EventSurvey(base, input.spec().events[0], input.spec().objective, reached);
    };
    const app::study::EventSurvey of_none = survey({}),
                                  of_all = survey({0, 0, base.scene.grid.rows, base.scene.grid.columns});
    EXPECT_GT(of_none.pieces(), 6);  // of the outline 100 m / 20 m
    EXPECT_EQ(of_none.pieces(), of_all.pieces());
}

// With FRANA_TWINS twins of each noise it prints what they give; see share/doc/calibration.md.
TEST_F(Twin, IntervalsHoldTheTruth) {
    const char* const asked = std::getenv("FRANA_TWINS");
    const unsigned twins = asked == nullptr ? 2 : static_cast<unsigned>(std::max(1, std::atoi(asked)));
    for (const double noise : {0.25, 1.0, 2.0}) {
        if (asked == nullptr && noise != 1) continue;
        std::vector<std::vector<double>> ranks(2);
        std::vector<std::size_t> members;
        double spread[2] = {0, 0}, error[2] = {0, 0};
        for (unsigned twin = 0; twin < twins; ++twin) {
            const TwinResult one = calibrated(twin, noise, asked == nullptr ? 18 : 100);
            members.push_back(one.members);
            for (std::size_t k = 0; k < 2; ++k) {
                ranks[k].push_back(one.rank[k]);
                spread[k] += one.spread[k] * one.spread[k] / twins;
                error[k] += one.error[k] * one.error[k] / twins;
                if (asked != nullptr) continue;
                EXPECT_GT(one.rank[k], 0.005) << twin << " " << k;
                EXPECT_LT(one.rank[k], 0.995) << twin << " " << k;
                EXPECT_LT(one.spread[k], 0.2) << twin << " " << k;  // 0.29 of the distribution itself
            }
        }
        if (asked == nullptr) continue;
        std::sort(members.begin(), members.end());
        for (std::size_t k = 0; k < 2; ++k) {
            std::size_t half = 0, most = 0;
            for (const double rank : ranks[k]) {
                half += rank > 0.25 && rank < 0.75 ? 1 : 0;
                most += rank > 0.05 && rank < 0.95 ? 1 : 0;
            }
            std::printf(
                "noise %.2f cells, key %zu: 50 %% interval %.0f %%, 90 %% interval %.0f %%, KS p %.3f, spread %.4f, "
                "rms error %.4f, ratio %.2f; members median %zu, most %zu\n",
                noise, k, 100.0 * static_cast<double>(half) / twins, 100.0 * static_cast<double>(most) / twins,
                uniform_probability(ranks[k]), std::sqrt(spread[k]), std::sqrt(error[k]),
                std::sqrt(spread[k] / error[k]), members[members.size() / 2], members.back());
            std::fflush(stdout);
        }
    }
}

/// Whether a doubt says that the world is another one.
bool is_told(const TwinResult& twin) {
    return std::any_of(twin.told.begin(), twin.told.end(), [](const std::string& kind) {
        return kind == "survey-error" || kind == "outline-bias" || kind == "prior-limit";
    });
}

// With FRANA_TWINS twins of each world it prints in how many the calibration says that something is wrong.
TEST_F(Twin, WrongWorldsAreTold) {
    const char* const asked = std::getenv("FRANA_TWINS");
    const unsigned twins = asked == nullptr ? 1 : static_cast<unsigned>(std::max(1, std::atoi(asked)));
    const World worlds[] = {{"exact"},
                            {"dtm", 0, {"terrain.error=3, 40"}},
                            {"half", 0.5},
                            {"one", 1},
                            {"cohesion", 0, {"material.bed-friction=voellmy, cohesion", "material.cohesion=1500"}}};
    for (const World& world : worlds) {
        if (asked == nullptr && world.name != "exact" && world.name != "one") continue;
        unsigned told = 0;
        std::map<std::string, unsigned> kinds;
        for (unsigned twin = 0; twin < twins; ++twin) {
            const TwinResult one = calibrated(twin, 0.25, 60, world);
            told += is_told(one) ? 1 : 0;
            for (const std::string& kind : std::set<std::string>(one.told.begin(), one.told.end())) ++kinds[kind];
            if (asked == nullptr) {
                EXPECT_EQ(is_told(one), world.name != "exact") << world.name;
            }
            if (std::getenv("FRANA_TWIN_LINES") != nullptr)
                std::printf("%s %u: chi2 %.1f unshifted %.1f pieces %.1f scatter %.1f rank %.2f %.2f\n",
                            world.name.c_str(), twin, one.chi_square, one.unshifted, one.pieces, one.scatter,
                            one.rank[0], one.rank[1]);
        }
        if (asked == nullptr) continue;
        std::printf("%s: told in %u of %u;", world.name.c_str(), told, twins);
        for (const auto& [kind, count] : kinds) std::printf(" %s %u", kind.c_str(), count);
        std::printf("\n");
        std::fflush(stdout);
    }
}

}  // namespace
}  // namespace frana::test
