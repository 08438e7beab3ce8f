// SPDX-License-Identifier: GPL-3.0-or-later
#include "order_statistic.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "setae/core/errors.hpp"
#include "setae/numerics/row_blocks.hpp"

namespace setae::processing {

Sample::Sample(const ComputedRows& values) {
    constexpr Index size = 8192, few = 8 * size,
                    scattering = 2'654'435'761;  // equal steps could coincide with columns of a map
    const Index n = values.rows * values.columns;
    if (n < few) return;
    for (Index k = 0; k < size; ++k) {
        const Index place = k * scattering % n;
        const double value = values.at(place / values.columns, place % values.columns);
        if (!std::isnan(value)) sorted_.push_back(value);
    }
    std::sort(sorted_.begin(), sorted_.end());
}

Bounds Sample::around(double probability, double width) const {
    const auto size = static_cast<double>(sorted_.size());
    // five standard errors of the rank of a median, more at the ends
    const double margin = width * (2.5 * std::sqrt(size) + 1.0);
    const double lower = std::floor(probability * size) - margin, upper = std::floor(probability * size) + margin;
    Bounds bounds;
    if (lower >= 0.0) bounds.low = sorted_[static_cast<std::size_t>(lower)];
    if (upper <= size - 1.0) bounds.high = sorted_[static_cast<std::size_t>(upper)];
    return bounds;
}

void QuantileSearch::add(const double* values, Index n) {
    const auto [low, high] = bounds_;
    constexpr Index stretch = 512;
    std::array<double, stretch> kept;
    for (Index begin = 0; begin < n; begin += stretch) {
        const double* const part = values + begin;
        const Index size = std::min(stretch, n - begin);
        Index defined = 0, below = 0, at_low = 0, at_high = 0;
        for (Index k = 0; k < size; ++k) {
            defined += !std::isnan(part[k]);
            below += part[k] < low;
            at_low += part[k] == low;
            at_high += part[k] == high;
        }
        defined_ += defined;
        below_ += below;
        at_low_ += at_low;
        at_high_ += at_high;
        std::size_t count = 0;
        for (Index k = 0; k < size; ++k) {
            kept[count] = part[k];
            count += static_cast<std::size_t>(static_cast<int>(part[k] > low) & static_cast<int>(part[k] < high));
        }
        between_.insert(between_.end(), kept.begin(), kept.begin() + static_cast<std::ptrdiff_t>(count));
    }
}

void QuantileSearch::add(const QuantileSearch& other) {
    defined_ += other.defined_;
    below_ += other.below_;
    at_low_ += other.at_low_;
    at_high_ += other.at_high_;
    between_.insert(between_.end(), other.between_.begin(), other.between_.end());
}

std::optional<double> QuantileSearch::at(Index rank) {
    rank -= below_;
    if (rank < 0) return {};
    if (rank < at_low_) return bounds_.low;
    rank -= at_low_;
    if (rank < std::ssize(between_)) {
        const auto place = between_.begin() + rank;
        std::nth_element(between_.begin(), place, between_.end());
        return *place;
    }
    rank -= std::ssize(between_);
    // equal bounds count the same numbers
    if (bounds_.low < bounds_.high && rank < at_high_) return bounds_.high;
    return {};
}

std::optional<double> QuantileSearch::quantile(double probability) {
    if (defined_ == 0) throw InternalError("a quantile needs at least one number");
    const double order = static_cast<double>(defined_ - 1) * probability;
    const auto below = static_cast<Index>(std::floor(order));
    const double share = order - static_cast<double>(below);
    const auto lower = at(below);
    if (!lower || !(share > 0.0) || below + 1 >= defined_) return lower;
    const auto upper = at(below + 1);
    if (!upper) return {};
    return *lower + share * (*upper - *lower);
}

std::optional<double> quantile(const ComputedRows& values, double probability, parallel::Threads threads) {
    const Sample sample(values);
    for (const double width : search_widths) {
        QuantileSearch all(sample.around(probability, width));
        for (const auto& part : numerics::by_row_blocks(numerics::RowBlocks(values.rows, values.columns), threads, all,
                                                        [&](Index first, Index last, QuantileSearch& search) {
                                                            Array1D row(values.columns);
                                                            for (Index i = first; i < last; ++i) {
                                                                values.load(i, row.data());
                                                                search.add(row.data(), row.size());
                                                            }
                                                        }))
            all.add(part);
        if (all.defined() == 0) return {};
        if (const auto found = all.quantile(probability)) return found;
    }
    throw InternalError("a quantile outside the values that were kept");
}

}  // namespace setae::processing
