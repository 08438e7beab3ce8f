// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/topography/detrend.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include <fmt/format.h>
#include <Eigen/Dense>

#include "map_trend.hpp"
#include "setae/core/errors.hpp"

namespace setae::topography {
namespace {

constexpr std::array<std::pair<Trend, const char*>, 4> trend_names{
    {{Trend::none, "none"}, {Trend::mean, "mean"}, {Trend::tilt, "tilt"}, {Trend::parabola, "parabola"}}};

int polynomial_order(Trend trend) { return trend == Trend::parabola ? 2 : trend == Trend::tilt ? 1 : 0; }

/// Normal equations G c = b of a least-squares fit, solved in the well-conditioned centred coordinates of the callers.
Eigen::VectorXd solve(const Eigen::MatrixXd& gram, const Eigen::VectorXd& moments) {
    return gram.ldlt().solve(moments);
}

[[noreturn]] void too_few(Index defined, Index needed) {
    throw UndefinedDataError(
        fmt::format("{} defined heights, a trend with {} coefficients needs more", defined, needed));
}

double centred(Index i, Index n) {
    return n > 1 ? 2.0 * static_cast<double>(i) / static_cast<double>(n - 1) - 1.0 : 0.0;
}

/// Removes a polynomial of the given order from equidistant samples. Returns false where too few are defined.
template <class Line>
bool remove_polynomial(Line&& heights, int order) {
    const auto n = heights.size();
    const Index terms = order + 1;
    Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(terms, terms);
    Eigen::VectorXd moments = Eigen::VectorXd::Zero(terms);
    Eigen::VectorXd basis(terms);
    const auto fill_basis = [&](Index i) {
        const double t = centred(i, n);
        basis[0] = 1.0;
        for (Index k = 1; k < terms; ++k) basis[k] = basis[k - 1] * t;
    };
    // the first defined height as origin, so that a large offset costs no digits
    double origin = 0.0;
    for (Index i = 0; i < n; ++i)
        if (heights[i] == heights[i]) {
            origin = heights[i];
            break;
        }
    Index defined = 0;
    for (Index i = 0; i < n; ++i) {
        if (heights[i] != heights[i]) continue;
        fill_basis(i);
        gram.noalias() += basis * basis.transpose();
        moments += (heights[i] - origin) * basis;
        ++defined;
    }
    if (defined < terms) return false;
    const Eigen::VectorXd coefficients = solve(gram, moments);
    for (Index i = 0; i < n; ++i) {
        fill_basis(i);
        heights[i] = (heights[i] - origin) - coefficients.dot(basis);
    }
    return true;
}

}  // namespace

HeightMap detrended(HeightMap map, Trend trend, parallel::Threads threads) {
    if (trend == Trend::none) return map;
    MapTrendFit fit(trend, map.heights.rows(), map.heights.cols());
    fit.add(map.heights, 0, threads);
    fit.solved().subtract_from(map.heights, 0, threads);
    return map;
}

TiledMap detrended(TiledMap map, Trend trend, Index lines_together, parallel::Threads threads) {
    if (trend == Trend::none) return map;
    MapTrendFit fit(trend, map.nx, map.ny);
    for (Index first = 0; first < map.ny; first += lines_together)
        fit.add(map.lines(first, std::min(lines_together, map.ny - first)), first, threads);
    map.lines = [lines = std::move(map.lines), removed = fit.solved(), threads](Index first, Index count) {
        auto band = lines(first, count);
        removed.subtract_from(band, first, threads);
        return band;
    };
    return map;
}

LineScan detrended(LineScan scan, Trend trend) {
    if (trend == Trend::none) return scan;
    const int order = polynomial_order(trend);
    if (!remove_polynomial(scan.heights, order)) too_few((scan.heights == scan.heights).count(), order + 1);
    return scan;
}

Profile detrended(Profile profile, Trend trend) {
    if (trend == Trend::none) return profile;
    const Index terms = polynomial_order(trend) + 1;
    const auto n = profile.positions.size();
    if (n < terms || n < 2) too_few(n, terms);
    const double middle = 0.5 * (profile.positions[0] + profile.positions[n - 1]);
    const double half = 0.5 * profile.size();
    const Array1D t = (profile.positions - middle) / half;
    const double origin = profile.heights[0];
    const Array1D h = profile.heights - origin;
    // three Gauss points integrate cubic × quadratic on each segment exactly
    constexpr std::array<double, 3> node{-0.77459666924148337704, 0.0, 0.77459666924148337704};
    constexpr std::array<double, 3> weight{5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0};
    Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(terms, terms);
    Eigen::VectorXd rhs = Eigen::VectorXd::Zero(terms);
    Eigen::VectorXd basis(terms);
    const auto fill_basis = [&](double s) {
        basis[0] = 1.0;
        for (Index k = 1; k < terms; ++k) basis[k] = basis[k - 1] * s;
    };
    for (Index i = 0; i + 1 < n; ++i)
        for (std::size_t g = 0; g < node.size(); ++g) {
            const double s = 0.5 * (1.0 + node[g]);
            fill_basis(t[i] + s * (t[i + 1] - t[i]));
            const double w = weight[g] * (t[i + 1] - t[i]);
            gram.noalias() += w * basis * basis.transpose();
            rhs += w * (h[i] + s * (h[i + 1] - h[i])) * basis;
        }
    const Eigen::VectorXd coefficients = solve(gram, rhs);
    for (Index i = 0; i < n; ++i) {
        fill_basis(t[i]);
        profile.heights[i] = h[i] - coefficients.dot(basis);
    }
    return profile;
}

Measurement detrended(Measurement measurement, Trend trend, parallel::Threads threads) {
    if (auto* map = std::get_if<HeightMap>(&measurement)) return detrended(std::move(*map), trend, threads);
    if (auto* scan = std::get_if<LineScan>(&measurement)) return detrended(std::move(*scan), trend);
    return detrended(std::get<Profile>(std::move(measurement)), trend);
}

Trend trend_from_name(const std::string& name) {
    for (const auto& [trend, known] : trend_names)
        if (name == known) return trend;
    throw InvalidArgument(fmt::format("'{}' is not a trend; expected none, mean, tilt or parabola", name));
}

std::string name(Trend trend) {
    for (const auto& [known, text] : trend_names)
        if (known == trend) return text;
    throw InternalError("trend without a name");
}

}  // namespace setae::topography
