// SPDX-License-Identifier: Apache-2.0
#include "support/pdf_check.h"

#include <gdal_priv.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "gis/access/gdal_session.h"
#include "support/files.h"

namespace frana::gis::test {
namespace {

// Runs it; adds its stderr, and its exit status unless 0.
void run(const std::string& command, const std::string& path, std::vector<std::string>& problems) {
    const std::string messages = path + ".stderr";
    const int status = std::system((command + " 2>'" + messages + "'").c_str());
    if (status != 0) problems.push_back(command + " ended with " + std::to_string(status));
    if (const std::string words = text_in(messages); !words.empty()) problems.push_back(words.substr(0, 200));
    std::filesystem::remove(messages);
}

// Reads and deletes a picture written by a tool.
Pixels taken(const std::string& path) {
    Pixels pixels = pixels_of(path);
    std::filesystem::remove(path);
    std::filesystem::remove(path + ".aux.xml");
    return pixels;
}

std::string size_text(const Pixels& pixels) {
    return std::to_string(pixels.width) + " x " + std::to_string(pixels.height);
}

// Poppler stretches a picture by one pixel on either side.
constexpr int k_stretched = 1;
constexpr int k_block = 20;
// The whole contrast, moved by a pixel over a block's side, both ways.
constexpr int k_moved = 2 * 255 * k_stretched / k_block;

int block_mean(const Pixels& pixels, int left, int top, int colour) {
    int sum = 0;
    for (int row = top; row < top + k_block; ++row)
        for (int column = left; column < left + k_block; ++column)
            sum += pixels.rgb[3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(pixels.width) +
                                   static_cast<std::size_t>(column)) +
                              static_cast<std::size_t>(colour)];
    return sum / (k_block * k_block);
}

void compare_page(const Pixels& page, const Pixels& expected, std::vector<std::string>& problems) {
    if (std::abs(page.width - expected.width) > k_stretched || std::abs(page.height - expected.height) > k_stretched) {
        problems.push_back("the page is of " + size_text(page) + " pixels, not of " + size_text(expected));
        return;
    }
    for (int top = 0; top + k_block <= std::min(page.height, expected.height); top += k_block) {
        for (int left = 0; left + k_block <= std::min(page.width, expected.width); left += k_block) {
            for (int colour = 0; colour < 3; ++colour) {
                const int off = block_mean(page, left, top, colour) - block_mean(expected, left, top, colour);
                if (std::abs(off) <= k_moved + 1) continue;
                problems.push_back("the page differs at " + std::to_string(left) + ", " + std::to_string(top));
                return;
            }
        }
    }
}

}  // namespace

Pixels pixels_of(const std::string& path) {
    const GdalSession session;
    const GDALDatasetUniquePtr file(GDALDataset::Open(path.c_str(), GDAL_OF_RASTER));
    if (!file || file->GetRasterCount() < 3) {
        ADD_FAILURE() << path << ": " << session.last_message();
        return {};
    }
    Pixels pixels{file->GetRasterXSize(), file->GetRasterYSize(), {}};
    pixels.rgb.resize(3 * static_cast<std::size_t>(pixels.width) * static_cast<std::size_t>(pixels.height));
    EXPECT_EQ(file->RasterIO(GF_Read, 0, 0, pixels.width, pixels.height, pixels.rgb.data(), pixels.width, pixels.height,
                             GDT_Byte, 3, nullptr, 3, 3 * pixels.width, 1, nullptr),
              CE_None);
    return pixels;
}

std::vector<std::string> pdf_problems(const std::string& path, const Pixels& expected, double dots_per_inch) {
    std::vector<std::string> problems;
    const std::string name = "'" + path + "'";
    run("pdftoppm -singlefile -r " + std::to_string(dots_per_inch) + " " + name + " " + name, path, problems);
    run("pdffonts " + name + " > '" + path + ".fonts'", path, problems);
    if (!problems.empty()) return problems;
    compare_page(taken(path + ".ppm"), expected, problems);
    std::istringstream fonts(text_in(path + ".fonts"));
    std::filesystem::remove(path + ".fonts");
    int count = -2;  // two lines of headings
    for (std::string line; std::getline(fonts, line); ++count)
        if (count >= 0 && line.find(" yes yes yes ") == std::string::npos)
            problems.push_back("a font is not embedded, or its letters cannot be searched: " + line);
    if (count < 1) problems.emplace_back("there are no letters");
    return problems;
}

std::string pdf_text(const std::string& path) {
    std::vector<std::string> problems;
    run("pdftotext -layout '" + path + "' '" + path + ".txt'", path, problems);
    EXPECT_EQ(problems, std::vector<std::string>{});
    std::string text = text_in(path + ".txt");
    std::filesystem::remove(path + ".txt");
    return text;
}

}  // namespace frana::gis::test
