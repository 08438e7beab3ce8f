// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "import_samples.hpp"
#include "setae/tables/spreadsheet.hpp"
#include "setae/tables/table_file.hpp"

using namespace setae::tests;

namespace setae::tables::tests::any_table_test {
namespace {

RawTable table_of(const std::string& text, const TableOptions& options = {}) {
    return read_raw_table(bytes::memory_source("t.csv", text), options);
}

TEST(AnyTable, UnitsAreFoundInEveryUsualSpelling) {
    for (const char* name :
         {"force (mN)", "force [mN]", "force_mN", "force / mN", "force in mN", "force mN", "force, mN"}) {
        const auto table = table_of(fmt::format("{};time [s]\n1;2\n3;4\n", name));
        EXPECT_EQ(table.columns[0].name, "force") << name;
        EXPECT_EQ(table.columns[0].unit, "mN") << name;
    }
}

TEST(AnyTable, NamesEndingLikeUnitsAreUnchanged) {
    const auto table = table_of("contact_radius,F_max,T_min,x_m,column_1\n1,2,3,4,5\n2,3,4,5,6\n");
    EXPECT_EQ(table.columns[0].name, "contact_radius");
    EXPECT_EQ(table.columns[1].name, "F_max");
    EXPECT_EQ(table.columns[2].name, "T_min");
    EXPECT_EQ(table.columns[3].name, "x_m");
    EXPECT_EQ(table.columns[4].name, "column_1");
}

TEST(AnyTable, TwoUnitsForOneColumnAreRefused) {
    const auto message = message_of([] { (void)table_of("force [mN],time [s]\nN,s\n1,2\n2,3\n"); });
    EXPECT_TRUE(holds(message, "mixed units: column 'force' is in mN according to its name and in N")) << message;
}

TEST(AnyTable, KeyedCommentsAreKeptAsMetadata) {
    const auto table = table_of(
        "# surface: UNCD\n# sphere radius : 1.25 mm\n# a remark\nforce [mN],time [s]\n1,2\n# stopped: here\n2,3\n");
    EXPECT_EQ(table.metadata.at("surface"), "UNCD");
    EXPECT_EQ(table.metadata.at("sphere radius"), "1.25 mm");
    EXPECT_EQ(table.metadata.size(), 2u);
    EXPECT_EQ(table.columns[0].values.size(), 2);
    const TemporaryFolder folder;
    EXPECT_EQ(read_table(folder.write("t.csv", "# surface: UNCD\na,b\n1,2\n3,4\n")).metadata.at("surface"), "UNCD");
}

TEST(AnyTable, AmbiguousCommasAreRefusedWithTheOptions) {
    const std::string text = "force [mN]\ttime [s]\n1,234\t5,678\n-2,345\t6,789\n";
    const auto message = message_of([&] { (void)table_of(text); });
    EXPECT_TRUE(holds(message, "t.csv:2: '1,234' is ambiguous")) << message;
    EXPECT_TRUE(holds(message, "decimal = \"comma\" or decimal = \"point\"")) << message;
    EXPECT_DOUBLE_EQ(table_of(text, {.decimal_point = ','}).columns[0].values[1], -2.345);
    EXPECT_DOUBLE_EQ(table_of(text, {.decimal_point = '.'}).columns[0].values[1], -2345.0);
}

TEST(AnyTable, OneCellDecidesTheMeaningOfCommas) {
    EXPECT_DOUBLE_EQ(table_of("a\tb\n1,234\t5,678\n1,5\t6,789\n").columns[0].values[0], 1.234);
    EXPECT_DOUBLE_EQ(table_of("a\tb\n1,234\t0,678\n2,345\t6,789\n").columns[0].values[0], 1.234);
    EXPECT_DOUBLE_EQ(table_of("a\tb\n1,234\t5.5\n2,345\t6.75\n").columns[0].values[0], 1234.0);
    EXPECT_DOUBLE_EQ(table_of("a\tb\n1,234,567.5\t5\n2,345.25\t6\n").columns[0].values[0], 1234567.5);
    EXPECT_DOUBLE_EQ(table_of("a;b\n1.234,5;5\n2.345,25;6\n").columns[0].values[0], 1234.5);
    EXPECT_DOUBLE_EQ(table_of("a;b\n1,234;5,678\n2,345;6,789\n").columns[0].values[0],
                     1.234);  // semicolons separate where commas are decimals
    EXPECT_DOUBLE_EQ(table_of("a\tb\n1.234\t5.678\n2.345\t6.789\n").columns[0].values[0], 1.234);
}

TEST(AnyTable, NumbersInQuotesKeepTheirSeparators) {
    const auto check = [](const std::string& text, double x, double z) {
        const auto table = table_of(text);
        ASSERT_EQ(table.columns.size(), 2u) << text;
        EXPECT_DOUBLE_EQ(table.columns[0].values[1], x) << text;
        EXPECT_DOUBLE_EQ(table.columns[1].values[1], z) << text;
    };
    check("\"x [um]\",\"z [nm]\"\n\"0,0\",\"1,5\"\n\"1,0\",\"-2,5\"\n", 1.0, -2.5);
    check("x [um],z [nm]\n0.0,\"1,234.5\"\n1.0,\"2,234.5\"\n2.0,999.5\n", 1.0, 2234.5);
    check("x [um],\"z, up [nm]\"\n0.0,1.5\n1.0,2.5\n", 1.0, 2.5);
    check("x [um];z [nm]\n0,5;1.234,5\n1,5;-2.234,5\n2,5;999,5\n", 1.5, -2234.5);
    check("x [um];z [nm]\n0,5;1 234,5\n1,5;2\u202f234,5\n2,5;999,5\n", 1.5, 2234.5);
    check("x [um];z [nm]\n0.5;1'234.5\n1.5;2\u2019234.5\n2.5;999.5\n", 1.5, 2234.5);
    check("x [um],z [nm]\n\"0\",\" 1.5\"\n\"1\",\" 2.5\"\n", 1.0, 2.5);
    EXPECT_TRUE(holds(message_of([] { (void)table_of("x [um],z [nm]\n\"1,234\",\"2,345\"\n\"5,678\",\"6,789\"\n"); }),
                      "ambiguous"));
}

TEST(AnyTable, AmbiguousPointsAreRefused) {
    const std::string text = "x [um];z [nm]\n0;1.234\n1;999\n2;12.000\n";
    EXPECT_TRUE(holds(message_of([&] { (void)table_of(text); }),
                      "t.csv:2: '1.234' is ambiguous, as is every number with a point"));
    EXPECT_DOUBLE_EQ(table_of(text, {.decimal_point = ','}).columns[1].values[2], 12000.0);
    EXPECT_DOUBLE_EQ(table_of("x [um];z [nm]\n0;1.234\n1;999.000\n2;12.000\n").columns[1].values[2], 12.0);
    EXPECT_DOUBLE_EQ(table_of("x [um];z [nm]\n0;1.234\n1;999\n2;12.5\n").columns[1].values[0], 1.234);
}

TEST(AnyTable, PointsGroupThousandsIfCommasAreDecimal) {
    std::string text = "x [um];z [nm]\n0,5;1.234\n";
    for (int i = 1; i < 200; ++i) text += fmt::format("{},5;{},25\n", i, i);
    EXPECT_DOUBLE_EQ(table_of(text).columns[1].values[0], 1234.0);
}

TEST(AnyTable, CommasBothSeparatingAndDecimalAreRefused) {
    const auto message = message_of([] { (void)table_of("force [mN],time [s]\n1,5,0,1\n2,5,0,2\n"); });
    EXPECT_TRUE(holds(message, "t.csv:2: 4 numbers between commas below 2 names")) << message;
}

TEST(AnyTable, ColumnsOfTextAreKeptSeparate) {
    const auto table = table_of("force [mN],state,time [s]\n1,free flight,2\n3,contact,4\n,contact,5\n");
    ASSERT_EQ(table.columns.size(), 3u);
    EXPECT_EQ(table.columns[1].name, "state");
    EXPECT_TRUE(holds(table.columns[1].text, "'free flight' on line 2"));
    EXPECT_TRUE(table.columns[1].values.isNaN().all());
    EXPECT_DOUBLE_EQ(table.columns[2].values[1], 4.0);
    EXPECT_TRUE(std::isnan(table.columns[0].values[2]));
}

TEST(AnyTable, InvalidRowsAreNamed) {
    EXPECT_TRUE(holds(message_of([] { (void)table_of("a,b\n1,2\n3,4\n5\n6,7\n"); }), "t.csv:4: 1 columns, expected 2"));
    EXPECT_TRUE(holds(message_of([] { (void)table_of("a,b\n1,2\n3,oops\n5,6\n6,7\n"); }),
                      "t.csv:3: 'oops' in column 2 is not a number"));
    EXPECT_TRUE(holds(message_of([] { (void)table_of("only words here\nand there\n"); }), "no row of numbers"));
    EXPECT_TRUE(holds(message_of([] { (void)table_of(""); }), "is empty"));
}

TEST(Spreadsheet, FirstSheetWithATableIsRead) {
    const auto table = read_raw_table(bytes::memory_source("t.xlsx", xlsx_loop()));
    ASSERT_EQ(table.columns.size(), 3u);
    EXPECT_EQ(table.columns[0].name, "Force");
    EXPECT_EQ(table.columns[0].unit, "mN");
    EXPECT_EQ(table.columns[1].name, "Displacement");
    EXPECT_EQ(table.columns[1].unit, "um");
    EXPECT_DOUBLE_EQ(table.columns[1].values[0], 10.5);
    EXPECT_TRUE(std::isnan(table.columns[1].values[2]));
    EXPECT_DOUBLE_EQ(table.columns[0].values[2], 3.0);
    EXPECT_TRUE(holds(table.columns[2].text, "'ok' in cell D4"));
    EXPECT_EQ(table.header.front(), "sheet: Loop");
}

TEST(Spreadsheet, SheetsAreChosenByName) {
    const auto first =
        xlsx_sheet({{{"A1", "a [N]"}, {"B1", "b [m]"}}, {{"A2", "1"}, {"B2", "2"}}, {{"A3", "3"}, {"B3", "4"}}});
    const auto second =
        xlsx_sheet({{{"A1", "a [N]"}, {"B1", "b [m]"}}, {{"A2", "5"}, {"B2", "6"}}, {{"A3", "7"}, {"B3", "8"}}});
    const auto book = bytes::memory_source("t.xlsx", xlsx_file({{"one", first}, {"two", second}}));
    EXPECT_DOUBLE_EQ(read_raw_table(book).columns[0].values[0], 1.0);
    EXPECT_EQ(read_raw_table(book).metadata.at("other_sheets"), "two");
    EXPECT_DOUBLE_EQ(read_raw_table(book, {.sheet = "two"}).columns[0].values[1], 7.0);
    EXPECT_TRUE(holds(message_of([&] { (void)read_raw_table(book, {.sheet = "three"}); }),
                      "no sheet 'three'; the workbook has 'one', 'two'"));
    EXPECT_TRUE(holds(message_of([] { (void)table_of("1 2\n3 4\n", {.sheet = "one"}); }), "is not a workbook"));
}

TEST(Spreadsheet, MistakesAreNamedByCell) {
    const auto message = [](const std::string& sheet, const std::vector<std::string>& strings = {}) {
        return message_of([&] {
            (void)read_raw_table(bytes::memory_source("t.xlsx", xlsx_file({{"S", sheet}}, strings)));
        });
    };
    EXPECT_TRUE(holds(message(xlsx_sheet({})), "sheet 'S' is empty"));
    EXPECT_TRUE(holds(message(xlsx_sheet({{{"A1", "words"}}, {{"A2", "more"}}})), "does not have two rows of numbers"));
    const auto text = xlsx_sheet({{{"A1", "a"}, {"B1", "b"}},
                                  {{"A2", "1"}, {"B2", "2"}},
                                  {{"A3", "3"}, {"B3", "oops"}},
                                  {{"A4", "5"}, {"B4", "6"}}});
    EXPECT_TRUE(holds(message(text), "sheet 'S': 'oops' in cell B3 is not a number"));
    EXPECT_TRUE(holds(message(xlsx_sheet({{{"A1", "s:7"}}})), "shared string '7' does not exist; there are 0"));
    EXPECT_TRUE(holds(message(xlsx_sheet({{{"ZZZZ1", "1"}}})), "'ZZZZ1' is not a cell"));
    EXPECT_TRUE(holds(message("<worksheet>"), "is not XML"));
    EXPECT_TRUE(holds(message(R"(<worksheet><sheetData><row r="0"><c><v>1</v></c></row></sheetData></worksheet>)"),
                      "'0' is not a row"));
}

TEST(Spreadsheet, OneLongStringInManyCellsIsRefused) {
    std::string cells;
    for (int k = 0; k < 300; ++k) cells += R"(<c t="s"><v>0</v></c>)";
    const auto sheet = "<worksheet><sheetData><row>" + cells + "</row></sheetData></worksheet>";
    const auto book = xlsx_file({{"S", sheet}}, {"<t>" + std::string(1 << 20, 'x') + "</t>"});
    EXPECT_TRUE(holds(message_of([&] { (void)read_raw_table(bytes::memory_source("t.xlsx", book)); }),
                      "sheet 'S': more than 256 MB of text in its cells, at IW1"));
}

}  // namespace
}  // namespace setae::tables::tests::any_table_test
