// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "gis/access/table_in.h"
#include "gis/raster/raster_in.h"
#include "started_program.h"
#include "study/kept_records.h"
#include "support/checked_scene.h"

namespace frana::test {

class Ensemble : public CheckedScene {
  protected:
    const std::vector<std::string> k_run{"ensemble", "study.ini", "--out", "out", "--quiet"};

    Ensemble() { write_scene("stop-when-still = off\n" + k_numbers_only + "charts = off\n"); }

    void write_study(const std::string& head, const std::string& rest) const {
        write("study.ini", "[study]\nscene = scene.ini\n" + head + rest);
    }
    [[nodiscard]] Outcome run(const std::vector<std::string>& more = {}) const { return frana(with_more(k_run, more)); }
    void expect_run_refused(const std::vector<std::string>& words, const std::vector<std::string>& more = {}) const {
        refusal_of(refused(with_more(k_run, more)), words);
    }
    /// Whole ones of a study that is being built.
    [[nodiscard]] std::vector<KeptRecord> records() const {
        try {
            std::vector<std::string> names;
            for (const std::string& name : files())
                if (name.find("/records/record") != std::string::npos && name.find("partial/") != std::string::npos)
                    names.push_back(name);
            return kept_records(folder_.string(), names);
        } catch (const std::filesystem::filesystem_error&) {  // a folder went while it was read
            return {};
        }
    }
    /// Starts the study and sends a signal as soon as so many members have their record.
    [[nodiscard]] Outcome stop_after(std::size_t members, int signal_number) const {
        StartedProgram program(folder_.string(), {"ensemble", "study.ini", "--out", "out", "--threads", "2"});
        EXPECT_TRUE(program.wait_until([&] { return records().size() >= members; }));
        program.send(signal_number);
        return program.wait();
    }
    [[nodiscard]] Rows members(const std::string& result = "out") const {
        return rows_of(path(result + "/members.csv"));
    }
    [[nodiscard]] double probability(const std::string& name, int row, int column) const {
        return gis::read_result_raster(path("out/" + name + ".tif")).at(row, column);
    }
    /// Everything that must not differ: rasters with their styles, tables without wall times, the check by
    /// the other scheme.
    [[nodiscard]] std::map<std::string, std::string> lasting(const std::string& result) const {
        std::map<std::string, std::string> files;
        for (const std::string& name : TinyScene::files()) {
            if (!name.starts_with(result + "/")) continue;
            const std::string rest = name.substr(result.size() + 1);
            if (rest.ends_with(".tif") || rest.ends_with(".qml") || rest == "sensitivity.csv" || rest == "study.ini")
                files[rest] = read_text(path(name));
        }
        std::string rows;
        for (auto row : members(result)) {
            row.erase("engine_seconds");
            for (const auto& [key, value] : row) rows += key + "=" + value + ";";
        }
        files["members"] = rows;
        const Json summary = parse_json(read_text(path(result + "/summary.json")));
        files["scheme check"] = summary.contains("scheme_check") ? summary["scheme_check"].dump() : "";
        return files;
    }
    void expect_same(const std::string& a, const std::string& b) const {
        const auto first = lasting(a), second = lasting(b);
        EXPECT_GT(first.size(), 20U);
        EXPECT_EQ(first.size(), second.size());
        for (const auto& [name, content] : first)
            EXPECT_TRUE(second.count(name) > 0 && second.at(name) == content) << name;
    }
};

inline const std::string k_two_keys =
    "[vary]\nmaterial.friction-angle = uniform(10, 20)\nmaterial.turbulence = log-uniform(300, 3000)\n";

}  // namespace frana::test
