// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/bytes/nesting.hpp"

#include <gtest/gtest.h>

#include <string>

#include "setae/bytes/json_text.hpp"
#include "setae/bytes/yaml_text.hpp"
#include "setae/core/errors.hpp"

namespace setae::bytes::nesting_test {
namespace {

std::string repeated(const std::string& text, std::size_t count) {
    std::string all;
    for (std::size_t i = 0; i < count; ++i) all += text;
    return all;
}

TEST(Nesting, OfJsonCountsOpenBrackets) {
    EXPECT_FALSE(json_too_deep(repeated("[", max_levels) + repeated("]", max_levels)));
    EXPECT_EQ(json_too_deep(repeated("[", max_levels + 1)), max_levels);
    EXPECT_FALSE(json_too_deep(repeated("[]", 1000)));
    EXPECT_FALSE(json_too_deep("\"" + repeated("[", 1000) + "\\\"" + repeated("{", 1000) + "\""));
}

TEST(Nesting, OfXmlCountsOpenElements) {
    EXPECT_FALSE(xml_too_deep(repeated("<a>", max_levels) + repeated("</a>", max_levels)));
    EXPECT_EQ(xml_too_deep(repeated("<a>", max_levels + 1)), 3 * max_levels);
    EXPECT_FALSE(xml_too_deep(repeated("<a/>", 1000) + repeated("<b></b>", 1000)));
    EXPECT_FALSE(xml_too_deep("<!--" + repeated("<a>", 1000) + "--><![CDATA[" + repeated("<a>", 1000) + "]]><?x?>"));
}

TEST(Nesting, OfTomlCountsDottedNamesToo) {
    EXPECT_FALSE(toml_too_deep("[a.b.c]\nx = 1.5\ny = [[1.0, 2.0], [3.0, 4.0]]\n" + repeated("z = 1.5e3\n", 1000)));
    EXPECT_TRUE(toml_too_deep("a" + repeated(".a", max_levels + 1) + " = 1"));
    EXPECT_TRUE(toml_too_deep("[" + repeated("a . ", max_levels + 2) + "a]"));
    EXPECT_TRUE(toml_too_deep("x = " + repeated("[", max_levels + 1)));
    EXPECT_FALSE(
        toml_too_deep("text = \"" + repeated("a.", 1000) + repeated("[", 1000) + "\" # " + repeated("[", 1000)));
    EXPECT_FALSE(toml_too_deep("text = \"\"\"\n" + repeated("[", 1000) + "\n\"\"\"\n"));
}

TEST(Json, WhenDamagedIsRefusedWithTheByteOffset) {
    const auto message = [](const std::string& text) {
        try {
            (void)parsed_json(text, "a.json", "no trace");
        } catch (const FormatError& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(message("{\"a\": [1, 2]}"), "");
    EXPECT_EQ(message("{\"a\": ,}"), "a.json: at byte 7: no trace");
    EXPECT_EQ(message(repeated("[", 200'000)), "a.json: at byte 64: no trace; JSON of more than 64 levels is not read");
    EXPECT_TRUE(json_or_null(repeated("[", 200'000)).is_null());
    EXPECT_TRUE(json_or_null("{").is_null());
    EXPECT_EQ(json_or_null("[1]").size(), 1u);
}

std::string refusal_of_yaml(const std::string& text) {
    try {
        (void)parsed_yaml(text, "a.yml");
    } catch (const FormatError& error) {
        return error.what();
    }
    return "";
}

TEST(Yaml, WithAliasesIsReadUpToALimit) {
    const auto node = parsed_yaml("base: &b {x: 1}\nfirst: *b\nsecond: [*b, *b]\n", "a.yml");
    EXPECT_EQ(node["second"][1]["x"].as<int>(), 1);
    EXPECT_NE(refusal_of_yaml("x: &a [*a]").find("a.yml:1: YAML: an alias of a node that contains this alias"),
              std::string::npos);
    EXPECT_NE(refusal_of_yaml("x:\n  - &a {y: [*a]}").find("a.yml:2:"), std::string::npos);
    std::string laughs = "a0: &a0 [x]\n";
    for (int i = 1; i < 12; ++i)
        laughs += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [" +
                  repeated("*a" + std::to_string(i - 1) + ",", 10) + "]\n";
    EXPECT_NE(refusal_of_yaml(laughs).find("its aliases repeat too much"), std::string::npos);
    std::string chain = "a0: &a0 [x]\n";
    for (int i = 1; i < 80; ++i)
        chain += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [*a" + std::to_string(i - 1) + "]\n";
    EXPECT_NE(refusal_of_yaml(chain).find("more than 64 levels"), std::string::npos);
}

TEST(Yaml, TooDeepOrInvalidIsRefused) {
    EXPECT_EQ(refusal_of_yaml(repeated("[", 60) + repeated("]", 60)), "");
    EXPECT_NE(refusal_of_yaml(repeated("[", 200'000)).find("more than 64 levels"), std::string::npos);
    EXPECT_NE(refusal_of_yaml(repeated("{a: ", 200'000)).find("more than 64 levels"), std::string::npos);
    EXPECT_NE(refusal_of_yaml("a: [1").find("a.yml:"), std::string::npos);
    EXPECT_EQ(refusal_of_yaml(""), "");
}

}  // namespace
}  // namespace setae::bytes::nesting_test
