// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "sample_files.hpp"
#include "setae/formats/channel.hpp"
#include "setae/formats/npy.hpp"
#include "setae/tables/loop_file.hpp"
#include "setae/tables/table_file.hpp"

using namespace setae::tests;

namespace setae::formats::tests::round_trip_property_test {
namespace {

Array1D to_array(const std::vector<double>& values) {
    return Eigen::Map<const Array1D>(values.data(), static_cast<Index>(values.size()));
}

bool same(const Array1D& a, const Array1D& b) {
    return a.size() == b.size() && (a == b || (a.isNaN() && b.isNaN())).all();
}

rc::Gen<std::vector<double>> numbers(std::size_t count) {
    const auto any = rc::gen::oneOf(rc::gen::arbitrary<double>(), rc::gen::just(std::nan("")),
                                    rc::gen::map(rc::gen::inRange(-1000, 1000), [](int n) { return n / 8.0; }));
    return rc::gen::container<std::vector<double>>(count, any);
}

RC_GTEST_PROP(Csv, PreservesEveryDouble, ()) {
    const auto rows = *rc::gen::inRange<std::size_t>(1, 20);
    auto first = *numbers(rows);
    first.front() = 1.0;  // a table needs at least one number
    const auto second = *numbers(rows);
    Table table;
    table.columns = {{"a", "m", to_array(first)}, {"b", "1/m", to_array(second)}};
    const TemporaryFolder folder;
    tables::write_csv(folder.path("t.csv"), table);
    const auto back = tables::read_table(folder.path("t.csv"));
    RC_ASSERT(same(back.at("a"), table.columns[0].values));
    RC_ASSERT(same(back.at("b"), table.columns[1].values));
}

RC_GTEST_PROP(LoopFile, IsUnchangedAfterWritingAndReading, ()) {
    const auto rows = *rc::gen::inRange<std::size_t>(1, 20);
    Table table;
    for (const auto& [name, unit] : {std::pair{"force", "N"},
                                     {"displacement", "m"},
                                     {"contact_radius", "m"},
                                     {"time", "s"},
                                     {"temperature", "°C"},
                                     {"state", ""}})
        table.columns.push_back({name, unit, to_array(*numbers(rows))});
    // any text of one line without outer blanks: UTF-8 letters, colons, commas, quotes, '#'
    const auto text = rc::gen::container<std::string>(rc::gen::elementOf(std::string("ab7:,#\"'[]=-")));
    std::map<std::string, std::string> metadata{
        {"sphere_radius", fmt::format("{} mm", *rc::gen::inRange(1, 1000) / 7.0)}};
    for (const char* key : {"surface", "elastomer", "my_own_key_2"}) metadata[key] = *text + "µ";
    const TemporaryFolder folder;
    tables::write_loop(folder.path("l.csv"), table, metadata);
    auto back = tables::read_loop(folder.path("l.csv"));
    RC_ASSERT(back.columns.size() == table.columns.size());
    for (std::size_t k = 0; k < table.columns.size(); ++k) {
        RC_ASSERT(back.columns[k].name == table.columns[k].name);
        RC_ASSERT(back.columns[k].unit == table.columns[k].unit);
        RC_ASSERT(same(back.columns[k].values, table.columns[k].values));
    }
    for (const char* own : {"file", "format", "version"}) back.metadata.erase(own);
    RC_ASSERT(back.metadata == metadata);
}

RC_GTEST_PROP(Text, HasTheSameValuesInEveryDialect, ()) {
    const auto rows = *rc::gen::inRange(2, 20);
    const auto digits =
        *rc::gen::container<std::vector<int>>(static_cast<std::size_t>(rows), rc::gen::inRange(-99999, 99999));
    const auto text = [&](char separator, char decimal) {
        std::string lines;
        for (int i = 0; i < rows; ++i) {
            auto line = fmt::format("{}.5{}{}.25\n", i, separator, digits[static_cast<std::size_t>(i)]);
            std::replace(line.begin(), line.end(), '.', decimal);
            lines += line;
        }
        return lines;
    };
    const auto plain = tables::read_raw_table(bytes::memory_source("plain", text('\t', '.')));
    for (const auto& [separator, decimal] :
         {std::pair{';', '.'}, {',', '.'}, {' ', '.'}, {'\t', ','}, {';', ','}, {' ', ','}}) {
        const auto table = tables::read_raw_table(bytes::memory_source("other", text(separator, decimal)));
        RC_ASSERT(table.columns.size() == 2u);
        RC_ASSERT(same(table.columns[0].values, plain.columns[0].values));
        RC_ASSERT(same(table.columns[1].values, plain.columns[1].values));
    }
}

RC_GTEST_PROP(Npy, KeepsEveryFiniteHeight, ()) {
    const auto nx = *rc::gen::inRange<Index>(2, 8), ny = *rc::gen::inRange<Index>(2, 8);
    const auto values = *numbers(static_cast<std::size_t>(nx * ny));
    Array2D map = Eigen::Map<const Array2D>(values.data(), nx, ny);
    map(0, 0) = 1.0;
    const TemporaryFolder folder;
    write_npy(folder.path("m.npy"), map);
    const auto back = std::get<topography::HeightMap>(
        read(folder.path("m.npy"), 0, {.size = {{1.0, 1.0}}, .unit = "m", .keep_values = true}));
    RC_ASSERT((back.heights == map || (back.heights.isNaN() && !map.isFinite())).all());
}

}  // namespace
}  // namespace setae::formats::tests::round_trip_property_test
