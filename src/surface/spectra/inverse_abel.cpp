// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectra/inverse_abel.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <Eigen/SparseCore>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/beta.hpp>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/numerics/dense.hpp"

namespace setae::spectra {
namespace {

using Sparse = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Values and slopes of ln C1D over ln q at the wavevectors, as linear functions of the given logarithms.
struct LocalFits {
    Sparse value, slope;
};

/// The parabola around each point. half_width 0: through the point.
LocalFits local_fits(const Array1D& x, const Array1D& relative_error, double half_width) {
    const Index n = x.size();
    std::vector<Eigen::Triplet<double>> values, slopes;
    for (Index i = 0; i < n; ++i) {
        Index first = std::clamp<Index>(i - 1, 0, n - 3), last = first + 2;
        if (half_width > 0.0) {
            while (first > 0 && x[i] - x[first - 1] < half_width) --first;
            while (last + 1 < n && x[last + 1] - x[i] < half_width) ++last;
            // a parabola through three points smooths nothing
            if (last - first < 3) (first > 0 ? --first : ++last);
        }
        const Index count = last - first + 1;
        const double reach = 1.01 * std::max({half_width, x[i] - x[first], x[last] - x[i]});
        // at the ends of noisy data a line: the slope of a parabola at its end is dominated by noise
        const bool straight = half_width > 0.0 && (i - first < 2 || last - i < 2);
        Eigen::MatrixXd design(count, straight ? 2 : 3);
        Eigen::VectorXd weight(count);
        for (Index k = 0; k < count; ++k) {
            const double d = x[first + k] - x[i], t = std::abs(d) / reach;
            design(k, 0) = 1.0;
            design(k, 1) = d;
            if (!straight) design(k, 2) = d * d;
            weight[k] = half_width > 0.0 ? std::pow(1.0 - t * t * t, 3) / std::pow(relative_error[first + k], 2) : 1.0;
        }
        const Eigen::MatrixXd weighted = weight.asDiagonal() * design;
        const Eigen::MatrixXd solution = numerics::solved_symmetric(numerics::transposed_product(design, weighted),
                                                                    Eigen::MatrixXd(weighted.transpose()));
        for (Index k = 0; k < count; ++k) {
            if (half_width > 0.0) values.emplace_back(i, first + k, solution(0, k));
            slopes.emplace_back(i, first + k, solution(1, k));
        }
        if (half_width == 0.0) values.emplace_back(i, i, 1.0);
    }
    LocalFits fits{Sparse(n, n), Sparse(n, n)};
    fits.value.setFromTriplets(values.begin(), values.end());
    fits.slope.setFromTriplets(slopes.begin(), slopes.end());
    return fits;
}

/// A cubic between two points and the dependence of value and slope on those at its ends, at t in 0 … 1.
struct Hermite {
    double values[4], slopes[4];  ///< factors of left value, left slope, right value, right slope
};

Hermite hermite(double t, double width) {
    const double u = 1.0 - t;
    return {{(1.0 + 2.0 * t) * u * u, width * t * u * u, t * t * (3.0 - 2.0 * t), -width * t * t * u},
            {-6.0 * t * u / width, u * (1.0 - 3.0 * t), 6.0 * t * u / width, t * (3.0 * t - 2.0)}};
}

/// ∫_0^θ (sin/sin θ)^α: contribution of a power law beyond the last wavevector.
double tail_integral(double sine, double alpha) {
    return 0.5 * boost::math::beta(0.5 * (alpha + 1.0), 0.5, std::min(1.0, sine * sine)) * std::pow(sine, -alpha);
}

/// C_iso at one wavevector and its derivatives by values and slopes of ln C1D at all of them.
struct Transformed {
    double C_iso = 0.0;
    Eigen::VectorXd by_value, by_slope;
};

Transformed transformed(Index at, const Array1D& q, const Array1D& x, const Eigen::VectorXd& y,
                        const Eigen::VectorXd& s) {
    const Index n = q.size();
    Transformed result{0.0, Eigen::VectorXd::Zero(n), Eigen::VectorXd::Zero(n)};
    const double factor = 2.0 / q[at];
    using Rule = boost::math::quadrature::gauss<double, 8>;
    const auto& abscissa = Rule::abscissa();
    const auto& weights = Rule::weights();
    for (Index k = at; k + 1 < n; ++k) {
        const double upper = std::asin(std::min(1.0, q[at] / q[k])), lower = std::asin(q[at] / q[k + 1]),
                     width = x[k + 1] - x[k];
        const double half = 0.5 * (upper - lower), middle = 0.5 * (upper + lower);
        for (std::size_t g = 0; g < 2 * abscissa.size(); ++g) {
            const double node = g < abscissa.size() ? abscissa[g] : -abscissa[g - abscissa.size()];
            const double weight = factor * half * weights[g % abscissa.size()];
            const double place = std::log(q[at] / std::sin(middle + half * node));
            const auto h = hermite(std::clamp((place - x[k]) / width, 0.0, 1.0), width);
            const double log_C =
                h.values[0] * y[k] + h.values[1] * s[k] + h.values[2] * y[k + 1] + h.values[3] * s[k + 1];
            const double alpha =
                -(h.slopes[0] * y[k] + h.slopes[1] * s[k] + h.slopes[2] * y[k + 1] + h.slopes[3] * s[k + 1]);
            const double part = weight * std::exp(log_C);
            result.C_iso += part * alpha;
            result.by_value[k] += part * (alpha * h.values[0] - h.slopes[0]);
            result.by_slope[k] += part * (alpha * h.values[1] - h.slopes[1]);
            result.by_value[k + 1] += part * (alpha * h.values[2] - h.slopes[2]);
            result.by_slope[k + 1] += part * (alpha * h.values[3] - h.slopes[3]);
        }
    }
    const double alpha = -s[n - 1], sine = q[at] / q[n - 1];
    if (!(alpha > 0.0)) return result;
    constexpr double step = 1e-5;
    const auto tail = [&](double exponent) {
        return factor * std::exp(y[n - 1]) * exponent * tail_integral(sine, exponent);
    };
    result.C_iso += tail(alpha);
    result.by_value[n - 1] += tail(alpha);
    result.by_slope[n - 1] -=
        (tail(alpha + step) - tail(alpha - step * std::min(1.0, alpha))) / (step + step * std::min(1.0, alpha));
    return result;
}

void check(const ArrayView1D& q, const ArrayView1D& C1D, const ArrayView1D& standard_error,
           const InverseAbelOptions& options) {
    if (q.size() < 4 || C1D.size() != q.size() || (standard_error.size() != 0 && standard_error.size() != q.size()))
        throw InvalidArgument(
            fmt::format("{} wavevectors, {} values of C1D, {} standard errors; expected at least four, and one of each",
                        q.size(), C1D.size(), standard_error.size()));
    for (Index k = 0; k < q.size(); ++k)
        if (!(q[k] > 0.0 && std::isfinite(q[k]) && C1D[k] > 0.0 && std::isfinite(C1D[k])) ||
            (k > 0 && !(q[k] > q[k - 1])) || (standard_error.size() > 0 && !(standard_error[k] >= 0.0)))
            throw InvalidArgument(fmt::format(
                "row {}: C1D = {} m3 at {} 1/m; expected increasing wavevectors, positive values and errors >= "
                "0",
                k, C1D[k], q[k]));
    if (!(options.smoothing >= 0.0 && std::isfinite(options.smoothing)))
        throw InvalidArgument(fmt::format("smoothing over {} decades; expected 0 or more", options.smoothing));
}

}  // namespace

IsotropicFromLines isotropic_from_lines(const ArrayView1D& wavevector, const ArrayView1D& C1D,
                                        const ArrayView1D& standard_error, const InverseAbelOptions& options) {
    check(wavevector, C1D, standard_error, options);
    const Index n = wavevector.size();
    const Array1D q = wavevector, x = q.log();
    const bool known = standard_error.size() > 0;
    const Array1D relative = known ? Array1D(standard_error / C1D) : Array1D::Ones(n);
    const double largest = relative.maxCoeff();
    // a point without error would determine the fit alone
    const auto fits = local_fits(x, largest > 0.0 ? relative.max(0.01 * largest).eval() : Array1D::Ones(n).eval(),
                                 0.5 * options.smoothing * std::log(10.0));
    const Eigen::VectorXd data = C1D.log().matrix(), y = fits.value * data, s = fits.slope * data;
    IsotropicFromLines result;
    result.wavevector = q;
    result.density.resize(n);
    result.standard_error.resize(n);
    result.band = {q[0], q[n - 1]};
    result.kind = Density::C_iso;
    for (Index k = 0; k < n; ++k) {
        const auto t = transformed(k, q, x, y, s);
        result.density[k] = t.C_iso > 0.0 ? t.C_iso : undefined;
        const Eigen::VectorXd by_data = fits.value.transpose() * t.by_value + fits.slope.transpose() * t.by_slope;
        result.standard_error[k] =
            known && t.C_iso > 0.0 ? std::sqrt((by_data.array() * relative).square().sum()) : undefined;
    }
    result.ratio = result.density * q / (pi * C1D);
    return result;
}

IsotropicFromLines isotropic_from_lines(const CombinedSpectrum& spectrum, const InverseAbelOptions& options) {
    const Index n = spectrum.wavevector.size();
    Array1D errors = spectrum.standard_error;
    if (!(errors > 0.0).any()) return isotropic_from_lines(spectrum.wavevector, spectrum.density, Array1D(), options);
    for (Index k = 0; k < n; ++k) {
        if (spectrum.standard_error[k] > 0.0) continue;
        for (Index away = 1; away < n; ++away) {
            const Index below = k - away, above = k + away;
            const Index nearest = below >= 0 && spectrum.standard_error[below] > 0.0  ? below
                                  : above < n && spectrum.standard_error[above] > 0.0 ? above
                                                                                      : -1;
            if (nearest < 0) continue;
            errors[k] = spectrum.density[k] * spectrum.standard_error[nearest] / spectrum.density[nearest] *
                        std::sqrt(spectrum.count[nearest] / spectrum.count[k]);
            break;
        }
    }
    return isotropic_from_lines(spectrum.wavevector, spectrum.density, errors, options);
}

}  // namespace setae::spectra
