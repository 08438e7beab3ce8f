// SPDX-License-Identifier: GPL-3.0-or-later
#include "periodic_patch.hpp"

#include <algorithm>
#include <cmath>

#include <boost/math/quadrature/gauss.hpp>

#include "setae/core/constants.hpp"
#include "setae/fourier/transform.hpp"

namespace setae::synthesis {
namespace {

using Complex = std::complex<double>;

constexpr Index kernel_width = 8;
constexpr double shape = 2.30 * static_cast<double>(kernel_width);  // the source's choice for twice the grid
constexpr std::size_t coefficients = 13;

double kernel(double z) { return std::abs(z) < 1.0 ? std::exp(shape * (std::sqrt((1.0 - z) * (1.0 + z)) - 1.0)) : 0.0; }

/// ∫ kernel(2x/width) cos(2π share x) dx, x in grid steps.
double kernel_transform(double share) {
    constexpr double half = 0.5 * static_cast<double>(kernel_width);
    return 2.0 * boost::math::quadrature::gauss<double, 60>::integrate(
                     [&](double x) { return kernel(x / half) * std::cos(2.0 * pi * share * x); }, 0.0, half);
}

/// The kernel on each of the 8 steps as a polynomial in t in [−½, ½], so that 8 weights are one vector loop.
struct KernelPolynomials {
    std::array<std::array<double, kernel_width>, coefficients> of_power{};

    KernelPolynomials() {
        for (std::size_t s = 0; s < kernel_width; ++s) {
            // Newton's divided differences at Chebyshev points, then powers of t
            std::array<double, coefficients> node{}, divided{}, power{};
            for (std::size_t i = 0; i < coefficients; ++i) {
                node[i] = 0.5 * std::cos(pi * (static_cast<double>(i) + 0.5) / static_cast<double>(coefficients));
                divided[i] = kernel((static_cast<double>(s) - 3.5 - node[i]) / 4.0);
            }
            for (std::size_t order = 1; order < coefficients; ++order)
                for (std::size_t i = coefficients - 1; i >= order; --i)
                    divided[i] = (divided[i] - divided[i - 1]) / (node[i] - node[i - order]);
            for (std::size_t i = coefficients; i-- > 0;) {
                for (std::size_t j = coefficients - 1; j > 0; --j) power[j] = power[j - 1] - node[i] * power[j];
                power[0] = divided[i] - node[i] * power[0];
            }
            for (std::size_t j = 0; j < coefficients; ++j) of_power[j][s] = power[j];
        }
    }
};

/// Weights of the 8 grid points from `first` on for a point at `first` + 3.5 + t.
void kernel_weights(const KernelPolynomials& polynomials, double t, std::array<double, kernel_width>& weights) {
    weights = polynomials.of_power[coefficients - 1];
    for (std::size_t j = coefficients - 1; j-- > 0;)
        for (std::size_t s = 0; s < kernel_width; ++s) weights[s] = weights[s] * t + polynomials.of_power[j][s];
}

const KernelPolynomials& polynomials() {
    static const KernelPolynomials table;
    return table;
}

struct GridPlace {
    Index first;
    double t;
};

/// For u in periods: first of the 8 grid points around it (0 … n − 1, shifted by 4), and its position among them.
GridPlace grid_place(double u, Index points) {
    const double n = static_cast<double>(points);
    const double x = (u - std::floor(u)) * n;
    const auto below = static_cast<Index>(x);
    return {below < points ? below : 0, (below < points ? x - static_cast<double>(below) : 0.0) - 0.5};
}

}  // namespace

PeriodicPatch::PeriodicPatch(const Modes& modes) : values_(static_cast<std::size_t>(stride * stride)) {
    static_assert(width == kernel_width);
    std::array<double, highest_mode + 1> correction{};
    for (Index k = 0; k <= highest_mode; ++k)
        correction[static_cast<std::size_t>(k)] =
            1.0 / kernel_transform(static_cast<double>(k) / static_cast<double>(points));
    const auto corrected = [&](Index k, Index m) {
        return modes(k, m) *
               (correction[static_cast<std::size_t>(k)] * correction[static_cast<std::size_t>(std::abs(m))]);
    };
    const auto wrapped = [](Index k) { return static_cast<std::size_t>(k < 0 ? k + points : k); };

    // lines of fixed k >= 0 along v; the sum over k < 0 is the conjugate of that over k > 0
    const fourier::ComplexTransform transform(points, fourier::ComplexTransform::Sign::plus);
    fourier::Buffer<Complex> lines(static_cast<std::size_t>((highest_mode + 1) * points), Complex{});
    for (Index k = 0; k <= highest_mode; ++k) {
        Complex* line = lines.data() + k * points;
        for (Index m = k == 0 ? 1 : -highest_mode; m <= highest_mode; ++m) line[wrapped(m)] = 2.0 * corrected(k, m);
        transform.apply(line);
    }
    fourier::Buffer<Complex> column(static_cast<std::size_t>(points));
    // grid point i is stored in row i + 3, so the 8 points around step i begin at row i: 3 before, the point, 4 after
    for (Index j = 0; j < stride; ++j) {
        std::fill(column.begin(), column.end(), Complex{});
        const Index v = (j - 3 + points) % points;
        for (Index k = 0; k <= highest_mode; ++k)
            column[static_cast<std::size_t>(k)] = lines[static_cast<std::size_t>(k * points + v)];
        transform.apply(column.data());
        for (Index i = 0; i < stride; ++i)
            values_[static_cast<std::size_t>(i * stride + j)] =
                column[static_cast<std::size_t>((i - 3 + points) % points)].real();
    }
}

void PeriodicPatch::add_at(const double* u, const double* v, double* sums, Index count) const {
    std::array<double, kernel_width> along_u, along_v;
    const auto& table = polynomials();
    for (Index i = 0; i < count; ++i) {
        const auto row = grid_place(u[i], points), column = grid_place(v[i], points);
        kernel_weights(table, row.t, along_u);
        kernel_weights(table, column.t, along_v);
        const double* corner = values_.data() + row.first * stride + column.first;
        std::array<double, kernel_width> across{};
        for (std::size_t r = 0; r < kernel_width; ++r)
            for (std::size_t c = 0; c < kernel_width; ++c)
                across[c] += along_u[r] * corner[static_cast<Index>(r) * stride + static_cast<Index>(c)];
        double sum = 0.0;
        for (std::size_t c = 0; c < kernel_width; ++c) sum += across[c] * along_v[c];
        sums[i] += sum;
    }
}

}  // namespace setae::synthesis
