// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/numerics/random_numbers.hpp"

#include <algorithm>
#include <array>
#include <complex>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/numerics/random_blocks.hpp"

namespace setae::numerics {
namespace {

void require_count(Index count) {
    if (count < 0) throw InvalidArgument(fmt::format("{} random numbers; expected 0 or more", count));
}

std::complex<double> normal_pair(RandomKey key, std::uint64_t block) {
    std::complex<double> pair;
    complex_normals(key, &block, &pair, 1);
    return pair;
}

}  // namespace

RandomKey substream(RandomKey key, std::uint64_t index) {
    // a separate key, so no number drawn elsewhere becomes the key of a stream
    constexpr std::uint64_t naming = 0x73756273747265ULL;
    return {key.seed, random_block({key.seed ^ naming, key.stream}, index)[0]};
}

std::uint64_t random_bits(RandomKey key, std::uint64_t counter) { return random_block(key, counter / 2)[counter % 2]; }

double uniform_number(RandomKey key, std::uint64_t counter) { return uniform_from(random_bits(key, counter)); }

double normal_number(RandomKey key, std::uint64_t counter) {
    const auto pair = normal_pair(key, counter / 2);
    return counter % 2 == 0 ? pair.real() : pair.imag();
}

void fill_normal(RandomKey key, std::uint64_t first_counter, Eigen::Ref<Array1D> out) {
    constexpr Index batch = 256;
    std::array<std::uint64_t, batch> blocks;
    std::array<std::complex<double>, batch> pairs;
    Index i = 0;
    const Index n = out.size();
    if (n > 0 && first_counter % 2 == 1) out[i++] = normal_number(key, first_counter);
    while (i < n) {
        const Index count = std::min(batch, (n - i + 1) / 2);
        const std::uint64_t block = (first_counter + static_cast<std::uint64_t>(i)) / 2;
        for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) blocks[k] = block + k;
        complex_normals(key, blocks.data(), pairs.data(), count);
        for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
            out[i++] = pairs[k].real();
            if (i < n) out[i++] = pairs[k].imag();
        }
    }
}

Array1D normal_numbers(RandomKey key, std::uint64_t first_counter, Index count) {
    require_count(count);
    Array1D numbers(count);
    fill_normal(key, first_counter, numbers);
    return numbers;
}

Index random_index(RandomKey key, std::uint64_t counter, Index n) {
    if (n < 1 || n > Index{1} << 40)
        throw InvalidArgument(fmt::format("a random index below {}; expected 1 … 2^40", n));
    return static_cast<Index>(uniform_number(key, counter) * static_cast<double>(n));
}

}  // namespace setae::numerics
