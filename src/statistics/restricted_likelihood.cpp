// SPDX-License-Identifier: GPL-3.0-or-later
#include "restricted_likelihood.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

#include "jet.hpp"
#include "setae/core/errors.hpp"
#include "setae/numerics/dense.hpp"

namespace setae::statistics {
namespace {

/// ln det V, 1ᵀV⁻¹1, 1ᵀV⁻¹y and yᵀV⁻¹y of a group of rows.
struct GroupSums {
    Jet log_determinant, weight, weighted, square;

    GroupSums& operator+=(const GroupSums& other) {
        log_determinant += other.log_determinant;
        weight += other.weight;
        weighted += other.weighted;
        square += other.square;
        return *this;
    }
};

/// Of one row: V = v.
GroupSums of_row(double value, const Jet& variance) {
    const Jet weight = reciprocal(variance);
    return {log(variance), weight, value * weight, value * value * weight};
}

/// V + θ 11ᵀ by Sherman and Morrison.
GroupSums with_common(const GroupSums& sums, const Jet& theta) {
    const Jet grown = Jet{.value = 1.0} + theta * sums.weight;
    const Jet shrink = reciprocal(grown);
    return {sums.log_determinant + log(grown), sums.weight * shrink, sums.weighted * shrink,
            sums.square + -1.0 * (theta * sums.weighted * sums.weighted * shrink)};
}

/// ln L_R of a design. `value`: deviations from the surfaces' plain means, so that little cancels.
Jet log_likelihood(const NestedDesign& design, const Array1D& value, const std::vector<Jet>& theta) {
    const std::size_t depth = std::max<std::size_t>(theta.size(), 1);
    // open[k]: rows of the group that stands open at level k − 1; 0 is the surface
    std::vector<GroupSums> open(depth);
    Jet total;
    const auto n = static_cast<std::size_t>(design.size());
    for (std::size_t i = 0; i < n; ++i) {
        const auto row = static_cast<Index>(i);
        const Jet known{.value = design.known_variance[row]};
        open.back() += of_row(value[row], theta.empty() ? known : known + theta.back());
        for (std::size_t k = depth - 1; k-- > 0;) {
            if (i + 1 < n && design.levels[k].group[i + 1] == design.levels[k].group[i]) break;
            open[k] += with_common(open[k + 1], theta[k]);
            open[k + 1] = {};
        }
        if (i + 1 < n && design.surface[i + 1] == design.surface[i]) continue;
        const auto& surface = open[0];
        const Jet residual = surface.square + -1.0 * (surface.weighted * surface.weighted * reciprocal(surface.weight));
        total += -0.5 * (surface.log_determinant + log(surface.weight) + residual);
        open[0] = {};
    }
    return total;
}

/// A design in units of its own scatter.
struct Scaled {
    NestedDesign design;
    Array1D value;  ///< deviations
    double scale = 1.0;
    double offset = 0.0;          ///< ln L_R of the design less that of the scaled one
    bool without_errors = false;  ///< some row has no variance of its own
};

Scaled scaled_design(const NestedDesign& design) {
    Scaled scaled{.design = design, .value = design.value};
    const auto n = static_cast<std::size_t>(design.size());
    for (std::size_t first = 0; first < n;) {
        auto last = first;
        while (last < n && design.surface[last] == design.surface[first]) ++last;
        auto part = scaled.value.segment(static_cast<Index>(first), static_cast<Index>(last - first));
        part -= part.mean();
        first = last;
    }
    const auto contrasts = static_cast<double>(n - design.surfaces.size());
    const double square = scaled.value.square().sum() / std::max(1.0, contrasts) + design.known_variance.mean();
    if (square > 0.0) scaled.scale = std::sqrt(square);
    scaled.value /= scaled.scale;
    scaled.design.known_variance /= scaled.scale * scaled.scale;
    scaled.offset = -contrasts * std::log(scaled.scale);
    scaled.without_errors = (design.known_variance == 0.0).any();
    return scaled;
}

constexpr double lowest = -27.6;  ///< ln of the least variance that is not 0, 1e-12 of the scatter
constexpr double nearly_zero = -16.0;
constexpr double highest = 14.0;

struct Climb {
    Array1D x;
    double log_likelihood = -HUGE_VAL;
    bool converged = false;
};

/// Damped Newton steps in x = ln θ of the free levels, the others at 0.
Climb climb(const Scaled& scaled, const std::vector<std::size_t>& free, Array1D x) {
    const auto m = static_cast<Index>(free.size());
    const auto value_at = [&](const Array1D& at) {
        std::vector<Jet> theta(scaled.design.levels.size());
        for (std::size_t i = 0; i < free.size(); ++i)
            theta[free[i]] = exponential_of_variable(at[static_cast<Index>(i)], i);
        return log_likelihood(scaled.design, scaled.value, theta);
    };
    Jet here = value_at(x);
    if (m == 0) return {x, here.value, true};
    constexpr int most_steps = 200;
    for (int step = 0; step < most_steps; ++step) {
        Eigen::MatrixXd hessian(m, m);
        Eigen::VectorXd gradient(m);
        for (Index i = 0; i < m; ++i) {
            gradient[i] = here.first[static_cast<std::size_t>(i)];
            for (Index j = 0; j < m; ++j)
                hessian(i, j) = here.second[Jet::at(static_cast<std::size_t>(i), static_cast<std::size_t>(j))];
        }
        const numerics::SymmetricEigen eigen = numerics::symmetric_eigen(hessian);
        const Eigen::VectorXd along = eigen.vectors.transpose() * gradient;
        const Eigen::VectorXd curvature = eigen.values.cwiseAbs().cwiseMax(1e-10);
        Eigen::VectorXd move = eigen.vectors * along.cwiseQuotient(curvature);
        const double gain = gradient.dot(move);
        if (gain < 1e-18) return {x, here.value, true};
        constexpr double longest = 3.0;
        if (const double length = move.cwiseAbs().maxCoeff(); length > longest) move *= longest / length;
        double share = 1.0;
        bool better = false;
        for (; share > 1e-6 && !better; share *= 0.5) {
            const Array1D next = (x + share * move.array()).max(lowest).min(highest);
            const Jet there = value_at(next);
            better = there.value > here.value;
            if (better) {
                x = next;
                here = there;
            }
        }
        // at a bound, or as high as rounding tells
        if (!better) return {x, here.value, gain < 1e-7 || (x <= lowest).any()};
    }
    return {x, here.value, false};
}

/// Starts of m levels: alike, and each larger than the others in turn.
std::vector<Array1D> starts_of(std::size_t m) {
    const auto count = static_cast<Index>(m);
    std::vector<Array1D> starts{Array1D::Constant(count, -std::log(static_cast<double>(std::max<std::size_t>(m, 1))))};
    if (m > 1)
        for (Index i = 0; i < count; ++i) {
            Array1D start = Array1D::Constant(count, -4.0);
            start[i] = 0.0;
            starts.push_back(std::move(start));
        }
    return starts;
}

}  // namespace

double log_restricted_likelihood(const NestedDesign& design, const Array1D& variances) {
    auto scaled = scaled_design(design);
    std::vector<Jet> theta;
    for (const double variance : variances) theta.push_back({.value = variance / (scaled.scale * scaled.scale)});
    return log_likelihood(scaled.design, scaled.value, theta).value + scaled.offset;
}

LikelihoodMaximum maximise_restricted_likelihood(const NestedDesign& design) {
    const std::size_t levels = design.levels.size();
    LikelihoodMaximum best{.variances = Array1D::Zero(static_cast<Index>(levels)), .log_likelihood = undefined};
    const auto scaled = scaled_design(design);
    if (levels == 0 || (scaled.value.abs().maxCoeff() == 0.0 && scaled.without_errors)) return best;
    double highest_likelihood = -HUGE_VAL;
    bool at_an_end = false;
    const auto try_set = [&](const std::vector<std::size_t>& free) {
        for (const auto& start : starts_of(free.size())) {
            const auto top = climb(scaled, free, start);
            if (!(top.log_likelihood > highest_likelihood + 1e-9)) continue;
            highest_likelihood = top.log_likelihood;
            at_an_end = top.x.size() > 0 && top.x.minCoeff() < nearly_zero;
            best.variances.setZero();
            for (std::size_t i = 0; i < free.size(); ++i)
                best.variances[static_cast<Index>(free[i])] =
                    std::exp(top.x[static_cast<Index>(i)]) * scaled.scale * scaled.scale;
            best.log_likelihood = top.log_likelihood + scaled.offset;
            best.converged = top.converged;
        }
    };
    std::vector<std::vector<std::size_t>> sets;
    for (unsigned bits = 0; bits < (1U << levels); ++bits) {
        std::vector<std::size_t> free;
        for (std::size_t k = 0; k < levels; ++k)
            if ((bits >> k) & 1U) free.push_back(k);
        // without errors of their own rows need the variance of repeats
        if (!scaled.without_errors || (!free.empty() && free.back() == levels - 1)) sets.push_back(std::move(free));
    }
    std::stable_sort(sets.begin(), sets.end(), [](const auto& a, const auto& b) { return a.size() < b.size(); });
    try_set(sets.back());
    if (!at_an_end) return best;
    // some level belongs at 0: of sets that reach the same likelihood, the one with most levels there
    highest_likelihood = -HUGE_VAL;
    for (const auto& free : sets) try_set(free);
    return best;
}

DesignInformation information_of(const NestedDesign& design, const Array1D& variances) {
    const auto levels = static_cast<Index>(design.levels.size());
    DesignInformation result;
    // in units that keep squares of small numbers apart from 0
    const double unit = variances.sum() + design.known_variance.mean();
    if (!(unit > 0.0)) throw InternalError("a mixed model without any variance");
    Eigen::MatrixXd information = Eigen::MatrixXd::Zero(levels, levels);
    const auto n = static_cast<std::size_t>(design.size());
    for (std::size_t first = 0; first < n;) {
        auto last = first;
        while (last < n && design.surface[last] == design.surface[first]) ++last;
        const auto size = static_cast<Index>(last - first);
        std::vector<Eigen::MatrixXd> indicators;  // Z of each level
        Eigen::MatrixXd V =
            (design.known_variance.segment(static_cast<Index>(first), size) / unit).matrix().asDiagonal();
        for (Index k = 0; k < levels; ++k) {
            const auto& group = design.levels[static_cast<std::size_t>(k)].group;
            Eigen::MatrixXd Z = Eigen::MatrixXd::Zero(size, group[last - 1] - group[first] + 1);
            for (Index i = 0; i < size; ++i) Z(i, group[first + static_cast<std::size_t>(i)] - group[first]) = 1.0;
            V += variances[k] / unit * (Z * Z.transpose());
            indicators.push_back(std::move(Z));
        }
        const auto found = numerics::inverse_positive_definite(V);
        if (!found) throw InternalError("the covariance of replicates cannot be inverted");
        const Eigen::MatrixXd& inverse = *found;
        const Eigen::VectorXd column = inverse.rowwise().sum();
        const double weight = column.sum();
        const Eigen::VectorXd value = design.value.segment(static_cast<Index>(first), size).matrix();
        const double centre = value.mean();
        GeneralizedMean mean{centre + column.dot((value.array() - centre).matrix()) / weight, unit / weight,
                             Array1D::Zero(levels)};
        const Eigen::MatrixXd P = inverse - column * column.transpose() / weight;
        for (Index j = 0; j < levels; ++j) {
            const auto& Zj = indicators[static_cast<std::size_t>(j)];
            mean.gradient[j] = (Zj.transpose() * column).squaredNorm() / (weight * weight);
            const Eigen::MatrixXd rows = Zj.transpose() * P;
            for (Index k = 0; k <= j; ++k)
                information(j, k) += 0.5 * (rows * indicators[static_cast<std::size_t>(k)]).squaredNorm();
        }
        result.means.push_back(std::move(mean));
        first = last;
    }
    information.triangularView<Eigen::StrictlyUpper>() = information.transpose();
    result.covariance = (unit * unit * numerics::inverse(information)).array();
    return result;
}

}  // namespace setae::statistics
