// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/fields/option.hpp"

#include <array>

#include <gtest/gtest.h>

namespace setae::fields {
namespace {

struct Wanted {
    std::string radius;
    std::optional<double> ratio;
    bool free = false;
};

}  // namespace

template <>
struct Asked<Wanted> {
    using R = Wanted;
    static constexpr std::array options{
        option<&R::radius>("sphere_radius", "radius of the sphere")
            .of(positive(dimension::length))
            .such_as("1 mm")
            .or_else("that of the file"),
        option<&R::ratio>("poisson_ratio", "Poisson ratio").within(domain::poisson_ratio).in_python("nu"),
        option<&R::free>("free", "free edges"),
    };
};

namespace option_test {
namespace {

TEST(Option, KnowsWhereItsValueIsKept) {
    Wanted wanted;
    *std::get<std::string*>(Asked<Wanted>::options[0].place(&wanted)) = "2 mm";
    *std::get<std::optional<double>*>(Asked<Wanted>::options[1].place(&wanted)) = 0.4;
    *std::get<bool*>(Asked<Wanted>::options[2].place(&wanted)) = true;
    EXPECT_EQ(wanted.radius, "2 mm");
    EXPECT_EQ(wanted.ratio, 0.4);
    EXPECT_TRUE(wanted.free);
}

TEST(Option, HasASentenceOfHelp) {
    EXPECT_EQ(help_of(Asked<Wanted>::options[0]), "radius of the sphere, such as \"1 mm\"; default: that of the file");
    EXPECT_EQ(help_of(Asked<Wanted>::options[2]), "free edges");
}

TEST(Spelled, NamesOptionsAsAFrontEndDoes) {
    const auto typed = [](std::string_view name, std::string_view value) {
        if (name != "poisson_ratio" && name != "layer") return std::string();
        return "--" + std::string(name) + (value.empty() ? "" : " \"" + std::string(value) + "\"");
    };
    EXPECT_EQ(spelled("expected `poisson_ratio` with `layer = 1 um`", typed),
              "expected --poisson_ratio with --layer \"1 um\"");
    EXPECT_EQ(spelled("`setae info` lists them", typed), "`setae info` lists them");
    EXPECT_EQ(spelled("a lone ` stays", typed), "a lone ` stays");
    EXPECT_EQ(spelled("", typed), "");
}

}  // namespace
}  // namespace option_test
}  // namespace setae::fields
