// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/fourier/nonuniform.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "plain_sum.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/fourier/buffer.hpp"
#include "setae/fourier/fast_length.hpp"
#include "setae/fourier/transform.hpp"
#include "spreading_kernel.hpp"

namespace setae::fourier {
namespace {

void check(const ArrayView1D& positions, const ArrayView1D& coefficients, const ArrayView1D& wavevectors) {
    if (positions.size() != coefficients.size())
        throw InvalidArgument(fmt::format("{} positions for {} coefficients; expected one per coefficient",
                                          positions.size(), coefficients.size()));
    if (!positions.isFinite().all() || !coefficients.isFinite().all() || !wavevectors.isFinite().all())
        throw InvalidArgument("values of a non-uniform transform are not finite");
}

Complex plain_sum(const ArrayView1D& positions, const ArrayView1D& coefficients, double wavevector) {
    double real = 0.0, imaginary = 0.0;
    for (Index k = 0; k < positions.size(); ++k) {
        const double phase = wavevector * positions[k];
        real += coefficients[k] * std::cos(phase);
        imaginary -= coefficients[k] * std::sin(phase);
    }
    return {real, imaginary};
}

/// Smallest 2^a 3^b 5^c that is even and >= n.
Index smooth_size(double n) { return 2 * fast_length(static_cast<Index>(std::ceil(0.5 * n))); }

struct Extent {
    double centre;
    double half;
};

Extent extent_of(double lowest, double highest) { return {0.5 * (lowest + highest), 0.5 * (highest - lowest)}; }

/// Sums for a band of wavevectors by the cheapest method.
class BandTransform {
public:
    BandTransform(const ArrayView1D& positions, const ArrayView1D& coefficients, const ArrayView1D& wavevectors,
                  parallel::Threads threads, Eigen::ArrayXcd& result)
        : positions_(positions),
          coefficients_(coefficients),
          wavevectors_(wavevectors),
          threads_(threads),
          result_(result),
          x_(extent_of(positions.minCoeff(), positions.maxCoeff())) {}

    /// `band`: indices of wavevectors in increasing order of q.
    void apply(std::span<const Index> band) const {
        if (band.empty()) return;
        const auto q = extent_of(wavevectors_[band.front()], wavevectors_[band.back()]);
        const double steps = grid_steps(q);
        if (sum_cost(band) <= grid_cost(band, steps)) return by_sum(band);
        if (steps <= largest_grid) return by_grid(band, q, steps);
        const auto middle =
            std::partition_point(band.begin(), band.end(), [&](Index j) { return wavevectors_[j] < q.centre; });
        const auto lower = static_cast<std::size_t>(middle - band.begin());
        apply(band.first(lower));
        apply(band.subspan(lower));
    }

private:
    static constexpr double largest_grid = 1 << 21;
    static constexpr double width = static_cast<double>(SpreadingKernel::width);
    static constexpr double sigma = SpreadingKernel::oversampling;

    /// Points of the grid in x, before the second oversampling.
    [[nodiscard]] double grid_steps(const Extent& q) const { return 2.0 * sigma * x_.half * q.half / pi + 2.0 * width; }

    // measured: 12 ns per term of the sum, 6 ns per grid point and doubling of the grid, 150 ns per point spread or
    // interpolated
    [[nodiscard]] double sum_cost(std::span<const Index> band) const {
        return 12.0 * static_cast<double>(positions_.size()) * static_cast<double>(band.size());
    }
    [[nodiscard]] double grid_cost(std::span<const Index> band, double steps) const {
        return 6.0 * steps * std::log2(steps) +
               150.0 * (static_cast<double>(positions_.size()) + static_cast<double>(band.size()));
    }

    /// Calls body for the entries of the band, in fixed chunks.
    template <class Body>
    void for_each(std::span<const Index> band, const Body& body) const {
        constexpr std::size_t chunk = 256;
        parallel::for_each_index((band.size() + chunk - 1) / chunk, threads_, [&](std::size_t c) {
            for (std::size_t b = c * chunk; b < std::min(band.size(), (c + 1) * chunk); ++b) body(band[b]);
        });
    }

    void by_sum(std::span<const Index> band) const {
        for_each(band, [&](Index j) { result_[j] = plain_sum(positions_, coefficients_, wavevectors_[j]); });
    }

    void by_grid(std::span<const Index> band, const Extent& q, double steps) const {
        const auto& kernel = SpreadingKernel::instance();
        const Index fine = smooth_size(sigma * steps), coarse = fine / static_cast<Index>(sigma);
        // step of the grid in x: waves up to q.half are sampled sigma times finer than needed
        const double step = q.half > 0.0 && x_.half > 0.0 ? pi / (sigma * q.half) : std::max(x_.half, 1.0);
        const Buffer<Complex> spectrum = transformed_grid(spread(q.centre, step, coarse), coarse, fine);
        const double to_fine = static_cast<double>(fine) * step / (2.0 * pi);
        for_each(band, [&](Index j) {
            const double offset = wavevectors_[j] - q.centre;
            const auto taps = kernel.at(offset * to_fine);
            Complex sum{};
            for (Index i = 0; i < SpreadingKernel::width; ++i) {
                const Index m = taps.first + i;
                sum +=
                    taps.values[static_cast<std::size_t>(i)] * spectrum[static_cast<std::size_t>(m < 0 ? m + fine : m)];
            }
            result_[j] = sum * std::polar(1.0, -wavevectors_[j] * x_.centre) / kernel.transform(offset * step);
        });
    }

    /// Grid values b_l, l = −coarse/2 … coarse/2 − 1, of the points with phases exp(−i q_c x).
    [[nodiscard]] std::vector<Complex> spread(double q_centre, double step, Index coarse) const {
        const auto& kernel = SpreadingKernel::instance();
        std::vector<Complex> grid(static_cast<std::size_t>(coarse));
        for (Index k = 0; k < positions_.size(); ++k) {
            const double x = positions_[k] - x_.centre;
            const auto taps = kernel.at(x / step);
            const Complex value = coefficients_[k] * std::polar(1.0, -q_centre * x);
            Complex* place = grid.data() + (taps.first + coarse / 2);
            for (std::size_t i = 0; i < taps.values.size(); ++i) place[i] += taps.values[i] * value;
        }
        return grid;
    }

    /// Transform of the grid on `fine` wavevectors, prepared for interpolation with the kernel.
    static Buffer<Complex> transformed_grid(const std::vector<Complex>& grid, Index coarse, Index fine) {
        const auto& kernel = SpreadingKernel::instance();
        Buffer<Complex> spectrum(static_cast<std::size_t>(fine), Complex{});
        // the transform of the kernel is even, so l and −l share a value; l = −coarse/2 is outside the spread
        const auto entry = [&](Index l) { return grid[static_cast<std::size_t>(l + coarse / 2)]; };
        spectrum[0] = entry(0) / kernel.transform(0.0);
        for (Index l = 1; l < coarse / 2; ++l) {
            const double inverse =
                1.0 / kernel.transform(2.0 * pi * static_cast<double>(l) / static_cast<double>(fine));
            spectrum[static_cast<std::size_t>(l)] = entry(l) * inverse;
            spectrum[static_cast<std::size_t>(fine - l)] = entry(-l) * inverse;
        }
        ComplexTransform(fine).apply(spectrum.data());
        return spectrum;
    }

    const ArrayView1D& positions_;
    const ArrayView1D& coefficients_;
    const ArrayView1D& wavevectors_;
    parallel::Threads threads_;
    Eigen::ArrayXcd& result_;
    Extent x_;
};

}  // namespace

Eigen::ArrayXcd nonuniform_transform(const ArrayView1D& positions, const ArrayView1D& coefficients,
                                     const ArrayView1D& wavevectors, parallel::Threads threads) {
    check(positions, coefficients, wavevectors);
    Eigen::ArrayXcd result = Eigen::ArrayXcd::Zero(wavevectors.size());
    if (positions.size() == 0) return result;
    std::vector<Index> order(static_cast<std::size_t>(wavevectors.size()));
    std::iota(order.begin(), order.end(), Index{0});
    std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return wavevectors[a] < wavevectors[b]; });
    BandTransform(positions, coefficients, wavevectors, threads, result).apply(order);
    return result;
}

Eigen::ArrayXcd nonuniform_transform_by_sum(const ArrayView1D& positions, const ArrayView1D& coefficients,
                                            const ArrayView1D& wavevectors, parallel::Threads threads) {
    check(positions, coefficients, wavevectors);
    Eigen::ArrayXcd result(wavevectors.size());
    parallel::for_each_index(static_cast<std::size_t>(wavevectors.size()), threads, [&](std::size_t j) {
        result[static_cast<Index>(j)] = plain_sum(positions, coefficients, wavevectors[static_cast<Index>(j)]);
    });
    return result;
}

}  // namespace setae::fourier
