// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/synthesis/multiscale.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "octave.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/quantity.hpp"

namespace setae::synthesis {
namespace {

constexpr Index highest_mode = PeriodicPatch::highest_mode;

/// Slopes of the axes of the patches: quadratic irrationals with small continued fractions, which are hardest to
/// approximate by rational numbers, so a line along x, y or a diagonal returns to a place of a patch as late as
/// possible.
constexpr std::array<double, 4> slopes = {0.6180339887498949, 0.41421356237309503, 0.3027756377319946,
                                          0.7320508075688772};

/// Power of the mode cells of one octave in the octant 0 <= m <= k: ∫ C d²q/4π² over the part of the cell in the band.
class CellPowers {
public:
    CellPowers(const spectra::SpectralDensity& C_iso, double spacing, const Band& band)
        : powers_(Array2D::Zero(highest_mode + 1, highest_mode + 1)) {
        constexpr int samples = 4;  // per side of the cell, so a cutoff inside it counts with its share
        const double share = spacing * spacing / (4.0 * pi * pi * samples * samples);
        for (Index k = 0; k <= highest_mode; ++k)
            for (Index m = 0; m <= k; ++m) {
                if (k == 0) continue;
                double sum = 0.0;
                for (int a = 0; a < samples; ++a)
                    for (int b = 0; b < samples; ++b) {
                        const double x = static_cast<double>(k) + (a + 0.5) / samples - 0.5,
                                     y = static_cast<double>(m) + (b + 0.5) / samples - 0.5;
                        const double q = spacing * std::sqrt(x * x + y * y);
                        if (q > band.lower && q <= band.upper) sum += checked(C_iso(q), q);
                    }
                powers_(k, m) = share * sum;
            }
    }

    [[nodiscard]] double operator()(Index k, Index m) const {
        const Index a = std::abs(k), b = std::abs(m);
        return powers_(std::max(a, b), std::min(a, b));
    }

private:
    static double checked(double C, double q) {
        if (!(C >= 0.0) || !std::isfinite(C))
            throw InvalidArgument(fmt::format("C_iso = {} m4 at q = {} 1/m; expected finite and not negative", C, q));
        return C;
    }

    Array2D powers_;
};

/// Modes in the half plane k > 0, or k = 0 and m > 0.
template <class Body>
void for_half_plane(const Body& body) {
    for (Index k = 0; k <= highest_mode; ++k)
        for (Index m = k == 0 ? 1 : -highest_mode; m <= highest_mode; ++m) body(k, m);
}

/// exp(iφ) of a mode from a separate pair of numbers.
std::complex<double> phase(numerics::RandomKey key, Index k, Index m) {
    const auto block = static_cast<std::uint64_t>(k * (2 * highest_mode + 1) + m + highest_mode);
    const double real = numerics::normal_number(key, 2 * block),
                 imaginary = numerics::normal_number(key, 2 * block + 1);
    return std::complex<double>(real, imaginary) / std::sqrt(real * real + imaginary * imaginary);
}

struct MadeOctave {
    std::optional<Octave> octave;  ///< empty if the band has no power
    ScaleMoments moments;
};

/// The octave that ends at q = 2^exponent rad/m. Its numbers depend on that exponent, so other limits of wavelengths do
/// not change it; the last one also includes all longer wavelengths.
MadeOctave make_octave(const spectra::SpectralDensity& C_iso, numerics::RandomKey key, int exponent, const Band& band) {
    const double spacing = std::ldexp(1.0, exponent) / static_cast<double>(highest_mode);
    const CellPowers powers(C_iso, spacing, band);
    MadeOctave made;
    for_half_plane([&](Index k, Index m) {
        const double power = 2.0 * powers(k, m), q_squared = spacing * spacing * static_cast<double>(k * k + m * m);
        made.moments.height += power;
        made.moments.slope += power * q_squared;
    });
    if (made.moments.height == 0.0) return made;
    const auto octave = static_cast<std::uint64_t>(Index{exponent} + 4096);
    const numerics::RandomKey own = numerics::substream(key, octave);
    const auto turn = octave % (2 * slopes.size());
    const double slope = (turn < slopes.size() ? 1.0 : -1.0) * slopes[turn % slopes.size()];
    const double length = std::sqrt(1.0 + slope * slope);
    made.octave.emplace(Octave{1.0 / length, slope / length, 2.0 * pi / spacing, PeriodicPatch([&](Index k, Index m) {
                                   return std::sqrt(powers(k, m)) * phase(own, k, m);
                               })});
    return made;
}

void require_wavelengths(const MultiscaleOptions& options) {
    if (!(options.shortest_wavelength > 0.0 && options.longest_wavelength > options.shortest_wavelength &&
          std::isfinite(options.longest_wavelength)))
        throw InvalidArgument(
            fmt::format("a surface with wavelengths from {} m to {} m; expected 0 < shortest < longest",
                        options.shortest_wavelength, options.longest_wavelength));
}

void require_points(Index nx, Index ny, double step) {
    if (nx < 1 || ny < 1 || !(step > 0.0) || !std::isfinite(step))
        throw InvalidArgument(
            fmt::format("{} x {} points {} m apart; expected at least one point and a distance > 0", nx, ny, step));
}

constexpr Index points_at_once = 512;

}  // namespace

struct MultiscaleSurface::Octaves {
    std::vector<Octave> octaves;
    ScaleMoments moments;

    /// heights[i] = h(x[i], y[i]); the octaves are added in one order.
    void heights_at(const double* x, const double* y, double* heights, Index count) const {
        std::array<double, points_at_once> u, v;
        std::fill_n(heights, count, 0.0);
        for (const auto& octave : octaves) {
            const double cosine = octave.cosine / octave.period, sine = octave.sine / octave.period;
            for (Index i = 0; i < count; ++i) {
                u[static_cast<std::size_t>(i)] = cosine * x[i] + sine * y[i];
                v[static_cast<std::size_t>(i)] = cosine * y[i] - sine * x[i];
            }
            octave.patch.add_at(u.data(), v.data(), heights, count);
        }
    }

    /// The heights of points 0 … count − 1, whose position `place(i, x, y)` writes, in blocks on all threads.
    template <class Place>
    void fill(double* heights, Index count, parallel::Threads threads, const Place& place) const {
        const auto blocks = static_cast<std::size_t>((count + points_at_once - 1) / points_at_once);
        parallel::for_each_index(blocks, threads, [&](std::size_t block) {
            const Index first = static_cast<Index>(block) * points_at_once, n = std::min(points_at_once, count - first);
            std::array<double, points_at_once> x, y;
            for (Index i = 0; i < n; ++i)
                place(first + i, x[static_cast<std::size_t>(i)], y[static_cast<std::size_t>(i)]);
            heights_at(x.data(), y.data(), heights + first, n);
        });
    }
};

MultiscaleSurface::MultiscaleSurface(const spectra::SpectralDensity& C_iso, const MultiscaleOptions& options)
    : threads_(options.threads) {
    require_wavelengths(options);
    const Band band{2.0 * pi / options.longest_wavelength, 2.0 * pi / options.shortest_wavelength};
    const int highest = static_cast<int>(std::ceil(std::log2(band.upper)));
    // the period of the last patch is at least the longest wavelength: its mode 1 is no longer one
    const int lowest =
        std::min(highest, static_cast<int>(std::floor(std::log2(band.lower * static_cast<double>(highest_mode)))));
    std::vector<MadeOctave> made(static_cast<std::size_t>(highest - lowest + 1));
    parallel::for_each_index(made.size(), threads_, [&](std::size_t index) {
        const int exponent = lowest + static_cast<int>(index);
        const Band own{exponent == lowest ? band.lower : std::ldexp(1.0, exponent - 1),
                       std::min(band.upper, std::ldexp(1.0, exponent))};
        made[index] = make_octave(C_iso, options.key, exponent, own);
    });
    auto octaves = std::make_unique<Octaves>();
    for (auto& one : made) {
        octaves->moments.height += one.moments.height;
        octaves->moments.slope += one.moments.slope;
        if (one.octave) octaves->octaves.push_back(std::move(*one.octave));
    }
    if (octaves->octaves.empty())
        throw InvalidArgument(
            fmt::format("C_iso is zero at all wavelengths from {} m to {} m; expected some power between them",
                        options.shortest_wavelength, options.longest_wavelength));
    octaves_ = std::move(octaves);
}

MultiscaleSurface::~MultiscaleSurface() = default;
MultiscaleSurface::MultiscaleSurface(MultiscaleSurface&&) noexcept = default;
MultiscaleSurface& MultiscaleSurface::operator=(MultiscaleSurface&&) noexcept = default;

topography::HeightMap MultiscaleSurface::window(const Window& window) const {
    require_points(window.nx, window.ny, window.pixel_size);
    topography::HeightMap map{
        Array2D(window.nx, window.ny),
        {static_cast<double>(window.nx) * window.pixel_size, static_cast<double>(window.ny) * window.pixel_size}};
    octaves_->fill(map.heights.data(), map.heights.size(), threads_, [&](Index i, double& x, double& y) {
        const Index row = i / window.ny, column = i % window.ny;
        x = window.x + static_cast<double>(row) * window.pixel_size;
        y = window.y + static_cast<double>(column) * window.pixel_size;
    });
    return map;
}

topography::LineScan MultiscaleSurface::line(const LinePath& path) const {
    require_points(path.points, 1, path.step);
    topography::LineScan scan{Array1D(path.points), static_cast<double>(path.points) * path.step};
    const double step_x = path.step * std::cos(path.direction), step_y = path.step * std::sin(path.direction);
    octaves_->fill(scan.heights.data(), path.points, threads_, [&](Index i, double& x, double& y) {
        x = path.x + static_cast<double>(i) * step_x;
        y = path.y + static_cast<double>(i) * step_y;
    });
    return scan;
}

Array1D MultiscaleSurface::heights_at(const ArrayView1D& x, const ArrayView1D& y) const {
    if (x.size() != y.size() || !x.isFinite().all() || !y.isFinite().all())
        throw InvalidArgument(
            fmt::format("{} positions x and {} positions y of a surface; expected as many of both, all finite",
                        x.size(), y.size()));
    Array1D heights(x.size());
    octaves_->fill(heights.data(), x.size(), threads_, [&](Index i, double& at_x, double& at_y) {
        at_x = x[i];
        at_y = y[i];
    });
    return heights;
}

double MultiscaleSurface::rms_height() const { return std::sqrt(octaves_->moments.height); }
double MultiscaleSurface::rms_slope() const { return std::sqrt(octaves_->moments.slope); }

}  // namespace setae::synthesis
