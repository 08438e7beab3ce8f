// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <optional>

#include "setae/core/summation.hpp"
#include "setae/half_space/hard_wall.hpp"

namespace setae::half_space {
namespace {

/// Of the residual; what is asked for, Σ s, is then twice as exact in digits.
constexpr double stiffness_tolerance = 1e-6;
constexpr Index most_iterations = 500;

double sum_of_products(const Array2D& a, const Array2D& b) {
    Array1D rows(a.rows());
    for (Index i = 0; i < a.rows(); ++i) rows[i] = pairwise_sum((a.row(i) * b.row(i)).transpose());
    return pairwise_sum(rows);
}

/// y = a filter's answer to x, on the set alone.
void apply_on_set(ElasticOperator& elastic, const fourier::Multiplier& multiplier, const Array2D& set, const Array2D& x,
                  Array2D& y) {
    elastic.apply(
        multiplier, [&](Index i, double* line) { Eigen::Map<Array1D>(line, x.cols()) = x.row(i).transpose(); },
        [&](Index i, const double* line) {
            y.row(i) = Eigen::Map<const Array1D>(line, x.cols()).transpose() * set.row(i);
        });
}

}  // namespace

double contact_stiffness(const HardWall& problem, const HardWallContact& contact, parallel::Threads threads) {
    require_shape(contact.pressures, problem.grid, "pressures");
    ElasticOperator response(problem.grid, problem.body, problem.edges, threads);
    std::optional<ElasticOperator> unpadded;
    if (problem.edges != Edges::periodic) unpadded.emplace(problem.grid, problem.body, Edges::periodic, threads);
    ElasticOperator& preconditioner = unpadded ? *unpadded : response;
    const double hardness = problem.hardness.value_or(std::numeric_limits<double>::infinity());
    const Array2D set = (contact.pressures > 0.0 && contact.pressures < hardness).cast<double>();
    const double points = set.sum();
    if (points == 0.0) return 0.0;
    if (points == static_cast<double>(set.size()) && response.mean_displacement() != MeanDisplacement::finite)
        return std::numeric_limits<double>::infinity();
    const double least = preconditioner.least_stiffness();
    const auto stiffness =
        preconditioner.multiplier([least](double k) { return k > 0.0 && std::isfinite(k) ? k : least; });

    // conjugate gradients for G s = 1 on the set
    Array2D r = set, z(set.rows(), set.cols()), t, s = Array2D::Zero(set.rows(), set.cols());
    double last = 0.0;
    for (Index iteration = 0; iteration < most_iterations; ++iteration) {
        apply_on_set(preconditioner, stiffness, set, r, z);
        const double product = sum_of_products(r, z);
        if (iteration == 0) t = z;
        else t = z + product / last * t;
        last = product;
        apply_on_set(response, response.compliance(), set, t, z);
        const double step = product / sum_of_products(t, z);
        s += step * t;
        r -= step * z;
        if (sum_of_products(r, r) <= stiffness_tolerance * stiffness_tolerance * points) break;
    }
    return sum_of_products(s, set) / static_cast<double>(set.size());
}

}  // namespace setae::half_space
