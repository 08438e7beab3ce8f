// SPDX-License-Identifier: GPL-3.0-or-later
#include "local_medians.hpp"

#include <array>
#include <utility>

#if defined(__x86_64__)
#define SETAE_WIDER_VECTORS
#endif

namespace setae::processing {
namespace {

/// As many numbers as fit into a register of the processor.
template <int width>
struct Lanes {
    using Values [[gnu::vector_size(width * sizeof(double))]] = double;
    /// The same vector at any address; a copy of bytes would go through memory in halves.
    using Unaligned [[gnu::vector_size(width * sizeof(double)), gnu::aligned(alignof(double)), gnu::may_alias]] =
        double;

    Values values;
};

/// The smaller numbers of two to the first, the larger ones to the second.
template <int width>
[[gnu::always_inline]] inline void order(Lanes<width>& low, Lanes<width>& high) {
    const auto a = low.values, b = high.values;
    low.values = a < b ? a : b;
    high.values = a > b ? a : b;
}

/// Removes the smallest and the largest of `size` numbers; the others move to the front.
template <int width>
[[gnu::always_inline]] inline void drop_ends(Lanes<width>* kept, std::size_t size) {
#pragma GCC unroll 16
    for (std::size_t k = 0; 2 * k + 1 < size; ++k) order(kept[k], kept[size - 1 - k]);
#pragma GCC unroll 16
    for (std::size_t k = 1; 2 * k < size; ++k) order(kept[0], kept[k]);
#pragma GCC unroll 16
    for (std::size_t k = size / 2; k + 1 < size; ++k) order(kept[k], kept[size - 1]);
    kept[0] = kept[size - 2];
}

/// Number of values kept at once, of `all` numbers, an even number: the smallest and the largest one of more than half
/// of them are not in the middle.
constexpr std::size_t largest_of(std::size_t all) { return all / 2 + 2; }

/// The difference of heights to the point (a, b) places further.
template <int width>
[[gnu::always_inline]] inline void load_difference(const double* here, Index row_length, const Tilt& tilt, Index a,
                                                   Index b, Lanes<width>& difference) {
    using Unaligned = typename Lanes<width>::Unaligned;
    const typename Lanes<width>::Values there = *reinterpret_cast<const Unaligned*>(here + a * row_length + b),
                                        centre = *reinterpret_cast<const Unaligned*>(here);
    difference.values = there - centre - static_cast<double>(a) * tilt.down - static_cast<double>(b) * tilt.along;
}

template <int width>
[[gnu::always_inline]] inline void write_middle(const Lanes<width>* kept, double* median) {
    *reinterpret_cast<typename Lanes<width>::Unaligned*>(median) = 0.5 * (kept[0].values + kept[1].values);
}

/// The default, reach 2: all loop counts are known at compile time, and all numbers remain in registers.
template <int width>
struct SquareOfDefault {
    static constexpr Index reach = 2, side = 2 * reach + 1;
    static constexpr std::size_t all = side * side - 1, most = largest_of(all);

    std::array<Lanes<width>, most> kept;

    template <std::size_t k>
    [[gnu::always_inline]] inline void add(const double* here, Index row_length, const Tilt& tilt) {
        constexpr auto place = static_cast<Index>(k < all / 2 ? k : k + 1);
        constexpr std::size_t before = k < most ? k : 2 * most - 2 - k;
        load_difference(here, row_length, tilt, place / side - reach, place % side - reach, kept[before]);
        if constexpr (before + 1 == most || k >= most) drop_ends(kept.data(), before + 1);
    }

    template <std::size_t... k>
    [[gnu::always_inline]] inline void find(const double* here, Index row_length, const Tilt& tilt, double* median,
                                            std::index_sequence<k...>) {
        (add<k>(here, row_length, tilt), ...);
        write_middle(kept.data(), median);
    }
};

template <int width>
[[gnu::always_inline]] inline void medians_of_default(const double* here, Index row_length, const Tilt& tilt,
                                                      Index count, double* medians) {
    using Square = SquareOfDefault<width>;
    for (Index k = 0; k < count; k += width)
        Square{}.find(here + k, row_length, tilt, medians + k, std::make_index_sequence<Square::all>{});
}

void medians_in_pairs(const double* here, Index row_length, const Tilt& tilt, Index count, double* medians) {
    medians_of_default<2>(here, row_length, tilt, count, medians);
}

#ifdef SETAE_WIDER_VECTORS
__attribute__((target("avx2"))) void medians_in_fours(const double* here, Index row_length, const Tilt& tilt,
                                                      Index count, double* medians) {
    medians_of_default<4>(here, row_length, tilt, count, medians);
}

__attribute__((target("avx512f"))) void medians_in_eights(const double* here, Index row_length, const Tilt& tilt,
                                                          Index count, double* medians) {
    medians_of_default<8>(here, row_length, tilt, count, medians);
}
#endif

using Medians = void (*)(const double*, Index, const Tilt&, Index, double*);

Medians widest() {
#ifdef SETAE_WIDER_VECTORS
    if (__builtin_cpu_supports("avx512f")) return medians_in_eights;
    if (__builtin_cpu_supports("avx2")) return medians_in_fours;
#endif
    return medians_in_pairs;
}

/// Any reach.
void medians_of_rectangle(const double* here, Index row_length, const Tilt& tilt, const Reach& reach, double* median) {
    constexpr Index side = 2 * largest_reach + 1;
    std::array<Lanes<2>, largest_of(side * side - 1)> kept;
    const auto most = largest_of(static_cast<std::size_t>((2 * reach.rows + 1) * (2 * reach.columns + 1) - 1));
    for (Index k = 0; k < medians_together; k += 2) {
        std::size_t size = 0, limit = most;
        for (Index a = -reach.rows; a <= reach.rows; ++a)
            for (Index b = -reach.columns; b <= reach.columns; ++b) {
                if (a == 0 && b == 0) continue;
                load_difference(here + k, row_length, tilt, a, b, kept[size++]);
                if (size < limit || size <= 2) continue;
                drop_ends(kept.data(), size);
                size -= 2;
                limit = size + 1;
            }
        while (size > 2) {
            drop_ends(kept.data(), size);
            size -= 2;
        }
        write_middle(kept.data(), median + k);
    }
}

}  // namespace

void find_local_medians(const double* here, Index row_length, const Tilt& tilt, const Reach& reach, Index groups,
                        double* medians) {
    static const Medians of_default = widest();
    constexpr Index by_default = SquareOfDefault<2>::reach;
    if (reach.rows == by_default && reach.columns == by_default)
        return of_default(here, row_length, tilt, groups * medians_together, medians);
    for (Index k = 0; k < groups * medians_together; k += medians_together)
        medians_of_rectangle(here + k, row_length, tilt, reach, medians + k);
}

}  // namespace setae::processing
