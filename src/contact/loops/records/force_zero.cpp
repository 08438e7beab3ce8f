// SPDX-License-Identifier: GPL-3.0-or-later
#include "force_zero.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Dense>

#include "baseline.hpp"
#include "channel_noise.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/statistics.hpp"
#include "setae/numerics/dense.hpp"

namespace setae::loops {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index max_degree = 3;

/// One section of free flight.
struct Stretch {
    IndexRange range;
    double variance = 0.0;  ///< variance of a mean of n samples times n [N²], with correlations of neighbours
};

/// 1, u, u², … at every sample.
MatrixXd powers(const Array1D& u, Index degree) {
    MatrixXd result(u.size(), degree + 1);
    result.col(0).setOnes();
    for (Index k = 1; k <= degree; ++k) result.col(k) = (result.col(k - 1).array() * u).matrix();
    return result;
}

/// A polynomial through free flight.
struct Curve {
    VectorXd coefficients;
    MatrixXd covariance;
};

/// Free flight of a record on a clock from −1 to 1.
class FreeFlight {
public:
    FreeFlight(const Loop& loop, std::vector<IndexRange> ranges) : force_(loop.force) {
        const Array1D clock = clock_of(loop);
        u_ = 2.0 * (clock - clock[0]) / (clock[clock.size() - 1] - clock[0]) - 1.0;
        for (const IndexRange& range : ranges) {
            const FreeFlightNoise noise = free_flight_noise(force_.segment(range.first, range.count()));
            stretches_.push_back({range, noise.sigma * noise.sigma * noise.correlated_samples()});
        }
    }

    [[nodiscard]] const std::vector<Stretch>& stretches() const { return stretches_; }
    [[nodiscard]] const Array1D& clock() const { return u_; }

    /// By Huber's weights, the scatter of each stretch its own.
    [[nodiscard]] Curve fitted(Index degree) const {
        constexpr int rounds = 6;
        constexpr double bend_at = 2.5, normal_scale = 1.4826;
        std::vector<Array1D> weights;
        for (const Stretch& stretch : stretches_) weights.push_back(Array1D::Ones(stretch.range.count()));
        Curve curve;
        for (int round = 0; round < rounds; ++round) {
            MatrixXd normal = MatrixXd::Zero(degree + 1, degree + 1), spread = normal;
            VectorXd right = VectorXd::Zero(degree + 1);
            for (std::size_t s = 0; s < stretches_.size(); ++s) {
                const auto& [range, variance] = stretches_[s];
                const MatrixXd design = powers(u_.segment(range.first, range.count()), degree);
                const MatrixXd weighed = weights[s].matrix().asDiagonal() * design;
                normal += design.transpose() * weighed;
                right += weighed.transpose() * force_.segment(range.first, range.count()).matrix();
                spread += variance * weighed.transpose() * weighed;
            }
            const MatrixXd inverse = numerics::inverse(normal);
            curve = {inverse * right, inverse * spread * inverse.transpose()};
            for (std::size_t s = 0; s < stretches_.size(); ++s) {
                const Array1D rest = residuals(curve, s);
                const double scale = normal_scale * median_of(rest.abs());
                if (scale > 0.0) weights[s] = (bend_at * scale / rest.abs().max(1e-12 * scale)).min(1.0);
            }
        }
        return curve;
    }

    [[nodiscard]] Array1D residuals(const Curve& curve, std::size_t stretch) const {
        const IndexRange& range = stretches_[stretch].range;
        const MatrixXd design = powers(u_.segment(range.first, range.count()), curve.coefficients.size() - 1);
        return force_.segment(range.first, range.count()) - (design * curve.coefficients).array();
    }

    /// Probability of a deviation of means and slopes of the sections from the curve at least as large by chance; 1
    /// where there is nothing to compare.
    [[nodiscard]] double chance(const Curve& curve) const {
        double chi2 = 0.0;
        for (std::size_t s = 0; s < stretches_.size(); ++s) {
            const auto& [range, variance] = stretches_[s];
            if (!(variance > 0.0)) continue;
            const Array1D rest = residuals(curve, s);
            const Array1D u = u_.segment(range.first, range.count());
            const Array1D from_middle = u - u.mean();
            const double n = static_cast<double>(range.count()), spread = from_middle.square().sum();
            const double slope = (from_middle * rest).sum() / spread;
            chi2 += n * rest.mean() * rest.mean() / variance + spread * slope * slope / variance;
        }
        const double freedom =
            2.0 * static_cast<double>(stretches_.size()) - static_cast<double>(curve.coefficients.size());
        return freedom > 0.0 ? chi_squared_exceedance(chi2, freedom) : 1.0;
    }

    [[nodiscard]] Array1D along(const Curve& curve) const {
        return (powers(u_, curve.coefficients.size() - 1) * curve.coefficients).array();
    }

private:
    const Array1D& force_;
    Array1D u_;
    std::vector<Stretch> stretches_;
};

std::vector<IndexRange> free_ranges(const Segments& segments, DriftModel model) {
    std::vector<IndexRange> ranges;
    if (segments.before.range) ranges.push_back(*segments.before.range);
    const bool first_alone = (model == DriftModel::extrapolated || model == DriftModel::constant) && !ranges.empty();
    if (segments.after && segments.after->range && !first_alone) ranges.push_back(*segments.after->range);
    return ranges;
}

/// Samples between the first and the last section; for one section all others.
IndexRange contact_between(const std::vector<Stretch>& stretches, Index samples) {
    if (stretches.size() > 1) return {stretches.front().range.last + 1, stretches.back().range.first - 1};
    const IndexRange& range = stretches.front().range;
    return range.first > samples - 1 - range.last ? IndexRange{0, range.first - 1}
                                                  : IndexRange{range.last + 1, samples - 1};
}

Index degree_wanted(DriftModel model, std::size_t stretches) {
    switch (model) {
        case DriftModel::constant: return 0;
        case DriftModel::quadratic: return stretches > 1 ? 2 : 1;
        case DriftModel::cubic: return stretches > 1 ? 3 : 1;
        default: return 1;
    }
}

/// Independent errors of a curve, sample by sample.
Array2D modes_of(const Curve& curve, const Array1D& u) {
    const auto lower = numerics::cholesky(curve.covariance);
    if (!lower) return Array2D(u.size(), 0);  // exact: free flight without noise
    return (powers(u, curve.coefficients.size() - 1) * *lower).array();
}

/// The degree of polynomial for the free flight.
struct Chosen {
    Index degree = 1;
    double doubt = 0.0;  ///< one standard deviation of the error by the choice of degree within contact [N]
    bool irregular = false;
};

Chosen automatic_degree(const Loop& loop, const FreeFlight& flight) {
    constexpr double unlikely = 0.02, share_of_tension = 0.003, max_bend = 3.0;
    Chosen chosen;
    if (flight.stretches().size() < 2) return chosen;
    Array1D before = flight.along(flight.fitted(1));
    const Array1D line = before;
    const IndexRange contact = contact_between(flight.stretches(), loop.force.size());
    const double tension = -(loop.force - line).minCoeff();
    const auto bend = [&](const Array1D& zero) {
        return contact.count() > 0 ? (zero - line).segment(contact.first, contact.count()).abs().maxCoeff() : 0.0;
    };
    while (chosen.degree < max_degree && flight.chance(flight.fitted(chosen.degree)) < unlikely) {
        const Array1D next = flight.along(flight.fitted(chosen.degree + 1));
        if (!(bend(next) > share_of_tension * tension)) break;
        ++chosen.degree;
        before = next;
    }
    if (chosen.degree == 1) return chosen;
    const double change = std::abs(line[line.size() - 1] - line[0]);
    if (chosen.degree == max_degree && bend(before) > max_bend * std::max(change, share_of_tension * tension)) {
        return {.degree = 1, .doubt = 0.5 * bend(before), .irregular = true};
    }
    // a cubic cannot be tested: its deviation from the line is uncertain
    const Array1D next = chosen.degree < max_degree ? flight.along(flight.fitted(chosen.degree + 1)) : line;
    const double share = chosen.degree < max_degree ? 0.5 : 0.25;
    chosen.doubt = share * (next - before).segment(contact.first, contact.count()).abs().maxCoeff();
    return chosen;
}

/// Between the sections of free flight, where it is zero, the error of a curve may have any shape: the first two waves.
void add_doubt(Array2D& modes, const IndexRange& contact, double size) {
    const Index added = modes.cols();
    modes.conservativeResize(Eigen::NoChange, added + 2);
    modes.rightCols(2).setZero();
    const Array1D phase = pi * Array1D::LinSpaced(contact.count(), 0.0, 1.0);
    modes.col(added).segment(contact.first, contact.count()) = size * phase.sin();
    modes.col(added + 1).segment(contact.first, contact.count()) = size * (2.0 * phase).sin();
}

}  // namespace

ForceZero force_zero(const Loop& loop, const Segments& segments, DriftModel model) {
    const Index n = loop.force.size();
    const std::vector<IndexRange> ranges = free_ranges(segments, model);
    ForceZero zero;
    if (ranges.empty()) {
        zero.value = Array1D::Constant(n, segments.before.force);
        zero.modes = Array2D(n, 0);
        zero.drift.change = {.value = 0.0};
        return zero;
    }
    const FreeFlight flight(loop, ranges);
    Chosen chosen{.degree = degree_wanted(model, ranges.size())};
    if (model == DriftModel::automatic) chosen = automatic_degree(loop, flight);
    const Curve curve = flight.fitted(chosen.degree);
    zero.value = flight.along(curve);
    zero.modes = modes_of(curve, flight.clock());
    if (chosen.doubt > 0.0) add_doubt(zero.modes, contact_between(flight.stretches(), n), chosen.doubt);
    ForceDrift& drift = zero.drift;
    drift = {.degree = static_cast<int>(chosen.degree),
             .irregular = chosen.irregular,
             .stretches = static_cast<Index>(ranges.size())};
    drift.change = {.value = zero.value[n - 1] - zero.value[0],
                    .standard_error = (zero.modes.row(n - 1) - zero.modes.row(0)).matrix().norm(),
                    .method = "free flight"};
    const IndexRange contact = contact_between(flight.stretches(), n);
    if (contact.count() > 0) {
        const auto part = [&](const Array1D& values) { return values.segment(contact.first, contact.count()); };
        drift.largest_in_contact = (part(zero.value) - zero.value[0]).abs().maxCoeff();
        if (chosen.degree > 1) drift.bend = part(zero.value - flight.along(flight.fitted(1))).abs().maxCoeff();
    }
    if (model == DriftModel::constant) drift.change = {.value = 0.0};
    return zero;
}

Loop without_displacement_drift(const Loop& loop, double rate) {
    if (rate == 0.0 || loop.displacement.size() == 0) return loop;
    if (loop.time.size() != loop.force.size() || !loop.time.allFinite())
        throw InvalidArgument(
            "a drift of the displacement needs the time of every sample, which the record does not have");
    Loop level = loop;
    level.displacement -= rate * (loop.time - loop.time[0]);
    return level;
}

}  // namespace setae::loops
