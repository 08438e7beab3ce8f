// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/roughness/slope_shape.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/roughness/true_area.hpp"

namespace setae::roughness {
namespace {

constexpr double classes_per_decade = 40.0, lowest_decade = -6.0, highest_decade = 4.0;
constexpr auto class_count = static_cast<std::size_t>((highest_decade - lowest_decade) * classes_per_decade);

/// The class of a positive number without its logarithm: the leading bits of a double give an interval with at most one
/// border between classes.
class ClassOf {
public:
    ClassOf() {
        for (std::size_t k = 0; k < intervals; ++k) {
            const double left = std::bit_cast<double>((first_bits + k) << shift);
            const auto at = static_cast<int>(std::floor((std::log10(left) - lowest_decade) * classes_per_decade));
            steps_[k] = {std::pow(10.0, lowest_decade + (at + 1) / classes_per_decade), {within(at), within(at + 1)}};
        }
    }

    std::size_t operator()(double square) const {
        if (!(square >= smallest)) return 0;
        if (!(square < largest)) return class_count - 1;
        const auto& step = steps_[(std::bit_cast<std::uint64_t>(square) >> shift) - first_bits];
        return step.classes[square >= step.border ? 1 : 0];  // an index, because a branch would be unpredictable
    }

private:
    struct Step {
        double border;
        std::array<std::uint32_t, 2> classes;  ///< of numbers below the border and of the others
    };
    static std::uint32_t within(int at) {
        return static_cast<std::uint32_t>(std::clamp(at, 0, static_cast<int>(class_count) - 1));
    }
    /// Thirty-two intervals per octave, each at most 3.2 % wide; a class is 5.9 % wide.
    static constexpr int shift = 52 - 5;
    static constexpr double smallest = 0x1p-20, largest = 0x1p14;
    static constexpr std::uint64_t first_bits = std::bit_cast<std::uint64_t>(smallest) >> shift;
    static constexpr std::size_t intervals = (std::bit_cast<std::uint64_t>(largest) >> shift) - first_bits;

    std::array<Step, intervals> steps_;
};

struct Classes {
    /// Count and sum of squares in one register, added simultaneously.
    using Sum [[gnu::vector_size(2 * sizeof(double))]] = double;
    std::array<Sum, class_count> of_class{};

    void add(std::size_t at, double square) { of_class[at] += Sum{1.0, square}; }
    void add(const Classes& other) {
        for (std::size_t k = 0; k < class_count; ++k) of_class[k] += other.of_class[k];
    }
};

}  // namespace

double SlopeShape::area_ratio(double rms_slope) const {
    if (!(rms_slope >= 0.0)) throw InvalidArgument(fmt::format("rms slope is {}; expected a number >= 0", rms_slope));
    return (share * (1.0 + rms_slope * rms_slope * square).sqrt()).sum();
}

SlopeShape slope_shape(const topography::HeightMap& map, double rms_slope, parallel::Threads threads) {
    if (!(rms_slope > 0.0)) throw UndefinedDataError(map.metadata.file + ": all slopes are 0");
    const Index nx = map.heights.rows(), ny = map.heights.cols();
    const Index rows = map.periodic ? nx : nx - 1, columns = map.periodic ? ny : ny - 1;
    const auto [dx, dy] = map.pixel_size();
    const double along_x = 1.0 / (dx * rms_slope), along_y = 1.0 / (dy * rms_slope);
    static const ClassOf class_of;
    constexpr Index together = 32;
    std::vector<Classes> parts(static_cast<std::size_t>((rows + together - 1) / together));
    parallel::for_each_index(parts.size(), threads, [&](std::size_t part) {
        const Index first = static_cast<Index>(part) * together;
        std::array<Classes, 4> of_triangle;  // neighbours are similar: four tables, so no sum waits for the last
        const auto square = [](double x) { return x * x; };
        for (Index i = first; i < std::min(rows, first + together); ++i) {
            const double *lower = map.heights.data() + i * ny, *upper = map.heights.data() + (i + 1) % nx * ny;
            double x0 = square((upper[0] - lower[0]) * along_x);
            for (Index j = 0; j < columns; ++j) {
                const Index next = j + 1 == ny ? 0 : j + 1;
                const double x1 = square((upper[next] - lower[next]) * along_x),
                             y0 = square((lower[next] - lower[j]) * along_y),
                             y1 = square((upper[next] - upper[j]) * along_y);
                const std::array<double, 4> squares{x0 + y0, x0 + y1, x1 + y0, x1 + y1};
                x0 = x1;
                if (!std::isfinite(squares[0] + squares[3])) continue;
                for (std::size_t k = 0; k < squares.size(); ++k) of_triangle[k].add(class_of(squares[k]), squares[k]);
            }
        }
        for (const auto& classes : of_triangle) parts[part].add(classes);
    });
    Classes all;
    for (const auto& part : parts) all.add(part);
    double total = 0.0;
    for (const auto& sum : all.of_class) total += sum[0];
    SlopeShape shape{Array1D::Zero(class_count), Array1D::Zero(class_count)};
    for (std::size_t k = 0; k < class_count; ++k) {
        const double count = all.of_class[k][0], square = all.of_class[k][1];
        shape.share[static_cast<Index>(k)] = count / total;
        if (count > 0.0) shape.square[static_cast<Index>(k)] = square / count;
    }
    return shape;
}

SlopeShape slope_shape(const topography::HeightMap& map, parallel::Threads threads) {
    return slope_shape(map, triangulated_area(map, threads).rms_slope, threads);
}

SlopeShape mean_shape(const std::vector<WeighedShape>& shapes) {
    if (shapes.empty()) throw InvalidArgument("no map is given; a distribution of slopes needs at least one");
    double area = 0.0;
    for (const auto& weighed : shapes) area += weighed.area;
    SlopeShape mean{Array1D::Zero(class_count), Array1D::Zero(class_count)};
    for (const auto& [shape, own] : shapes) {
        mean.share += own / area * shape.share;
        mean.square += own / area * shape.share * shape.square;
    }
    mean.square = (mean.share > 0.0).select(mean.square / mean.share.max(1e-300), 0.0);
    return mean;
}

}  // namespace setae::roughness
