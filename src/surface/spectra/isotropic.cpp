// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectra/isotropic.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <vector>

#include "checks.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/summation.hpp"
#include "setae/fourier/map_transform.hpp"

namespace setae::spectra {
namespace {

/// Writes line i of the map, minus its mean, times the window.
using LineLoader = std::function<void(Index, double*)>;

LineLoader product_loader(const ArrayView2D& heights, double mean, Window window) {
    return [&heights, mean, along_x = window_values(window, heights.rows()),
            along_y = window_values(window, heights.cols())](Index i, double* values) {
        Eigen::Map<Array1D>(values, heights.cols()) = (heights.row(i).transpose() - mean) * (along_x[i] * along_y);
    };
}

/// 1 + cos(2πr/D) inside the circle of diameter D = min(L_x, L_y) about point (nx/2, ny/2), not yet scaled.
double radial_value(double x, double y, double diameter) {
    const double r = std::hypot(x, y);
    return 2.0 * r < diameter ? 1.0 + std::cos(2.0 * pi * r / diameter) : 0.0;
}

LineLoader radial_loader(const ArrayView2D& heights, const std::array<double, 2>& size, double mean) {
    const Index nx = heights.rows(), ny = heights.cols();
    const double dx = size[0] / static_cast<double>(nx), dy = size[1] / static_cast<double>(ny);
    const double diameter = std::min(size[0], size[1]);
    const Index middle_x = nx / 2, middle_y = ny / 2;
    const auto line = [=](Index i) {
        const double x = static_cast<double>(i - middle_x) * dx;
        return Array1D(Array1D::NullaryExpr(
            ny, [=](Index j) { return radial_value(x, static_cast<double>(j - middle_y) * dy, diameter); }));
    };
    Array1D power(nx);
    for (Index i = 0; i < nx; ++i) power[i] = line(i).square().sum();
    const double scale = std::sqrt(static_cast<double>(nx * ny) / pairwise_sum(power));
    return [&heights, line, mean, scale](Index i, double* values) {
        Eigen::Map<Array1D>(values, heights.cols()) = (heights.row(i).transpose() - mean) * (scale * line(i));
    };
}

/// Mean height, or zero if no trend is removed. Detects undefined heights.
double mean_to_remove(const topography::HeightMap& map, const SpectrumOptions& options) {
    const Index rows = map.heights.rows(), block = fourier::lines_per_block;
    Array1D sums = Array1D::Zero(rows);
    parallel::for_each_index(static_cast<std::size_t>(fourier::block_count(rows)), options.threads, [&](std::size_t b) {
        const Index first = static_cast<Index>(b) * block;
        for (Index i = first; i < std::min(rows, first + block); ++i) {
            sums[i] = map.heights.row(i).sum();
            if (!std::isfinite(sums[i])) require_defined(map.heights.row(i).transpose(), map.metadata);
        }
    });
    return options.trend == topography::Trend::none ? 0.0
                                                    : pairwise_sum(sums) / static_cast<double>(map.heights.size());
}

/// Passes the half spectrum of the detrended, windowed map to `consume`.
void transform(const topography::HeightMap& map, Window window, const SpectrumOptions& options,
               const fourier::BlockConsumer& consume) {
    if (options.trend == topography::Trend::tilt || options.trend == topography::Trend::parabola) {
        SpectrumOptions without_trend = options;
        without_trend.trend = topography::Trend::mean;
        require_defined(Eigen::Map<const Array1D>(map.heights.data(), map.heights.size()), map.metadata);
        return transform(topography::detrended(map, options.trend), window, without_trend, consume);
    }
    const double mean = mean_to_remove(map, options);
    const ArrayView2D heights = map.heights;
    const auto load =
        window == Window::radial_hann ? radial_loader(heights, map.size, mean) : product_loader(heights, mean, window);
    fourier::transform_map(heights.rows(), heights.cols(), load, consume, options.threads);
}

/// |H|² to C2D: pixel area squared over area.
double spectral_factor(const topography::HeightMap& map) {
    const auto pixel = map.pixel_size();
    return pixel[0] * pixel[0] * pixel[1] * pixel[1] / (map.size[0] * map.size[1]);
}

/// Sums of a bin.
struct BinSums {
    Array1D power, wavevector, count;
    explicit BinSums(Index bins) : power(Array1D::Zero(bins)), wavevector(power), count(power) {}
    void add(const BinSums& other) {
        power += other.power;
        wavevector += other.wavevector;
        count += other.count;
    }
};

/// Bins from q_min to q_max and the modes of one map.
class RadialBins {
public:
    RadialBins(const topography::HeightMap& map, const LogGrid& grid, double q_min, double q_max)
        : nx_(map.heights.rows()), ny_(map.heights.cols()), dqx_(2.0 * pi / map.size[0]), dqy_(2.0 * pi / map.size[1]) {
        const Index first = grid.bin_of(q_min), last = grid.bin_of(q_max);
        constexpr double rounding = 1e-12;
        edges_.push_back(q_min * (1.0 - rounding));
        for (Index bin = first + 1; bin <= last; ++bin) edges_.push_back(grid.edge(bin) * (1.0 - rounding));
        edges_.push_back(q_max * (1.0 + rounding));
    }

    [[nodiscard]] Index size() const { return static_cast<Index>(edges_.size()) - 1; }

    /// Adds line m of the spectrum: along it |q| grows with |k|, so the members of a bin are two runs, k and nx − k.
    void add_line(Index m, const fourier::Complex* line, BinSums& sums) const {
        const double qy = static_cast<double>(m) * dqy_;
        const double sides = m == 0 || 2 * m == ny_ ? 1.0 : 2.0;  // lines m and ny − m
        Index begin = first_beyond(edges_[0], qy);
        for (Index bin = 0; bin < size(); ++bin) {
            const Index end = first_beyond(edges_[static_cast<std::size_t>(bin) + 1], qy);
            if (end <= begin) continue;
            sums.power[bin] += sides * (power(line, begin, end) + mirrored_power(line, begin, end));
            for (Index k = begin; k < end; ++k) {
                const double members = sides * (k == 0 || 2 * k == nx_ ? 1.0 : 2.0);
                const double qx = static_cast<double>(k) * dqx_;
                sums.wavevector[bin] += members * std::sqrt(qx * qx + qy * qy);
                sums.count[bin] += members;
            }
            begin = end;
        }
    }

private:
    /// Smallest k >= 0 with |q| >= edge, at most one past the last.
    [[nodiscard]] Index first_beyond(double edge, double qy) const {
        if (edge <= qy) return 0;
        const auto k = static_cast<Index>(std::ceil(std::sqrt(edge * edge - qy * qy) / dqx_));
        return std::min(k, nx_ / 2 + 1);
    }
    static double power(const fourier::Complex* line, Index begin, Index end) {
        return Eigen::Map<const Array1D>(reinterpret_cast<const double*>(line + begin), 2 * (end - begin))
            .square()
            .sum();
    }
    [[nodiscard]] double mirrored_power(const fourier::Complex* line, Index begin, Index end) const {
        const Index first = std::max<Index>(begin, 1), last = std::min(end, (nx_ + 1) / 2);
        return last > first ? power(line, nx_ - last + 1, nx_ - first + 1) : 0.0;
    }

    Index nx_, ny_;
    double dqx_, dqy_;
    std::vector<double> edges_;
};

}  // namespace

MeasuredSpectrum isotropic_power_spectrum(const topography::HeightMap& map, const SpectrumOptions& options,
                                          const LogGrid& grid) {
    require_shape(map);
    const auto window = resolved(options.window, map.periodic);
    const auto reliable = reliable_band(map, options.reliability, options.threads);
    const auto pixel = map.pixel_size();
    const double nyquist = pi / std::max(pixel[0], pixel[1]);
    const RadialBins bins(map, grid, 2.0 * pi / std::max(map.size[0], map.size[1]), nyquist);

    std::vector<BinSums> shares(static_cast<std::size_t>(fourier::block_count(map.heights.cols() / 2 + 1)),
                                BinSums(bins.size()));
    transform(map, window, options, [&](const fourier::SpectrumBlock& block) {
        auto& share = shares[static_cast<std::size_t>(block.index)];
        for (Index m = 0; m < block.lines; ++m) bins.add_line(block.first + m, block.line(m), share);
    });
    BinSums sums(bins.size());
    for (const auto& share : shares) sums.add(share);

    std::vector<Index> filled;
    for (Index bin = 0; bin < bins.size(); ++bin)
        if (sums.count[bin] > 0.0) filled.push_back(bin);
    MeasuredSpectrum spectrum;
    spectrum.kind = Density::C_iso;
    spectrum.count = sums.count(filled);
    spectrum.wavevector = sums.wavevector(filled) / spectrum.count;
    spectrum.density = sums.power(filled) / spectrum.count * spectral_factor(map);
    spectrum.band.lower = reliable.band.lower;
    spectrum.band.upper = std::min(reliable.band.upper, nyquist);
    spectrum.window = name(window);
    spectrum.alerts = reliable.alerts;
    spectrum.metadata = map.metadata;
    return spectrum;
}

double energy_per_modulus_of_modes(const topography::HeightMap& map, const Band& band, const SpectrumOptions& options) {
    require_shape(map);
    const Index nx = map.heights.rows(), ny = map.heights.cols();
    const Array1D qx = Array1D::NullaryExpr(
        nx, [&](Index k) { return 2.0 * pi / map.size[0] * static_cast<double>(std::min(k, nx - k)); });
    std::vector<double> shares(static_cast<std::size_t>(fourier::block_count(ny / 2 + 1)), 0.0);
    transform(map, resolved(options.window, map.periodic), options, [&](const fourier::SpectrumBlock& block) {
        auto& share = shares[static_cast<std::size_t>(block.index)];
        for (Index line = 0; line < block.lines; ++line) {
            const Index m = block.first + line;
            const double sides = m == 0 || 2 * m == ny ? 1.0 : 2.0;  // lines m and ny − m
            const Array1D q = (qx.square() + std::pow(2.0 * pi / map.size[1] * static_cast<double>(m), 2)).sqrt();
            const Array1D power = Eigen::Map<const Eigen::ArrayXcd>(block.line(line), nx).abs2();
            share += sides * (q >= band.lower && q <= band.upper).select(q * power, 0.0).sum();
        }
    });
    const double area = map.size[0] * map.size[1];
    return 0.25 * spectral_factor(map) / area * std::accumulate(shares.begin(), shares.end(), 0.0);
}

Array2D power_spectrum_map(const topography::HeightMap& map, const SpectrumOptions& options) {
    require_shape(map);
    const Index nx = map.heights.rows(), ny = map.heights.cols();
    const double factor = spectral_factor(map);
    Array2D spectrum(nx, ny);
    transform(map, resolved(options.window, map.periodic), options, [&](const fourier::SpectrumBlock& block) {
        for (Index k = 0; k < nx; ++k)
            for (Index line = 0; line < block.lines; ++line) {
                const Index m = block.first + line;
                const double value = std::norm(block.line(line)[k]) * factor;
                spectrum(k, m) = value;
                spectrum((nx - k) % nx, (ny - m) % ny) = value;
            }
    });
    return spectrum;
}

}  // namespace setae::spectra
