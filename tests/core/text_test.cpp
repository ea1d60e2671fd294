// SPDX-License-Identifier: Apache-2.0
#include "core/text.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/json.h"

namespace frana {
namespace {

TEST(Base64, AsTheStandardsExamples) {
    // RFC 4648, section 10
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foob"), "Zm9vYg==");
    EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(base64("\xff\xfe"), "//4=");
}

TEST(Json, EscapesAndNests) {
    const Json json{{"a\"b", "line\nend\\"}, {"x", 0.1},          {"none", 0.0 / 0.0},
                    {"bytes", "caf\xE9"},    {"list", {1, true}}, {"empty", Json::object()}};
    EXPECT_EQ(json_text(json),
              "{\n  \"a\\\"b\": \"line\\nend\\\\\",\n  \"x\": 0.1,\n  \"none\": null,\n"
              "  \"bytes\": \"caf\\\\xe9\",\n  \"list\": [\n    1,\n    true\n  ],\n  \"empty\": {}\n}\n");
    for (const double value : {0.1, 1.0 / 3, 9.80665, 5e-324, 1.7976931348623157e308, 527000.125, 4.0})
        EXPECT_EQ(Json::parse(json_text(value)).get<double>(), value);
}

}  // namespace

}  // namespace frana
