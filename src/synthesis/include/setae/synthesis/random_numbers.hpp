// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "setae/core/arrays.hpp"

namespace setae::synthesis {

/// Names a sequence of random numbers: number i of it is a function of (key, i) alone, drawn in any order by any thread.
///
/// seed: what the user gives. stream: which of the independent sequences of that seed.
struct RandomKey {
    std::uint64_t seed = 0;
    std::uint64_t stream = 0;

    friend bool operator==(const RandomKey&, const RandomKey&) = default;
};

/// Key number `index` below a key: one for each instrument, scan, loop or replica; substreams can have their own.
///
/// The stream is 64 bits of the generator itself, so two keys of one seed coincide with probability 2^−64.
[[nodiscard]] RandomKey substream(RandomKey key, std::uint64_t index);

/// 64 random bits: half counter mod 2 of block counter/2 of Philox4x32-10 with the seed as key and the stream in the upper
/// half of its counter.
/// Source: Salmon, Moraes, Dror, Shaw, Proc. SC11 (2011), doi 10.1145/2063384.2063405.
[[nodiscard]] std::uint64_t random_bits(RandomKey key, std::uint64_t counter);

/// A number uniform in (0, 1): (b + ½) 2^−52, b the upper 52 of random_bits.
[[nodiscard]] double uniform_number(RandomKey key, std::uint64_t counter);

/// A standard normal number, by Box and Muller from the two halves of a block: numbers 2m and 2m + 1 are the real and
/// imaginary part of √(−2 ln u) exp(iφ).
///
/// u as uniform_number, φ uniform on the circle. Largest magnitude √(106 ln 2) = 8.57. Only + − × ÷ √ of IEEE 754 in a
/// fixed order, no library function: the same bytes on every machine and with every compiler that keeps that standard.
/// Uniform and normal numbers of one key and counter come from the same bits; draw them from different streams.
[[nodiscard]] double normal_number(RandomKey key, std::uint64_t counter);

/// values[i] = uniform_number(key, first_counter + i).
void fill_uniform(RandomKey key, std::uint64_t first_counter, Eigen::Ref<Array1D> values);

/// values[i] = normal_number(key, first_counter + i), the same bytes, about 12 ns a number.
void fill_normal(RandomKey key, std::uint64_t first_counter, Eigen::Ref<Array1D> values);

[[nodiscard]] Array1D uniform_numbers(RandomKey key, std::uint64_t first_counter, Index count);
[[nodiscard]] Array1D normal_numbers(RandomKey key, std::uint64_t first_counter, Index count);

}  // namespace setae::synthesis
