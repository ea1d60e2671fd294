// SPDX-License-Identifier: Apache-2.0
#include "study/member_record.h"

#include <zlib.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>

#include "core/archive.h"
#include "core/error.h"
#include "core/file_aside.h"
#include "simulation/run_check.h"
#include "simulation/simulation.h"

namespace frana::study {
namespace {

constexpr char k_magic[8] = {'f', 'r', 'a', 'n', 'a', ' ', 'm', 'b'};
/// Increases with every change of what a record contains.
constexpr std::uint32_t k_format = 1;
constexpr std::size_t k_head_bytes = sizeof k_magic + sizeof k_format + sizeof(std::uint64_t);

void add_bytes(std::string& bytes, const void* from, std::size_t count) {
    bytes.append(static_cast<const char*>(from), count);
}

std::uint32_t crc_of(const char* bytes, std::size_t count) {
    return static_cast<std::uint32_t>(crc32_z(0, reinterpret_cast<const Bytef*>(bytes), count));
}

/// Why a run's figures are those of another event than its scene; empty: they are good.
std::string failure_of(const RunResult& result) {
    switch (result.stop_reason) {
        case StopReason::reached_no_data:
        case StopReason::non_finite:
        case StopReason::impossible_speed:
        case StopReason::volume_drift:
            return describe(result.stop_reason);
        default:
            return "";
    }
}

void add_cells(const RunResult& result, MemberRecord& record) {
    const auto number = [](double value) { return static_cast<float>(value); };
    result.max_depth.values.for_each_stored([&](std::size_t cell, double depth) {
        if (std::isnan(depth)) return;
        const double velocity = result.max_velocity.values[cell];
        if (record.runs.empty() || record.runs.back().first + record.runs.back().count != cell)
            record.runs.push_back({cell, 0});
        ++record.runs.back().count;
        record.depth.push_back(number(depth));
        record.velocity.push_back(number(std::isnan(velocity) ? 0 : velocity));
        record.arrival.push_back(number(result.arrival_time.values[cell]));
    });
}

}  // namespace

CellWindow MemberRecord::place_in(const GridSpec& grid) const {
    const double column = (west - grid.west) / grid.cell_size, row = (grid.north - north) / grid.cell_size;
    constexpr double k_tolerance = 1e-3;  // of a cell: files round their origin
    const auto is_whole = [](double value) { return std::abs(value - std::round(value)) < k_tolerance; };
    if (!is_whole(column) || !is_whole(row) || std::abs(cell_size / grid.cell_size - 1) > 1e-9)
        throw Error(ErrorKind::input,
                    Problem{"has other cells than the study's scene", "member " + std::to_string(member), "", "",
                            "Set terrain.crs and terrain.cell-size in the scene"});
    return {static_cast<std::int64_t>(std::llround(row)), static_cast<std::int64_t>(std::llround(column)), rows,
            columns};
}

Raster MemberRecord::raster(Quantity quantity, const GridSpec& grid) const {
    Raster raster(grid, k_no_data);
    const std::vector<float>& values = of(quantity);
    for_each_cell(grid, [&](std::int64_t row, std::int64_t column, std::size_t index) {
        if (row >= 0 && column >= 0 && row < grid.rows && column < grid.columns)
            raster.at(row, column) = static_cast<double>(values[index]);
    });
    return raster;
}

MemberRecord empty_record(std::uint64_t member, const GridSpec& grid) {
    MemberRecord record;
    record.member = member;
    record.west = grid.west;
    record.north = grid.north;
    record.cell_size = grid.cell_size;
    record.columns = grid.columns;
    record.rows = grid.rows;
    return record;
}

MemberRecord record_of(std::uint64_t member, const RunResult& result, const Scene& scene, double threshold) {
    MemberRecord record = empty_record(member, scene.grid);
    record.failure = failure_of(result);
    for (const RunValue& value : reported_values(result, scene, threshold))
        record.figures.push_back({value.key, value.title, value.unit, value.value});
    record.figures.push_back({"volume_m3", "volume", "m3", result.volume_entered});
    record.engine_seconds = result.engine_seconds;
    add_cells(result, record);
    return record;
}

void write_record(const std::string& path, MemberRecord record) {
    std::string content;
    StateWriter writer([&](const void* from, std::size_t count) { add_bytes(content, from, count); });
    writer(record);
    std::string bytes;
    add_bytes(bytes, k_magic, sizeof k_magic);
    add_bytes(bytes, &k_format, sizeof k_format);
    const std::uint64_t size = content.size();
    add_bytes(bytes, &size, sizeof size);
    bytes += content;
    const std::uint32_t crc = crc_of(bytes.data(), bytes.size());
    add_bytes(bytes, &crc, sizeof crc);
    write_file(path, bytes, Sync::yes);
}

std::optional<MemberRecord> read_record(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) return std::nullopt;
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    std::uint32_t crc = 0, format = 0;
    std::uint64_t size = 0;
    if (bytes.size() < k_head_bytes + sizeof crc || std::memcmp(bytes.data(), k_magic, sizeof k_magic) != 0)
        return std::nullopt;
    std::memcpy(&format, bytes.data() + sizeof k_magic, sizeof format);
    std::memcpy(&size, bytes.data() + sizeof k_magic + sizeof format, sizeof size);
    if (format != k_format || size != bytes.size() - k_head_bytes - sizeof crc) return std::nullopt;
    std::memcpy(&crc, bytes.data() + bytes.size() - sizeof crc, sizeof crc);
    if (crc != crc_of(bytes.data(), bytes.size() - sizeof crc)) return std::nullopt;
    const char* next = bytes.data() + k_head_bytes;
    const char* const end = bytes.data() + bytes.size() - sizeof crc;
    StateReader reader(
        [&](void* to, std::size_t count) {
            StateReader::require(count <= static_cast<std::size_t>(end - next));
            std::memcpy(to, next, count);
            next += count;
        },
        size);
    MemberRecord record;
    try {
        reader(record);
        StateReader::require(next == end);
        std::uint64_t cells = 0;
        for (const CellRun& run : record.runs) cells += run.count;
        StateReader::require(cells == record.depth.size() && cells == record.velocity.size() &&
                             cells == record.arrival.size());
    } catch (const Error&) {
        return std::nullopt;
    }
    return record;
}

}  // namespace frana::study
