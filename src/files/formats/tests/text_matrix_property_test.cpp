// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "sample_files.hpp"
#include "setae/formats/channel.hpp"
#include "setae/formats/format.hpp"
#include "setae/tables/text_numbers.hpp"

using namespace setae::tests;

namespace setae::formats::tests::text_matrix_property_test {
namespace {

rc::Gen<double> any_number() {
    const auto bits = rc::gen::map(rc::gen::arbitrary<std::uint64_t>(),
                                   [](std::uint64_t pattern) { return std::bit_cast<double>(pattern); });
    const auto edges = rc::gen::element(0.0, -0.0, 5e-324, -2.2250738585072011e-308, std::numeric_limits<double>::max(),
                                        1e23, 0.1, 9007199254740993.0);
    const auto heights = rc::gen::map(rc::gen::inRange(-1000000, 1000000), [](int n) { return 1e-12 * n; });
    return rc::gen::oneOf(bits, edges, heights);
}

/// Cells of files: many spellings of numbers, words, and invalid ones.
rc::Gen<std::string> any_cell() {
    const auto number = rc::gen::map(any_number(), [](double value) { return fmt::format("{}", value); });
    const auto spelled = rc::gen::element<std::string>("1", "+2.5", "-.5", "3.", "1e5", "1E-400", "1e400", "-0", "007",
                                                       "nan", "NaN", "bad", "Bad", "inf", "-inf", "***", "--",
                                                       "\"4.5\"", "1.#QNAN", "N/A", "#NV", "null", "#N/A");
    const auto wrong = rc::gen::element<std::string>("x", "1.2.3", "1e", "0x10", "1,5", "+-3", "++1", "1-2");
    return rc::gen::weightedOneOf<std::string>({{12, number}, {6, spelled}, {1, wrong}});
}

template <class Read>
std::pair<Array2D, std::string> outcome(const Read& read) {
    try {
        return {read(), ""};
    } catch (const std::exception& error) {
        return {Array2D(), error.what()};
    }
}

bool same(double a, double b) {
    return std::isnan(a) ? std::isnan(b) : std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

RC_GTEST_PROP(TextNumbers, EqualThoseOfReadingLineByLine, ()) {
    const char separator = *rc::gen::element('\t', ' ', ';', ',');
    const auto columns = *rc::gen::inRange<std::size_t>(1, 6), rows = *rc::gen::inRange<std::size_t>(1, 60);
    const bool commas = separator != ',' && *rc::gen::arbitrary<bool>();
    std::string text;
    for (std::size_t j = 0; j < rows; ++j) {
        text +=
            *rc::gen::weightedElement<std::string>({{8, ""}, {1, "\n"}, {1, "# remark\n"}, {1, "  \t\n"}, {1, " "}});
        for (std::size_t i = 0; i < columns; ++i) {
            auto cell = *any_cell();
            if (commas) std::replace(cell.begin(), cell.end(), '.', ',');
            text += (i > 0 ? std::string(1, separator) : "") + cell;
        }
        text += *rc::gen::weightedElement<std::string>(
            {{8, "\n"}, {1, "\r\n"}, {1, " \n"}, {1, std::string(1, separator) + "\n"}});
    }
    tables::TextStart start;
    start.source = bytes::memory_source("text", text);
    start.layout.dialect = {separator, commas ? ',' : '.'};
    start.layout.columns = start.layout.filled = columns;
    const auto lines = tables::find_number_lines(start, 0, text.size());
    const auto [plain, plain_error] = outcome([&] { return tables::read_numbers_plainly(lines); });
    const auto [fast, fast_error] = outcome([&] { return tables::read_numbers(lines); });
    RC_ASSERT(fast_error == plain_error);
    RC_ASSERT(fast.rows() == plain.rows() && fast.cols() == plain.cols());
    for (Index i = 0; i < plain.size(); ++i) RC_ASSERT(same(fast.data()[i], plain.data()[i]));
}

Array2D any_heights(Index nx, Index ny) {
    Array2D heights(nx, ny);
    for (Index i = 0; i < heights.size(); ++i) {
        heights.data()[i] = *any_number();
        if (!std::isfinite(heights.data()[i])) heights.data()[i] = undefined;
    }
    heights(0, 0) = 1e-9;
    return heights;
}

double any_length() { return 1e-9 * *rc::gen::inRange(1, 1000000) / 7.0; }

RC_GTEST_PROP(TextMatrix, IsUnchangedAfterWritingAndReading, ()) {
    topography::HeightMap map{any_heights(*rc::gen::inRange<Index>(2, 9), *rc::gen::inRange<Index>(2, 9)),
                              {any_length(), any_length()},
                              false,
                              {}};
    map.metadata.name = *rc::gen::element<std::string>("", "Height (forward)", "Höhe: 3");
    const TemporaryFolder folder;
    const auto path = folder.path("map.txt");
    format_to_write(path).write(path, map);
    const auto back = std::get<topography::HeightMap>(read(path, std::nullopt, ReadOptions{.keep_values = true}));
    RC_ASSERT(back.shape() == map.shape());
    RC_ASSERT(back.size == map.size);
    RC_ASSERT(back.metadata.name == map.metadata.name);
    for (Index i = 0; i < map.heights.size(); ++i) RC_ASSERT(same(back.heights.data()[i], map.heights.data()[i]));
}

RC_GTEST_PROP(TextCurve, IsUnchangedAfterWritingAndReading, ()) {
    const auto count = *rc::gen::inRange<Index>(3, 20);
    topography::Profile profile{Array1D(count), any_heights(count, 1).col(0), {}};
    for (Index i = 0; i < count; ++i) profile.positions[i] = 1e-9 * static_cast<double>(i * i) / 7.0;
    const TemporaryFolder folder;
    const auto path = folder.path("curve.csv");
    format_to_write(path).write(path, profile);
    const auto back = std::get<topography::Profile>(read(path, std::nullopt, ReadOptions{.keep_values = true}));
    RC_ASSERT(back.positions.size() == count);
    for (Index i = 0; i < count; ++i)
        RC_ASSERT(same(back.positions[i], profile.positions[i]) && same(back.heights[i], profile.heights[i]));
}

RC_GTEST_PROP(TextLine, PreservesHeightsToTheBitAndTheSize, ()) {
    const auto count = *rc::gen::inRange<Index>(2, 20);
    const topography::LineScan scan{any_heights(count, 1).col(0), any_length(), false, {}};
    const TemporaryFolder folder;
    const auto path = folder.path("line.csv");
    format_to_write(path).write(path, scan);
    const auto back = std::get<topography::LineScan>(read(path, std::nullopt, ReadOptions{.keep_values = true}));
    RC_ASSERT(back.heights.size() == count);
    RC_ASSERT(std::abs(back.size / scan.size - 1.0) < 1e-14);
    for (Index i = 0; i < count; ++i) RC_ASSERT(same(back.heights[i], scan.heights[i]));
}

}  // namespace
}  // namespace setae::formats::tests::text_matrix_property_test
