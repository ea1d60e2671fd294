// SPDX-License-Identifier: Apache-2.0
#include "render/canvas/image.h"

#include <sys/resource.h>

#include <gtest/gtest.h>
#include <csignal>

#include <fstream>

#include "core/error.h"
#include "scenes.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGReader.h"

namespace frana::render {
namespace {

TEST(WritePng, IsReadBackPixelForPixel) {
    const test::Folder folder("png");
    Image image(37, 23);
    for (std::size_t i = 0; i < image.rgb.size(); ++i) image.rgb[i] = static_cast<std::uint8_t>(i * 7);
    write_png(folder.file("a.png"), image);

    vtkNew<vtkPNGReader> reader;
    reader->SetFileName(folder.file("a.png").c_str());
    reader->Update();
    const int* size = reader->GetOutput()->GetDimensions();
    ASSERT_EQ(size[0], 37);
    ASSERT_EQ(size[1], 23);
    for (int row = 0; row < 23; ++row) {
        for (int column = 0; column < 37; ++column) {
            const auto* p = static_cast<unsigned char*>(reader->GetOutput()->GetScalarPointer(column, 22 - row, 0));
            ASSERT_EQ((Rgb{p[0], p[1], p[2]}), image.colour(column, row));
        }
    }
    EXPECT_EQ(folder.count(), 1U);  // no unfinished file left
}

TEST(WritePng, StoresItsPrintedSize) {
    const test::Folder folder("png_dpi");
    write_png(folder.file("a.png"), Image(4, 4), 300);
    std::ifstream file(folder.file("a.png"), std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    const auto place = bytes.find("pHYs");
    ASSERT_NE(place, std::string::npos);
    // 300 dots in 0.0254 m are 11811 per metre, in four bytes, most significant first, horizontally and vertically; 1:
    // metre.
    EXPECT_EQ(bytes.substr(place + 4, 9), std::string("\0\0\x2e\x23\0\0\x2e\x23\1", 9));
    write_png(folder.file("b.png"), Image(4, 4));
    std::ifstream other(folder.file("b.png"), std::ios::binary);
    EXPECT_EQ((std::string{std::istreambuf_iterator<char>(other), {}}).find("pHYs"), std::string::npos);
}

TEST(WritePng, AMissingFolderIsAnEnvironmentError) {
    const test::Folder folder("png_missing");
    try {
        write_png(folder.file("no/such/folder/a.png"), Image(4, 4));
        FAIL() << "accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::environment);
        EXPECT_NE(std::string(error.what()).find("a.png"), std::string::npos);
    }
}

TEST(WritePng, AFullDiskIsReportedAndLeavesTheOldFile) {
    const test::Folder folder("png_full");
    const std::string path = folder.file("a.png");
    write_png(path, Image(4, 4));
    const auto size = std::filesystem::file_size(path);
    rlimit usual{};
    ::getrlimit(RLIMIT_FSIZE, &usual);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{100, usual.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
    EXPECT_THROW(write_png(path, Image(400, 400)), Error);
    ::setrlimit(RLIMIT_FSIZE, &usual);
    std::signal(SIGXFSZ, handler);
    EXPECT_EQ(std::filesystem::file_size(path), size);
    EXPECT_EQ(folder.count(), 1U);
}

TEST(WritePng, EmptyPicturesAreRefused) {
    const test::Folder folder("png_empty");
    EXPECT_THROW(write_png(folder.file("a.png"), Image()), Error);
    EXPECT_EQ(folder.count(), 0U);
}

}  // namespace
}  // namespace frana::render
