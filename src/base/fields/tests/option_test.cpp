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
    std::vector<long> left_out;
    std::vector<std::string> notes;
    std::string table;
    int order = 1;
    std::vector<std::string> steps;
};

}  // namespace

template <>
struct Asked<Wanted> {
    using R = Wanted;
    static constexpr std::array options{
        option<&R::radius>("sphere_radius", "radius of the sphere")
            .of(positive(dimension::length), "mm")
            .such_as("1 mm")
            .or_else("that of the file"),
        option<&R::ratio>("poisson_ratio", "Poisson ratio").within(domain::poisson_ratio).in_python("nu"),
        option<&R::free>("free", "free edges"),
        option<&R::left_out>("exclude", "numbers of frames left out").separated_by(','),
        option<&R::notes>("note", "note on a frame").such_as("12: glare").one_at_a_time(),
        option<&R::table>("table", "table of frames").of_input(),
        option<&R::order>("order", "order of the derivative").between(1, 3),
        option<&R::steps>("step", "step of the processing")
            .offering([] {
                return std::vector<std::string>{"level", "despike"};
            })
            .one_at_a_time()
            .or_word("steps"),
    };
};

namespace option_test {
namespace {

TEST(Option, ValueIsKeptInItsMember) {
    Wanted wanted;
    *std::get<std::string*>(Asked<Wanted>::options[0].place(&wanted)) = "2 mm";
    *std::get<std::optional<double>*>(Asked<Wanted>::options[1].place(&wanted)) = 0.4;
    *std::get<bool*>(Asked<Wanted>::options[2].place(&wanted)) = true;
    EXPECT_EQ(wanted.radius, "2 mm");
    EXPECT_EQ(wanted.ratio, 0.4);
    std::get<std::vector<long>*>(Asked<Wanted>::options[3].place(&wanted))->push_back(12);
    EXPECT_TRUE(wanted.free);
    EXPECT_EQ(wanted.left_out, std::vector<long>{12});
}

TEST(Option, DescribesItsDomain) {
    const auto& [radius, ratio, free, excluded, note, table, order, step] = Asked<Wanted>::options;
    EXPECT_EQ(radius.usual_unit, "mm");
    EXPECT_EQ(ratio.domain->upper, 0.5);
    EXPECT_FALSE(free.whole);
    EXPECT_EQ(order.whole->least, 1);
    EXPECT_EQ(order.whole->greatest, 3);
    EXPECT_EQ(step.offered(), (std::vector<std::string>{"level", "despike"}));
    EXPECT_TRUE(step.named_each_time);
    EXPECT_FALSE(order.named_each_time);
    EXPECT_EQ(step.word, "steps");
}

TEST(Option, HasAHelpSentence) {
    EXPECT_EQ(help_of(Asked<Wanted>::options[0]), "radius of the sphere, such as \"1 mm\"; default: that of the file");
    EXPECT_EQ(help_of(Asked<Wanted>::options[2]), "free edges");
    EXPECT_EQ(help_of(Asked<Wanted>::options[4]), "note on a frame, such as \"12: glare\"; may be repeated");
}

TEST(Option, DescribesListsRepetitionAndInputFiles) {
    const auto& [radius, ratio, free, excluded, note, table, order, step] = Asked<Wanted>::options;
    EXPECT_EQ(excluded.separator, ',');
    EXPECT_TRUE(note.named_each_time && !excluded.named_each_time);
    EXPECT_TRUE(table.is_input && !note.is_input);
}

TEST(Spelled, WritesOptionsInTheStyleOfTheFrontEnd) {
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
