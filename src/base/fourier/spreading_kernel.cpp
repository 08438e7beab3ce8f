// SPDX-License-Identifier: GPL-3.0-or-later
#include "spreading_kernel.hpp"

#include <cmath>

#include "setae/core/constants.hpp"

namespace setae::fourier {
namespace {

constexpr double half_width = 0.5 * static_cast<double>(SpreadingKernel::width);

double shape() {
    constexpr double sigma = SpreadingKernel::oversampling;
    const double stretch = 2.0 * half_width / sigma * (sigma - 0.5);
    return pi * std::sqrt(stretch * stretch - 0.8);
}

/// ψ(z)/ψ(0); entire in z², so it can be sampled slightly outside −1 … 1.
double kernel_value(double z) {
    const double beta = shape(), square = beta * beta * (1.0 - z * z);
    // power series of I0 in (argument/2)², all terms positive for |z| <= 1
    const auto bessel = [](double argument_squared) {
        double term = 1.0, sum = 1.0;
        for (int k = 1; std::abs(term) > 1e-20 * std::abs(sum); ++k) {
            term *= 0.25 * argument_squared / (static_cast<double>(k) * k);
            sum += term;
        }
        return sum;
    };
    return bessel(square) / bessel(beta * beta);
}

}  // namespace

SpreadingKernel::SpreadingKernel() {
    constexpr std::size_t nodes = degree + 1;
    for (std::size_t tap = 0; tap < static_cast<std::size_t>(width); ++tap) {
        std::array<double, nodes> samples;
        for (std::size_t j = 0; j < nodes; ++j) {
            const double t = std::cos(pi * (static_cast<double>(j) + 0.5) / nodes);
            samples[j] = kernel_value((static_cast<double>(tap) + 0.5 * (t + 1.0) - half_width) / half_width);
        }
        // Chebyshev coefficients, then T_p expanded in powers of t
        std::array<double, nodes> powers{}, previous{}, current{};
        previous[0] = 1.0;
        current[1] = 1.0;
        for (std::size_t p = 0; p < nodes; ++p) {
            double coefficient = 0.0;
            for (std::size_t j = 0; j < nodes; ++j)
                coefficient +=
                    samples[j] * std::cos(pi * static_cast<double>(p) * (static_cast<double>(j) + 0.5) / nodes);
            coefficient *= (p == 0 ? 1.0 : 2.0) / nodes;
            const auto& polynomial = p == 0 ? previous : current;
            for (std::size_t k = 0; k <= p; ++k) powers[k] += coefficient * polynomial[k];
            if (p == 0) continue;
            std::array<double, nodes> next{};
            for (std::size_t k = 0; k + 1 < nodes; ++k) next[k + 1] = 2.0 * current[k];
            for (std::size_t k = 0; k < nodes; ++k) next[k] -= previous[k];
            previous = current;
            current = next;
        }
        for (std::size_t p = 0; p < nodes; ++p) coefficients_[p][tap] = powers[p];
    }
}

const SpreadingKernel& SpreadingKernel::instance() {
    static const SpreadingKernel kernel;
    return kernel;
}

SpreadingKernel::Taps SpreadingKernel::at(double position) const {
    const double start = std::ceil(position - half_width);
    const double t = 2.0 * (start - (position - half_width)) - 1.0;
    Taps taps{static_cast<Index>(start), coefficients_[degree]};
    for (std::size_t p = degree; p-- > 0;)
        for (std::size_t i = 0; i < static_cast<std::size_t>(width); ++i)
            taps.values[i] = taps.values[i] * t + coefficients_[p][i];
    return taps;
}

double SpreadingKernel::transform(double k) const {
    const double beta = shape(), xi = k * half_width;
    const double root = std::sqrt(beta * beta - xi * xi);
    // ∫_{−1}^{1} I0(β√(1−z²)) cos ξz dz = 2 sinh(root)/root, over ψ(0) = I0(β)
    static const double centre = std::cyl_bessel_i(0.0, shape());
    return half_width * 2.0 * std::sinh(root) / root / centre;
}

}  // namespace setae::fourier
