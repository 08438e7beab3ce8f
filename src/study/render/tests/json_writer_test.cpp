// SPDX-License-Identifier: GPL-3.0-or-later
#include "json/json_writer.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include <nlohmann/json.hpp>

namespace setae::output::json_writer_test {
namespace {

TEST(JsonText, ParsesBackToTheDocument) {
    const Json json{{"a", {1, 2.0, -0.5e-300, nullptr, true, "ä\n\"", 1e100, 0.1}},
                    {"empty", {{"object", Json::object()}, {"array", Json::array()}}},
                    {"nested", {{{"x", 1}}, {{"x", {{"y", {1, 2}}}}}}},
                    {"large", std::numeric_limits<std::uint64_t>::max()}};
    EXPECT_EQ(Json::parse(as_text(json)), json);
    EXPECT_EQ(as_text(json).back(), '\n');
    for (const auto& one : {Json(1.0), Json("x"), Json::array(), Json::object(), Json{1, 2}, Json(nullptr)})
        EXPECT_EQ(Json::parse(as_text(one)), one);
}

TEST(JsonText, KeepsRealNumbersAndListsOnOneLine) {
    EXPECT_EQ(as_text(Json{{"x", {1.0, 2.5, 3}}}), "{\n  \"x\": [1.0, 2.5, 3]\n}\n");
    EXPECT_EQ(as_text(Json{{"x", {{{"y", 1}}}}}), "{\n  \"x\": [\n    {\n      \"y\": 1\n    }\n  ]\n}\n");
    EXPECT_EQ(as_text(Json(std::numeric_limits<double>::infinity())), "null\n");
    EXPECT_EQ(as_text(Json("\xff")), "\"\uFFFD\"\n");
}

TEST(JsonWriter, WritesEquallyInPiecesAndAtOnce) {
    const Json first{{"a", {1, 2}}}, second{{"b", {{{"c", 1.5}}}}};
    std::string text;
    JsonWriter writer([&](std::string_view piece) { text += piece; });
    writer.begin_object();
    writer.key("list");
    writer.begin_array();
    writer.element(first);
    writer.element_as(JsonWriter::text_within(2, second));
    writer.end_array();
    writer.key("last");
    writer.value("x");
    writer.end_object();
    EXPECT_EQ(text, as_text(Json{{"list", {first, second}}, {"last", "x"}}));
}

}  // namespace
}  // namespace setae::output::json_writer_test
