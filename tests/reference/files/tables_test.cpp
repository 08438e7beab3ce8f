// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "reference_data.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/tables/mapping.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::formats::tables_test {
namespace {

constexpr const char* mapping_path = "examples/mappings/eoh.toml";

/// Points, F_max and F_po [nN] as the files' MEMS columns give them: extremes above the median of the first 5 % of
/// points.
struct Loop {
    const char* file;
    Index points;
    double largest_force;
    double pull_off_force;
};

void PrintTo(const Loop& loop, std::ostream* stream) { *stream << loop.file; }

class MemsLoop : public testing::TestWithParam<Loop> {};

double median_of_start(const Array1D& values) {
    const auto n = static_cast<std::size_t>(values.size() / 20);
    std::vector<double> start(values.data(), values.data() + n);
    std::sort(start.begin(), start.end());
    return 0.5 * (start[(n - 1) / 2] + start[n / 2]);
}

TEST_P(MemsLoop, IsReadWithTheMapping) {
    SETAE_REQUIRE_REFERENCE_DATA(path, std::string("jkr/") + GetParam().file);
    const auto table = tables::read_mapped_table(path.string(), tables::read_mapping(mapping_path));
    tables::require_loop_columns(table, path.string());
    ASSERT_EQ(table.rows(), GetParam().points);
    const Array1D force = (table.at("force") - median_of_start(table.at("force"))) / units::nN;
    EXPECT_NEAR(force.maxCoeff(), GetParam().largest_force, 0.6);
    EXPECT_NEAR(force.minCoeff(), GetParam().pull_off_force, 0.06);
    const Array1D displacement = table.at("displacement");
    EXPECT_GT(displacement.maxCoeff() - displacement.minCoeff(), 100e-9);
    EXPECT_LT(displacement.maxCoeff() - displacement.minCoeff(), 10e-6);
    const auto& time = table.at("time");
    EXPECT_TRUE((time.tail(time.size() - 1) > time.head(time.size() - 1)).all());
}

INSTANTIATE_TEST_SUITE_P(Files, MemsLoop,
                         testing::Values(Loop{"pdms_a.txt", 1534, 1432, -2115.1},
                                         Loop{"pdms_b.txt", 1734, 2075, -2094.0},
                                         Loop{"pdms_c.txt", 2068, 3171, -2119.1},
                                         Loop{"pdms_10-1_d.txt", 3101, 949, -2797.0}));

TEST(MemsTable, WithDriftOnlyIsRefusedForTheMissingColumn) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "jkr/drift_only.txt");
    try {
        (void)tables::read_mapped_table(path.string(), tables::read_mapping(mapping_path));
        FAIL() << "read";
    } catch (const FormatError& error) {
        EXPECT_NE(std::string(error.what()).find("'Piezo position'"), std::string::npos) << error.what();
    }
}

TEST(MemsTable, WithoutForceIsNotALoop) {
    SETAE_REQUIRE_REFERENCE_DATA(path, "jkr/pdms_a.txt");
    EXPECT_THROW((void)tables::read_loop_table(path.string()), FormatError);
}

}  // namespace
}  // namespace setae::formats::tables_test
