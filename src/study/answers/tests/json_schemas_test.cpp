// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/json_schemas.hpp"

#include <algorithm>
#include <array>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "setae/core/errors.hpp"
#include "setae/fields/describe.hpp"

namespace setae::answers::json_schemas_test {

struct Weight {
    double value = 0.0;
};
struct Weights {
    int count = 0;
};

}  // namespace setae::answers::json_schemas_test

template <>
struct setae::fields::Described<setae::answers::json_schemas_test::Weight> {
    using T = answers::json_schemas_test::Weight;
    static constexpr std::array rows{value<&T::value>("weight", "N", "weight of the body")};
    static constexpr Description description{"", "weight of a body", rows};
};

template <>
struct setae::fields::Described<setae::answers::json_schemas_test::Weights> {
    using T = answers::json_schemas_test::Weights;
    static constexpr std::array rows{field<&T::count>("count", "number of bodies")};
    static constexpr Description description{"", "weights of several bodies", rows};
};

namespace setae::answers::json_schemas_test {
namespace {

constexpr std::array further{
    DescribedOutput{.command = "weigh", .description = &fields::Described<Weight>::description},
    DescribedOutput{.command = "balance", .description = &fields::Described<Weight>::description, .is_list = true},
    DescribedOutput{.command = "weigh", .description = &fields::Described<Weights>::description},
};

TEST(JsonSchemas, AreOrderedByCommand) {
    const auto commands = JsonSchemas(further).commands();
    EXPECT_TRUE(std::is_sorted(commands.begin(), commands.end()));
    EXPECT_EQ(std::count(commands.begin(), commands.end(), "weigh"), 1);
    EXPECT_EQ(std::count(commands.begin(), commands.end(), "balance"), 1);
    EXPECT_EQ(commands.size(), JsonSchemas().commands().size() + 2);
}

TEST(JsonSchemas, OfAListDescribeItsEntries) {
    const auto schema = JsonSchemas(further).of("balance");
    EXPECT_EQ(schema["type"], "array");
    EXPECT_EQ(schema["items"]["properties"]["weight"]["unit"], "N");
    EXPECT_TRUE(schema["$defs"].contains("value"));
}

TEST(JsonSchemas, OfOneCommandAreAlternatives) {
    const auto schema = JsonSchemas(further).of("weigh");
    EXPECT_EQ(schema["description"], "weight of a body; or weights of several bodies");
    ASSERT_EQ(schema["anyOf"].size(), 2U);
    EXPECT_TRUE(schema["anyOf"][0]["properties"].contains("weight"));
    EXPECT_TRUE(schema["anyOf"][1]["properties"].contains("count"));
}

TEST(JsonSchemas, RefuseAnUnknownCommand) { EXPECT_THROW((void)JsonSchemas().of("weigh"), InvalidArgument); }

}  // namespace
}  // namespace setae::answers::json_schemas_test
