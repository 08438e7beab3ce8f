// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "setae/core/arrays.hpp"

namespace setae::numerics {

/// A sequence of random numbers; its numbers are pure functions of (key, counter), so any thread may draw any number.
struct RandomKey {
    std::uint64_t seed = 0;    ///< set by the user
    std::uint64_t stream = 0;  ///< number of the independent sequence of this seed

    friend bool operator==(const RandomKey&, const RandomKey&) = default;
};

/// The key of one of many independent sequences of a key: streams that differ by key or index share no numbers, except
/// for collisions of 64-bit hashes (10⁶ streams: 3e-8).
[[nodiscard]] RandomKey substream(RandomKey key, std::uint64_t index);

/// 64 random bits: half (counter mod 2) of block (counter div 2) of Philox4x32-10 with key = seed, counter words
/// (block, stream).
/// Source: Salmon, Moraes, Dror, Shaw, SC'11, doi 10.1145/2063384.2063405.
[[nodiscard]] std::uint64_t random_bits(RandomKey key, std::uint64_t counter);

/// Uniform in (0, 1): (k + ½)/2⁵², k the upper 52 of the random bits. Exact; never 0 or 1.
[[nodiscard]] double uniform_number(RandomKey key, std::uint64_t counter);

/// Standard normal number.
///
///   n_2b = √(−2 ln u) cos φ,  n_2b+1 = √(−2 ln u) sin φ,  u = uniform 2b, φ uniform from random bits 2b + 1
///
/// ln, cos and sin are polynomials with a fixed order of operations (only +, −, ×, /, √ of IEEE 754), within 2e-16 of
/// the functions, so the bytes do not depend on computer, compiler or mathematics library. |n| < 8.6. A uniform and a
/// normal number of one key and counter share their bits: draw them from different streams. Source: Box and Muller,
/// Ann. Math. Stat. 29 (1958) 610; coefficients of Sun's fdlibm (e_log, k_sin, k_cos).
[[nodiscard]] double normal_number(RandomKey key, std::uint64_t counter);

/// out_i = normal_number(key, first_counter + i), about 8 ns per number.
void fill_normal(RandomKey key, std::uint64_t first_counter, Eigen::Ref<Array1D> out);

/// `count` numbers from first_counter on. @throws InvalidArgument for count < 0.
[[nodiscard]] Array1D normal_numbers(RandomKey key, std::uint64_t first_counter, Index count);

/// An index 0 … n − 1, each equally likely to within n/2⁵²: floor(n u). @throws InvalidArgument for n < 1 or n > 2⁴⁰.
[[nodiscard]] Index random_index(RandomKey key, std::uint64_t counter, Index n);

}  // namespace setae::numerics
