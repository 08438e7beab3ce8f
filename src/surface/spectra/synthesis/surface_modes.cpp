// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/synthesis/surface_modes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/summation.hpp"
#include "setae/numerics/random_blocks.hpp"

namespace setae::synthesis {
namespace {

constexpr Index max_points = Index{1} << 31;

void check(const SurfaceGrid& grid) {
    const bool points = grid.nx >= 2 && grid.ny >= 2 && grid.nx < max_points && grid.ny < max_points;
    const bool extent = grid.size_x > 0.0 && grid.size_y > 0.0 && std::isfinite(grid.size_x * grid.size_y);
    if (!points || !extent)
        throw InvalidArgument(fmt::format(
            "a surface of {} x {} points over {} m x {} m; expected at least 2 x 2 points and positive sizes", grid.nx,
            grid.ny, grid.size_x, grid.size_y));
}

void check(const spectra::Anisotropy& anisotropy) {
    if (!(anisotropy.stretch > 0.0) || !std::isfinite(anisotropy.stretch) || !std::isfinite(anisotropy.angle))
        throw InvalidArgument(
            fmt::format("features stretched {} times along {} rad; expected a positive factor and an angle",
                        anisotropy.stretch, anisotropy.angle));
}

struct QuadraticForm {
    double xx, xy, yy;
};

/// (s q_∥)² + q_⊥² in terms of mode numbers.
QuadraticForm stretched_form(const SurfaceGrid& grid, const spectra::Anisotropy& anisotropy) {
    check(grid);
    check(anisotropy);
    const double unit_x = 2.0 * pi / grid.size_x, unit_y = 2.0 * pi / grid.size_y;
    if (anisotropy.stretch == 1.0) return {unit_x * unit_x, 0.0, unit_y * unit_y};
    const double along = anisotropy.stretch * anisotropy.stretch - 1.0;
    const double cosine = std::cos(anisotropy.angle), sine = std::sin(anisotropy.angle);
    return {unit_x * unit_x * (1.0 + along * cosine * cosine), 2.0 * unit_x * unit_y * along * cosine * sine,
            unit_y * unit_y * (1.0 + along * sine * sine)};
}

/// Range of the stretched q² over all modes except the mean.
AmplitudeTable table_for(const spectra::SpectralDensity& C_iso, const SurfaceGrid& grid,
                         const spectra::Anisotropy& anisotropy) {
    (void)stretched_form(grid, anisotropy);
    const double unit_x = 2.0 * pi / grid.size_x, unit_y = 2.0 * pi / grid.size_y;
    const double half_x = 0.5 * static_cast<double>(grid.nx), half_y = 0.5 * static_cast<double>(grid.ny);
    const double low = std::min(1.0, anisotropy.stretch) * std::min(unit_x, unit_y);
    const double high = std::max(1.0, anisotropy.stretch) * std::hypot(unit_x * half_x, unit_y * half_y);
    // slightly more, for rounding of the quadratic form
    return {C_iso, low * low * (1.0 - 1e-9), high * high * (1.0 + 1e-9)};
}

/// The random block of a mode: its numbers, the one that may be negative folded to 0, −1, 1, −2, … -> 0, 1, 2, 3, …
std::uint64_t block_of(Index kx, Index ky) {
    const std::uint64_t folded = kx >= 0 ? 2 * static_cast<std::uint64_t>(kx) : 2 * static_cast<std::uint64_t>(-kx) - 1;
    return folded << 31 | static_cast<std::uint64_t>(ky);
}

}  // namespace

SurfaceModes::SurfaceModes(const spectra::SpectralDensity& C_iso, const SurfaceGrid& grid,
                           const SurfaceOptions& options)
    : grid_(grid),
      key_(options.key),
      amplitudes_(options.amplitudes),
      table_(table_for(C_iso, grid, options.anisotropy)) {
    const auto form = stretched_form(grid, options.anisotropy);
    xx_ = form.xx;
    xy_ = form.xy;
    yy_ = form.yy;
    factor_ = std::sqrt(options.anisotropy.stretch / (grid.size_x * grid.size_y));
}

double SurfaceModes::stretched_square(Index kx, Index ky) const {
    const double x = static_cast<double>(kx), y = static_cast<double>(ky);
    return x * (xx_ * x + xy_ * y) + yy_ * y * y;
}

double SurfaceModes::amplitude(Index kx, Index ky) const {
    return kx == 0 && ky == 0 ? 0.0 : factor_ * table_(stretched_square(kx, ky));
}

void SurfaceModes::line(Index ky, std::complex<double>* modes) const {
    const Index nx = grid_.nx, drawn = is_own_pair(ky) ? nx / 2 + 1 : nx;
    constexpr Index batch = 512;
    std::array<std::uint64_t, batch> blocks;
    for (Index from = 0; from < drawn; from += batch) {
        const Index count = std::min(batch, drawn - from);
        const auto number = [&](Index i) { return from + i <= nx / 2 ? from + i : from + i - nx; };
        for (Index i = 0; i < count; ++i) blocks[static_cast<std::size_t>(i)] = block_of(number(i), ky);
        if (amplitudes_ == Amplitudes::gaussian) numerics::complex_normals(key_, blocks.data(), modes + from, count);
        else numerics::unit_phases(key_, blocks.data(), modes + from, count);
        // two normal numbers of variance ½ each
        const double share = amplitudes_ == Amplitudes::gaussian ? std::sqrt(0.5) : 1.0;
        for (Index i = 0; i < count; ++i) modes[from + i] *= share * amplitude(number(i), ky);
    }
    if (!is_own_pair(ky)) return;
    for (Index k = 1; k < (nx + 1) / 2; ++k) modes[nx - k] = std::conj(modes[k]);
    // a mode that is its own conjugate is real: one normal number of variance 1, or a sign
    const auto make_real = [&](Index k) {
        modes[k] = amplitudes_ == Amplitudes::gaussian ? std::sqrt(2.0) * modes[k].real()
                                                       : std::copysign(amplitude(k, ky), modes[k].real());
    };
    make_real(0);
    if (nx % 2 == 0) make_real(nx / 2);
}

SurfaceModes::LineSums SurfaceModes::sums(Index ky) const {
    const double unit_x = 2.0 * pi / grid_.size_x, unit_y = 2.0 * pi / grid_.size_y,
                 members = is_own_pair(ky) ? 1.0 : 2.0;
    const double y_square = std::pow(unit_y * static_cast<double>(ky), 2.0);
    Array1D height(grid_.nx), slope(grid_.nx);
    for (Index k = 0; k < grid_.nx; ++k) {
        const Index kx = k <= grid_.nx / 2 ? k : is_own_pair(ky) ? grid_.nx - k : k - grid_.nx;
        height[k] = members * std::pow(amplitude(kx, ky), 2.0);
        slope[k] = height[k] * (std::pow(unit_x * static_cast<double>(kx), 2.0) + y_square);
    }
    return {pairwise_sum(height), pairwise_sum(slope)};
}

}  // namespace setae::synthesis
