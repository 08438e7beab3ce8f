// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/fields/describe.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "setae/core/errors.hpp"

namespace setae::fields {

/// Same form as loops::Outcome.
template <class T>
struct Outcome {
    std::optional<T> value;
    std::string reason;

    explicit operator bool() const { return value.has_value(); }
    const T& operator*() const { return *value; }
};

struct Point {
    double x = 0.0;
    std::string name;
};

/// A field of every kind.
struct Sample {
    bool flag = true;
    int whole = 3;
    double number = 0.5, force = 2e-3, stiffness = 5.0;
    Estimate energy{.value = 1.0, .standard_error = 0.1};
    TracedValue area{Estimate{.value = 4.0, .standard_error = 0.5}, "area"};
    std::string text = "words";
    std::vector<std::string> texts{"a", "b"};
    std::vector<double> values{1.0, 2.0}, numbers{3.0, 4.0};
    Array1D column = Array1D::Constant(1, 5.0);
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(2, 2);
    std::vector<int> wholes{1, 2};
    Point point{1.0, "first"};
    std::vector<Point> points{{2.0, "second"}, {3.0, "third"}};
    std::vector<Point> left_out_if_empty;
    std::optional<double> absent, no_value, there = 7.0;
    Outcome<Point> failed{{}, "no data"}, found{Point{5.0, "found"}, ""};
    std::vector<std::pair<std::string, Estimate>> by_name{{"model", {.value = 6.0}}};
    std::vector<std::pair<std::string, double>> none_by_name;
    double hidden = 9.0;
};

template <>
struct Described<Point> {
    using T = Point;
    static constexpr std::array rows{field<&T::x>("x", "place"), field<&T::name>("name", "of the point")};
    static constexpr Description description{"point", "a point", rows};
};
static_assert(complete<Point>);

template <>
struct Described<Sample> {
    using T = Sample;
    static constexpr std::array<std::string_view, 2> words{"words", "deeds"};
    static constexpr std::array names_row{field<&T::texts>("texts", "a list")};
    static constexpr Description together{"", "fields that stand together", names_row};
    static constexpr std::array rows{
        field<&T::flag>("flag", "yes or no"),
        field<&T::whole>("whole", "a count"),
        field<&T::number>("number", "a ratio"),
        value<&T::force>("force", "N", "a force"),
        quantity<&T::stiffness>("stiffness", "k", "N/m", "a quantity without an error"),
        quantity<&T::energy>("energy", "E", "J", "an energy").as("energy_loss"),
        quantity<&T::area>("area", "A", "m2", "an area"),
        field<&T::text>("text", "words").one_of(words),
        part<T>("part", "texts in an object of their own", together),
        value<&T::values>("values", "J/m2", "two works"),
        field<&T::numbers>("numbers", "two numbers"),
        field<&T::column>("column", "an array"),
        field<&T::matrix>("matrix", "rows of numbers"),
        field<&T::wholes>("wholes", "two counts"),
        field<&T::point>("point", "a point"),
        field<&T::points>("points", "points"),
        field<&T::left_out_if_empty>("left_out_if_empty", "none").with(Missing::left_out),
        field<&T::absent>("absent", "no field"),
        field<&T::no_value>("no_value", "null").or_null(),
        value<&T::there>("there", "s", "a time"),
        field<&T::failed>("failed", "null and a reason"),
        field<&T::found>("found", "a point"),
        quantity<&T::by_name>("by_name", "W", "J/m2", "of each model"),
        field<&T::none_by_name>("none_by_name", "null").or_null(),
        made<T>("twice", "computed", [](const T& of) { return 2.0 * of.number; }),
        made<T>("of_its_own_unit", "computed",
                [](const T& of) { return Quantity{.quantity = "q", .estimate = {.value = of.number}, .unit = "m/s"}; }),
        written_elsewhere("answer", "by other code"),
        inner<&T::hidden>(),
    };
    static constexpr Description description{"", "a sample", rows};
};
static_assert(complete<Sample>);

namespace {

/// Records everything in the order of arrival.
class Recorded final : public Sink {
public:
    std::string text_;

    void flag(const Row& row, bool value) override { add(row, value ? "true" : "false"); }
    void whole(const Row& row, long long value) override { add(row, std::to_string(value)); }
    void whole(const Row& row, std::uint64_t value) override { add(row, std::to_string(value)); }
    void number(const Row& row, double value) override { add(row, shown(value)); }
    void value(const Row& row, double value) override { add(row, shown(value) + " " + std::string(row.unit)); }
    void quantity(const Row& row, const Estimate& e) override {
        add(row, shown(e.value) + "±" + shown(e.standard_error) + " " + std::string(row.unit));
    }
    void quantity(const Row& row, const Quantity& q) override { add(row, shown(q.estimate.value) + " " + q.unit); }
    void fields_of(const Quantity& q) override { text_ += q.quantity + " " + shown(q.estimate.value) + ";"; }
    void text(const Row& row, std::string_view value) override { add(row, std::string(value)); }
    void begin_list(const Row& row) override { add(row, "["); }
    void end_list(const Row&) override { text_ += "]"; }
    void begin(const Row& row) override { add(row, "{"); }
    void end(const Row&) override { text_ += "}"; }
    void key(std::string_view name) override { text_ += std::string(name) + ":"; }
    void missing(const Row& row, std::string_view reason) override { add(row, "null(" + std::string(reason) + ")"); }

private:
    static std::string shown(double value) {
        char text[32];
        std::snprintf(text, sizeof text, "%g", value);
        return text;
    }
    void add(const Row& row, const std::string& value) { text_ += std::string(row.name) + "=" + value + ";"; }
};

std::string recorded(const Sample& sample) {
    Recorded sink;
    put(&sample, Described<Sample>::description, sink);
    return sink.text_;
}

TEST(Fields, AreWrittenInRowOrderWithUnitsAndReasons) {
    EXPECT_EQ(
        recorded({}),
        "flag=true;whole=3;number=0.5;force=0.002 N;stiffness=5±nan N/m;energy=1±0.1 J;area=4±0.5 m2;text=words;part={;texts=[;texts=a;texts=b;]}"
        "values=[;values=1;values=2;]numbers=[;numbers=3;numbers=4;]column=[;column=5;]"
        "matrix=[;matrix=[;matrix=1;matrix=0;]matrix=[;matrix=0;matrix=1;]]wholes=[;wholes=1;wholes=2;]point={;x=1;name=first;}"
        "points=[;points={;x=2;name=second;}points={;x=3;name=third;}]no_value=null();there=7 s;failed=null(no data);"
        "found={;x=5;name=found;}by_name={;model:by_name=6±nan J/m2;}none_by_name=null();twice=1;of_its_own_unit=0.5 m/s;");
}

TEST(Fields, PassOnUndefinedAndInfiniteNumbers) {
    Sample sample;
    sample.number = std::nan("");
    sample.force = INFINITY;
    EXPECT_NE(recorded(sample).find("number=nan;force=inf N;"), std::string::npos);
}

TEST(Fields, HaveTheKindOfTheirMember) {
    const auto kind = [](std::string_view name) {
        for (const auto& row : Described<Sample>::rows)
            if (row.name == name) return row.kind;
        ADD_FAILURE() << name;
        return Kind::flag;
    };
    EXPECT_EQ(kind("force"), Kind::value);
    EXPECT_EQ(kind("there"), Kind::value);
    EXPECT_EQ(kind("number"), Kind::number);
    EXPECT_EQ(kind("energy"), Kind::quantity);
    EXPECT_EQ(kind("area"), Kind::quantity);
    EXPECT_EQ(kind("text"), Kind::choice);
    EXPECT_EQ(kind("points"), Kind::objects);
    EXPECT_EQ(kind("found"), Kind::object);
    EXPECT_EQ(kind("by_name"), Kind::quantity_of);
    EXPECT_EQ(kind("none_by_name"), Kind::number_of);
}

struct Whole : Point {
    int more = 1;
};

}  // namespace

template <>
struct Described<Whole> {
    static constexpr std::array rows{inherited<Point, Whole>(), field<&Whole::more>("more", "its own")};
    static constexpr Description description{"", "a type with a base", rows};
};
static_assert(complete<Whole>);

namespace {

TEST(Fields, OfABaseComeBeforeDerivedFields) {
    Recorded sink;
    const Whole whole{{4.0, "base"}, 2};
    put(&whole, Described<Whole>::description, sink);
    EXPECT_EQ(sink.text_, "x=4;name=base;more=2;");
}

/// What is held by name, quantities under their own names, and what is filled later.
struct Held {
    std::vector<std::pair<std::string, Point>> points{{"a", {1.0, "first"}}};
    std::vector<std::pair<std::string, int>> counts{{"a", 2}};
    std::vector<std::pair<std::string, std::string>> labels{{"a", "one"}};
    std::map<std::string, int> sorted{{"b", 4}, {"a", 3}};
    std::map<std::string, int> none;
    std::vector<Quantity> list{{.quantity = "force", .estimate = {.value = 3.0}, .unit = "N"}};
    Boxed<Point> boxed, no_box;
};

}  // namespace

template <>
struct Described<Held> {
    using T = Held;
    static constexpr std::array possible_rows{possible("force", "F", "N", "a force"),
                                              possible("work", "W", "J", "a work")};
    static constexpr Description possible_quantities{"", "quantities", possible_rows};
    static constexpr std::array rows{
        field<&T::points>("points", "points by name"),
        field<&T::counts>("counts", "whole numbers by name"),
        field<&T::labels>("labels", "texts by name"),
        field<&T::sorted>("sorted", "whole numbers in the order of their names"),
        field<&T::none>("none", "whole numbers by name, of which there are none"),
        field<&T::list>("list", "quantities"),
        quantities_among<T>(possible_quantities, [](const T& of) -> const auto& { return of.list; }),
        quantity_fields<T>([](const T& of) -> const Quantity& { return of.list.front(); }),
        list_filled_later<Point>("later", "a list"),
        objects_filled_later<Point>("by_name_later", "objects"),
        field<&T::boxed>("boxed", "a point elsewhere"),
        field<&T::no_box>("no_box", "no point").or_null(),
    };
    static constexpr Description description{"", "what is held by name", rows};
};
static_assert(complete<Held>);

namespace {

TEST(Fields, WriteMapsByNameAndQuantitiesByTheirNames) {
    Recorded sink;
    Held held;
    held.boxed = Point{5.0, "boxed"};
    put(&held, Described<Held>::description, sink);
    EXPECT_EQ(sink.text_,
              "points={;a:points={;x=1;name=first;}}counts={;a:counts=2;}labels={;a:labels=one;}"
              "sorted={;a:sorted=3;b:sorted=4;}none={;}list=[;list=3 N;]"
              "force=3 N;force 3;later=[;]by_name_later={;}boxed={;x=5;name=boxed;}no_box=null();");
    EXPECT_EQ(Described<Held>::rows[0].kind, Kind::objects_of);
    EXPECT_EQ(Described<Held>::rows[1].kind, Kind::whole_of);
    EXPECT_EQ(Described<Held>::rows[2].kind, Kind::text_of);
    EXPECT_EQ(Described<Held>::rows[3].kind, Kind::whole_of);
    EXPECT_EQ(Described<Held>::rows[5].kind, Kind::quantities);
}

TEST(Fields, RefuseAnUndeclaredQuantity) {
    Recorded sink;
    Held held;
    held.list.front().quantity = "speed";
    EXPECT_THROW(put(&held, Described<Held>::description, sink), InternalError);
}

/// Values whose output differs from that of other numbers.
struct Odd {
    std::uint64_t seed = std::numeric_limits<std::uint64_t>::max();
    double work = 2.0;
};

}  // namespace

template <>
struct Described<Odd> {
    static constexpr std::array rows{field<&Odd::seed>("seed", "of random numbers"),
                                     field<&Odd::work>("work", "a number without its unit").in_unit("J/m2")};
    static constexpr Description description{"", "odd values", rows};
};
static_assert(complete<Odd>);

namespace {

TEST(Fields, HaveSeedsOf64BitsAndNumbersWithoutTheirUnit) {
    Recorded sink;
    const Odd odd;
    put(&odd, Described<Odd>::description, sink);
    EXPECT_EQ(sink.text_, "seed=18446744073709551615;work=2;");
    EXPECT_EQ(Described<Odd>::rows[1].kind, Kind::number);
    EXPECT_EQ(Described<Odd>::rows[1].unit, "J/m2");
}

/// Lists of lists, and what has its names from elsewhere.
struct Nested {
    std::vector<std::vector<int>> lists{{1, 2}, {}};
    std::vector<std::array<double, 2>> pairs{{3.0, 4.0}};
    std::map<std::string, std::string> notes{{"a", "one"}};
};

}  // namespace

template <>
struct Described<Nested> {
    using T = Nested;
    static constexpr std::array rows{
        field<&T::lists>("lists", "lists of counts").with(Missing::left_out),
        field<&T::pairs>("pairs", "pairs of numbers"),
        field<&T::notes>("notes", "texts by name"),
    };
    static constexpr Description description{"", "lists of lists", rows};
};
static_assert(complete<Nested>);

namespace {

TEST(Fields, MayBeListsOfLists) {
    Recorded sink;
    const Nested nested;
    put(&nested, Described<Nested>::description, sink);
    EXPECT_EQ(sink.text_,
              "lists=[;lists=[;lists=1;lists=2;]lists=[;]]pairs=[;pairs=[;pairs=3;pairs=4;]]notes={;a:notes=one;}");
    const auto& rows = Described<Nested>::rows;
    EXPECT_EQ(rows[0].kind, Kind::wholes);
    EXPECT_EQ(rows[0].levels, 2);
    EXPECT_EQ(rows[1].kind, Kind::numbers);
    EXPECT_EQ(rows[1].levels, 2);
    EXPECT_EQ(rows[2].kind, Kind::text_of);
}

/// Texts and lists that may be empty.
struct Empty {
    std::string text;
    std::vector<std::string> texts{""};
    std::optional<std::string> given_text = "";
    std::optional<std::vector<int>> given_list = std::vector<int>{};
};

}  // namespace

template <>
struct Described<Empty> {
    using T = Empty;
    static constexpr std::array rows{
        field<&T::text>("always", "empty"),
        field<&T::text>("left_out", "empty").with(Missing::left_out),
        field<&T::text>("null", "empty").or_null(),
        field<&T::texts>("texts", "empty texts").with(Missing::left_out),
        field<&T::given_text>("given_text", "given and empty"),
        field<&T::given_list>("given_list", "given and empty"),
    };
    static constexpr Description description{"", "what may be empty", rows};
};
static_assert(complete<Empty>);

namespace {

TEST(Fields, ThatAreEmptyMayBeMissing) {
    Recorded sink;
    const Empty empty;
    put(&empty, Described<Empty>::description, sink);
    EXPECT_EQ(sink.text_, "always=;null=null();texts=[;texts=;]given_text=;given_list=[;]");
}

TEST(Fields, MayBePlainNumbersOfQuantities) {
    static constexpr std::array possible_rows{number("force", "N", "a force"),
                                              number("work", "J", "a work").with(Missing::left_out)};
    static constexpr Description possible_numbers{"", "numbers", possible_rows};
    static constexpr std::array rows{numbers_among<Held>(possible_numbers, [](const Held& of) { return of.list; })};
    static constexpr Description description{"", "quantities without symbols", rows};
    Recorded sink;
    Held held;
    put(&held, description, sink);
    EXPECT_EQ(sink.text_, "force=3;");
    held.list.front().quantity = "speed";
    EXPECT_THROW(put(&held, description, sink), InternalError);
}

TEST(Fields, MayBeColumnsOfATable) {
    static constexpr std::array possible_rows{column("distance", "m", "a distance")};
    static constexpr Description possible_columns{"", "columns", possible_rows};
    constexpr auto itself = [](const Table& table) -> const Table& { return table; };
    static constexpr std::array rows{columns_among<Table>(possible_columns, itself), units_of_columns<Table>(itself)};
    static constexpr Description description{"", "a table", rows};
    const Table table{{{"distance", "m", Array1D::Constant(1, 2.0)}, {"unforeseen", "s", {}}}, {}};
    Recorded sink;
    put(&table, description, sink);
    EXPECT_EQ(sink.text_, "distance:=[;=2;]unforeseen:=[;]units={;distance:units=m;unforeseen:units=s;}");
}

TEST(Fields, MayBeColumnsWithUnits) {
    static constexpr std::array columns{field<&Point::x>("x", "place").in_unit("m")};
    static constexpr Description of_columns{"", "columns", columns};
    static constexpr std::array units{units_of(of_columns)};
    static constexpr auto rows = joined(columns, units);
    static constexpr Description description{"", "columns and their units", rows};
    const Point point{1.0, "first"};
    Recorded sink;
    put(&point, description, sink);
    EXPECT_EQ(sink.text_, "x=1;units={;x:units=m;}");
}

struct Grown {
    double first = 0.0, second = 0.0;
};

}  // namespace

template <>
struct Described<Grown> {
    static constexpr std::array rows{field<&Grown::first>("first", "named"), field<&Grown::first>("again", "twice")};
    static constexpr Description description{"", "a type of which a member has no row", rows};
};
static_assert(!complete<Grown>, "one member named twice is not two members");

}  // namespace setae::fields
