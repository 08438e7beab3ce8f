// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <Eigen/LU>
#include <boost/math/quadrature/gauss.hpp>

#include "chebyshev.hpp"
#include "domain.hpp"
#include "setae/contact/layer.hpp"
#include "setae/core/errors.hpp"
#include "setae/platform/processes.hpp"

namespace setae::contact::layer {
namespace {

void require_poisson_ratio(double poisson_ratio) {
    if (!(poisson_ratio > -1.0 && poisson_ratio <= 0.5))
        throw InvalidArgument(fmt::format("poisson ratio must lie in (-1, 0.5], got {}", poisson_ratio));
}

/// Difference of the layer from a half-space at x = qh: 1 − 1/stiffness_ratio. Proportional to 2x² e^(−2x)·4/(3 − 4ν)
/// for large x.
double softening(double x, double poisson_ratio) {
    const double lead = 3.0 - 4.0 * poisson_ratio;
    const double rest = 2.0 * x * x + 8.0 * poisson_ratio * poisson_ratio - 12.0 * poisson_ratio + 5.0;
    return (lead * std::exp(-2.0 * x) + 2.0 * x + rest) / (lead * std::cosh(2.0 * x) + rest);
}

/// Its cosine transform ∫0^∞ softening(x) cos(xy) dx for y in [0, 2·largest_ratio], tabulated.
ChebyshevSeries transformed_softening(double poisson_ratio) {
    constexpr std::size_t points = 64;
    constexpr double upper = 2.0 * Layer::largest_ratio;
    constexpr int panels = 12;
    constexpr double end = 24.0;  // the rest is below 1e-17
    std::vector<double> values(points);
    for (std::size_t i = 0; i < points; ++i) {
        const double y = ChebyshevSeries::point(i, points, upper);
        for (int panel = 0; panel < panels; ++panel)
            values[i] += boost::math::quadrature::gauss<double, 30>::integrate(
                [&](double x) { return softening(x, poisson_ratio) * std::cos(x * y); }, panel * end / panels,
                (panel + 1) * end / panels);
    }
    return {values, upper};
}

/// Nodes and weights of Gauss and Legendre on [0, 1].
struct Rule {
    std::vector<double> nodes, weights;
};

Rule gauss_rule() {
    using Gauss = boost::math::quadrature::gauss<double, 30>;
    Rule rule;
    for (std::size_t i = 0; i < Gauss::abscissa().size(); ++i)
        for (const double sign : {-1.0, 1.0}) {
            rule.nodes.push_back(0.5 + 0.5 * sign * Gauss::abscissa()[i]);
            rule.weights.push_back(0.5 * Gauss::weights()[i]);
        }
    return rule;
}

/// Factors at one α: φ(s) − ∫0^1 K(s, t) φ(t) dt = right side, K = (α/π) [κ(α(s + t)) + κ(α❘s − t❘)], solved by
/// Nyström's method for the right sides 1 (flat punch) and s² (paraboloid). The force is the integral of φ, the
/// singularity of pressure at the edge φ(1).
Factors solved(double ratio, const ChebyshevSeries& kappa, const Rule& rule) {
    const auto kernel = [&](double s, double t) {
        return ratio / pi * (kappa.value(ratio * (s + t)) + kappa.value(ratio * std::abs(s - t)));
    };
    const auto n = static_cast<Index>(rule.nodes.size());
    Eigen::MatrixXd matrix(n, n);
    Eigen::MatrixXd right(n, 2);
    Eigen::RowVectorXd weights(n), at_edge(n);
    for (Index i = 0; i < n; ++i) {
        const double s = rule.nodes[i];
        for (Index j = 0; j < n; ++j) matrix(i, j) = (i == j ? 1.0 : 0.0) - kernel(s, rule.nodes[j]) * rule.weights[j];
        right(i, 0) = 1.0;
        right(i, 1) = s * s;
        weights[i] = rule.weights[i];
        at_edge[i] = kernel(1.0, s) * rule.weights[i];
    }
    const Eigen::MatrixXd phi = matrix.partialPivLu().solve(right);
    const Eigen::RowVector2d integral = weights * phi;
    const Eigen::RowVector2d edge = Eigen::RowVector2d::Ones() + at_edge * phi;
    // without adhesion the edge is regular: δ = (a²/R) edge[1]/edge[0]
    const double flat = edge[1] / edge[0];
    return {.stiffness = integral[0],
            .dry_displacement = flat,
            .dry_force = 1.5 * (flat * integral[0] - integral[1]),
            .edge = edge[0]};
}

constexpr std::array members{&Factors::stiffness, &Factors::dry_displacement, &Factors::dry_force, &Factors::edge};

double checked_ratio(double contact_radius, double thickness) {
    require_not_negative(contact_radius, "contact radius");
    const double ratio = contact_radius / thickness;
    if (ratio > Layer::largest_ratio * (1.0 + 1e-14))
        throw InvalidArgument(
            fmt::format("contact radius {} m is more than {} layer thicknesses of {} m, where the factors of the layer "
                        "end; use a thicker layer or smaller contacts",
                        contact_radius, Layer::largest_ratio, thickness));
    return ratio;
}

}  // namespace

/// Logarithms of the factors over a/h.
struct Layer::Table {
    std::vector<ChebyshevSeries> logarithms;  // in the order of members
};

Layer::Table Layer::table_of(double poisson_ratio) {
    constexpr std::size_t points = 48;
    const ChebyshevSeries kappa = transformed_softening(poisson_ratio);
    const Rule rule = gauss_rule();
    std::array<std::vector<double>, members.size()> values;
    for (std::size_t i = 0; i < points; ++i) {
        const Factors factors = solved(ChebyshevSeries::point(i, points, largest_ratio), kappa, rule);
        for (std::size_t k = 0; k < members.size(); ++k) values[k].push_back(std::log(factors.*members[k]));
    }
    Table table;
    for (const std::vector<double>& series : values) table.logarithms.emplace_back(series, largest_ratio);
    return table;
}

std::shared_ptr<const Layer::Table> Layer::kept_table(double poisson_ratio) {
    constexpr std::size_t max_kept = 64;
    static std::mutex mutex;
    static std::mutex& of_tables = platform::free_in_every_child(mutex);
    static std::map<double, std::shared_ptr<const Table>> kept;
    const std::lock_guard lock(of_tables);
    if (kept.size() >= max_kept && !kept.contains(poisson_ratio)) kept.clear();
    auto& table = kept[poisson_ratio];
    if (!table) table = std::make_shared<const Table>(table_of(poisson_ratio));
    return table;
}

Layer::Layer(double thickness, double poisson_ratio) : thickness_(thickness), poisson_ratio_(poisson_ratio) {
    require_positive(thickness, "layer thickness");
    require_poisson_ratio(poisson_ratio);
    table_ = kept_table(poisson_ratio);
}

Factors Layer::factors(double contact_radius) const {
    const double ratio = checked_ratio(contact_radius, thickness_);
    Factors result;
    for (std::size_t k = 0; k < members.size(); ++k) result.*members[k] = std::exp(table_->logarithms[k].value(ratio));
    return result;
}

Factors Layer::factor_slopes(double contact_radius) const {
    const double ratio = checked_ratio(contact_radius, thickness_);
    Factors result = factors(contact_radius);
    for (std::size_t k = 0; k < members.size(); ++k)
        result.*members[k] *= table_->logarithms[k].derivative(ratio) / thickness_;
    return result;
}

double stiffness_ratio(double x, double poisson_ratio) {
    require_poisson_ratio(poisson_ratio);
    if (!(x > 0.0)) throw InvalidArgument(fmt::format("wavevector times thickness is {}; expected > 0", x));
    constexpr double half_space = 20.0;  // 2x² e^(−2x) is below 1e-14
    if (x > half_space) return 1.0;
    const double lead = 3.0 - 4.0 * poisson_ratio;
    const double rest = 2.0 * x * x + 8.0 * poisson_ratio * poisson_ratio - 12.0 * poisson_ratio + 5.0;
    // sinh(2x) − 2x without cancellation
    const double y = 2.0 * x;
    const double beyond = y < 0.1 ? y * y * y / 6.0 * (1.0 + y * y / 20.0 * (1.0 + y * y / 42.0)) : std::sinh(y) - y;
    return (lead * std::cosh(y) + rest) / ((lead - 1.0) * std::sinh(y) + beyond);
}

}  // namespace setae::contact::layer
