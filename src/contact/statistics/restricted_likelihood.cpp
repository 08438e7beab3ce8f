// SPDX-License-Identifier: GPL-3.0-or-later
#include "restricted_likelihood.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

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

/// Sums of one row: V = v.
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

/// ln L_R of a design whose levels nest. `value`: deviations from the surfaces' plain means, so that little cancels.
Jet log_likelihood_of_nested(const NestedDesign& design, const Array1D& value, const std::vector<Jet>& theta) {
    const std::size_t depth = std::max<std::size_t>(theta.size(), 1);
    // open[k]: rows of the open group at level k − 1; 0 is the surface
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

/// Rows that are inverted together.
struct Block {
    Index first = 0, size = 0;  ///< rows
    Index first_surface = 0, surfaces = 0;
};

Block all_rows(const NestedDesign& design) { return {0, design.size(), 0, static_cast<Index>(design.surfaces.size())}; }

/// Indicators of groups in a block's rows.
Eigen::MatrixXd indicators(const std::vector<int>& group, const Block& block) {
    const auto begin = group.begin() + block.first, end = begin + block.size;
    const auto [least, most] = std::minmax_element(begin, end);
    Eigen::MatrixXd Z = Eigen::MatrixXd::Zero(block.size, *most - *least + 1);
    for (Index i = 0; i < block.size; ++i) Z(i, begin[i] - *least) = 1.0;
    return Z;
}

/// V⁻¹ of a block and its sums for means and likelihood.
struct BlockInverse {
    std::vector<Eigen::MatrixXd> groups;  ///< Z of each level
    Eigen::MatrixXd surfaces;             ///< X
    Eigen::MatrixXd inverse;              ///< V⁻¹
    Eigen::MatrixXd weighted;             ///< V⁻¹X
    Eigen::MatrixXd means_covariance;     ///< Φ = (XᵀV⁻¹X)⁻¹
    Eigen::MatrixXd residual;             ///< P = V⁻¹ − V⁻¹X Φ XᵀV⁻¹
    double log_determinants = 0.0;        ///< ln det V + ln det XᵀV⁻¹X
};

/// ln det of a matrix with the given root.
double log_determinant(const Eigen::MatrixXd& root) { return 2.0 * root.diagonal().array().log().sum(); }

/// Nothing where V is singular to rounding.
std::optional<BlockInverse> block_inverse(const NestedDesign& design, const Block& block, const Array1D& variances,
                                          double unit) {
    BlockInverse result{.surfaces = indicators(design.surface, block)};
    Eigen::MatrixXd V = (design.known_variance.segment(block.first, block.size) / unit).matrix().asDiagonal();
    for (std::size_t k = 0; k < design.levels.size(); ++k) {
        result.groups.push_back(indicators(design.levels[k].group, block));
        V += variances[static_cast<Index>(k)] / unit * (result.groups[k] * result.groups[k].transpose());
    }
    auto inverse = numerics::inverse_positive_definite(V);
    const auto root = numerics::cholesky(V);
    if (!inverse || !root) return std::nullopt;
    result.inverse = std::move(*inverse);
    result.weighted = result.inverse * result.surfaces;
    const Eigen::MatrixXd weight = result.surfaces.transpose() * result.weighted;
    auto means_covariance = numerics::inverse_positive_definite(weight);
    const auto root_of_weight = numerics::cholesky(weight);
    if (!means_covariance || !root_of_weight) return std::nullopt;
    result.means_covariance = std::move(*means_covariance);
    result.residual = result.inverse - result.weighted * result.means_covariance * result.weighted.transpose();
    result.log_determinants = log_determinant(*root) + log_determinant(*root_of_weight);
    return result;
}

/// ln L_R of a design whose levels cross, with its derivatives by θ:
///
///   ∂_k = −½ [tr(P K_k) − yᵀP K_k P y],  ∂_jk = −½ [2 yᵀP K_j P K_k P y − tr(P K_j P K_k)],  K = Z Zᵀ
Jet log_likelihood_of_crossed(const NestedDesign& design, const Array1D& value, const std::vector<Jet>& theta) {
    const std::size_t levels = theta.size();
    Array1D variances(static_cast<Index>(levels));
    for (std::size_t k = 0; k < levels; ++k) variances[static_cast<Index>(k)] = theta[k].value;
    const auto found = block_inverse(design, all_rows(design), variances, 1.0);
    if (!found) return {.value = -HUGE_VAL};
    const auto& block = *found;
    const Eigen::VectorXd residual = block.residual * value.matrix();
    Jet total{.value = -0.5 * (block.log_determinants + value.matrix().dot(residual))};
    std::vector<Eigen::VectorXd> sums;  // Zᵀ P y
    for (std::size_t j = 0; j < levels; ++j) {
        sums.emplace_back(block.groups[j].transpose() * residual);
        const Eigen::MatrixXd rows = block.groups[j].transpose() * block.residual;
        for (std::size_t k = 0; k <= j; ++k) {
            const Eigen::MatrixXd joint = rows * block.groups[k];
            if (k == j) {
                const double slope = -0.5 * (joint.trace() - sums[j].squaredNorm());
                for (std::size_t a = 0; a < Jet::most; ++a) total.first[a] += slope * theta[j].first[a];
                for (std::size_t ab = 0; ab < total.second.size(); ++ab)
                    total.second[ab] += slope * theta[j].second[ab];
            }
            const double curvature =
                (k == j ? 1.0 : 2.0) * -0.5 * (2.0 * sums[j].dot(joint * sums[k]) - joint.squaredNorm());
            for (std::size_t a = 0; a < Jet::most; ++a)
                for (std::size_t b = 0; b <= a; ++b)
                    total.second[Jet::at(a, b)] +=
                        0.5 * curvature *
                        (theta[j].first[a] * theta[k].first[b] + theta[j].first[b] * theta[k].first[a]);
        }
    }
    return total;
}

Jet log_likelihood(const NestedDesign& design, const Array1D& value, const std::vector<Jet>& theta) {
    return design.crossed() ? log_likelihood_of_crossed(design, value, theta)
                            : log_likelihood_of_nested(design, value, theta);
}

GeneralizedMean contrast(const DesignInformation& information, const Eigen::VectorXd& weights) {
    GeneralizedMean result{weights.dot(information.means), weights.dot(information.means_covariance * weights),
                           Array1D(static_cast<Index>(information.gradients.size()))};
    for (std::size_t k = 0; k < information.gradients.size(); ++k)
        result.gradient[static_cast<Index>(k)] = weights.dot(information.gradients[k] * weights);
    return result;
}

/// A design in units of its own scatter.
struct Scaled {
    NestedDesign design;
    Array1D value;  ///< deviations
    double scale = 1.0;
    double offset = 0.0;          ///< ln L_R of the design minus that of the scaled one
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
    constexpr int max_steps = 200;
    for (int step = 0; step < max_steps; ++step) {
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
        // at a bound, or at the maximum within rounding
        if (!better) return {x, here.value, gain < 1e-7 || (x <= lowest).any()};
    }
    return {x, here.value, false};
}

/// Starts of m levels: equal, and each larger than the others in turn.
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

GeneralizedMean DesignInformation::mean(std::size_t surface) const {
    return contrast(*this, Eigen::VectorXd::Unit(means.size(), static_cast<Index>(surface)));
}

GeneralizedMean DesignInformation::difference(std::size_t later, std::size_t earlier) const {
    Eigen::VectorXd weights = Eigen::VectorXd::Unit(means.size(), static_cast<Index>(later));
    weights[static_cast<Index>(earlier)] -= 1.0;
    return contrast(*this, weights);
}

namespace {

/// Rows that share no random effect with others: the groups of the outermost level, in the order of rows.
std::vector<Block> independent_groups(const NestedDesign& design) {
    const auto& group = design.levels.front().group;
    std::vector<Block> blocks;
    for (Index i = 0; i < design.size(); ++i) {
        const auto row = static_cast<std::size_t>(i);
        if (i == 0 || group[row] != group[row - 1]) blocks.push_back({i, 0, design.surface[row], 1});
        ++blocks.back().size;
    }
    return blocks;
}

/// V⁻¹ of an independent group for the sums of a surface.
struct GroupInverse {
    Eigen::VectorXd weighted;              ///< w = V⁻¹ 1
    std::vector<Eigen::VectorXd> sums;     ///< Z_jᵀ w of each level
    std::vector<Eigen::MatrixXd> between;  ///< Z_jᵀ V⁻¹ Z_k, k <= j
};

GroupInverse group_inverse(const NestedDesign& design, const Block& block, const Array1D& variances, double unit) {
    Eigen::MatrixXd V = (design.known_variance.segment(block.first, block.size) / unit).matrix().asDiagonal();
    std::vector<Eigen::MatrixXd> groups;
    for (std::size_t k = 0; k < design.levels.size(); ++k) {
        groups.push_back(indicators(design.levels[k].group, block));
        V += variances[static_cast<Index>(k)] / unit * (groups[k] * groups[k].transpose());
    }
    const auto inverse = numerics::inverse_positive_definite(V);
    if (!inverse) throw InternalError("the covariance of replicates cannot be inverted");
    GroupInverse result{.weighted = inverse->rowwise().sum()};
    for (std::size_t j = 0; j < groups.size(); ++j) {
        result.sums.emplace_back(groups[j].transpose() * result.weighted);
        for (std::size_t k = 0; k <= j; ++k) result.between.emplace_back(groups[j].transpose() * *inverse * groups[k]);
    }
    return result;
}

/// Sums over the groups of one surface.
struct SurfaceSums {
    double weight = 0.0, plain = 0.0;  ///< 1ᵀ V⁻¹ 1; sum of values
    Index rows = 0;
    Array1D squares;              ///< |Z_jᵀ w|² of each level
    Eigen::MatrixXd whole, bent;  ///< |Z_jᵀ V⁻¹ Z_k|²; (Z_jᵀ w)^T (Z_jᵀ V⁻¹ Z_k) (Z_kᵀ w)

    explicit SurfaceSums(Index levels)
        : squares(Array1D::Zero(levels)),
          whole(Eigen::MatrixXd::Zero(levels, levels)),
          bent(Eigen::MatrixXd::Zero(levels, levels)) {}

    void add(const GroupInverse& group) {
        weight += group.weighted.sum();
        std::size_t place = 0;
        for (Index j = 0; j < squares.size(); ++j) {
            const auto& of_j = group.sums[static_cast<std::size_t>(j)];
            squares[j] += of_j.squaredNorm();
            for (Index k = 0; k <= j; ++k, ++place) {
                whole(j, k) += group.between[place].squaredNorm();
                bent(j, k) += of_j.dot(group.between[place] * group.sums[static_cast<std::size_t>(k)]);
            }
        }
    }
};

/// The information as in information_of_crossed() for nested levels: V is inverted group by group of the outermost
/// level. With P = V⁻¹ - φ w wᵀ of a surface, w = V⁻¹1, φ = 1/(1ᵀV⁻¹1):
///
///   tr(P K_j P K_k) = |Z_jᵀ V⁻¹ Z_k|² - 2 φ (Z_jᵀ w)^T (Z_jᵀ V⁻¹ Z_k) (Z_kᵀ w) + φ² |Z_jᵀ w|² |Z_kᵀ w|²
///
/// Cost: the sum of the cubes of the rows of these groups.
DesignInformation information_of_nested(const NestedDesign& design, const Array1D& variances, double unit) {
    const auto levels = static_cast<Index>(design.levels.size()), surfaces = static_cast<Index>(design.surfaces.size());
    DesignInformation result{
        .means = Eigen::VectorXd::Zero(surfaces),
        .row_weights = Eigen::MatrixXd::Zero(surfaces, design.size()),
        .means_covariance = Eigen::MatrixXd::Zero(surfaces, surfaces),
        .gradients = std::vector<Eigen::MatrixXd>(design.levels.size(), Eigen::MatrixXd::Zero(surfaces, surfaces))};
    std::vector<SurfaceSums> sums(design.surfaces.size(), SurfaceSums(levels));
    for (const auto& block : independent_groups(design)) {
        const auto group = group_inverse(design, block, variances, unit);
        auto& own = sums[static_cast<std::size_t>(block.first_surface)];
        own.add(group);
        own.plain += design.value.segment(block.first, block.size).sum();
        own.rows += block.size;
        result.row_weights.row(block.first_surface).segment(block.first, block.size) = group.weighted.transpose();
    }
    Eigen::MatrixXd information = Eigen::MatrixXd::Zero(levels, levels);
    for (Index s = 0; s < surfaces; ++s) {
        const auto& own = sums[static_cast<std::size_t>(s)];
        const double phi = 1.0 / own.weight;
        result.row_weights.row(s) *= phi;
        result.means_covariance(s, s) = unit * phi;
        result.means[s] = own.plain / static_cast<double>(own.rows);
        for (Index j = 0; j < levels; ++j) {
            result.gradients[static_cast<std::size_t>(j)](s, s) = phi * phi * own.squares[j];
            for (Index k = 0; k <= j; ++k)
                information(j, k) +=
                    0.5 * (own.whole(j, k) - 2.0 * phi * own.bent(j, k) + phi * phi * own.squares[j] * own.squares[k]);
        }
    }
    // about the plain means, so that little cancels
    Array1D centred(design.size());
    for (Index i = 0; i < design.size(); ++i)
        centred[i] = design.value[i] - result.means[design.surface[static_cast<std::size_t>(i)]];
    for (Index i = 0; i < design.size(); ++i) {
        const auto s = design.surface[static_cast<std::size_t>(i)];
        result.means[s] += result.row_weights(s, i) * centred[i];
    }
    information.triangularView<Eigen::StrictlyUpper>() = information.transpose();
    result.covariance = (unit * unit * numerics::inverse(information)).array();
    return result;
}

DesignInformation information_of_crossed(const NestedDesign& design, const Array1D& variances, double unit) {
    const auto levels = static_cast<Index>(design.levels.size());
    const auto found = block_inverse(design, all_rows(design), variances, unit);
    if (!found) throw InternalError("the covariance of replicates cannot be inverted");
    const auto& block = *found;
    const Eigen::VectorXd value = design.value.matrix();
    const Eigen::VectorXd centre =
        (block.surfaces.transpose() * value).cwiseQuotient(block.surfaces.colwise().sum().transpose());
    DesignInformation result;
    result.means = centre + block.means_covariance * (block.weighted.transpose() * (value - block.surfaces * centre));
    result.row_weights = block.means_covariance * block.weighted.transpose();
    result.means_covariance = unit * block.means_covariance;
    Eigen::MatrixXd information = Eigen::MatrixXd::Zero(levels, levels);
    for (Index j = 0; j < levels; ++j) {
        const auto& Zj = block.groups[static_cast<std::size_t>(j)];
        const Eigen::MatrixXd moved = Zj.transpose() * block.weighted * block.means_covariance;
        result.gradients.emplace_back(moved.transpose() * moved);
        const Eigen::MatrixXd rows = Zj.transpose() * block.residual;
        for (Index k = 0; k <= j; ++k)
            information(j, k) += 0.5 * (rows * block.groups[static_cast<std::size_t>(k)]).squaredNorm();
    }
    information.triangularView<Eigen::StrictlyUpper>() = information.transpose();
    result.covariance = (unit * unit * numerics::inverse(information)).array();
    return result;
}

}  // namespace

DesignInformation information_of(const NestedDesign& design, const Array1D& variances) {
    // in units in which squares of small numbers differ from 0
    const double unit = variances.sum() + design.known_variance.mean();
    if (!(unit > 0.0)) throw InternalError("a mixed model without any variance");
    return design.crossed() ? information_of_crossed(design, variances, unit)
                            : information_of_nested(design, variances, unit);
}

}  // namespace setae::statistics
