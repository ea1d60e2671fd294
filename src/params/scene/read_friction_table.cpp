// SPDX-License-Identifier: Apache-2.0
#include "params/scene/read_friction_table.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <utility>

#include "core/text.h"
#include "params/grammar/data_file.h"
#include "params/grammar/value_text.h"

namespace frana {
namespace {

namespace fs = std::filesystem;

constexpr int k_most_terrains = 20;
constexpr double k_usual_spacing = 10;  // of elevations for the curvature [m]

/// A number of a key's name: 100000, not 1e+05.
std::string plain_text(double value) {
    return value == std::floor(value) ? std::to_string(static_cast<std::int64_t>(value)) : shortest_text(value);
}

class TableReader : DataFile {
  public:
    TableReader(const std::string& path, const std::string& label, Problems& problems)
        : DataFile(path, label, "share/doc/input.md", problems) {}

    FrictionTable read(const std::string& name) {
        FrictionTable table{.name = name};
        describe("table", table);
        table.note = taken("table.note").value_or("");
        table.periods = rising("table.return-periods", required("table.return-periods"));
        for (const auto& [key, limits] :
             {std::pair{"table.volume-limits", &table.volumes}, std::pair{"table.altitude-limits", &table.altitudes}})
            if (const auto text = taken(key)) *limits = rising(key, *text);
        table.spacing = k_usual_spacing;
        if (const auto text = taken("table.curvature-spacing"))
            table.spacing = number("table.curvature-spacing", *text, {0.1, 1000});
        if (const auto text = taken("table.density")) table.density = number("table.density", *text, {10, 10000});
        if (has_section("forest")) {
            table.forest.emplace();
            table.forest->more_friction = number("forest.more-friction", required("forest.more-friction"), {0, 2});
            table.forest->turbulence = number("forest.turbulence", required("forest.turbulence"), {1, 1e9});
        }
        read_classes(table);
        refuse_rest();
        return table;
    }

  private:
    double number(const std::string& key, const std::string& text, NumberRange range) {
        const auto value = number_from_text(text);
        if (value && range.has(*value)) return *value;
        if (!text.empty()) refuse(value ? "is out of range" : "is not a number", key, text, range.text(), "Correct it");
        return range.lowest;
    }

    void read_classes(FrictionTable& table) {
        const std::vector<int> numbers = numbered("class", k_most_terrains);
        if (numbers.empty())
            refuse("has no classes of terrain", "class-1", "", "", "Add a section for each, by rising curvature");
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            const std::string section = "class-" + std::to_string(i + 1);
            if (numbers[i] != static_cast<int>(i) + 1)
                refuse("is missing", section, "", "classes without a gap", "Number them one after the other");
            FrictionTable::Terrain& kind = table.terrain.emplace_back();
            kind.name = named(section + ".name", table.texts);
            if (numbers.size() == 1) continue;  // all terrain
            if (const auto text = i == 0 ? taken(section + ".slope-below") : std::nullopt) {
                kind.slope_below = number(section + ".slope-below", *text, {0.1, 90});
                continue;
            }
            const std::string key = section + ".curvature", text = required(key);
            kind.curvature = number(key, text, {-10, 10});
            if (i > 0 && !table.terrain[i - 1].slope_below && !(kind.curvature > table.terrain[i - 1].curvature))
                refuse("is not greater than that of the class before", key, text,
                       "greater than " + shortest_text(table.terrain[i - 1].curvature), "Sort them by curvature");
        }
        std::vector<double> least{0};  // volumes
        least.insert(least.end(), table.volumes.begin(), table.volumes.end());
        for (const double period : table.periods)
            for (const double volume : least)
                for (std::size_t i = 0; i < table.terrain.size(); ++i)
                    read_values("class-" + std::to_string(i + 1) + "." + plain_text(period) + "-years-from-" +
                                    plain_text(volume) + "-m3",
                                table.altitudes.size() + 1, table.values);
    }

    /// "0.33 1250, 0.305 1400": mu and xi of each band of altitude, the lowest first.
    void read_values(const std::string& key, std::size_t bands, std::vector<FrictionPair>& values) {
        const std::string text = required(key);
        std::vector<double> read;
        for (const std::string& word : words_of(text)) read.push_back(number_from_text(word).value_or(-1));
        const std::size_t first = values.size();
        bool good = read.size() == 2 * bands;
        for (std::size_t i = 0; good && i + 1 < read.size(); i += 2) {
            good = NumberRange{0, 2}.has(read[i]) && NumberRange{1, 1e9}.has(read[i + 1]);
            values.push_back({read[i], read[i + 1]});
        }
        if (!good && !text.empty())
            refuse("is not a mu and a xi for each band of altitude", key, text,
                   std::to_string(bands) + (bands == 1 ? " pair" : " pairs") + ", mu 0 to 2, xi 1 to 1e9 m/s2",
                   "Write for example 0.33 1250, 0.305 1400, 0.29 1500");
        values.resize(first + bands);
    }
};

}  // namespace

FrictionTable read_friction_table(const std::string& path, const std::string& label, Problems& problems) {
    FrictionTable table = TableReader(path, label, problems).read(fs::path(path).stem().string());
    table.file = path;
    return table;
}

std::optional<FrictionTable> resolved_friction_table(const FrictionTableSpec& spec, const std::string& share,
                                                     const Place& where, Problems& problems) {
    if (!spec.name) return std::nullopt;
    const auto file = data_file_of(*spec.name, share, k_friction_folder, where, problems);
    if (!file) return std::nullopt;
    return attempt(problems, [&]() -> std::optional<FrictionTable> {
        Problems of_file;
        FrictionTable table = read_friction_table(*file, *file, of_file);
        of_file.throw_if_any();
        return table;
    });
}

}  // namespace frana
