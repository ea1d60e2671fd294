// SPDX-License-Identifier: Apache-2.0
// Checkpoints of other formats are refused: this frana would not end their runs with the same bits.
#include <cmath>
#include <cstring>
#include <fstream>

#include "app/input/prepare.h"
#include "app/input/share_directory.h"
#include "app/store/checkpoint_file.h"
#include "app/store/own_files.h"
#include "app/store/scene_identity.h"
#include "gis/raster/raster_in.h"
#include "params/scene/read_scene.h"
#include "simulation/simulation.h"
#include "support/tiny_scene.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t k_format_place = 12;
constexpr std::int64_t k_saved_step = 8;

std::string in_format(std::uint32_t format, std::string file) {
    std::memcpy(file.data() + k_format_place, &format, sizeof format);
    return file;
}

class OlderCheckpoint : public TinyScene {
  protected:
    OlderCheckpoint() : log_(true), prepared_(prepared()) {
        EXPECT_GT(prepared_.scene.grid.origin_column, 0);
        EXPECT_GT(prepared_.scene.grid.origin_row, 0);
    }

    // Runs to the end, with a checkpoint as left by a killed run.
    Raster run_to_end(std::optional<OriginCell> told) {
        fs::create_directories(path("result.partial/checkpoint"));
        app::note_building(path("result.partial"));
        RunOptions options;
        options.after_step = [&](const Progress& now, const SaveState& state) {
            if (now.step != k_saved_step) return;
            app::write_checkpoint(file(),
                                  {app::checkpoint_build(),
                                   app::scene_identity(prepared_),
                                   now.step,
                                   now.time,
                                   now.end,
                                   1,
                                   {},
                                   {},
                                   told,
                                   {}},
                                  state);
        };
        const RunResult result = run(prepared_.scene, options);
        EXPECT_GT(result.steps, k_saved_step);
        return result.raster("max_depth");
    }
    [[nodiscard]] std::string file() const { return path("result.partial/checkpoint/step_000000000000008.frana"); }
    // --resume ends with the result of the run.
    void expect_resumes_to(const Raster& expected) {
        const Outcome outcome = succeeded(frana({"run", path("scene.ini"), "--out", "result", "--resume"}));
        EXPECT_NE(outcome.err.find("resuming from"), std::string::npos) << outcome.err;
        const Raster made = gis::read_result_raster(path("result/max_depth.tif"));
        ASSERT_EQ(made.values.size(), expected.values.size());
        int flooded = 0;
        for (std::size_t i = 0; i < made.values.size(); ++i) {
            if (std::isnan(made.values[i])) continue;
            ++flooded;
            ASSERT_EQ(static_cast<float>(made.values[i]), static_cast<float>(expected.values[i])) << i;
        }
        EXPECT_GT(flooded, 100);
    }

    app::RunLog log_;
    app::Prepared prepared_;

  private:
    app::Prepared prepared() {
        write_scene(k_numbers_only);
        return app::prepare(read_scene(path("scene.ini"), {}, app::share_directory()), log_);
    }
};

TEST_F(OlderCheckpoint, OfThisFormatUsesItsOrigin) {
    put_origin(prepared_.scene, {0, 0});
    expect_resumes_to(run_to_end(OriginCell{0, 0}));
}

TEST_F(OlderCheckpoint, OriginOutsideOfTheGridIsRefused) {
    run_to_end(OriginCell{k_columns, 0});
    refusal_of(frana({"run", path("scene.ini"), "--out", "result", "--resume"}),
               {"does not fit this program and scene"});
}

TEST_F(OlderCheckpoint, OfAnotherFormatIsRefusedWithAMessage) {
    run_to_end({});
    for (const auto& [format, age] : {std::pair<std::uint32_t, std::string>{1, "an older"},
                                      {app::k_checkpoint_format - 1, "an older"},
                                      {app::k_checkpoint_format + 1, "a newer"}}) {
        const std::string other = in_format(format, read_text(file()));
        std::ofstream(file(), std::ios::binary) << other;
        refusal_of(frana({"run", path("scene.ini"), "--out", "result", "--resume"}),
                   {"was written by " + age + " frana, in format " + std::to_string(format) + "; this one reads " +
                    std::to_string(app::k_checkpoint_format)});
    }
}

}  // namespace
}  // namespace frana::test
