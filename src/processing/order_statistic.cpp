// SPDX-License-Identifier: GPL-3.0-or-later
#include "order_statistic.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "setae/numerics/row_blocks.hpp"

namespace setae::processing {
namespace {

constexpr std::uint64_t sign_bit = std::uint64_t{1} << 63;
constexpr int digit_bits = 16;
constexpr std::uint64_t digit_mask = (std::uint64_t{1} << digit_bits) - 1;
constexpr std::uint64_t largest_key = ~std::uint64_t{0};
/// Values that agree in their leading digits are copied where they are at most one of so many.
constexpr Index few = 8;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// The number a key was made of.
double value_of(std::uint64_t key) { return std::bit_cast<double>(key & sign_bit ? key & ~sign_bit : ~key); }

}  // namespace

OrderStatistics::OrderStatistics(const double* values, Index n, bool absolute, parallel::Threads threads)
    : values_(values), n_(n), absolute_(absolute), threads_(threads) {
    const auto counted = numerics::by_row_blocks(numerics::RowBlocks(n, 1), threads, Index{0},
                                                 [&](Index first, Index last, Index& count) {
                                                     for (Index i = first; i < last; ++i)
                                                         count += values[i] == values[i];
                                                 });
    for (const Index count : counted) defined_ += count;
}

double OrderStatistics::value(Index i) const { return absolute_ ? std::fabs(values_[i]) : values_[i]; }

/// Bits that are ordered as the numbers are.
std::uint64_t OrderStatistics::key(double value) const {
    const auto bits = std::bit_cast<std::uint64_t>(absolute_ ? std::fabs(value) : value);
    return bits & sign_bit ? ~bits : bits | sign_bit;
}

double OrderStatistics::at(Index rank) const { return pair_at(rank)[0]; }

std::array<double, 2> OrderStatistics::pair_at(Index rank) const {
    const auto pair = between_sampled(rank);
    return pair ? *pair : by_digits(rank);
}

std::optional<std::array<double, 2>> OrderStatistics::between_sampled(Index rank) const {
    constexpr Index sample_size = 8192, scattering = 2'654'435'761;  // equal steps may meet the same columns of a map
    if (n_ < few * sample_size) return {};
    std::vector<double> sample;
    for (Index k = 0; k < sample_size; ++k) {
        const Index i = k * scattering % n_;
        if (values_[i] == values_[i]) sample.push_back(value(i));
    }
    if (sample.empty()) return {};
    std::sort(sample.begin(), sample.end());
    // five standard errors of the rank of a median on either side, and more at the ends
    const auto size = std::ssize(sample);
    const auto margin = static_cast<Index>(2.5 * std::sqrt(static_cast<double>(size))) + 1;
    const auto middle =
        static_cast<Index>(static_cast<double>(rank) / static_cast<double>(defined_) * static_cast<double>(size));
    const auto bound = [&](Index place) {
        return sample[static_cast<std::size_t>(std::clamp<Index>(place, 0, size - 1))];
    };
    const double low = bound(middle - margin), high = bound(middle + margin);

    struct Part {
        Index below = 0;
        double above = infinity;
        std::vector<double> between;
    };
    const auto parts =
        numerics::by_row_blocks(numerics::RowBlocks(n_, 1), threads_, Part{}, [&](Index first, Index last, Part& part) {
            constexpr Index stretch = 512;
            std::array<double, stretch> kept;
            for (Index begin = first; begin < last; begin += stretch) {
                std::size_t count = 0;
                for (Index i = begin; i < std::min(last, begin + stretch); ++i) {
                    const double v = value(i);
                    part.below += v < low;
                    part.above = v > high && v < part.above ? v : part.above;
                    kept[count] = v;
                    count += static_cast<std::size_t>(static_cast<int>(v >= low) & static_cast<int>(v <= high));
                }
                part.between.insert(part.between.end(), kept.begin(),
                                    kept.begin() + static_cast<std::ptrdiff_t>(count));
            }
        });
    std::vector<std::uint64_t> keys;
    double above = infinity;
    for (const auto& part : parts) {
        rank -= part.below;
        above = std::min(above, part.above);
        for (const double v : part.between) keys.push_back(key(v));
    }
    if (rank < 0 || rank >= std::ssize(keys)) return {};
    return pair_of(keys, rank, key(above));
}

/// The key at a rank and the next one, which is `above` behind the last.
std::array<double, 2> OrderStatistics::pair_of(std::vector<std::uint64_t>& keys, Index rank, std::uint64_t above) {
    const auto at = keys.begin() + rank;
    std::nth_element(keys.begin(), at, keys.end());
    const auto next = at + 1 == keys.end() ? above : *std::min_element(at + 1, keys.end());
    return {value_of(*at), value_of(next)};
}

std::array<double, 2> OrderStatistics::by_digits(Index rank) const {
    std::uint64_t prefix = 0;
    std::vector<Index> counts(digit_mask + 1);
    for (int shift = 64 - digit_bits; shift >= 0; shift -= digit_bits) {
        std::fill(counts.begin(), counts.end(), 0);
        // of 64 bits, those above the current digit must agree with what was found before
        const bool first = shift + digit_bits == 64;
        for (Index i = 0; i < n_; ++i) {
            if (values_[i] != values_[i]) continue;
            const auto bits = key(values_[i]);
            if (first || bits >> (shift + digit_bits) == prefix) ++counts[(bits >> shift) & digit_mask];
        }
        std::uint64_t digit = 0;
        while (rank >= counts[digit]) rank -= counts[digit++];
        prefix = prefix << digit_bits | digit;
        if (shift > 0 && counts[digit] <= n_ / few) return among(prefix, shift, rank, counts[digit]);
    }
    const auto next = rank + 1 < static_cast<Index>(counts[prefix & digit_mask]) ? prefix : least_above(prefix);
    return {value_of(prefix), value_of(next)};
}

std::array<double, 2> OrderStatistics::among(std::uint64_t prefix, int shift, Index rank, Index count) const {
    std::vector<std::uint64_t> keys;
    keys.reserve(static_cast<std::size_t>(count));
    auto above = largest_key;
    for (Index i = 0; i < n_; ++i) {
        if (values_[i] != values_[i]) continue;
        const auto bits = key(values_[i]);
        if (bits >> shift == prefix) keys.push_back(bits);
        else if (bits >> shift > prefix) above = std::min(above, bits);
    }
    return pair_of(keys, rank, above);
}

std::uint64_t OrderStatistics::least_above(std::uint64_t bound) const {
    auto least = largest_key;
    for (Index i = 0; i < n_; ++i)
        if (values_[i] == values_[i])
            if (const auto bits = key(values_[i]); bits > bound) least = std::min(least, bits);
    return least;
}

double OrderStatistics::quantile(double probability) const {
    const double order = static_cast<double>(defined_ - 1) * probability;
    const auto below = static_cast<Index>(std::floor(order));
    const double share = order - static_cast<double>(below);
    const auto [lower, upper] = pair_at(below);
    if (!(share > 0.0) || below + 1 >= defined_) return lower;
    return lower + share * (upper - lower);
}

}  // namespace setae::processing
