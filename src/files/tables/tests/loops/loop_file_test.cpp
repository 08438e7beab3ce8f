// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/tables/loop_file.hpp"

#include <cmath>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "import_samples.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/tables/table_file.hpp"

using namespace setae::tests;

namespace setae::tables::tests::loop_file_test {
namespace {

Table small_loop() {
    Table table;
    table.columns = {{"time", "s", Array1D{{0.0, 0.1}}},
                     {"force", "N", Array1D{{1e-3, -2.0 / 3.0}}},
                     {"displacement", "m", Array1D{{0.0, 1e-6}}},
                     {"contact_radius", "m", Array1D{{std::nan(""), 1e-5}}}};
    return table;
}

TEST(LoopFile, IsWrittenAsDocumented) {
    EXPECT_EQ(
        as_loop_file(small_loop(),
                     {{"surface", "UNCD"}, {"sphere_radius", "1.25 mm"}, {"file", "a.csv"}, {"comment", ""}}),
        "# format: setae loop\n# version: 1\n# comment:\n# sphere_radius: 1.25 mm\n# surface: UNCD\n"
        "time [s],force [N],displacement [m],contact_radius [m]\n0,0.001,0,\n0.1,-0.6666666666666666,1e-06,1e-05\n");
}

TEST(LoopFile, IsReadBackWithQuantitiesInSi) {
    const TemporaryFolder folder;
    write_loop(folder.path("l.csv"), small_loop(), {{"sphere_radius", "1.25 mm"}, {"surface", "UNCD: polished"}});
    const auto loop = read_loop(folder.path("l.csv"));
    EXPECT_EQ(loop.at("force")[1], -2.0 / 3.0);
    EXPECT_TRUE(std::isnan(loop.at("contact_radius")[0]));
    EXPECT_DOUBLE_EQ(loop_quantity(loop, "sphere_radius").value().value, 1.25e-3);
    EXPECT_FALSE(loop_quantity(loop, "sphere_radius").value().uncertain());
    EXPECT_FALSE(loop_quantity(loop, "lens_height").has_value());
    EXPECT_EQ(loop.metadata.at("surface"), "UNCD: polished");
    EXPECT_THROW((void)loop_quantity(loop, "surface"), InvalidArgument);
    EXPECT_NO_THROW((void)read_loop_table(folder.path("l.csv")));  // any reader of tables reads it
}

TEST(LoopFile, ReadsQuantitiesWithStandardErrors) {
    const TemporaryFolder folder;
    const auto with = [&](const std::string& entry) {
        return folder.write("l.csv",
                            "# format: setae loop\n# version: 1\n# " + entry + "\nforce [N],displacement [m]\n1,2\n");
    };
    const auto radius = loop_quantity(read_loop(with("sphere_radius: 1.25 ± 0.01 mm")), "sphere_radius").value();
    EXPECT_DOUBLE_EQ(radius.value, 1.25e-3);
    EXPECT_DOUBLE_EQ(radius.standard_error, 1e-5);
    for (const char* refused : {"sphere_radius: 1.25 ± 2 mm", "sphere_radius: -1 mm", "lens_poisson_ratio: 0.6",
                                "spring_constant: 1 ± 0.1 N/m"})
        EXPECT_THROW((void)read_loop(with(refused)), FormatError) << refused;
}

TEST(LoopFile, HandWrittenFilesMayUseOtherUnits) {
    const TemporaryFolder folder;
    const auto loop = read_loop(folder.write(
        "l.csv",
        "# format: setae loop\r\n# version: 1\r\n\r\n# just a remark\r\nforce [mN], displacement [um]\r\n1, 2\r\n# pause\r\n3, 4\r\n"));
    EXPECT_DOUBLE_EQ(loop.at("force")[1], 3e-3);
    EXPECT_DOUBLE_EQ(loop.at("displacement")[0], 2e-6);
}

TEST(LoopFile, MistakesAreNamedByLine) {
    const TemporaryFolder folder;
    const std::string head = "# format: setae loop\n# version: 1\n";
    const auto message = [&](const std::string& text) {
        return message_of([&] { (void)read_loop(folder.write("l.csv", text)); });
    };
    EXPECT_TRUE(holds(message("force [N],displacement [m]\n1,2\n"), "l.csv:1: not a loop file"));
    EXPECT_TRUE(holds(message("# format: setae loop\n# version: 2\nforce [N],displacement [m]\n1,2\n"),
                      "version '2' of the loop format is unknown; expected 1"));
    EXPECT_TRUE(
        holds(message(head + "# sphere_radius: 1.25\nforce [N],displacement [m]\n1,2\n"), "l.csv:3: sphere_radius"));
    EXPECT_TRUE(
        holds(message(head + "# sphere_radius: 1.25 N\nforce [N],displacement [m]\n1,2\n"), "l.csv:3: sphere_radius"));
    EXPECT_TRUE(holds(message(head + "# spot: 1\n# spot: 2\nforce [N],displacement [m]\n1,2\n"),
                      "l.csv:4: key 'spot' is given twice"));
    EXPECT_TRUE(holds(message(head + "force [N],displacement [m]\n1,2\n3\n"), "l.csv:5: 1 cells, expected 2"));
    EXPECT_TRUE(holds(message(head + "force [N],displacement [m]\n1,2\n3,x\n"),
                      "l.csv:5: 'x' for displacement is not a number"));
    EXPECT_TRUE(holds(message(head + "force [N],displacement [parsec]\n1,2\n"),
                      "l.csv:3: column 'displacement' has the unknown unit 'parsec'"));
    EXPECT_TRUE(holds(message(head + "force [N],force [N]\n1,2\n"), "two columns are named 'force'"));
    EXPECT_TRUE(holds(message(head + "force [N],displacement [m]\n"), "no rows of numbers"));
    EXPECT_TRUE(holds(message(head), "no row of column names"));
    EXPECT_TRUE(holds(message(head + "force [N],x [m]\n1,2\n"), "no column 'displacement' or 'contact_radius'"));
}

TEST(LoopFile, RefusesToWriteWhatCannotBeReadBack) {
    const auto loop = small_loop();
    for (const auto& [key, value] : {std::pair<std::string, std::string>{"Surface", "a"},
                                     {"surface", "two\nlines"},
                                     {"surface", " blank"},
                                     {"surface", "\xff"},
                                     {"1st", "a"},
                                     {"sphere_radius", "1.25"},
                                     {"lens_youngs_modulus", "2 mN"},
                                     {"", "a"}})
        EXPECT_THROW((void)as_loop_file(loop, {{key, value}}), InvalidArgument) << key << ": " << value;
    for (const auto& column : {Column{"a [x]", "", Array1D::Zero(2)},
                               {"load in mN", "", Array1D::Zero(2)},
                               {"force", "N", Array1D::Zero(2)},
                               {"x", "mm", Array1D::Zero(2)},
                               {"", "m", Array1D::Zero(2)},
                               {"#a", "m", Array1D::Zero(2)},
                               {"a", "m", Array1D::Zero(3)}}) {
        auto broken = loop;
        broken.columns.push_back(column);
        EXPECT_THROW((void)as_loop_file(broken, {}), InvalidArgument) << column.name;
    }
    auto no_force = loop;
    no_force.columns.erase(no_force.columns.begin() + 1);
    EXPECT_THROW((void)as_loop_file(no_force, {}), InvalidArgument);
}

TEST(LoopFile, EveryKeyIsInTheDocumentation) {
    std::ifstream document("docs/reference/loop-format.md");
    const std::string text{std::istreambuf_iterator<char>(document), {}};
    for (const auto& key : loop_keys()) EXPECT_TRUE(holds(text, fmt::format("| {} |", key.name))) << key.name;
}

}  // namespace
}  // namespace setae::tables::tests::loop_file_test
