// SPDX-License-Identifier: Apache-2.0
#include "gis/raster/picture_file.h"

#include <gdal.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include "gis/access/gdal_session.h"
#include "gis/raster/raster_source.h"
#include "support/files.h"
#include "support/pdf_check.h"

namespace frana::gis {
namespace {

/// Grey noise, which neither format compresses, or one colour.
void write_png(const std::string& path, int width, int height, bool noise) {
    GDALAllRegister();
    std::mt19937 random(7);
    std::vector<std::uint8_t> rgb(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 90);
    if (noise)
        for (std::uint8_t& value : rgb) value = static_cast<std::uint8_t>(random() % 256);
    const GdalDataset memory(GDALCreate(GDALGetDriverByName("MEM"), "", width, height, 3, GDT_Byte, nullptr));
    ASSERT_EQ(GDALDatasetRasterIO(memory.get(), GF_Write, 0, 0, width, height, rgb.data(), width, height, GDT_Byte, 3,
                                  nullptr, 3, 3 * width, 1),
              CE_None);
    const GdalDataset file(
        GDALCreateCopy(GDALGetDriverByName("PNG"), path.c_str(), memory.get(), FALSE, nullptr, nullptr, nullptr));
    ASSERT_TRUE(file);
}

TEST(PagePicture, KeepsASmallPictureAsItIs) {
    const test::Folder folder;
    write_png(folder.file("flat.png"), 400, 300, false);
    const PagePicture picture = page_picture(folder.file("flat.png"), 1600, 200'000);
    EXPECT_EQ(picture.mime, "image/png");
    EXPECT_EQ(picture.bytes, test::text_in(folder.file("flat.png")));
    EXPECT_EQ(picture.width, 400);
    EXPECT_EQ(picture.height, 300);
}

TEST(PagePicture, BringsALargeOneBelowItsLimits) {
    const test::Folder folder;
    write_png(folder.file("flat.png"), 2000, 1000, false);
    const PagePicture narrow = page_picture(folder.file("flat.png"), 800, 200'000);
    EXPECT_EQ(narrow.width, 800);
    EXPECT_EQ(narrow.height, 400);
    test::write_text(folder.file("flat.jpg"), narrow.bytes);
    const test::Pixels pixels = test::pixels_of(folder.file("flat.jpg"));
    ASSERT_EQ(pixels.width, 800);
    for (const std::uint8_t value : pixels.rgb) ASSERT_NEAR(value, 90, 2);
    write_png(folder.file("noise.png"), 900, 600, true);
    for (const std::size_t limit : {400'000U, 150'000U, 60'000U}) {
        const PagePicture picture = page_picture(folder.file("noise.png"), 1600, limit);
        EXPECT_EQ(picture.mime, "image/jpeg");
        EXPECT_LE(picture.bytes.size(), limit);
        EXPECT_GT(picture.bytes.size(), limit / 8) << "no worse than need be";
    }
}

TEST(PagePicture, RefusesWhatIsNoPicture) {
    const test::Folder folder;
    test::write_text(folder.file("text.png"), "no picture");
    EXPECT_EQ(test::error_of([&] { (void)page_picture(folder.file("text.png"), 1600, 1000); }).kind(),
              ErrorKind::environment);
}

}  // namespace
}  // namespace frana::gis
