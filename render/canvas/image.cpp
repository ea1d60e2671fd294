// SPDX-License-Identifier: Apache-2.0
#include "render/canvas/image.h"

#include <png.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "core/error.h"
#include "core/files.h"

namespace frana::render {

Raster raster_window(const Raster& raster, const Bounds& window, std::int64_t most_cells) {
    const GridSpec& grid = raster.grid;
    const auto clamped = [](double cell, std::int64_t count) {
        return static_cast<std::int64_t>(std::clamp(cell, 0.0, static_cast<double>(count)));
    };
    const std::int64_t first_column = clamped(std::floor((window.west - grid.west) / grid.cell_size) - 1, grid.columns);
    const std::int64_t last_column = clamped(std::ceil((window.east - grid.west) / grid.cell_size) + 1, grid.columns);
    const std::int64_t first_row = clamped(std::floor((grid.north - window.north) / grid.cell_size) - 1, grid.rows);
    const std::int64_t last_row = clamped(std::ceil((grid.north - window.south) / grid.cell_size) + 1, grid.rows);
    Raster part;
    if (last_column <= first_column || last_row <= first_row) return part;

    const std::int64_t longer = std::max(last_column - first_column, last_row - first_row);
    const std::int64_t block = std::max<std::int64_t>(1, (longer + most_cells - 1) / most_cells);
    GridSpec spec = grid;
    spec.west = grid.west + static_cast<double>(first_column) * grid.cell_size;
    spec.north = grid.north - static_cast<double>(first_row) * grid.cell_size;
    spec.cell_size = grid.cell_size * static_cast<double>(block);
    spec.columns = std::max<std::int64_t>(1, (last_column - first_column) / block);
    spec.rows = std::max<std::int64_t>(1, (last_row - first_row) / block);
    part = Raster(spec);
    for (std::int64_t row = 0; row < spec.rows; ++row) {
        for (std::int64_t column = 0; column < spec.columns; ++column) {
            const std::int64_t r0 = first_row + row * block, c0 = first_column + column * block;
            if (!raster.values.stores_any({r0, c0, block, block})) {
                part.at(row, column) = raster.at(r0, c0);
                continue;
            }
            double sum = 0;
            std::int64_t count = 0;
            for (std::int64_t r = first_row + row * block; r < std::min(first_row + (row + 1) * block, last_row); ++r) {
                for (std::int64_t c = first_column + column * block;
                     c < std::min(first_column + (column + 1) * block, last_column); ++c) {
                    sum += raster.at(r, c);
                    ++count;
                }
            }
            part.at(row, column) = sum / static_cast<double>(count);
        }
    }
    return part;
}

std::optional<Bounds> data_bounds(const Raster& raster) {
    const GridSpec& grid = raster.grid;
    std::int64_t first_row = grid.rows, last_row = -1, first_column = grid.columns, last_column = -1;
    raster.values.for_each_stored([&](std::size_t cell, double value) {
        if (std::isnan(value)) return;
        const std::int64_t row = static_cast<std::int64_t>(cell) / grid.columns,
                           column = static_cast<std::int64_t>(cell) % grid.columns;
        first_row = std::min(first_row, row);
        last_row = std::max(last_row, row);
        first_column = std::min(first_column, column);
        last_column = std::max(last_column, column);
    });
    if (last_row < 0) return std::nullopt;
    return Bounds{grid.west + static_cast<double>(first_column) * grid.cell_size,
                  grid.north - static_cast<double>(last_row + 1) * grid.cell_size,
                  grid.west + static_cast<double>(last_column + 1) * grid.cell_size,
                  grid.north - static_cast<double>(first_row) * grid.cell_size};
}

double interpolated(const Raster& raster, Point map) noexcept {
    const GridSpec& grid = raster.grid;
    // Up to half a cell beyond the outermost centres the edge value applies: the cell's area ends there, not its
    // centre.
    double column = (map.x - grid.west) / grid.cell_size - 0.5;
    double row = (grid.north - map.y) / grid.cell_size - 0.5;
    if (!(column >= -0.5 && row >= -0.5 && column <= static_cast<double>(grid.columns) - 0.5 &&
          row <= static_cast<double>(grid.rows) - 0.5)) {
        return k_no_data;
    }
    column = std::clamp(column, 0.0, static_cast<double>(grid.columns - 1));
    row = std::clamp(row, 0.0, static_cast<double>(grid.rows - 1));
    const auto c0 = static_cast<std::int64_t>(column), r0 = static_cast<std::int64_t>(row);
    const double u = column - static_cast<double>(c0), v = row - static_cast<double>(r0);
    // On a centre line the neighbour beyond has weight zero; a gap there must not affect the value (NaN times 0 is
    // NaN).
    constexpr double k_none = 1e-6;
    const std::int64_t c1 = u < k_none ? c0 : std::min(c0 + 1, grid.columns - 1);
    const std::int64_t r1 = v < k_none ? r0 : std::min(r0 + 1, grid.rows - 1);
    const double upper = raster.at(r0, c0) * (1 - u) + raster.at(r0, c1) * u;
    const double lower = raster.at(r1, c0) * (1 - u) + raster.at(r1, c1) * u;
    return upper * (1 - v) + lower * v;
}

namespace {

[[noreturn]] void fail(const char* what) {
    throw Error(ErrorKind::environment, Problem{what, "memory", std::strerror(errno), "", "check the free memory"});
}

/// Returns false if libpng or the stream fails. libpng exits by longjmp: no object here may need a destructor.
bool encode(std::FILE* stream, const Image& image, double dots_per_inch) {
    png_infop info = nullptr;
    png_structp png = png_create_write_struct(
        PNG_LIBPNG_VER_STRING, nullptr, [](png_structp failed, png_const_charp) { png_longjmp(failed, 1); },
        [](png_structp, png_const_charp) {});
    if (png == nullptr) return false;
    info = png_create_info_struct(png);
    if (info == nullptr || setjmp(png_jmpbuf(png)) != 0) {
        png_destroy_write_struct(&png, &info);
        return false;
    }
    png_init_io(png, stream);
    png_set_IHDR(png, info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height), 8,
                 PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (dots_per_inch > 0) {
        constexpr double k_inches_in_metre = 1 / 0.0254;
        const auto dots = static_cast<png_uint_32>(std::lround(dots_per_inch * k_inches_in_metre));
        png_set_pHYs(png, info, dots, dots, PNG_RESOLUTION_METER);
    }
    // One filter and a low level: a third of the time of libpng's default, and a tenth more bytes.
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_UP);
    png_set_compression_level(png, 2);
    png_write_info(png, info);
    for (int row = 0; row < image.height; ++row) png_write_row(png, image.pixel(0, row));
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    return true;
}

}  // namespace

Image::Image(int columns, int rows, Rgb fill) : width(columns), height(rows) {
    rgb.resize(3 * static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
    for (std::size_t i = 0; i < rgb.size(); i += 3) {
        rgb[i] = fill.r;
        rgb[i + 1] = fill.g;
        rgb[i + 2] = fill.b;
    }
}

std::string png_bytes(const Image& image, double dots_per_inch) {
    if (image.width < 1 || image.height < 1)
        throw Error(ErrorKind::environment, Problem{"an empty picture is not written", "", "", "", ""});
    char* bytes = nullptr;
    std::size_t size = 0;
    std::FILE* stream = ::open_memstream(&bytes, &size);
    if (stream == nullptr) fail("the picture cannot be written");
    const bool written = encode(stream, image, dots_per_inch);
    const bool closed = std::fclose(stream) == 0;
    const std::unique_ptr<char, void (*)(void*)> owned(bytes, &std::free);
    if (!written || !closed) fail("the picture could not be written completely");
    return {bytes, size};
}

void write_png(const std::string& path, const Image& image, double dots_per_inch) {
    write_file(path, png_bytes(image, dots_per_inch));
}

}  // namespace frana::render
