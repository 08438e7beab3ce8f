// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/synthesis/random_numbers.hpp"

#include <array>
#include <bit>
#include <cmath>

#include <Random123/philox.h>

#include "setae/core/constants.hpp"

namespace setae::synthesis {
namespace {

struct Block {
    std::uint64_t first, second;
};

std::uint64_t joined(std::uint32_t low, std::uint32_t high) { return static_cast<std::uint64_t>(high) << 32 | low; }
std::uint32_t low_half(std::uint64_t bits) { return static_cast<std::uint32_t>(bits); }
std::uint32_t high_half(std::uint64_t bits) { return static_cast<std::uint32_t>(bits >> 32); }

Block block(RandomKey key, std::uint64_t index) {
    const r123::Philox4x32::ctr_type counter{{low_half(index), high_half(index), low_half(key.stream), high_half(key.stream)}};
    const auto bits = r123::Philox4x32{}(counter, {{low_half(key.seed), high_half(key.seed)}});
    return {joined(bits[0], bits[1]), joined(bits[2], bits[3])};
}

/// (b + ½) 2^−52 of the upper 52 bits: exact, since 1 + b 2^−52 is a double and so is the difference.
double to_uniform(std::uint64_t bits) {
    return (std::bit_cast<double>(bits >> 12 | 0x3ff0000000000000U) - 1.0) + 0x1p-53;
}

/// ln u for u in (0, 1), within 3 ulp. u = m 2^e with m in [√½, √2); ln m = 2 artanh s, s = (m − 1)/(m + 1).
double logarithm(double value) {
    constexpr std::uint64_t root_half = 0x3fe6a09e667f3bcdU, bias = 1023ULL << 52;
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(value);
    const std::uint64_t shifted = bits - root_half + bias;
    const std::uint64_t exponent = shifted >> 52;
    const double mantissa = std::bit_cast<double>(bits - (exponent << 52) + bias);
    const double power = std::bit_cast<double>(exponent | 0x4330000000000000U) - (0x1p52 + 1023.0);
    const double s = (mantissa - 1.0) / (mantissa + 1.0), t = s * s;
    double series = 1.0 / 21.0;
    series = series * t + 1.0 / 19.0;
    series = series * t + 1.0 / 17.0;
    series = series * t + 1.0 / 15.0;
    series = series * t + 1.0 / 13.0;
    series = series * t + 1.0 / 11.0;
    series = series * t + 1.0 / 9.0;
    series = series * t + 1.0 / 7.0;
    series = series * t + 1.0 / 5.0;
    series = series * t + 1.0 / 3.0;
    return power * 0.6931471805599453 + (2.0 * s + 2.0 * s * t * series);
}

/// Sine and cosine in |angle| <= π/4 by their series.
double sine(double angle) {
    const double t = angle * angle;
    double series = -1.0 / 1307674368000.0;
    series = series * t + 1.0 / 6227020800.0;
    series = series * t - 1.0 / 39916800.0;
    series = series * t + 1.0 / 362880.0;
    series = series * t - 1.0 / 5040.0;
    series = series * t + 1.0 / 120.0;
    series = series * t - 1.0 / 6.0;
    return angle + angle * t * series;
}

double cosine(double angle) {
    const double t = angle * angle;
    double series = 1.0 / 20922789888000.0;
    series = series * t - 1.0 / 87178291200.0;
    series = series * t + 1.0 / 479001600.0;
    series = series * t - 1.0 / 3628800.0;
    series = series * t + 1.0 / 40320.0;
    series = series * t - 1.0 / 720.0;
    series = series * t + 1.0 / 24.0;
    series = series * t - 0.5;
    return 1.0 + t * series;
}

constexpr Index blocks_at_once = 128;
using Batch = std::array<std::uint64_t, blocks_at_once>;
using Numbers = std::array<double, 2 * blocks_at_once>;

/// Normal numbers of `count` blocks. The angle is (π/2)(k + f): k two bits, f uniform in (−½, ½); a quarter turn swaps
/// sine and cosine and sets signs, here on the bits so that the loop vectorises.
void box_muller(const Batch& first, const Batch& second, Index count, Numbers& numbers) {
    constexpr std::uint64_t sign_bit = 1ULL << 63;
    for (Index i = 0; i < count; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const double radius = std::sqrt(-2.0 * logarithm(to_uniform(first[at])));
        const std::uint64_t turn = second[at] >> 62;
        const double angle = (0.5 * pi) * (to_uniform(second[at] << 2) - 0.5);
        const std::uint64_t sin_bits = std::bit_cast<std::uint64_t>(radius * sine(angle));
        const std::uint64_t cos_bits = std::bit_cast<std::uint64_t>(radius * cosine(angle));
        const std::uint64_t odd = 0U - (turn & 1U);
        const std::uint64_t real = (cos_bits & ~odd) | (sin_bits & odd), imaginary = (sin_bits & ~odd) | (cos_bits & odd);
        numbers[2 * at] = std::bit_cast<double>(real ^ ((turn ^ turn >> 1) << 63 & sign_bit));
        numbers[2 * at + 1] = std::bit_cast<double>(imaginary ^ ((turn >> 1) << 63));
    }
}

}  // namespace

RandomKey substream(RandomKey key, std::uint64_t index) {
    constexpr std::uint64_t keys_domain = 0x9e3779b97f4a7c15U;  // apart from the numbers of the same seed
    return {key.seed, block({key.seed ^ keys_domain, key.stream}, index).first};
}

std::uint64_t random_bits(RandomKey key, std::uint64_t counter) {
    const auto both = block(key, counter / 2);
    return counter % 2 == 0 ? both.first : both.second;
}

double uniform_number(RandomKey key, std::uint64_t counter) { return to_uniform(random_bits(key, counter)); }

double normal_number(RandomKey key, std::uint64_t counter) {
    const auto both = block(key, counter / 2);
    Numbers numbers;
    box_muller({both.first}, {both.second}, 1, numbers);
    return numbers[counter % 2];
}

void fill_uniform(RandomKey key, std::uint64_t first_counter, Eigen::Ref<Array1D> values) {
    for (Index i = 0; i < values.size(); ++i) values[i] = uniform_number(key, first_counter + static_cast<std::uint64_t>(i));
}

void fill_normal(RandomKey key, std::uint64_t first_counter, Eigen::Ref<Array1D> values) {
    const std::uint64_t last_counter = first_counter + static_cast<std::uint64_t>(values.size());
    Batch first, second;
    Numbers numbers;
    for (std::uint64_t counter = first_counter; counter < last_counter;) {
        const std::uint64_t from = counter / 2;
        const auto count = static_cast<Index>(std::min<std::uint64_t>(blocks_at_once, (last_counter + 1) / 2 - from));
        for (Index i = 0; i < count; ++i) {
            const auto both = block(key, from + static_cast<std::uint64_t>(i));
            first[static_cast<std::size_t>(i)] = both.first;
            second[static_cast<std::size_t>(i)] = both.second;
        }
        box_muller(first, second, count, numbers);
        const std::uint64_t end = std::min(last_counter, 2 * (from + static_cast<std::uint64_t>(count)));
        for (; counter < end; ++counter) values[static_cast<Index>(counter - first_counter)] = numbers[counter - 2 * from];
    }
}

Array1D uniform_numbers(RandomKey key, std::uint64_t first_counter, Index count) {
    Array1D values(count);
    fill_uniform(key, first_counter, values);
    return values;
}

Array1D normal_numbers(RandomKey key, std::uint64_t first_counter, Index count) {
    Array1D values(count);
    fill_normal(key, first_counter, values);
    return values;
}

}  // namespace setae::synthesis
