// SPDX-License-Identifier: GPL-3.0-or-later
#include "contour_kernel.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "natural_spline.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/fourier/buffer.hpp"
#include "setae/fourier/transform.hpp"
#include "setae/numerics/random_numbers.hpp"
#include "setae/spectral_fit/hat_node.hpp"
#include "setae/topography/trace_response.hpp"

namespace setae::spectral_fit {
namespace {

using fourier::Buffer;
using fourier::Complex;

constexpr Index grid_points_per_step = 4;

/// The operator A of one contour.
class Operator {
public:
    explicit Operator(const Array1D& positions)
        : positions_(positions - positions[0]),
          length_(positions_[positions_.size() - 1]),
          grid_(grid_points_per_step * (positions.size() - 1)),
          spline_(positions_, grid_positions()),
          transform_(grid_) {
        const Array1D x = grid_positions();
        window_ =
            std::sqrt(2.0 / 3.0) * (1.0 - (x * (2.0 * pi / length_)).cos()) * (length_ / static_cast<double>(grid_));
        const Array1D centred = positions_ - positions_.mean();
        tilt_ = centred / std::sqrt(centred.square().sum());
    }

    [[nodiscard]] double length() const { return length_; }
    [[nodiscard]] Index modes() const { return (positions_.size() - 1) / 2; }
    [[nodiscard]] const Array1D& positions() const { return positions_; }

    /// A (real + i imaginary): element k is its transform at mode k, element n_f − k that at −k.
    [[nodiscard]] Buffer<Complex> transformed(Array1D real, Array1D imaginary) const {
        detrend(real);
        detrend(imaginary);
        const Array1D re = spline_(real), im = spline_(imaginary);
        Buffer<Complex> z(static_cast<std::size_t>(grid_));
        for (Index g = 0; g < grid_; ++g) z[static_cast<std::size_t>(g)] = Complex(re[g], im[g]) * window_[g];
        transform_.apply(z.data());
        return z;
    }

    /// |A (real + i imaginary)|² at k = 1 … modes, plus that at −k.
    [[nodiscard]] Array1D power(Array1D real, Array1D imaginary) const {
        const auto z = transformed(std::move(real), std::move(imaginary));
        Array1D result(modes());
        for (Index k = 1; k <= modes(); ++k)
            result[k - 1] =
                std::norm(z[static_cast<std::size_t>(k)]) + std::norm(z[static_cast<std::size_t>(grid_ - k)]);
        return result;
    }

    /// Effect of a wave e^{iqx} on modes 1 … modes: column 0 directly, column 1 by its mirror image e^{−iqx}.
    [[nodiscard]] Eigen::Matrix<Complex, Eigen::Dynamic, 2> answer(double wavevector) const {
        const Array1D phase = positions_ * wavevector;
        const auto z = transformed(phase.cos(), phase.sin());
        Eigen::Matrix<Complex, Eigen::Dynamic, 2> result(modes(), 2);
        for (Index k = 1; k <= modes(); ++k) {
            result(k - 1, 0) = z[static_cast<std::size_t>(k)];
            result(k - 1, 1) = std::conj(z[static_cast<std::size_t>(grid_ - k)]);
        }
        return result;
    }

private:
    [[nodiscard]] Array1D grid_positions() const {
        return Array1D::LinSpaced(grid_, 0.0, static_cast<double>(grid_ - 1)) * (length_ / static_cast<double>(grid_));
    }
    void detrend(Array1D& values) const {
        values -= values.mean();
        values -= (values * tilt_).sum() * tilt_;
    }

    Array1D positions_;
    double length_;
    Index grid_;
    NaturalSpline spline_;
    fourier::ComplexTransform transform_;
    Array1D window_, tilt_;
};

/// Wavevectors at which |A e^{iqx}|² is evaluated: dense where the contour resolves, logarithmic beyond.
Array1D integration_grid(double length, double mean_step, double shortest) {
    std::vector<double> q{0.0};
    const double step = 2.0 * pi / (4.0 * length), dense_end = std::min(shortest, 2.0 * pi / mean_step);
    for (const double part : {0.125, 0.25, 0.5}) q.push_back(part * step);
    constexpr double steps_each = 2048.0;
    for (double g = 1.0; g * step < dense_end * (1.0 - 1e-9);
         g = g < steps_each ? g + 1.0 : g * (1.0 + 1.0 / steps_each))
        q.push_back(g * step);
    constexpr double growth = 1.018;
    for (double next = dense_end; next < shortest * (1.0 - 1e-9); next *= growth) q.push_back(next);
    q.push_back(shortest);
    return Eigen::Map<const Array1D>(q.data(), static_cast<Index>(q.size()));
}

/// Integrals of C1D of one node over 0 … q, tabulated, because those of hat_node are too slow for a matrix.
class LineIntegralTable {
public:
    explicit LineIntegralTable(hat_node::LineIntegrals (*exact)(double)) : entries_(count + 3) {
        for (std::size_t i = 0; i < entries_.size(); ++i) entries_[i] = exact(step * static_cast<double>(i));
        const auto [zeroth, first] = exact(small);
        level_ = zeroth / small;
        curvature_ = 4.0 * (first / (small * small) - 0.5 * level_) / (small * small);
    }
    /// Below `small` C1D = level + curvature q²; above its reach the whole integral.
    [[nodiscard]] hat_node::LineIntegrals operator()(double q) const {
        if (q < small)
            return {q * (level_ + curvature_ * q * q / 3.0), q * q * (0.5 * level_ + 0.25 * curvature_ * q * q)};
        const double place = q / step;
        if (place >= static_cast<double>(count)) return entries_[count];
        const auto i = static_cast<std::size_t>(place);
        const double t = place - static_cast<double>(i), t1 = t - 1.0, t2 = t - 2.0, tp = t + 1.0;
        const double w[] = {-t * t1 * t2 / 6.0, tp * t1 * t2 / 2.0, -tp * t * t2 / 2.0, tp * t * t1 / 6.0};
        hat_node::LineIntegrals sum;
        for (std::size_t m = 0; m < 4; ++m) {
            sum.zeroth += w[m] * entries_[i + m - 1].zeroth;
            sum.first += w[m] * entries_[i + m - 1].first;
        }
        return sum;
    }

private:
    static constexpr double step = 5e-4, small = 0.02;
    static constexpr std::size_t count = 2130;  // beyond e^h = 1.0593
    std::vector<hat_node::LineIntegrals> entries_;
    double level_, curvature_;
};

/// Integrals of C1D of q_i times the triangle functions of the grid: E[P] = Σ_g power(q_g) weight(g, i).
Array2D quadrature(const Array1D& grid, const ArrayView1D& nodes) {
    static const LineIntegralTable whole(hat_node::line_integrals), lower(hat_node::line_integrals_of_lower_half);
    const Index last = nodes.size() - 1;
    Array2D weights = Array2D::Zero(grid.size(), nodes.size());
    for (Index i = 0; i <= last; ++i) {
        const double q_i = nodes[i], square = q_i * q_i;
        const auto integrals = [&](double q) {
            auto value = i == last ? lower(q / q_i) : whole(q / q_i);
            if (i == 0) {  // constant below the first node instead of its lower half
                const auto half = lower(q / q_i), disc = hat_node::line_integrals_of_disc(q / q_i);
                value.zeroth += disc.zeroth - half.zeroth;
                value.first += disc.first - half.first;
            }
            return hat_node::LineIntegrals{value.zeroth * square, value.first * square * q_i};
        };
        auto before = integrals(grid[0]);
        for (Index g = 0; g + 1 < grid.size() && grid[g] < 1.06 * q_i; ++g) {
            const auto after = integrals(grid[g + 1]);
            const double zeroth = after.zeroth - before.zeroth, first = after.first - before.first;
            const double right = (first - grid[g] * zeroth) / (grid[g + 1] - grid[g]);
            weights(g + 1, i) += right;
            weights(g, i) += zeroth - right;
            before = after;
        }
    }
    return weights;
}

/// Standard deviation of the noise of each point before smoothing [m].
Array1D noise_amplitude(const topography::Profile& contour) {
    const auto n = contour.positions.size();
    const auto& x = contour.positions;
    const Array1D share = Array1D::NullaryExpr(
        n, [&](Index k) { return 0.5 * (x[std::min(k + 1, n - 1)] - x[std::max<Index>(k - 1, 0)]); });
    const bool known = contour.standard_error.size() > 0 && contour.standard_error.maxCoeff() > 0.0;
    const Array1D shape = known ? contour.standard_error : Array1D::Ones(n);
    return shape * std::sqrt(contour.response->noise_density * contour.size() / (shape * share).square().sum());
}

/// E[P] of the noise of a trace: the rule of 2n equal steps over the circle, exact for white noise.
Array1D expected_noise(const Operator& transform, const topography::Profile& contour, const ModeBins& bins,
                       parallel::Threads threads) {
    const auto n = contour.positions.size();
    const Array1D amplitude = noise_amplitude(contour), count = Array1D::LinSpaced(n, 0.0, static_cast<double>(n - 1));
    const Array1D angle = Array1D::LinSpaced(n + 1, 0.0, pi);
    Array1D weight = topography::smoothing_transfer(*contour.response, angle / contour.response->step).square() *
                     (pi / static_cast<double>(n));
    weight[0] *= 0.5;
    weight[n] *= 0.5;
    Array2D power(bins.size(), n + 1);
    parallel::for_each_index(static_cast<std::size_t>(n + 1), threads, [&](std::size_t i) {
        const Array1D phase = count * angle[static_cast<Index>(i)];
        power.col(static_cast<Index>(i)) =
            bins.means(transform.power(amplitude * phase.cos(), amplitude * phase.sin()));
    });
    return (power.matrix() * weight.matrix()).array() / (2.0 * pi * transform.length());
}

/// Power of each wave of the grid from C1D and from the noise of a trace: ∫ C1D dq around it.
Array1D power_of_waves(const topography::Profile& contour, const Array1D& grid, const ArrayView1D& nodes,
                       const ArrayView1D& C_iso) {
    Array1D power = (quadrature(grid, nodes).matrix() * C_iso.matrix()).array().max(0.0);
    if (!contour.response) return power;
    const double end = pi / contour.response->step;
    const Array1D noise =
        topography::smoothing_transfer(*contour.response, grid).square() * contour.response->noise_density;
    power *= topography::trace_transfer(*contour.response, grid).square();
    for (Index g = 0; g + 1 < grid.size() && grid[g] < end; ++g) {
        const double half = 0.5 * (std::min(grid[g + 1], end) - grid[g]);
        power[g] += half * noise[g];
        power[g + 1] += half * noise[g + 1];
    }
    return power;
}

void require_points(const topography::Profile& contour) {
    topography::validate(contour);
    if (contour.positions.size() < 8)
        throw InvalidArgument(fmt::format("contour '{}' has {} points; expected at least 8",
                                          topography::label(contour.metadata), contour.positions.size()));
    if (!std::isfinite(contour.heights.sum()))
        throw UndefinedDataError(
            fmt::format("contour '{}' has undefined heights; clean it first", topography::label(contour.metadata)));
}

Array1D periodogram_by(const Operator& transform, const Array1D& heights) {
    // a real curve has the same power at k and −k
    return ModeBins(transform.modes()).means(transform.power(heights, Array1D::Zero(heights.size()))) /
           (2.0 * transform.length());
}

}  // namespace

Array1D contour_periodogram(const topography::Profile& contour) {
    require_points(contour);
    return periodogram_by(Operator(contour.positions), contour.heights);
}

ContourKernel contour_kernel(const topography::Profile& contour, const ArrayView1D& nodes, parallel::Threads threads) {
    require_points(contour);
    const Operator transform(contour.positions);
    const double length = transform.length(), mean_step = length / static_cast<double>(contour.positions.size() - 1);
    ContourKernel kernel{ModeBins(transform.modes()), length, periodogram_by(transform, contour.heights), {}, {}};
    const Array1D grid = integration_grid(length, mean_step, nodes[nodes.size() - 1]);
    Array2D power(kernel.bins.size(), grid.size());
    parallel::for_each_index(static_cast<std::size_t>(grid.size()), threads, [&](std::size_t g) {
        const Array1D phase = transform.positions() * grid[static_cast<Index>(g)];
        power.col(static_cast<Index>(g)) = kernel.bins.means(transform.power(phase.cos(), phase.sin()));
    });
    if (contour.response) {
        power.rowwise() *= topography::trace_transfer(*contour.response, grid).square().transpose();
        kernel.noise = expected_noise(transform, contour, kernel.bins, threads);
    }
    kernel.response = (power.matrix() * quadrature(grid, nodes).matrix()).array() / (2.0 * pi * length);
    return kernel;
}

Array1D white_noise(const topography::Profile& contour, parallel::Threads threads) {
    require_points(contour);
    const Operator transform(contour.positions);
    const ModeBins bins(transform.modes());
    const Index n = contour.positions.size();
    constexpr Index pairs = 256;  // one draw in the real part, another in the imaginary part
    Array2D power(bins.size(), pairs);
    parallel::for_each_index(static_cast<std::size_t>(pairs), threads, [&](std::size_t pair) {
        const numerics::RandomKey key{0, pair};
        const auto own = static_cast<std::uint64_t>(n);
        power.col(static_cast<Index>(pair)) =
            bins.means(transform.power(numerics::normal_numbers(key, 0, n), numerics::normal_numbers(key, own, n)));
    });
    return power.rowwise().mean() / (4.0 * transform.length());
}

Array1D independent_share(const topography::Profile& contour, const ArrayView1D& nodes, const ArrayView1D& C_iso,
                          parallel::Threads threads) {
    require_points(contour);
    const Operator transform(contour.positions);
    const ModeBins bins(transform.modes());
    const Array1D grid =
        integration_grid(transform.length(), transform.length() / static_cast<double>(contour.positions.size() - 1),
                         nodes[nodes.size() - 1]);
    const Array1D power = power_of_waves(contour, grid, nodes, C_iso);
    // amplitudes of each wave and of its mirror image at every mode, and at the mode in the middle of each group
    Eigen::MatrixXcd forth(transform.modes(), grid.size()), back(transform.modes(), grid.size());
    parallel::for_each_index(static_cast<std::size_t>(grid.size()), threads, [&](std::size_t g) {
        const auto column = static_cast<Index>(g);
        const auto answer = transform.answer(grid[column]);
        forth.col(column) = answer.col(0) * std::sqrt(power[column]);
        back.col(column) = answer.col(1) * std::sqrt(power[column]);
    });
    const Array1D variance = (forth.rowwise().squaredNorm() + back.rowwise().squaredNorm()).array();
    Array1D share(bins.size());
    constexpr Index block = 16;  // groups whose covariances with all modes are computed by one matrix product
    parallel::for_each_index(
        static_cast<std::size_t>((bins.size() + block - 1) / block), threads, [&](std::size_t task) {
            const Index first = static_cast<Index>(task) * block, count = std::min(block, bins.size() - first);
            const auto mode = [&](Index g) { return static_cast<Index>(bins.centre(first + g)) - 1; };
            Eigen::MatrixXcd forth_there(count, grid.size()), back_there(count, grid.size());
            for (Index g = 0; g < count; ++g) {
                forth_there.row(g) = forth.row(mode(g));
                back_there.row(g) = back.row(mode(g));
            }
            const Eigen::MatrixXcd covariance = forth * forth_there.adjoint() + back * back_there.adjoint();
            const Eigen::MatrixXcd pseudo = forth * back_there.transpose() + back * forth_there.transpose();
            for (Index g = 0; g < count; ++g)
                share[first + g] =
                    variance[mode(g)] /
                    ((covariance.col(g).cwiseAbs2() + pseudo.col(g).cwiseAbs2()).array() / variance).sum();
        });
    return share;
}

}  // namespace setae::spectral_fit
