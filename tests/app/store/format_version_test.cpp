// SPDX-License-Identifier: Apache-2.0
// Results and scenes contain their format: a newer one is refused with a message, an older one read.
#include <fstream>
#include <nlohmann/json.hpp>

#include "support/tiny_scene.h"

namespace frana::test {
namespace {

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const auto place = text.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    if (place != std::string::npos) text.replace(place, from.size(), to);
    return text;
}

class FormatVersion : public TinyScene {
  protected:
    FormatVersion() {
        write_scene(k_numbers_only);
        write_polygon("scar", {{15, 50}, {180, 50}, {180, 100}, {15, 100}});
        ran("result", {"time.end=1"});
    }
    // Everything that reads a result.
    [[nodiscard]] std::vector<Outcome> read_it() const {
        return {frana({"render", "result", "--map", "max_depth", "--size", "640x480"}),
                frana({"compare", "result", "--scar", "scar.geojson", "--out", "compared"}),
                frana({"run", "result/scene.ini", "--out", "again", "--overwrite", "--quiet"})};
    }
};

TEST_F(FormatVersion, IsWrittenAndReadBack) {
    EXPECT_EQ(json_number(read_text(path("result/summary.json")), "format"), 1);
    EXPECT_NE(read_text(path("result/scene.ini")).find("\nformat = 1\n"), std::string::npos);
    for (const Outcome& outcome : read_it()) EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

TEST_F(FormatVersion, ANewerResultIsRefusedWithAMessage) {
    Json summary = parse_json(read_text(path("result/summary.json")));
    summary["format"] = 7;
    write("result/summary.json", frana::json_text(summary));
    const std::vector<Outcome> outcomes = read_it();
    for (const std::size_t i : {0U, 1U}) {
        EXPECT_EQ(outcomes[i].exit_code, 2);
        EXPECT_NE(outcomes[i].err.find("summary.json: was written by a newer frana than this one (value format 7; "
                                       "allowed up to 1). Update frana"),
                  std::string::npos)
            << outcomes[i].err;
    }
}

TEST_F(FormatVersion, ANewerSceneIsRefusedWithAMessage) {
    write("result/scene.ini", replaced(read_text(path("result/scene.ini")), "\nformat = 1", "\nformat = 2"));
    for (const Outcome& outcome : read_it()) {
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_NE(outcome.err.find("newer frana than this one"), std::string::npos) << outcome.err;
    }
}

TEST_F(FormatVersion, ResultsFromBeforeFormatsAreRead) {
    Json summary = parse_json(read_text(path("result/summary.json")));
    EXPECT_EQ(summary.erase("format"), 1U);
    write("result/summary.json", frana::json_text(summary));
    write("result/scene.ini", replaced(read_text(path("result/scene.ini")), "\nformat = 1\n", "\n"));
    for (const Outcome& outcome : read_it()) EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

}  // namespace
}  // namespace frana::test
