// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/fields/view.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

namespace setae::fields {

struct Edge {
    std::string name = "receding";
    Estimate speed{.value = 2e-6, .standard_error = 1e-6};
};

struct Contact {
    bool full = true;
    double share = 0.25;
    std::optional<Edge> edge, other;
    std::vector<Edge> edges{{"one", {.value = 1.0}}, {"two", {.value = 2.0}}};
};

template <>
struct Described<Edge> {
    using T = Edge;
    static constexpr std::array rows{field<&T::name>("name", "of the edge"),
                                     quantity<&T::speed>("speed", "v", "m/s", "of it")};
    static constexpr Description description{"", "an edge", rows};
};
template <>
struct Described<Contact> {
    using T = Contact;
    static constexpr std::array rows{field<&T::full>("full", "whether it is"), field<&T::share>("share", "in contact"),
                                     field<&T::edge>("edge", "its edge"),
                                     field<&T::other>("other", "another").or_null(), field<&T::edges>("edges", "all")};
    static constexpr Description description{"", "a contact", rows};
};

struct Marked : Contact {
    std::string mark = "own";
};
template <>
struct Described<Marked> {
    using T = Marked;
    static constexpr std::array rows{inherited<Contact, T>(), field<&T::mark>("mark", "its own")};
    static constexpr Description description{"", "a contact with a mark", rows};
};

namespace {

constexpr auto view = view_of<Contact>({{"full"},
                                        {"in contact", "share"},
                                        {"edge", "edge.name"},
                                        {"v", "edge.speed", 1e-6},
                                        {"v of the other", "other.speed", Errors::left_out}});

TEST(View, SelectsFieldsByPathAndConvertsUnits) {
    const auto picked = cells(Contact{.edge = Edge{}}, view);
    ASSERT_EQ(picked.size(), 5u);
    EXPECT_EQ(std::get<std::string>(picked[0].value), "yes");
    EXPECT_EQ(std::get<double>(picked[1].value), 0.25);
    EXPECT_EQ(std::get<std::string>(picked[2].value), "receding");
    EXPECT_DOUBLE_EQ(std::get<double>(picked[3].value), 2.0);
    EXPECT_DOUBLE_EQ(picked[3].standard_error, 1.0);
    EXPECT_TRUE(std::isnan(std::get<double>(picked[4].value))) << "the speed of one edge is not that of another";
}

TEST(View, OfMissingPartsHasEmptyTextsAndUndefinedNumbers) {
    const auto picked = cells(Contact{}, view);
    EXPECT_EQ(std::get<std::string>(picked[2].value), "");
    EXPECT_TRUE(std::isnan(std::get<double>(picked[3].value)));
    EXPECT_TRUE(std::isnan(picked[3].standard_error));
}

TEST(View, FindsFieldsOfInlinedParts) {
    static constexpr auto of_marked = view_of<Marked>({{"mark"}, {"in contact", "share"}, {"edge", "edge.name"}});
    Marked marked;
    marked.edge = Edge{};
    const auto picked = cells(marked, of_marked);
    EXPECT_EQ(std::get<std::string>(picked[0].value), "own");
    EXPECT_EQ(std::get<double>(picked[1].value), 0.25);
    EXPECT_EQ(std::get<std::string>(picked[2].value), "receding");
}

TEST(View, DistinguishesColumnsWithErrors) {
    EXPECT_FALSE(has_error(view[1]));
    EXPECT_TRUE(has_error(view[3]));
    EXPECT_FALSE(has_error(view[4]));
    EXPECT_TRUE(holds_words(view[0]));
    EXPECT_FALSE(holds_words(view[3]));
}

}  // namespace
}  // namespace setae::fields
