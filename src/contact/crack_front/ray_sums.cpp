// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "map_modes.hpp"
#include "setae/core/constants.hpp"
#include "setae/fourier/buffer.hpp"
#include "setae/fourier/fast_length.hpp"
#include "setae/fourier/transform.hpp"

namespace setae::crack_front {
namespace {

/// Kernel exp(β(√(1−z²) − 1)), z = 2u/width, of grids `oversampling` times finer than needed: error about 3e-6.
/// Source: Barnett, Magland, af Klinteberg, SIAM J. Sci. Comput. 41 (2019) C479.
class RayKernel {
public:
    static constexpr std::size_t width = 6;
    static constexpr double oversampling = 4.0;

    static const RayKernel& instance() {
        static const RayKernel kernel;
        return kernel;
    }

    /// Kernel at the `width` grid points about a position, t in [−1, 1] twice its distance from the middle of the gap.
    /// Taps on either side are mirrored: f(t) and f(−t) are E(t²) ± t O(t²).
    void taps(double t, std::array<double, width>& values) const {
        std::array<double, half> even = even_[terms - 1], odd = odd_[terms - 1];
        const double square = t * t;
        for (std::size_t p = terms - 1; p-- > 0;)
            for (std::size_t i = 0; i < half; ++i) {
                even[i] = even[i] * square + even_[p][i];
                odd[i] = odd[i] * square + odd_[p][i];
            }
        for (std::size_t i = 0; i < half; ++i) {
            values[i] = even[i] + t * odd[i];
            values[width - 1 - i] = even[i] - t * odd[i];
        }
    }

    /// ∫ kernel exp(−iku) du, u in grid steps.
    [[nodiscard]] static double transform(double k) {
        constexpr int points = 200;  // midpoints of u = (width/2) sin φ: the kernel is smooth in φ
        double sum = 0.0;
        for (int n = 0; n < points; ++n) {
            const double phase = pi * ((n + 0.5) / points - 0.5);
            sum += std::cos(phase) * std::exp(beta * (std::cos(phase) - 1.0)) * std::cos(k * reach * std::sin(phase));
        }
        return sum * reach * pi / points;
    }

private:
    static constexpr std::size_t half = width / 2, terms = 7;
    static constexpr double reach = 0.5 * static_cast<double>(width);
    static constexpr double beta = 0.97 * pi * width * (1.0 - 0.5 / oversampling);

    static double value(double z) { return std::exp(beta * (std::sqrt(std::max(1.0 - z * z, 0.0)) - 1.0)); }

    /// Polynomials through Chebyshev's nodes.
    RayKernel() {
        constexpr std::size_t nodes = 2 * terms;
        for (std::size_t i = 0; i < half; ++i) {
            std::array<double, nodes> before{1.0}, here{0.0, 1.0};  // Chebyshev's polynomials, one after the other
            for (std::size_t c = 0; c < nodes; ++c) {
                const double share = coefficient(i, c);
                for (std::size_t p = 0; p < nodes; ++p) (p % 2 == 0 ? even_ : odd_)[p / 2][i] += share * before[p];
                std::array<double, nodes> next{};
                for (std::size_t p = 0; p + 1 < nodes; ++p) next[p + 1] = 2.0 * here[p];
                for (std::size_t p = 0; p < nodes; ++p) next[p] -= before[p];
                before = here;
                here = next;
            }
        }
    }

    /// Coefficient of Chebyshev's polynomial c in tap i, which is i + 1 − width/2 steps right of the grid point before
    /// the position.
    [[nodiscard]] static double coefficient(std::size_t i, std::size_t c) {
        constexpr int nodes = 2 * terms;
        double sum = 0.0;
        for (int n = 0; n < nodes; ++n) {
            const double phase = pi * (n + 0.5) / nodes;
            const double u = static_cast<double>(i) + 1.0 - reach - 0.5 * (1.0 + std::cos(phase));
            sum += value(u / reach) * std::cos(static_cast<double>(c) * phase);
        }
        return sum * (c == 0 ? 1.0 : 2.0) / nodes;
    }

    std::array<std::array<double, half>, terms> even_{}, odd_{};
};

}  // namespace

RaySums::RaySums(const MapModes& modes, Factor factor, const LinePoints& radii)
    : modes_(modes),
      factor_(factor),
      radii_(radii),
      back_(2 * fourier::fast_length(
                    static_cast<Index>(std::ceil(RayKernel::oversampling * static_cast<double>(radii.count))))),
      step_(2.0 * pi / (static_cast<double>(back_.points()) * radii.spacing)) {
    for (Index k = 0; k < radii.count; ++k)
        correction_.push_back(1.0 / RayKernel::transform(step_ * static_cast<double>(k) * radii.spacing));
    for (std::size_t m = 0; m < modes.count(); ++m) {
        const std::complex<double> c(modes.real[m], modes.imaginary[m]);
        const auto half = factor == Factor::none ? std::complex<double>(1.0)
                                                 : std::polar(std::sqrt(std::hypot(modes.qx[m], modes.qy[m])),
                                                              0.5 * std::atan2(modes.qy[m], modes.qx[m]));
        minus_.push_back(c * std::conj(half));
        plus_.push_back(c * half);
    }
}

void RaySums::along(double angle, double* values, double* opposite) const {
    using Complex = fourier::Complex;
    const double cosine = std::cos(angle), sine = std::sin(angle);
    // √(|q_z| + i q_x) = √q exp(i(π/4 − |ψ|/2)), ψ the angle of q against the ray folded into (−π, π]; of the opposite
    // ray it is the conjugate
    const bool front = factor_ == Factor::front;
    const Complex minus = front ? std::polar(1.0, 0.25 * pi + 0.5 * angle) : Complex(1.0);
    const Complex plus = front ? std::polar(1.0, 0.25 * pi - 0.5 * angle) : Complex(1.0);
    const auto modes = static_cast<std::size_t>(back_.modes());
    fourier::Buffer<Complex> grid(modes, Complex{}), opposite_grid(modes, Complex{});
    const auto& kernel = RayKernel::instance();
    std::array<double, RayKernel::width> taps{};
    for (std::size_t m = 0; m < modes_.count(); ++m) {
        const double q_along = modes_.qx[m] * cosine + modes_.qy[m] * sine;
        const double q_across = modes_.qy[m] * cosine - modes_.qx[m] * sine;
        const bool left = q_across > 0.0;
        Complex value = left ? minus * minus_[m] : plus * plus_[m];
        // c √(|q_z| − i q_x) exp(−i r q·n), conjugate
        Complex other = left ? std::conj(std::conj(minus) * plus_[m]) : std::conj(std::conj(plus) * minus_[m]);
        if (radii_.first != 0.0) {
            const auto shift = std::polar(1.0, q_along * radii_.first);
            value *= shift;
            other *= shift;
        }
        // sums are real: a mode at −p is the conjugate one at p
        if (q_along < 0.0) {
            value = std::conj(value);
            other = std::conj(other);
        }
        const double place = std::abs(q_along) / step_;
        const double below = std::floor(place);
        kernel.taps(2.0 * (place - below) - 1.0, taps);
        const Index first = static_cast<Index>(below) + 1 - static_cast<Index>(RayKernel::width / 2);
        for (std::size_t i = 0; i < RayKernel::width; ++i) {
            const Index l = first + static_cast<Index>(i);
            const auto place_of = static_cast<std::size_t>(std::abs(l));
            const double mirrored = l < 0 ? -taps[i] : taps[i];
            grid[place_of] += Complex(taps[i] * value.real(), mirrored * value.imag());
            opposite_grid[place_of] += Complex(taps[i] * other.real(), mirrored * other.imag());
        }
    }
    transformed(grid, values);
    transformed(opposite_grid, opposite);
}

void RaySums::transformed(fourier::Buffer<fourier::Complex>& grid, double* values) const {
    grid[0] *= 2.0;
    fourier::Buffer<double> line(static_cast<std::size_t>(back_.points()));
    back_.apply(grid.data(), line.data());
    for (Index k = 0; k < radii_.count; ++k)
        values[k] = line[static_cast<std::size_t>(k)] * correction_[static_cast<std::size_t>(k)];
}

}  // namespace setae::crack_front
