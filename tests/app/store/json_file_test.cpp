// SPDX-License-Identifier: Apache-2.0
// Anything in the place of a file that frana wrote is read, or treated as missing; nothing crashes the program.
#include "app/store/result_files.h"

#include <cstdint>
#include <nlohmann/json.hpp>

#include "app/store/manifest.h"
#include "support/tiny_scene.h"

namespace frana::test {
namespace {

using JsonFile = TinyScene;

TEST_F(JsonFile, InvalidJsonIsNone) {
    const std::string deep(1'000'000, '[');
    for (const std::string& text : {std::string(), std::string("{\"a\": 1"), std::string("{\"a\": 1} x"),
                                    std::string("{\"a\": 1e999}"), std::string("{\"a\": \"\xE9\"}"), deep}) {
        write("some.json", text);
        EXPECT_FALSE(app::read_json_file(path("some.json"))) << text.substr(0, 20);
    }
    write("some.json", deep + std::string(deep.size(), ']'));
    EXPECT_TRUE(app::read_json_file(path("some.json")));
    EXPECT_FALSE(app::read_json_file(path("none.json")));
    EXPECT_FALSE(app::read_json_file(path(".")));
}

TEST_F(JsonFile, ValuesAreThoseOfTheirTypeOnly) {
    const Json json = parse_json(R"({"a": {"b": 1.5, "n": 3, "t": "3", "y": true, "none": null}, "list": [4]})");
    EXPECT_EQ(app::value_in<double>(json, "/a/b"), 1.5);
    EXPECT_EQ(app::value_in<double>(json, "/a/n"), 3);
    EXPECT_EQ(app::value_in<std::int64_t>(json, "/a/n"), 3);
    EXPECT_EQ(app::value_in<std::string>(json, "/a/t"), "3");
    EXPECT_EQ(app::value_in<bool>(json, "/a/y"), true);
    EXPECT_EQ(app::value_in<double>(json, "/list/0"), 4);
    for (const char* place : {"/a/t", "/a/y", "/a/none", "/a", "/list", "/list/1", "/list/b", "/c/b", "/a/b/c"})
        EXPECT_FALSE(app::value_in<double>(json, place)) << place;
    EXPECT_FALSE(app::value_in<std::int64_t>(json, "/a/b"));
    EXPECT_FALSE(app::value_in<std::string>(Json(), "/a"));
}

TEST_F(JsonFile, AManifestOfAnotherShapeIsNone) {
    app::write_manifest(path("."), {"hash", 2.5, true, {{"a b.tif", 7}, {"begun.png", std::nullopt}}});
    const std::string text = read_text(path("manifest.json"));
    const auto manifest = app::read_manifest(path("."));
    ASSERT_TRUE(manifest);
    EXPECT_EQ(manifest->files.at("a b.tif"), 7U);
    EXPECT_FALSE(manifest->files.at("begun.png"));
    EXPECT_EQ(manifest->simulated_seconds, 2.5);
    const std::string good = "{\"name\": \"a\", \"bytes\": 7}";
    for (const std::string& files :
         {std::string("7"), std::string("[7]"), std::string("[{}]"), "[" + good + ", {\"name\": 7}]",
          std::string("[{\"name\": \"a\", \"bytes\": -7}]"), std::string("[{\"name\": \"a\", \"bytes\": 1e300}]"),
          std::string("[{\"name\": \"%zz\", \"bytes\": 7}]")}) {
        Json json = parse_json(text);
        json["files"] = parse_json(files);
        write("manifest.json", frana::json_text(json));
        EXPECT_FALSE(app::read_manifest(path("."))) << files;
    }
    for (const char* key : {"program", "format", "files"}) {
        Json json = parse_json(text);
        json[key] = nullptr;
        write("manifest.json", frana::json_text(json));
        EXPECT_FALSE(app::read_manifest(path("."))) << key;
    }
}

}  // namespace
}  // namespace frana::test
