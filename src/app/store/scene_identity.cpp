// SPDX-License-Identifier: Apache-2.0
#include "app/store/scene_identity.h"

#include <zlib.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/store/json_file.h"
#include "app/store/provenance.h"
#include "app/store/result_files.h"
#include "core/archive.h"
#include "core/shortest_text.h"

namespace frana::app {
namespace {

// Sums whatever it is given.
class Sum {
  public:
    Sum()
        : writer_([this](const void* data, std::size_t count) {
              if (count > 0) sum_ = crc32_z(sum_, static_cast<const Bytef*>(data), count);  // null would begin it anew
          }) {}
    void add(double value) { writer_(value); }
    void add(Point point) { writer_(point.x, point.y); }
    void add(const std::string& text) {
        add(static_cast<double>(text.size()));
        writer_.bytes(text.data(), text.size());
    }
    void add(const Raster& raster) { writer_.bytes(raster.values.data(), raster.values.size() * sizeof(double)); }
    void add(const HydrographPoint& point) {
        for (double value : {point.time, point.discharge, point.speed}) add(value);
    }
    void add(const Polygon& polygon) {
        add(polygon.outer);
        add(polygon.holes);
    }
    template <class T>
    void add(const std::vector<T>& list) {
        add(static_cast<double>(list.size()));
        for (const T& value : list) add(value);
    }
    template <class T>
    void add(const std::optional<T>& value) {
        add(value.has_value() ? 1.0 : 0.0);
        if (value) add(*value);
    }
    void add(const ReleaseArea& area) {
        add(area.outline);
        add(area.thickness_raster);
        add(area.volume);
        add(area.azimuth);
        for (double value : {area.thickness, area.start, area.speed}) add(value);
    }
    void add(const Inflow& inflow) {
        add(inflow.line);
        add(inflow.hydrograph);
        add(inflow.azimuth);
    }
    void add(const Gauge& gauge) {
        add(gauge.name);
        add(gauge.place);
    }
    void add(const CrossSection& section) {
        add(section.name);
        add(section.line);
    }
    [[nodiscard]] std::string text() const { return std::to_string(sum_); }

  private:
    uLong sum_ = 0;
    StateWriter writer_;
};

template <class... Values>
std::string line(const std::string& name, const Values&... values) {
    Sum sum;
    (sum.add(values), ...);
    return "checksum of " + name + " = " + sum.text() + "\n";
}

// Of a scene's text: "section.key = value" lines.
std::string keys(const std::string& text) {
    std::istringstream lines(text);
    std::string section, all;
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || line.front() == '#') continue;
        if (line.front() == '[') {
            section = line.substr(1, line.size() - 2);
        } else if (section != "output" || line.rfind("checkpoint-interval ", 0) != 0) {
            all += section + "." + line + "\n";
        }
    }
    return all;
}

std::map<std::string, std::string> facts(const std::string& identity) {
    std::map<std::string, std::string> list;
    std::istringstream lines(identity);
    for (std::string line; std::getline(lines, line);) {
        const auto place = line.find(" = ");
        if (place != std::string::npos) list[line.substr(0, place)] = line.substr(place + 3);
    }
    return list;
}

// What the structured model has from files.
std::string by_place(const std::optional<StructuredMaterial>& material) {
    if (!material) return "";
    const StructuredZones& zones = material->zones;
    return line("the material by place", zones.solid_fraction, zones.confined_share, zones.grain_density,
                zones.grain_diameter, zones.cohesion, zones.friction, zones.bed_friction) +
           line("the fluid that lies there", material->initial_fluid);
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> all;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) all.push_back(line);
    return all;
}

std::string identity(const std::string& scene_text, const std::vector<std::string>& data) {
    std::string text = keys(scene_text);
    for (const std::string& fact : data) text += fact + "\n";
    return text;
}

std::string text_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

std::vector<std::string> data_identity(const Prepared& prepared) {
    const Scene& scene = prepared.scene;
    const GridSpec& grid = scene.grid;
    return lines_of("working grid = " + std::to_string(grid.columns) + " x " + std::to_string(grid.rows) + " of " +
                    shortest_text(grid.cell_size) + " m from (" + shortest_text(grid.west) + ", " +
                    shortest_text(grid.north) + ")\n" + line("the coordinate reference system", grid.crs_wkt) +
                    line("the terrain", scene.terrain) + line("walls", scene.walls) +
                    line("the release", scene.release, scene.release_volume) + line("inflows", scene.inflows) +
                    line("zones", scene.zones.friction_coefficient, scene.zones.turbulence, scene.zones.cohesion,
                         scene.zones.erodible_depth) +
                    by_place(scene.structured) +
                    line("gauges and sections", scene.recording.gauges, scene.recording.sections));
}

std::string scene_identity(const Prepared& prepared) {
    return identity(echoed_scene(prepared), data_identity(prepared));
}

std::optional<std::string> result_identity(const std::string& result_folder) {
    const std::filesystem::path folder = result_folder;
    const std::string scene = text_of(folder / k_scene_file);
    const std::optional<Json> summary = read_json_file((folder / k_summary_file).string());
    if (scene.empty() || !summary || !summary->contains(k_data_key)) return std::nullopt;
    std::vector<std::string> data;
    for (const Json& fact : summary->at(k_data_key)) {
        if (!fact.is_string()) return std::nullopt;
        data.push_back(fact.get<std::string>());
    }
    return identity(scene, data);
}

std::vector<std::string> identity_differences(const std::string& here, const std::string& then) {
    constexpr std::size_t k_most = 4;
    const auto now = facts(here), before = facts(then);
    std::vector<std::string> words;
    for (const auto& [name, value] : now) {
        const auto old = before.find(name);
        if (old == before.end()) {
            words.push_back(name + " is " + value + " here and was not given");
        } else if (old->second != value) {
            const bool sum = name.rfind("checksum of ", 0) == 0;
            words.push_back(sum ? name.substr(12) + " differ" + (name.rfind("checksum of the", 0) == 0 ? "s" : "")
                                : name + " is " + value + " here and was " + old->second);
        }
    }
    for (const auto& [name, value] : before) {
        if (now.count(name) == 0) words.push_back(name + " was " + value + " and is not given here");
    }
    if (words.size() > k_most) {
        words.resize(k_most);
        words.emplace_back("and more");
    }
    return words;
}

}  // namespace frana::app
