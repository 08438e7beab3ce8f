// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "setae/core/errors.hpp"
#include "setae/core/extent.hpp"
#include "setae/fourier/buffer.hpp"
#include "setae/fourier/fast_length.hpp"

namespace setae::scales {
namespace {

using fourier::Buffer;
using fourier::Complex;

constexpr Index gathered = 16;   ///< lines copied from a map at a time
constexpr Index max_parts = 64;  ///< of a sum over lines, for any number of threads

}  // namespace

/// Sums over some of the lines.
struct LinePairs::Part {
    double whole_lines = 0.0;
    Array1D whole_power, whole_squares, holed_spectrum, holed_pairs;
    Buffer<double> line, weights, squares;
    Buffer<Complex> line_modes, weight_modes, square_modes;

    Part(Index points, Index padded, Index modes)
        : whole_power(Array1D::Zero(modes)),
          whole_squares(Array1D::Zero(points)),
          line(extent(padded), 0.0),
          line_modes(extent(modes)) {}
    /// Memory for lines with holes, if there are any.
    void make_room_for_holes() {
        if (!weights.empty()) return;
        weights.assign(line.size(), 0.0);
        squares.assign(line.size(), 0.0);
        weight_modes.resize(line_modes.size());
        square_modes.resize(line_modes.size());
        holed_spectrum = holed_pairs = Array1D::Zero(whole_power.size());
    }
};

LinePairs::LinePairs(Index points, bool periodic)
    : points_(points),
      padded_(periodic ? points : fourier::fast_length(2 * points - 1)),
      periodic_(periodic),
      transform_(padded_),
      whole_power_(Array1D::Zero(transform_.modes())),
      whole_squares_(Array1D::Zero(points)),
      holed_spectrum_(Array1D::Zero(transform_.modes())),
      holed_pairs_(Array1D::Zero(transform_.modes())) {}

void LinePairs::add_line(const double* heights, Part& part) const {
    double sum = 0.0;
    Index defined = 0;
    const double origin = [&] {
        for (Index i = 0; i < points_; ++i)
            if (!std::isnan(heights[i])) return heights[i];
        return 0.0;
    }();
    for (Index i = 0; i < points_; ++i)
        if (!std::isnan(heights[i])) {
            sum += heights[i] - origin;
            ++defined;
        }
    if (defined == 0) return;
    const double mean = sum / static_cast<double>(defined);
    if (!std::isfinite(mean)) throw InvalidArgument("a height of a line is infinite; mark it as undefined");
    double* line = part.line.data();
    if (defined == points_) {
        for (Index i = 0; i < points_; ++i) line[i] = (heights[i] - origin) - mean;
        for (Index i = 0; i < points_; ++i) part.whole_squares[i] += line[i] * line[i];
        transform_.forward(line, part.line_modes.data());
        for (Index q = 0; q < transform_.modes(); ++q) part.whole_power[q] += std::norm(part.line_modes[extent(q)]);
        part.whole_lines += 1.0;
        return;
    }
    part.make_room_for_holes();
    for (Index i = 0; i < points_; ++i) {
        const bool is_defined = !std::isnan(heights[i]);
        line[i] = is_defined ? (heights[i] - origin) - mean : 0.0;
        part.weights[extent(i)] = is_defined ? 1.0 : 0.0;
        part.squares[extent(i)] = line[i] * line[i];
    }
    transform_.forward(line, part.line_modes.data());
    transform_.forward(part.weights.data(), part.weight_modes.data());
    transform_.forward(part.squares.data(), part.square_modes.data());
    for (Index q = 0; q < transform_.modes(); ++q) {
        const Complex weight = part.weight_modes[extent(q)];
        part.holed_spectrum[q] +=
            (std::conj(weight) * part.square_modes[extent(q)]).real() - std::norm(part.line_modes[extent(q)]);
        part.holed_pairs[q] += std::norm(weight);
    }
}

void LinePairs::add(const ArrayView2D& lines, parallel::Threads threads) {
    const Index count = lines.cols(), groups = (count + gathered - 1) / gathered;
    const Index groups_per_part = (groups + max_parts - 1) / max_parts;
    const Index parts = (groups + groups_per_part - 1) / groups_per_part;
    std::vector<Part> sums;
    sums.reserve(extent(parts));
    for (Index p = 0; p < parts; ++p) sums.emplace_back(points_, padded_, transform_.modes());
    parallel::for_each_index(extent(parts), threads, [&](std::size_t index) {
        auto& part = sums[index];
        const Index stride = points_ + 8;  // never a power of two
        Buffer<double> block(extent(gathered * stride));
        const Index first_group = static_cast<Index>(index) * groups_per_part;
        for (Index group = first_group; group < std::min(groups, first_group + groups_per_part); ++group) {
            const Index first = group * gathered, taken = std::min(gathered, count - first);
            for (Index i = 0; i < points_; ++i) {
                const double* row = lines.data() + i * lines.outerStride() + first;
                for (Index j = 0; j < taken; ++j) block[extent(j * stride + i)] = row[j];
            }
            for (Index j = 0; j < taken; ++j) add_line(block.data() + j * stride, part);
        }
    });
    for (const auto& part : sums) {
        whole_lines_ += part.whole_lines;
        whole_power_ += part.whole_power;
        whole_squares_ += part.whole_squares;
        if (part.weights.empty()) continue;
        holed_spectrum_ += part.holed_spectrum;
        holed_pairs_ += part.holed_pairs;
    }
}

Array1D LinePairs::correlation(const Array1D& spectrum) const {
    const fourier::InverseRealTransform inverse(padded_);
    Buffer<Complex> modes(extent(inverse.modes()));
    Buffer<double> values(extent(padded_));
    std::copy(spectrum.begin(), spectrum.end(), modes.begin());
    inverse.apply(modes.data(), values.data());
    return Eigen::Map<const Array1D>(values.data(), points_) / static_cast<double>(padded_);
}

LinePairs::Sums LinePairs::sums() const {
    const Index lags = periodic_ ? points_ / 2 + 1 : points_;
    const Array1D lag = Array1D::LinSpaced(points_, 0.0, static_cast<double>(points_ - 1));
    const Array1D whole_pairs = periodic_ ? Array1D::Constant(points_, static_cast<double>(points_))
                                          : Array1D(static_cast<double>(points_) - lag);
    Array1D squares = Array1D::Constant(points_, whole_squares_.sum());
    if (!periodic_) {
        // half the squares of the points that are the first of a pair, and of those that are the second
        double first = 0.0, second = 0.0;
        for (Index k = points_ - 1; k >= 0; --k) {
            first += whole_squares_[points_ - 1 - k];
            second += whole_squares_[k];
            squares[k] = 0.5 * (first + second);
        }
    }
    squares += correlation(holed_spectrum_) - correlation(whole_power_);
    const Array1D pairs = whole_lines_ * whole_pairs + correlation(holed_pairs_).round();
    return {squares.head(lags).max(0.0), pairs.head(lags)};
}

}  // namespace setae::scales
