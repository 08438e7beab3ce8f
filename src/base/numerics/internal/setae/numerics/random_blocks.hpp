// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <complex>

#include "setae/numerics/random_numbers.hpp"

namespace setae::numerics {

/// Both halves of a block of Philox4x32-10.
[[nodiscard]] std::array<std::uint64_t, 2> random_block(RandomKey key, std::uint64_t block);

/// (k + ½)/2⁵², k the upper 52 bits: exact.
[[nodiscard]] double uniform_from(std::uint64_t bits);

/// out_i = n_2b + i n_2b+1 for the blocks b = blocks_i: two independent standard normal numbers.
void complex_normals(RandomKey key, const std::uint64_t* blocks, std::complex<double>* out, Index n);

/// out_i = exp(iφ), the phases of complex_normals.
void unit_phases(RandomKey key, const std::uint64_t* blocks, std::complex<double>* out, Index n);

}  // namespace setae::numerics
