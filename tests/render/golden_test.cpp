// SPDX-License-Identifier: Apache-2.0
// A few reference pictures, stored at a quarter of their size: they detect what tests of the structure do not (a
// palette reversed, light from below, a missing layer). FRANA_WRITE_GOLDEN=1 rewrites them; inspect them then.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "render/chart/chart.h"
#include "render/map/map2d.h"
#include "render/view/view3d.h"
#include "scenes.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"

namespace frana::render {
namespace {

constexpr int k_part = 4;

Image reduced(const Image& image) {
    Image small(image.width / k_part, image.height / k_part);
    for (int row = 0; row < small.height; ++row) {
        for (int column = 0; column < small.width; ++column) {
            for (int k = 0; k < 3; ++k) {
                int sum = 0;
                for (int i = 0; i < k_part * k_part; ++i)
                    sum += image.pixel(k_part * column + i % k_part, k_part * row + i / k_part)[k];
                small.pixel(column, row)[k] = static_cast<std::uint8_t>(sum / (k_part * k_part));
            }
        }
    }
    return small;
}

Image read_png(const std::string& path) {
    vtkNew<vtkPNGReader> reader;
    if (reader->CanReadFile(path.c_str()) == 0) return {};
    reader->SetFileName(path.c_str());
    reader->Update();
    const int* size = reader->GetOutput()->GetDimensions();
    Image image(size[0], size[1]);
    for (int row = 0; row < image.height; ++row) {  // VTK counts rows from below
        const auto* line =
            static_cast<const std::uint8_t*>(reader->GetOutput()->GetScalarPointer(0, image.height - 1 - row, 0));
        std::copy_n(line, 3 * image.width, image.pixel(0, row));
    }
    return image;
}

void expect_like(const Image& drawn, const std::string& name) {
    const Image now = reduced(drawn);
    const std::string path = std::string(FRANA_GOLDEN_DIR) + "/" + name + ".png";
    if (std::getenv("FRANA_WRITE_GOLDEN") != nullptr) write_png(path, now);
    const Image then = read_png(path);
    ASSERT_EQ(then.width, now.width) << path;
    ASSERT_EQ(then.height, now.height);
    double sum = 0;
    int far = 0;
    for (std::size_t i = 0; i < now.rgb.size(); ++i) {
        const int difference = std::abs(now.rgb[i] - then.rgb[i]);
        sum += difference;
        far += difference > 48 ? 1 : 0;
    }
    // Another processor or Mesa moves edges by a pixel and tones by a few: a block of 16 pixels differs by up to a
    // fifth in places. A missing layer or a wrong palette changes the mean by 5 and more.
    EXPECT_LT(sum / static_cast<double>(now.rgb.size()), 2) << name;
    EXPECT_LT(far, static_cast<int>(now.rgb.size()) / 100) << name;
}

TEST(Golden, MapWithEverything) {
    const Raster ground = test::terrain(), layer = test::tongue();
    MapSpec spec = test::crowded_map(ground, layer, 960, 720);
    spec.palette = "velocity";
    expect_like(draw_map(spec), "crowded_map");
}

TEST(Golden, View) {
    const Raster ground = test::terrain(), layer = test::tongue();
    ViewSpec spec;
    spec.title = "View";
    spec.legend_title = "Depth";
    spec.unit = "m";
    spec.terrain = &ground;
    spec.layer = &layer;
    spec.thickness = &layer;
    spec.width = 640;
    spec.height = 480;
    expect_like(draw_view(spec), "view");
}

TEST(Golden, Chart) {
    Chart chart{"Chart", "", "foot", 1, {}};
    ChartSeries curve{"curve", {0, 114, 178}, {}};
    for (int i = 0; i <= 50; ++i) curve.points.push_back({i / 5.0, std::sin(i / 5.0)});
    chart.panels = {{"Panel", "x [m]", "y [m]", {curve}}};
    expect_like(draw_chart(chart, 640, 480), "chart");
}

}  // namespace
}  // namespace frana::render
