// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/numerics/random_blocks.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include <Random123/philox.h>

#include "setae/core/constants.hpp"

namespace setae::numerics {
namespace {

using Bits = std::uint64_t;

constexpr Bits bits_of_one = 0x3ff0000000000000, mantissa_mask = 0x000fffffffffffff;

/// 1 + k/2⁵² in the mantissa, minus 1 − 2⁻⁵³.
double uniform(Bits bits) { return std::bit_cast<double>(bits_of_one | (bits >> 12)) - (1.0 - 0x1p-53); }

/// √(−2 ln u), u in (0, 1): u = 2^k m with m in [√½, √2), ln m = 2 artanh(s), s = (m − 1)/(m + 1).
double radius_from(double u) {
    constexpr Bits bits_of_root_half = 0x3fe6a09e00000000;
    const Bits shifted = std::bit_cast<Bits>(u) + (bits_of_one - bits_of_root_half);
    // an integer below 2⁵² as a double: in the mantissa of 2⁵²
    const double exponent = std::bit_cast<double>(0x4330000000000000 | (shifted >> 52)) - (0x1p52 + 1023.0);
    const double f = std::bit_cast<double>((shifted & mantissa_mask) + bits_of_root_half) - 1.0;
    const double s = f / (2.0 + f), z = s * s, half_square = 0.5 * f * f;
    const double series = z * (6.666666666666735130e-01 +
                               z * (3.999999999940941908e-01 +
                                    z * (2.857142874366239149e-01 +
                                         z * (2.222219843214978396e-01 +
                                              z * (1.818357216161805012e-01 +
                                                   z * (1.531383769920937332e-01 + z * 1.479819860511658591e-01))))));
    constexpr double ln2_high = 6.93147180369123816490e-01, ln2_low = 1.90821492927058770002e-10;
    const double logarithm =
        exponent * ln2_high - ((half_square - (s * (half_square + series) + exponent * ln2_low)) - f);
    return std::sqrt(-2.0 * logarithm);
}

struct Direction {
    double cosine, sine;
};

/// Cosine and sine of the angle (quarter + r) π/2: quarter from two bits, r in (−½, ½) from the fifty below.
Direction direction_from(Bits bits) {
    const Bits quarter = bits >> 62;
    const double r = std::bit_cast<double>(bits_of_one | ((bits >> 10) & mantissa_mask & ~Bits{3})) - (1.5 - 0x1p-51);
    const double x = r * (0.5 * pi), z = x * x;
    const double sine = x + x * z *
                                (-1.66666666666666324348e-01 +
                                 z * (8.33333333332248946124e-03 +
                                      z * (-1.98412698298579493134e-04 +
                                           z * (2.75573137070700676789e-06 +
                                                z * (-2.50507602534068634195e-08 + z * 1.58969099521155010221e-10)))));
    const double cosine =
        1.0 - (0.5 * z - z * z *
                             (4.16666666666666019037e-02 +
                              z * (-1.38888888888741095749e-03 +
                                   z * (2.48015872894767294178e-05 +
                                        z * (-2.75573143513906633035e-07 +
                                             z * (2.08757232129817482790e-09 - z * 1.13596475577881948265e-11))))));
    // a quarter turn takes (c, s) to (−s, c)
    const Bits swap = Bits{0} - (quarter & 1), c = std::bit_cast<Bits>(cosine), s = std::bit_cast<Bits>(sine);
    const Bits turned_c = (c & ~swap) | (s & swap), turned_s = (s & ~swap) | (c & swap);
    return {std::bit_cast<double>(turned_c ^ (((quarter ^ (quarter >> 1)) & 1) << 63)),
            std::bit_cast<double>(turned_s ^ ((quarter >> 1) << 63))};
}

/// Numbers computed together, so the compiler vectorises the loops.
constexpr Index batch = 128;
using Batch = std::array<Bits, batch>;

void fill_blocks(RandomKey key, const Bits* blocks, Batch& first, Batch& second, Index n) {
    for (Index i = 0; i < n; ++i) {
        const auto halves = random_block(key, blocks[i]);
        first[static_cast<std::size_t>(i)] = halves[0];
        second[static_cast<std::size_t>(i)] = halves[1];
    }
}

template <bool with_radius>
void fill(RandomKey key, const Bits* blocks, std::complex<double>* out, Index n) {
    Batch first, second;
    alignas(64) std::array<double, batch> cosines, sines;
    for (Index from = 0; from < n; from += batch) {
        const Index count = std::min(batch, n - from);
        fill_blocks(key, blocks + from, first, second, count);
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
            const Direction direction = direction_from(second[i]);
            cosines[i] = direction.cosine;
            sines[i] = direction.sine;
        }
        if constexpr (with_radius)
            for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
                const double radius = radius_from(uniform(first[i]));
                cosines[i] *= radius;
                sines[i] *= radius;
            }
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
            out[from + static_cast<Index>(i)] = {cosines[i], sines[i]};
    }
}

}  // namespace

std::array<Bits, 2> random_block(RandomKey key, Bits block) {
    const auto low = [](Bits value) { return static_cast<std::uint32_t>(value); };
    const auto high = [](Bits value) { return static_cast<std::uint32_t>(value >> 32); };
    const r123::Philox4x32::ctr_type counter{{low(block), high(block), low(key.stream), high(key.stream)}};
    const r123::Philox4x32::key_type words{{low(key.seed), high(key.seed)}};
    const auto out = r123::Philox4x32{}(counter, words);
    return {out[0] | Bits{out[1]} << 32, out[2] | Bits{out[3]} << 32};
}

double uniform_from(Bits bits) { return uniform(bits); }

void complex_normals(RandomKey key, const Bits* blocks, std::complex<double>* out, Index n) {
    fill<true>(key, blocks, out, n);
}
void unit_phases(RandomKey key, const Bits* blocks, std::complex<double>* out, Index n) {
    fill<false>(key, blocks, out, n);
}

}  // namespace setae::numerics
