// SPDX-License-Identifier: GPL-3.0-or-later
#include "model_problem.hpp"

#include <algorithm>
#include <cmath>

#include <limits>

#include <Eigen/Dense>

#include "setae/core/constants.hpp"
#include "setae/numerics/bracketing.hpp"

namespace setae::loops {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index entries_of_table = 256;

Array1D every(const Array1D& series, Index step) {
    if (series.size() == 0) return series;
    return series(Eigen::seq(0, Eigen::last, step));
}

/// t where the displacement stops falling, between two t that enclose it.
double fold_between(const ModelCurve& curve, const FitParameters& at, double lower, double upper) {
    const auto falls = [&](double t) { return curve.at(t, at.head<3>()).displacement_slope < 0.0; };
    return numerics::bisected(falls, lower, upper, 60).second;
}

}  // namespace

double CurveTable::guess(double value, double CurvePoint::*member, std::size_t first) const {
    const auto begin = points.begin() + static_cast<std::ptrdiff_t>(first);
    const auto above = std::lower_bound(begin, points.end(), value,
                                        [&](const CurvePoint& point, double v) { return point.*member < v; });
    if (above == begin) return t[first];
    if (above == points.end()) return t.back();
    const auto i = static_cast<std::size_t>(above - points.begin());
    const double low = points[i - 1].*member, high = points[i].*member;
    const double share = high > low ? (value - low) / (high - low) : 0.0;
    return t[i - 1] + share * (t[i] - t[i - 1]);
}

double CurveTable::at_force(double force, double CurvePoint::*member) const {
    if (t.size() < 2) return points.front().*member;  // a trial curve that folds beyond every force
    const double where = guess(force, &CurvePoint::force, min_force);
    const auto above = std::lower_bound(t.begin(), t.end(), where);
    const auto i = std::clamp<std::size_t>(static_cast<std::size_t>(above - t.begin()), 1, t.size() - 1);
    const double share = std::clamp((where - t[i - 1]) / (t[i] - t[i - 1]), 0.0, 1.0);
    return points[i - 1].*member + share * (points[i].*member - points[i - 1].*member);
}

BranchProblem::BranchProblem(ModelCurve curve, const BranchData& data, Channels channels, FitErrors errors,
                             const ChannelNoise& noise)
    : curve_(std::move(curve)), channels_(channels), errors_(errors), noise_(noise), force_(data.force) {
    const double sf = noise.force;
    whitening_(0, 0) = 1.0 / sf;
    if (has_displacement()) {
        displacement_ = data.displacement;
        origin_ = displacement_[0];
        depth_unit_ = displacement_.maxCoeff() - displacement_.minCoeff();
        // inverse of the covariance's Cholesky factor
        const double shared = noise.force_displacement_covariance / sf;
        const double own = std::sqrt(noise.displacement * noise.displacement - shared * shared);
        whitening_(1, 0) = -shared / (own * sf);
        whitening_(1, 1) = 1.0 / own;
    }
    if (has_radius()) {
        radius_ = data.contact_radius;
        whitening_(2, 2) = 1.0 / noise.contact_radius;
    }
    const auto largest = [](const Array1D& series) { return series.size() > 0 ? series.abs().maxCoeff() : 0.0; };
    const Vector scale = whitening_.cwiseAbs() * Vector(largest(force_), largest(displacement_), largest(radius_));
    rounding_ = 4e-16 * scale.sum();
    weights_.assign(static_cast<std::size_t>(samples()), Eigen::Matrix2d::Identity());
}

BranchProblem BranchProblem::thinned(Index most) const {
    BranchProblem few = *this;
    const Index step = (samples() + most - 1) / most;
    few.force_ = every(force_, step);
    few.displacement_ = every(displacement_, step);
    few.radius_ = every(radius_, step);
    few.weights_.assign(static_cast<std::size_t>(few.samples()), Eigen::Matrix2d::Identity());
    return few;
}

BranchProblem::Vector BranchProblem::whitened(double force, double displacement, double radius) const {
    return {whitening_(0, 0) * force, whitening_(1, 0) * force + whitening_(1, 1) * displacement,
            whitening_(2, 2) * radius};
}

BranchProblem::Vector BranchProblem::error(Index sample, const CurvePoint& point, double contact_point) const {
    return whitened(force_[sample] - point.force,
                    has_displacement() ? displacement_[sample] - contact_point - point.displacement : 0.0,
                    has_radius() ? radius_[sample] - point.radius : 0.0);
}

CurveTable BranchProblem::table(const FitParameters& at, Index entries) const {
    CurveTable table;
    const double reach = 1.05 * curve_.radius_bound(force_.maxCoeff(), at.head<3>());
    const double highest = std::min(reach > 0.0 ? reach : 1e-9 * curve_.radius(), curve_.largest_radius());
    if (curve_.includes_separation()) {
        const double depth = has_displacement() ? displacement_.minCoeff() - contact_point(at) : -0.0;
        const double lowest = -std::sqrt(curve_.radius() * std::max(0.0, -depth));
        const Index half = entries / 2;
        for (Index i = half; i > 0 && lowest < 0.0; --i)
            table.t.push_back(lowest * static_cast<double>(i) / static_cast<double>(half));
        table.t.push_back(0.0);
    }
    for (Index i = 1; i <= entries; ++i)
        table.t.push_back(highest * static_cast<double>(i) / static_cast<double>(entries));
    for (const double t : table.t) table.points.push_back(curve_.at(t, at.head<3>()));
    if (!curve_.includes_separation()) {
        // the table's first entry may be above the fold
        table.t.insert(table.t.begin(), 1e-6 * highest);
        table.points.insert(table.points.begin(), curve_.at(table.t.front(), at.head<3>()));
        std::size_t fold = table.t.size() - 1;
        while (fold > 0 && table.points[fold].displacement_slope > 0.0) --fold;
        const bool folds = table.points[fold].displacement_slope < 0.0 && fold + 1 < table.t.size();
        table.min_t = folds ? fold_between(curve_, at, table.t[fold], table.t[fold + 1]) : table.t.front();
        table.t.erase(table.t.begin(), table.t.begin() + static_cast<std::ptrdiff_t>(fold));
        table.points.erase(table.points.begin(), table.points.begin() + static_cast<std::ptrdiff_t>(fold));
        table.t.front() = table.min_t;
        table.points.front() = curve_.at(table.min_t, at.head<3>());
    } else {
        table.min_t = table.t.front();
    }
    const auto by_force = [](const CurvePoint& one, const CurvePoint& other) { return one.force < other.force; };
    // of equal forces (separated bodies) the last
    const auto least = std::min_element(table.points.rbegin(), table.points.rend(), by_force);
    table.min_force = static_cast<std::size_t>(table.points.rend() - least - 1);
    return table;
}

BranchProblem::Foot BranchProblem::foot(Index sample, const FitParameters& at, const CurveTable& table) const {
    const double point0 = contact_point(at);
    double lowest = curve_.includes_separation() ? -std::numeric_limits<double>::infinity() : 0.25 * table.min_t;
    if (has_radius()) lowest = 1e-6 * radius_[sample];
    const double highest = curve_.largest_radius();
    Foot foot;
    const auto move = [&](double t) {
        foot.t = t;
        foot.point = curve_.at(t, at.head<3>());
        foot.error = error(sample, foot.point, point0);
        foot.tangent = whitened(foot.point.force_slope, foot.point.displacement_slope,
                                has_radius() ? foot.point.radius_slope : 0.0);
        if (!has_displacement()) foot.tangent[1] = 0.0;
        if (foot.tangent.squaredNorm() == 0.0) foot.tangent = {0.0, 1.0, 0.0};  // Hertz and DMT at t = 0
    };
    double start = has_radius() ? radius_[sample] : 0.0;
    if (!has_radius()) {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < table.t.size(); ++i) {
            const double distance = error(sample, table.points[i], point0).squaredNorm();
            if (distance < least) {
                least = distance;
                start = table.t[i];
            }
        }
    }
    move(std::clamp(start, lowest, highest));
    // the distance decreases while tangent · error, here the pull, points along t; the nearest point is where it
    // changes its sign
    double below = lowest, above = highest;  // bounds of the nearest point
    double pull_below = undefined, pull_above = undefined;
    double last_pull = std::numeric_limits<double>::infinity();
    for (int round = 0; round < 100; ++round) {
        const double pull = foot.tangent.dot(foot.error), square = foot.tangent.squaredNorm(), t = foot.t;
        // a shorter step would not show in the distance
        if (std::abs(pull) <= std::sqrt(square) * (1e-8 * foot.error.norm() + rounding_)) break;
        (pull > 0.0 ? below : above) = t;
        (pull > 0.0 ? pull_below : pull_above) = pull;
        if (!(above - below > 1e-15 * std::abs(t))) {
            foot.at_bound = t == lowest || t == highest;
            break;
        }
        double target =
            t + pull / square;  // Gauss and Newton's step, good where the curve bends little within the error
        if (std::abs(pull) > 0.3 * last_pull) {
            const double secant = below + (above - below) * pull_below / (pull_below - pull_above);
            target = std::isfinite(secant) && round % 3 != 2 ? secant : target;
            if (std::isfinite(secant) && round % 3 == 2) target = 0.5 * (below + above);
        }
        last_pull = std::abs(pull);
        if (target >= above) target = pull_above < 0.0 ? 0.5 * (t + above) : above;
        if (target <= below) target = pull_below > 0.0 ? 0.5 * (t + below) : below;
        move(target);
    }
    return foot;
}

void BranchProblem::evaluate(const FitParameters& at, Eigen::Ref<VectorXd> residuals, MatrixXd* jacobian) const {
    if (jacobian) jacobian->setZero(this->residuals(), 4);
    if (errors_ == FitErrors::orthogonal_distance || !has_radius()) {
        if (errors_ == FitErrors::force_only) evaluate_at_displacement(at, residuals, jacobian);
        else evaluate_feet(at, residuals, jacobian);
    } else {
        evaluate_at_radius(at, residuals, jacobian);
    }
}

void BranchProblem::evaluate_feet(const FitParameters& at, Eigen::Ref<VectorXd> residuals, MatrixXd* jacobian) const {
    const CurveTable curve_table = has_radius() ? CurveTable{} : table(at, entries_of_table);
    const Index n = samples();
    for (Index i = 0; i < n; ++i) {
        const Foot nearest_point = foot(i, at, curve_table);
        Vector direction = nearest_point.tangent.normalized();
        std::array<Vector, 2> normals;
        if (!has_radius()) normals[0] = {-direction[1], direction[0], 0.0};
        else if (!has_displacement()) normals[0] = {direction[2], 0.0, -direction[0]};
        else normals[0] = Vector(direction[1], -direction[0], 0.0).normalized();
        if (nearest_point.at_bound && nearest_point.error.norm() > 0.0) normals[0] = nearest_point.error.normalized();
        normals[1] = direction.cross(normals[0]);
        const Index count = channels_ == Channels::force_displacement_radius ? 2 : 1;
        for (Index k = 0; k < count; ++k) {
            const Vector& normal = normals[static_cast<std::size_t>(k)];
            residuals[k * n + i] = normal.dot(nearest_point.error);
            if (!jacobian) continue;
            for (Index p = 0; p < 3; ++p) {
                const auto slot = static_cast<std::size_t>(p);
                const double by_displacement = has_displacement() ? nearest_point.point.displacement_by[slot] : 0.0;
                (*jacobian)(k* n + i, p) =
                    -normal.dot(whitened(nearest_point.point.force_by[slot], by_displacement, 0.0));
            }
            if (has_displacement())
                (*jacobian)(k* n + i, contact_point_slot) = -normal.dot(whitened(0.0, depth_unit_, 0.0));
        }
    }
}

Eigen::Matrix2d BranchProblem::spread(const CurvePoint& point) const {
    const double a2 = noise_.contact_radius * noise_.contact_radius;
    Eigen::Matrix2d covariance;
    covariance(0, 0) = noise_.force * noise_.force + point.force_slope * point.force_slope * a2;
    covariance(0, 1) = covariance(1, 0) =
        noise_.force_displacement_covariance + point.force_slope * point.displacement_slope * a2;
    covariance(1, 1) =
        noise_.displacement * noise_.displacement + point.displacement_slope * point.displacement_slope * a2;
    return covariance;
}

double BranchProblem::renew_weights(const FitParameters& at) {
    double change = 0.0;
    for (Index i = 0; i < samples() && weights_change(); ++i) {
        const Eigen::Matrix2d covariance = spread(curve_.at(radius_[i], at.head<3>()));
        Eigen::Matrix2d weight = Eigen::Matrix2d::Zero();
        if (has_displacement()) weight = covariance.llt().matrixL().solve(Eigen::Matrix2d::Identity().eval());
        else weight(0, 0) = 1.0 / std::sqrt(covariance(0, 0));
        Eigen::Matrix2d& old = weights_[static_cast<std::size_t>(i)];
        change = std::max(change, (weight - old).norm() / weight.norm());
        old = weight;
    }
    return change;
}

void BranchProblem::evaluate_at_radius(const FitParameters& at, Eigen::Ref<VectorXd> residuals,
                                       MatrixXd* jacobian) const {
    const Index n = samples(), count = this->residuals() / n;
    for (Index i = 0; i < n; ++i) {
        const CurvePoint point = curve_.at(radius_[i], at.head<3>());
        Eigen::Matrix2d weight = weights_[static_cast<std::size_t>(i)];
        if (errors_ == FitErrors::force_only) weight = Eigen::Matrix2d::Identity() * whitening_(0, 0);
        const Eigen::Vector2d difference(
            force_[i] - point.force,
            has_displacement() ? displacement_[i] - contact_point(at) - point.displacement : 0.0);
        const Eigen::Vector2d whole = weight * difference;
        for (Index k = 0; k < count; ++k) {
            residuals[k * n + i] = whole[k];
            if (!jacobian) continue;
            for (Index p = 0; p < 3; ++p) {
                const auto slot = static_cast<std::size_t>(p);
                (*jacobian)(k* n + i, p) = -weight(k, 0) * point.force_by[slot] -
                                           (has_displacement() ? weight(k, 1) * point.displacement_by[slot] : 0.0);
            }
            if (has_displacement()) (*jacobian)(k* n + i, contact_point_slot) = -weight(k, 1) * depth_unit_;
        }
    }
}

bool BranchProblem::ends_above(double depth, const CurveTable& table) const {
    return !curve_.includes_separation() && !(depth > table.points.front().displacement);
}

CurvePoint BranchProblem::point_at(double depth, const FitParameters& at, const CurveTable& table) const {
    if (ends_above(depth, table)) return table.points.front();
    const auto curve_at = [&](double t) { return curve_.at(t, at.head<3>()); };
    if (curve_.includes_separation())
        return curve_at(std::copysign(std::sqrt(curve_.radius() * std::abs(depth)), depth));
    double lower = table.min_t, upper = std::max(table.t.back(), lower);
    while (upper < curve_.largest_radius() && curve_at(upper).displacement < depth) {
        lower = upper;
        upper = std::min(2.0 * upper, curve_.largest_radius());
    }
    double t = std::clamp(table.guess(depth, &CurvePoint::displacement, 0), lower, upper);
    CurvePoint point;
    for (int round = 0; round < 100; ++round) {
        point = curve_at(t);
        const double excess = point.displacement - depth;
        (excess > 0.0 ? upper : lower) = t;
        double next = t - excess / point.displacement_slope;
        if (!(next > lower && next < upper)) next = 0.5 * (lower + upper);
        if (std::abs(next - t) <= 1e-15 * t) break;
        t = next;
    }
    return point;
}

void BranchProblem::evaluate_at_displacement(const FitParameters& at, Eigen::Ref<VectorXd> residuals,
                                             MatrixXd* jacobian) const {
    const CurveTable curve_table = table(at, entries_of_table);
    std::array<double, 3>
        end_by{};  // derivatives of the force at the end of the curve: the end moves with the parameters
    for (Index p = 0; jacobian && p < curve_.parameters(); ++p) {
        const double step = 1e-5 * std::max(1.0, std::abs(at[p]));
        FitParameters more = at, less = at;
        more[p] += step;
        less[p] -= step;
        end_by[static_cast<std::size_t>(p)] =
            (table(more, entries_of_table).points.front().force - table(less, entries_of_table).points.front().force) /
            (2.0 * step);
    }
    for (Index i = 0; i < samples(); ++i) {
        const double depth = displacement_[i] - contact_point(at);
        const bool beyond = ends_above(depth, curve_table);
        const CurvePoint point = point_at(depth, at, curve_table);
        residuals[i] = whitening_(0, 0) * (force_[i] - point.force);
        if (!jacobian) continue;
        const bool flat = beyond || point.displacement_slope == 0.0;
        const double slope = flat ? 0.0 : point.force_slope / point.displacement_slope;
        for (Index p = 0; p < 3; ++p) {
            const auto slot = static_cast<std::size_t>(p);
            const double by = beyond ? end_by[slot] : point.force_by[slot] - slope * point.displacement_by[slot];
            (*jacobian)(i, p) = -whitening_(0, 0) * by;
        }
        (*jacobian)(i, contact_point_slot) = whitening_(0, 0) * slope * depth_unit_;
    }
}

std::vector<CurvePoint> BranchProblem::fitted(const FitParameters& at) const {
    const CurveTable curve_table = has_radius() ? CurveTable{} : table(at, entries_of_table);
    std::vector<CurvePoint> points;
    for (Index i = 0; i < samples(); ++i) {
        if (errors_ != FitErrors::force_only) points.push_back(foot(i, at, curve_table).point);
        else
            points.push_back(has_radius() ? curve_.at(radius_[i], at.head<3>())
                                          : point_at(displacement_[i] - contact_point(at), at, curve_table));
    }
    return points;
}

Array1D BranchProblem::force_residuals(const std::vector<CurvePoint>& fitted) const {
    Array1D result(samples());
    for (Index i = 0; i < samples(); ++i) result[i] = force_[i] - fitted[static_cast<std::size_t>(i)].force;
    return result;
}

Array1D BranchProblem::displacement_residuals(const std::vector<CurvePoint>& fitted, const FitParameters& at) const {
    Array1D result(displacement_.size());
    for (Index i = 0; i < result.size(); ++i)
        result[i] = displacement_[i] - contact_point(at) - fitted[static_cast<std::size_t>(i)].displacement;
    return result;
}

Array1D BranchProblem::radius_residuals(const std::vector<CurvePoint>& fitted) const {
    Array1D result(radius_.size());
    for (Index i = 0; i < result.size(); ++i) result[i] = radius_[i] - fitted[static_cast<std::size_t>(i)].radius;
    return result;
}

double BranchProblem::chi2(const std::vector<CurvePoint>& fitted, const FitParameters& at) const {
    double sum = 0.0;
    for (Index i = 0; i < samples(); ++i) {
        const Vector whole = error(i, fitted[static_cast<std::size_t>(i)], contact_point(at));
        sum += errors_ == FitErrors::force_only ? whole[0] * whole[0] : whole.squaredNorm();
    }
    return sum;
}

double BranchProblem::distance(FitParameters& at, bool contact_point_given) const {
    constexpr Index entries = 96;
    if (has_displacement() && !contact_point_given) at[contact_point_slot] = 0.0;
    const CurveTable curve_table = table(at, entries);
    double sum = 0.0;
    if (has_displacement()) {
        Array1D depth(samples());
        for (Index i = 0; i < samples(); ++i)
            depth[i] = displacement_[i] - curve_table.at_force(force_[i], &CurvePoint::displacement);
        const double zero = contact_point_given ? contact_point(at) : depth.mean();
        at[contact_point_slot] = contact_point_value(zero);
        sum += (depth - zero).square().sum() / (depth_unit_ * depth_unit_);
    }
    if (has_radius()) {
        const double range = radius_.maxCoeff() - radius_.minCoeff();
        for (Index i = 0; i < samples(); ++i)
            sum += std::pow((radius_[i] - curve_table.at_force(force_[i], &CurvePoint::radius)) / range, 2);
    }
    return sum;
}

}  // namespace setae::loops
