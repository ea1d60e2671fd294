// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "support/tiny_scene.h"

namespace frana::test {
namespace {

class Schema : public TinyScene {
  protected:
    /// Problems of a scene by Python's jsonschema, the first line their number; "77": there is none.
    std::string problems(const std::string& scene) {
        write("schema.json", frana({"params", "--schema"}).out);
        const std::string script = std::string(FRANA_SOURCE_DIR) + "/tests/app/commands/validate_scene.py";
        const int status = std::system(
            ("/usr/bin/python3 '" + script + "' '" + path("schema.json") + "' '" + scene + "' > '" + path("said") + "'")
                .c_str());
        if (WEXITSTATUS(status) == 77) return "77";
        EXPECT_EQ(status, 0);
        return read_text(path("said"));
    }
};

TEST_F(Schema, HasTypesLimitsDefaultsAndUnits) {
    const Json schema = parse_json(frana({"params", "--schema"}).out);
    EXPECT_EQ(schema.at("$schema"), "https://json-schema.org/draft/2020-12/schema");
    const auto key = [&](const std::string& section, const std::string& name) {
        return schema.at("properties").at(section).at("properties").at(name);
    };
    const Json cfl = key("numerics", "cfl");
    EXPECT_EQ(cfl.at("type"), "number");
    EXPECT_EQ(cfl.at("exclusiveMinimum"), 0);
    EXPECT_EQ(cfl.at("maximum"), 1);
    const Json density = key("material", "density");
    EXPECT_EQ(density.at("minimum"), 10);
    EXPECT_EQ(density.at("maximum"), 10000);
    EXPECT_EQ(density.at("default"), 2000);
    EXPECT_EQ(density.at("unit"), "kg/m3");
    EXPECT_FALSE(density.at("description").get<std::string>().empty());
    EXPECT_EQ(key("terrain", "nodata-policy").at("enum"), Json({"stop", "wall", "fill"}));
    EXPECT_EQ(key("numerics", "particles-per-cell").at("enum"), Json({1, 4, 9, 16}));
    EXPECT_EQ(key("output", "depth-thresholds").at("type"), "array");
    EXPECT_TRUE(key("release", "thickness").at("anyOf").is_array());
    EXPECT_EQ(schema.at("properties").at("scar").at("properties").at("perimeter").at("type"), "string");
    // Every key, each with a meaning.
    for (const Json& declared : parse_json(frana({"params", "--json"}).out))
        EXPECT_EQ(key(declared.at("section"), declared.at("key")).at("description"), declared.at("meaning"));
}

TEST_F(Schema, TheSampleIsValidAndAWrongSceneIsNot) {
    const std::string sample = problems(std::string(FRANA_SOURCE_DIR) + "/sample_data/bindo/scene.ini");
    if (sample == "77") GTEST_SKIP() << "no python3-jsonschema";
    EXPECT_EQ(sample, "0\n");
    for (const char* name : {"coulomb", "structured"})
        EXPECT_EQ(problems(std::string(FRANA_SOURCE_DIR) + "/sample_data/bindo/" + name + ".ini"), "0\n") << name;
    write_scene("[numerics]\ncfl = 3\nscheme = round\nschem = auto\n[output]\ndepth-thresholds = 0.5, -2\n");
    const std::string wrong = problems(path("scene.ini"));
    EXPECT_EQ(wrong.rfind("4\n", 0), 0U) << wrong;
    for (const char* place : {"numerics/cfl", "numerics/scheme", "output/depth-thresholds/1", "'schem' was unexpected"})
        EXPECT_NE(wrong.find(place), std::string::npos) << wrong;
}

}  // namespace
}  // namespace frana::test
