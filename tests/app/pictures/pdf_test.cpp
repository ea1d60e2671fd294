// SPDX-License-Identifier: Apache-2.0
// Every PDF written by the program shows the same as the PNG beside it.
#include <cstdlib>

#include "support/pdf_check.h"
#include "support/tiny_scene.h"

namespace frana::test {
namespace {

class Pdf : public TinyScene {
  protected:
    // GDAL's threads damaged them, pictures of more than a megabyte; a machine with one processor has none.
    Pdf() { ::setenv("GDAL_NUM_THREADS", "2", 1); }
    ~Pdf() override { ::unsetenv("GDAL_NUM_THREADS"); }

    // Returns those below a folder; every one must be valid.
    [[nodiscard]] std::vector<std::string> good_pdfs(const std::string& folder) const {
        std::vector<std::string> found;
        for (const std::string& file : files()) {
            if (!file.starts_with(folder) || !file.ends_with(".pdf")) continue;
            const std::string stem = path(file.substr(0, file.size() - 4));
            found.push_back(file.substr(folder.size()));
            EXPECT_EQ(gis::test::pdf_problems(stem + ".pdf", gis::test::pixels_of(stem + ".png"), 150),
                      std::vector<std::string>{})
                << file;
        }
        return found;
    }
};

TEST_F(Pdf, OfEveryKindShowsThePixelsOfItsPng) {
    write_polygon("scar", {{20, 50}, {120, 50}, {120, 100}, {20, 100}});
    write_scene(
        "[scar]\nperimeter = scar.geojson\n[output]\nmap-formats = png, pdf\nmap-size = 800x600\n"
        "maps = max_depth, max_depth_3d\nanimation = off\n[time]\nframe-interval = 1\n");
    const Outcome run = frana({"run", "scene.ini", "--out", "result", "--threads", "2"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(good_pdfs("result/"),
              (std::vector<std::string>{"charts/profile_flow_path.pdf", "charts/scores.pdf", "charts/timeseries.pdf",
                                        "comparison.pdf", "maps/max_depth.pdf", "maps/max_depth_3d.pdf"}));
    const Outcome plates = frana({"render", "result", "--plates", "--size", "A4", "--out", "plates"});
    ASSERT_EQ(plates.exit_code, 0) << plates.err;
    EXPECT_EQ(good_pdfs("plates/"),
              (std::vector<std::string>{"comparison.pdf", "initial_state.pdf", "snapshots.pdf", "stresses.pdf"}));
    const Outcome foreign = frana({"render", "result/max_depth.tif", "--dtm", "result/dtm.tif", "--format", "png",
                                   "--format", "pdf", "--size", "800x600", "--out", "foreign"});
    ASSERT_EQ(foreign.exit_code, 0) << foreign.err;
    EXPECT_EQ(good_pdfs("foreign/"), std::vector<std::string>{"max_depth.pdf"});
}

}  // namespace
}  // namespace frana::test
