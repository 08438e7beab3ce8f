// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/synthesis/transformed_heights.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/fourier/inverse_map_transform.hpp"
#include "setae/fourier/map_transform.hpp"

namespace setae::synthesis {
namespace {

/// Half spectrum of a map: entry (m, k).
using HalfSpectrum = Eigen::Array<fourier::Complex, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

HalfSpectrum half_spectrum(const Array2D& map, parallel::Threads threads) {
    HalfSpectrum spectrum(map.cols() / 2 + 1, map.rows());
    fourier::transform_map(
        map.rows(), map.cols(), [&](Index i, double* line) { std::copy_n(map.row(i).data(), map.cols(), line); },
        [&](const fourier::SpectrumBlock& block) {
            for (Index m = 0; m < block.lines; ++m)
                std::copy_n(block.line(m), block.modes, spectrum.row(block.first + m).data());
        },
        threads);
    return spectrum;
}

/// Number of modes of the whole spectrum per mode in line m of the half spectrum.
double multiplicity(Index m, Index ny) { return m == 0 || 2 * m == ny ? 1.0 : 2.0; }

double mean_square(const Array2D& map) {
    double sum = 0.0;
    for (Index i = 0; i < map.rows(); ++i) sum += map.row(i).square().sum();
    return sum / static_cast<double>(map.size());
}

/// TransformCorrelation::parent as cubics between nodes with exact values and slopes: to 1e-13, one map at a time.
class ParentTable {
public:
    explicit ParentTable(const TransformCorrelation& correlation)
        : lowest_(correlation.transformed(-1.0)), values_(nodes), slopes_(nodes) {
        for (Index i = 0; i < nodes; ++i) {
            values_[i] = correlation.parent(i == nodes - 1 ? 1.0 : lowest_ + step() * static_cast<double>(i));
            slopes_[i] = step() / correlation.slope(values_[i]);
        }
    }

    [[nodiscard]] double operator()(double transformed) const {
        const double place = std::clamp((transformed - lowest_) / step(), 0.0, static_cast<double>(nodes - 1));
        const Index i = std::min(static_cast<Index>(place), nodes - 2);
        const double t = place - static_cast<double>(i), rest = 1.0 - t;
        return rest * rest * ((1.0 + 2.0 * t) * values_[i] + t * slopes_[i]) +
               t * t * ((3.0 - 2.0 * t) * values_[i + 1] - rest * slopes_[i + 1]);
    }

private:
    static constexpr Index nodes = 4097;
    [[nodiscard]] double step() const { return (1.0 - lowest_) / static_cast<double>(nodes - 1); }

    double lowest_;
    Array1D values_, slopes_;
};

/// Expected |h_q|² of random_surface: those of the surface with exact amplitudes.
Array2D expected_powers(const spectra::SpectralDensity& C_iso, const SurfaceGrid& grid, SurfaceOptions options) {
    options.amplitudes = Amplitudes::exact;
    options.exact_rms_height.reset();
    const double points = static_cast<double>(grid.nx) * static_cast<double>(grid.ny);
    return half_spectrum(random_surface(C_iso, grid, options).heights, options.threads).abs2() / (points * points);
}

/// Autocorrelation of the powers of modes, mean square 1.
Array2D autocorrelation(const Array2D& powers, const SurfaceGrid& grid, parallel::Threads threads) {
    Array2D correlation(grid.nx, grid.ny);
    fourier::inverse_transform_map(
        [&](Index m, fourier::Complex* modes) { std::copy_n(powers.row(m).data(), grid.nx, modes); }, correlation,
        threads);
    return correlation / double(correlation(0, 0));
}

struct Parent {
    Array2D amplitudes;  ///< of the half spectrum, unit variance
    double dropped_share = 0.0;
};

/// The spectrum of the Gaussian heights with this autocorrelation, without its negative modes.
Parent parent_of(Array2D correlation, const TransformCorrelation& transform, parallel::Threads threads) {
    const ParentTable table(transform);
    correlation = correlation.unaryExpr([&](double value) { return table(value); });
    Parent parent{half_spectrum(correlation, threads).real() / static_cast<double>(correlation.size())};
    double kept = 0.0, dropped = std::abs(parent.amplitudes(0, 0));  // the mean is not part of a surface
    parent.amplitudes(0, 0) = 0.0;
    for (Index m = 0; m < parent.amplitudes.rows(); ++m) {
        const auto row = parent.amplitudes.row(m);
        kept += multiplicity(m, correlation.cols()) * row.max(0.0).sum();
        dropped -= multiplicity(m, correlation.cols()) * row.min(0.0).sum();
    }
    parent.amplitudes = (parent.amplitudes.max(0.0) / kept).sqrt();
    parent.dropped_share = dropped / (kept + dropped);
    return parent;
}

void subtract_mean(Array2D& heights) {
    double sum = 0.0;
    Index defined = 0;
    for (Index i = 0; i < heights.size(); ++i) {
        const double height = heights.data()[i];
        if (std::isnan(height)) continue;
        sum += height;
        ++defined;
    }
    if (defined > 0) heights -= sum / static_cast<double>(defined);
}

}  // namespace

topography::HeightMap transformed_heights(const topography::HeightMap& map, const HeightTransform& transform,
                                          double gaussian_rms_height) {
    if (!(gaussian_rms_height > 0.0) || !std::isfinite(gaussian_rms_height))
        throw InvalidArgument(fmt::format("Gaussian heights of rms {} m; expected positive", gaussian_rms_height));
    auto result = map;
    result.heights = map.heights.unaryExpr([&](double height) {
        return std::isnan(height) ? height : gaussian_rms_height * transform(height / gaussian_rms_height);
    });
    subtract_mean(result.heights);
    return result;
}

NonGaussianSurface non_gaussian_surface(const spectra::SpectralDensity& C_iso, const SurfaceGrid& grid,
                                        const HeightTransform& transform, const SurfaceOptions& options) {
    const TransformCorrelation correlation(transform);
    const auto powers = expected_powers(C_iso, grid, options);
    double variance = 0.0;
    for (Index m = 0; m < powers.rows(); ++m) variance += multiplicity(m, grid.ny) * powers.row(m).sum();
    const auto parent = parent_of(autocorrelation(powers, grid, options.threads), correlation, options.threads);

    // the same random numbers as random_surface: a white surface of mean |h_q|² = 1/(nx ny), filtered
    SurfaceOptions white = options;
    white.exact_rms_height.reset();
    white.anisotropy = {};
    auto map = random_surface([](double) { return 1.0; }, grid, white);
    const auto spectrum = half_spectrum(map.heights, options.threads);
    const double scale = std::sqrt(grid.size_x * grid.size_y) / static_cast<double>(map.heights.size());
    fourier::inverse_transform_map(
        [&](Index m, fourier::Complex* modes) {
            for (Index k = 0; k < grid.nx; ++k) modes[k] = scale * parent.amplitudes(m, k) * spectrum(m, k);
        },
        map.heights, options.threads);

    const double rms = std::sqrt(variance);
    map.heights *= rms;
    NonGaussianSurface result{transformed_heights(map, transform, rms), parent.dropped_share};
    if (options.exact_rms_height)
        result.map.heights *= *options.exact_rms_height / std::sqrt(mean_square(result.map.heights));
    return result;
}

}  // namespace setae::synthesis
