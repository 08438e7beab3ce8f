// SPDX-License-Identifier: GPL-3.0-or-later
#include "height_likeness.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "height_names.hpp"
#include "setae/core/errors.hpp"
#include "text/column_meaning.hpp"

namespace setae::formats {
namespace {

constexpr Index longest_line_read = 1'000'000;
constexpr Index largest_packed = Index{1} << 22;  ///< values of an array that is unpacked to examine a few of its lines
constexpr Index narrowest_map = 4, tallest_table = 16;
constexpr const char* counting = "whole numbers that increase by one from value to value: an index";

bool grows(const Array1D& values) {
    for (Index i = 1; i < values.size(); ++i)
        if (!(values[i] > values[i - 1])) return false;
    return values.size() > 2;
}

bool are_whole(const Array1D& values) { return (values == values.round()).all(); }

bool are_even(const Array1D& values) {
    const double step = (values[values.size() - 1] - values[0]) / static_cast<double>(values.size() - 1);
    for (Index i = 0; i < values.size(); ++i)
        if (!(std::abs(values[i] - values[0] - step * static_cast<double>(i)) <=
              1e-6 * std::abs(step) + 1e-12 * std::abs(values[i])))
            return false;
    return true;
}

/// Why a monotonic line of values contains no heights; empty for others.
std::string reason_if_monotone(const Array1D& values) {
    if (!grows(values) && !grows(-values)) return {};
    if (are_whole(values)) return "whole numbers that increase from value to value: an index";
    if (are_even(values)) return "evenly spaced values: positions";
    return "values that increase throughout: positions";
}

/// Line k of the slow index of a map, as stored.
Array1D stored_line(const StoredArray& array, Index k) {
    const bool first_slow = !array.first_fast;
    const Index slow = array.shape[first_slow ? 0 : 1], fast = array.shape[first_slow ? 1 : 0];
    const auto width = bytes_of(array.sample);
    const auto distance =
        first_slow && array.first_distance ? array.first_distance : width * static_cast<std::uint64_t>(fast);
    const Raster line{.offset = array.offset + distance * static_cast<std::uint64_t>(std::min(k, slow - 1)),
                      .nx = fast,
                      .ny = 1,
                      .sample = array.sample,
                      .order = array.order};
    require_raster(line, array.data, "array");
    const auto values = read_raster(array.data, line, {});
    return Eigen::Map<const Array1D>(values.data(), values.size());
}

/// Whether the values of a map are the x or the y of its points: all lines equal, or each constant.
bool are_coordinates(const StoredArray& array) {
    if (array.hold && array.shape[0] * array.shape[1] > largest_packed) return false;
    const auto kept = array.hold ? array.hold() : nullptr;
    const Index slow = array.shape[array.first_fast ? 1 : 0];
    const auto first = stored_line(array, 0), middle = stored_line(array, slow / 2),
               last = stored_line(array, slow - 1);
    if (!first.isFinite().all() || !middle.isFinite().all() || !last.isFinite().all()) return false;
    const bool alike = (first == middle).all() && (first == last).all();
    if (alike) return grows(first) || grows(-first);
    const auto constant = [](const Array1D& line) { return line.size() > 2 && (line == line[0]).all(); };
    const bool each_constant = constant(first) && constant(middle) && constant(last);
    return each_constant && ((first[0] < middle[0]) == (middle[0] < last[0]));
}

/// Integers that increase by one from value to value, also from the end of a line to the next.
bool count_on(const StoredArray& array) {
    if (array.hold && array.shape[0] * array.shape[1] > largest_packed) return false;
    const auto kept = array.hold ? array.hold() : nullptr;
    const auto first = stored_line(array, 0), second = stored_line(array, 1);
    const Index n = first.size();
    for (Index i = 0; i < n; ++i)
        if (first[i] != first[0] + static_cast<double>(i) || second[i] != first[0] + static_cast<double>(n + i))
            return false;
    return n > 2 && second[0] != first[0];  // a step of 1 is below the rounding of 1e30
}

/// Why an array of few columns contains no heights; empty for wider ones.
std::string reason_if_narrow(const StoredArray& array) {
    const Index narrow = std::min(array.shape[0], array.shape[1]), wide = std::max(array.shape[0], array.shape[1]);
    if (narrow >= narrowest_map || wide < tallest_table) return {};
    return fmt::format("{} × {} numbers: a table of {} columns", array.shape[0], array.shape[1], narrow);
}

std::string reason_against_map(const LooseArray& loose) {
    const auto& array = loose.array;
    if (auto why = reason_if_narrow(array); !why.empty()) return why;
    if (bytes_of(array.sample) == 1) return "values of 8 bits: a picture or a mask";
    if (loose.integers) return "whole numbers without a unit";
    if (count_on(array)) return counting;
    return are_coordinates(array) ? "equal values in all lines, or one value per line: coordinates of the points"
                                  : std::string();
}

std::string reason_against_line(const LooseArray& loose) {
    const auto& array = loose.array;
    const bool few = std::max(array.shape.front(), array.shape.back()) <= longest_line_read;
    if (const auto why = few ? reason_if_monotone(values_of(array, "array")) : std::string(); !why.empty()) return why;
    if (loose.integers) return "whole numbers without a unit";
    return loose.only_array ? std::string()
                            : "one dimension, and neither the name nor a unit shows that it is a line of heights";
}

}  // namespace

std::string reason_against_heights(const LooseArray& loose) {
    if (!loose.array.refusal.empty() || is_height_name(loose.name) || loose.has_length) return {};
    const auto& shape = loose.array.shape;
    const bool line = shape.size() < 2 || shape[0] == 1 || shape[1] == 1;
    try {
        const auto why = line ? reason_against_line(loose) : reason_against_map(loose);
        const auto quantity = other_quantity(loose.name);
        return why.empty() && !quantity.empty() ? fmt::format("its name means {}", quantity) : why;
    } catch (const FormatError&) {  // damaged values: reported on reading
        return {};
    }
}

std::string reason_against_single_array(const StoredArray& array) {
    const auto& shape = array.shape;
    if (!array.refusal.empty() || shape.size() < 2 || shape[0] == 1 || shape[1] == 1) return {};
    if (auto why = reason_if_narrow(array); !why.empty()) return why;
    try {
        return count_on(array) ? counting : std::string();
    } catch (const FormatError&) {  // damaged values: reported on reading
        return {};
    }
}

}  // namespace setae::formats
