// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "setae/answers/json_schemas.hpp"

namespace setae::answers {
namespace {

TEST(QuantitiesInJson, HaveOneSymbolEach) {
    std::map<std::string, std::string> symbols;
    for (const auto& quantity : quantities_in_json(JsonSchemas())) {
        const auto [first, is_new] = symbols.emplace(quantity.name, quantity.symbol);
        EXPECT_EQ(first->second, quantity.symbol) << quantity.name << " at " << quantity.places.front();
    }
    EXPECT_GT(symbols.size(), 100u);
}

TEST(QuantitiesInJson, HaveOneUnitOrThatOfTheData) {
    std::map<std::string, std::string> units;
    for (const auto& quantity : quantities_in_json(JsonSchemas())) {
        if (quantity.unit.empty()) continue;
        const auto [first, is_new] = units.emplace(quantity.name, quantity.unit);
        EXPECT_EQ(first->second, quantity.unit) << quantity.name << " at " << quantity.places.front();
    }
}

TEST(QuantitiesInJson, HaveAMeaningAndAPlace) {
    for (const auto& quantity : quantities_in_json(JsonSchemas())) {
        EXPECT_FALSE(quantity.meaning.empty()) << quantity.name;
        EXPECT_FALSE(quantity.places.empty()) << quantity.name;
    }
}

}  // namespace
}  // namespace setae::answers
