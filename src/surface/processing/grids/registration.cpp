// SPDX-License-Identifier: GPL-3.0-or-later
#include "grids/registration.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include <fmt/format.h>
#include <Eigen/Dense>

#include "setae/core/errors.hpp"
#include "setae/fourier/inverse_map_transform.hpp"
#include "setae/fourier/map_transform.hpp"
#include "setae/processing/interpolation.hpp"
#include "setae/topography/detrend.hpp"

namespace setae::processing {
namespace {

using topography::HeightMap;
using Spectrum = Eigen::Array<fourier::Complex, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Points of the finer search; more would need more time without a gain.
constexpr Index max_points = 262144;
constexpr int max_steps = 40;
/// Minimum number of common points of a shift.
constexpr Index min_points = 16;
constexpr std::size_t max_peaks = 8;
/// Convergence of a shift in pixels.
constexpr double settled_shift = 1e-5;
/// Standard deviation [pixels] of the Gaussian that removes noise of single pixels from the phase correlation.
constexpr double blur = 1.0;

void require_alike(const HeightMap& fixed, const HeightMap& moved) {
    const auto a = fixed.pixel_size(), b = moved.pixel_size();
    for (const std::size_t direction : {0u, 1u})
        if (std::abs(a[direction] - b[direction]) > 1e-6 * a[direction])
            throw InvalidArgument(fmt::format(
                "{} has pixels of {} x {} m, {} of {} x {} m; expected equal pixels to find a shift: "
                "resample one of the maps",
                topography::label(fixed.metadata), a[0], a[1], topography::label(moved.metadata), b[0], b[1]));
    if (std::min({fixed.heights.rows(), fixed.heights.cols(), moved.heights.rows(), moved.heights.cols()}) < 8)
        throw InvalidArgument(
            fmt::format("{} and {}: maps of {} x {} and {} x {} points; expected at least 8 along each direction "
                        "to find a shift",
                        topography::label(fixed.metadata), topography::label(moved.metadata), fixed.heights.rows(),
                        fixed.heights.cols(), moved.heights.rows(), moved.heights.cols()));
}

/// Hann's window over n points, or 1 for periodic data.
Array1D window(Index n, bool periodic) {
    if (periodic) return Array1D::Ones(n);
    return 0.5 - 0.5 * ((Array1D::LinSpaced(n, 0.5, static_cast<double>(n) - 0.5)) *
                        (2.0 * std::numbers::pi / static_cast<double>(n)))
                           .cos();
}

/// Half spectrum of a map minus its plane, windowed, padded to the grid.
Spectrum spectrum_of(const HeightMap& map, Index nx, Index ny, parallel::Threads threads) {
    const Array1D along_x = window(map.heights.rows(), map.periodic),
                  along_y = window(map.heights.cols(), map.periodic);
    Spectrum spectrum(ny / 2 + 1, nx);
    fourier::transform_map(
        nx, ny,
        [&](Index i, double* line) {
            std::fill(line, line + ny, 0.0);
            if (i >= map.heights.rows()) return;
            for (Index j = 0; j < map.heights.cols(); ++j)
                if (const double height = map.heights(i, j); !std::isnan(height))
                    line[j] = along_x[i] * along_y[j] * height;
        },
        [&](const fourier::SpectrumBlock& block) {
            for (Index m = 0; m < block.lines; ++m) std::copy_n(block.line(m), nx, &spectrum(block.first + m, 0));
        },
        threads);
    return spectrum;
}

struct PixelShift {
    double x, y;
};

/// The whole-pixel shifts at the peaks of the phase correlation, highest first; periodic patterns have many.
std::vector<PixelShift> phase_peaks(const HeightMap& fixed, const HeightMap& moved, parallel::Threads threads) {
    const Index nx = std::max(fixed.heights.rows(), moved.heights.rows()),
                ny = std::max(fixed.heights.cols(), moved.heights.cols());
    Spectrum product = spectrum_of(moved, nx, ny, threads);
    const Spectrum other = spectrum_of(fixed, nx, ny, threads);
    double largest = 0.0;
    for (Index m = 0; m < product.rows(); ++m)
        for (Index k = 0; k < nx; ++k) {
            product(m, k) *= std::conj(other(m, k));
            largest = std::max(largest, std::abs(product(m, k)));
        }
    if (!(largest > 0.0))
        throw UndefinedDataError(
            fmt::format("{} and {}: at least one of the maps is flat, so that no shift can be found",
                        topography::label(fixed.metadata), topography::label(moved.metadata)));
    for (Index m = 0; m < product.rows(); ++m)
        for (Index k = 0; k < nx; ++k) {
            const double qx = 2.0 * std::numbers::pi * static_cast<double>(std::min(k, nx - k)) /
                              static_cast<double>(nx),
                         qy = 2.0 * std::numbers::pi * static_cast<double>(m) / static_cast<double>(ny);
            const double size = std::abs(product(m, k));
            product(m, k) *= size > 1e-14 * largest ? std::exp(-0.5 * blur * blur * (qx * qx + qy * qy)) / size : 0.0;
        }
    Array2D correlation(nx, ny);
    fourier::inverse_transform_map([&](Index m, fourier::Complex* modes) { std::copy_n(&product(m, 0), nx, modes); },
                                   correlation, threads);
    std::vector<PixelShift> peaks;
    for (const double highest = correlation.maxCoeff(); peaks.size() < max_peaks;) {
        Index i = 0, j = 0;
        if (correlation.maxCoeff(&i, &j) < 0.7 * highest) break;
        peaks.push_back({static_cast<double>(2 * i > nx ? i - nx : i), static_cast<double>(2 * j > ny ? j - ny : j)});
        for (Index k = -2; k <= 2; ++k)
            for (Index m = -2; m <= 2; ++m) correlation((i + k + nx) % nx, (j + m + ny) % ny) = -highest;
    }
    return peaks;
}

/// fixed(x) − moved(x + d) − plane over the common points: input of Gauss–Newton. The plane is needed because each map
/// was levelled over its own area.
struct Comparison {
    double square = 0.0;                             ///< mean of the squares after subtraction of the best plane
    double agreement = 0.0;                          ///< 1 − square/variance of the fixed heights
    Eigen::Vector2d step = Eigen::Vector2d::Zero();  ///< [pixels]
    Index points = 0;
};

Comparison compare(const HeightMap& fixed, const HeightMap& moved, const BicubicInterpolator& height,
                   const PixelShift& shift) {
    const Index nx = fixed.heights.rows(), ny = fixed.heights.cols();
    const auto stride =
        static_cast<Index>(std::ceil(std::sqrt(static_cast<double>(nx * ny) / static_cast<double>(max_points))));
    const auto pixel = moved.pixel_size();
    using Vector = Eigen::Matrix<double, 5, 1>;  // shift along x and y; constant, slopes of the plane
    Eigen::Matrix<double, 5, 5> normal = Eigen::Matrix<double, 5, 5>::Zero();
    Vector right = Vector::Zero();
    double sum = 0.0, heights_squared = 0.0, squares = 0.0;
    Comparison result;
    for (Index i = 0; i < nx; i += stride)
        for (Index j = 0; j < ny; j += stride) {
            const double here = fixed.heights(i, j);
            if (std::isnan(here)) continue;
            const SurfacePoint there =
                height.at((static_cast<double>(i) + shift.x) * pixel[0], (static_cast<double>(j) + shift.y) * pixel[1]);
            if (std::isnan(there.height)) continue;
            Vector change;
            change << there.slope_x * pixel[0], there.slope_y * pixel[1], 1.0,
                static_cast<double>(2 * i - nx) / static_cast<double>(nx),
                static_cast<double>(2 * j - ny) / static_cast<double>(ny);
            normal += change * change.transpose();
            right += (here - there.height) * change;
            squares += (here - there.height) * (here - there.height);
            sum += here;
            heights_squared += here * here;
            ++result.points;
        }
    if (result.points < min_points) return result;
    const auto n = static_cast<double>(result.points);
    const Eigen::Vector3d plane = normal.bottomRightCorner<3, 3>().ldlt().solve(right.tail<3>());
    result.square = (squares - plane.dot(right.tail<3>())) / n;
    const double variance = heights_squared / n - sum * sum / (n * n);
    result.agreement = variance > 0.0 ? 1.0 - result.square / variance : 0.0;
    result.step = normal.ldlt().solve(right).head<2>();
    return result;
}

struct Refined {
    PixelShift shift;
    Comparison comparison;
};

/// Gauss–Newton from a whole-pixel shift.
Refined refined(const HeightMap& fixed, const HeightMap& moved, const BicubicInterpolator& height, PixelShift shift) {
    Comparison here = compare(fixed, moved, height, shift);
    for (int step = 0; step < max_steps && here.points >= min_points && here.step.allFinite(); ++step) {
        // no step beyond half a pixel: slopes are valid only nearby
        const double length = here.step.norm();
        Eigen::Vector2d next = length > 0.5 ? Eigen::Vector2d(here.step * (0.5 / length)) : here.step;
        Comparison there;
        for (;;) {
            there = compare(fixed, moved, height, {shift.x + next[0], shift.y + next[1]});
            if ((there.points >= min_points && there.square <= here.square) || next.norm() < settled_shift) break;
            next *= 0.5;
        }
        if (there.points < min_points || there.square > here.square) break;
        shift = {shift.x + next[0], shift.y + next[1]};
        here = there;
        if (next.norm() < settled_shift) break;
    }
    return {shift, here};
}

}  // namespace

Shift shift_between(const HeightMap& fixed, const HeightMap& moved, parallel::Threads threads) {
    require_alike(fixed, moved);
    const auto trend = [](const HeightMap& map) {
        return map.periodic ? topography::Trend::mean : topography::Trend::tilt;
    };
    const HeightMap level_fixed = topography::detrended(fixed, trend(fixed)),
                    level_moved = topography::detrended(moved, trend(moved));
    const std::vector<PixelShift> peaks = phase_peaks(level_fixed, level_moved, threads);
    const BicubicInterpolator height(level_moved, threads);
    std::vector<Refined> found(peaks.size());
    parallel::for_each_index(peaks.size(), threads,
                             [&](std::size_t k) { found[k] = refined(level_fixed, level_moved, height, peaks[k]); });
    const auto best = std::max_element(found.begin(), found.end(), [](const Refined& a, const Refined& b) {
        return a.comparison.agreement < b.comparison.agreement;
    });
    const auto pixel = fixed.pixel_size();
    return {best->shift.x * pixel[0], best->shift.y * pixel[1], best->comparison.agreement};
}

}  // namespace setae::processing
