// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/LU>

#include "setae/core/arrays.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/extent.hpp"

namespace setae::half_space {

/// What a smooth sphere does under grips, in the units of SphereCell.
struct SphereJumps {
    double pull_off = 0.0;
    double jump_in = 0.0, loss_in = 0.0;    ///< displacement where it jumps into contact, and what that loses
    double jump_out = 0.0, loss_out = 0.0;  ///< likewise out of it
};

/// The same sphere and attraction (exponential) by other means: rings of constant pressure on a half-space, dense
/// Newton steps, and branches followed by the central gap and by the radius of contact, past where they turn. Nothing
/// is shared with the cell but the equations.
///
///   g = r²/2R − δ + Σ A p,  p = −(w/ρ) exp(−g/ρ) where g > 0;  the edge is about to open: p = −w/ρ in its ring
class AxisymmetricSphere {
public:
    AxisymmetricSphere(double range, double squared_ratio) : range_(range) {
        const double width = squared_ratio * range * range * modulus / work,
                     radius = std::max(2.45, std::sqrt(28.0 * range) + 1.2);
        rings_ = static_cast<Index>(std::ceil(radius / width));
        width_ = width;
        place_ = (Array1D::LinSpaced(rings_, 0.0, static_cast<double>(rings_ - 1)) + 0.5) * width;
        area_ = 2.0 * pi * place_ * width;
        height_ = 0.5 * place_.square();
        response_.resize(rings_, rings_);
        for (Index i = 0; i < rings_; ++i)
            for (Index j = 0; j < rings_; ++j)
                response_(i, j) =
                    disc(place_[i], place_[j] + 0.5 * width) - (j > 0 ? disc(place_[i], place_[j] - 0.5 * width) : 0.0);
    }

    [[nodiscard]] SphereJumps jumps() const {
        const auto apart = apart_branch();
        const auto touching = touching_branch();
        const auto last = std::ranges::max_element(apart, {}, &Point::displacement);
        const auto first = std::ranges::min_element(touching, {}, &Point::displacement);
        SphereJumps found{.jump_in = last->displacement, .jump_out = first->displacement};
        found.loss_in = last->energy - energy_at({touching.begin(), first + 1}, last->displacement);
        const bool far = first->displacement < apart.front().displacement;
        found.loss_out = first->energy - (far ? undeformed_energy(first->displacement)
                                              : energy_at({apart.begin(), last + 1}, first->displacement));
        for (const auto& point : touching) found.pull_off = std::max(found.pull_off, point.tension);
        return found;
    }

private:
    static constexpr double modulus = 0.75, work = 1.0 / pi;

    struct State {
        Eigen::VectorXd gaps, pressures;
        double displacement = 0.0;
    };
    struct Point {
        double displacement = 0.0, energy = 0.0, tension = 0.0;
    };

    /// Displacement at r of a disc under unit pressure.
    [[nodiscard]] static double disc(double r, double radius) {
        if (r < radius) return 4.0 * radius / (pi * modulus) * std::comp_ellint_2(r / radius);
        const double k = radius / r;
        return 4.0 * r / (pi * modulus) * (std::comp_ellint_2(k) - (1.0 - k * k) * std::comp_ellint_1(k));
    }
    [[nodiscard]] Eigen::VectorXd attraction(const Eigen::VectorXd& gaps) const {
        return (work / range_ * (-gaps.array() / range_).exp()).matrix();
    }

    /// Newton steps of at most 2ρ a gap; `touching` rings have g = 0 and a pressure of their own, the others the
    /// attraction's. What is held beside fixes the displacement: the central gap, or the pressure of the last ring.
    void settle(State& s, Index touching, double held) const {
        for (int step = 0; step < 100; ++step) {
            const Eigen::VectorXd pull = attraction(s.gaps);
            s.pressures.tail(rings_ - touching) = -pull.tail(rings_ - touching);
            const Eigen::VectorXd residual =
                s.gaps - height_.matrix() - response_ * s.pressures + Eigen::VectorXd::Constant(rings_, s.displacement);
            Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(rings_ + 1, rings_ + 1);
            matrix.topLeftCorner(rings_, rings_) = -response_;
            for (Index j = touching; j < rings_; ++j) {
                matrix.col(j).head(rings_) *= pull[j] / range_;
                matrix(j, j) += 1.0;
            }
            matrix.col(rings_).head(rings_).setOnes();
            matrix(rings_, std::max<Index>(touching - 1, 0)) = 1.0;
            Eigen::VectorXd right(rings_ + 1);
            right << -residual, held - (touching > 0 ? s.pressures[touching - 1] : s.gaps[0]);
            const Eigen::VectorXd change = matrix.partialPivLu().solve(right);
            const Eigen::VectorXd of_gaps = change.segment(touching, rings_ - touching);
            const double largest = of_gaps.cwiseAbs().maxCoeff(), share = std::min(1.0, 2.0 * range_ / largest);
            s.pressures.head(touching) += share * change.head(touching);
            s.gaps.tail(rings_ - touching) += share * of_gaps;
            s.displacement += share * change[rings_];
            if (largest < 1e-11) return;
        }
    }
    [[nodiscard]] Point point_of(const State& s) const {
        const Array1D p = s.pressures.array(), u = (response_ * s.pressures).array();
        return {.displacement = s.displacement,
                .energy = (area_ * (0.5 * p * u - work * (-s.gaps.array() / range_).exp())).sum(),
                .tension = -(p * area_).sum()};
    }

    /// −∫ w exp(−g/ρ) dA of a paraboloid that is far away.
    [[nodiscard]] double undeformed_energy(double displacement) const {
        return -2.0 * pi * work * range_ * std::exp(displacement / range_);
    }
    /// From far to where it would jump and a little further, by the central gap.
    [[nodiscard]] std::vector<Point> apart_branch() const {
        State s{
            .gaps = height_ + 6.0 * range_, .pressures = Eigen::VectorXd::Zero(rings_), .displacement = -6.0 * range_};
        std::vector<Point> branch;
        for (double gap = 6.0 * range_; gap > 0.3 * range_; gap -= 0.05 * range_) {
            settle(s, 0, gap);
            branch.push_back(point_of(s));
            if (branch.size() > 1 && s.displacement < branch[branch.size() - 2].displacement) break;
        }
        return branch;
    }
    /// A JKR contact of a radius, its pressures cut off half a ring within the edge.
    [[nodiscard]] State jkr(double a) const {
        const double punch = std::sqrt(2.0 * pi * a * work / modulus);
        State s{.gaps = Eigen::VectorXd::Zero(rings_),
                .pressures = Eigen::VectorXd::Zero(rings_),
                .displacement = a * a - punch};
        for (Index i = 0; i < rings_; ++i) {
            const double r = place_[i];
            if (r < a) {
                const double within = std::sqrt(a * a - r * r + a * width_);
                s.pressures[i] = modulus / pi * (2.0 * within - punch / within);
            } else {
                const double angle = std::asin(a / r);
                s.gaps[i] = 0.5 * r * r - s.displacement - 2.0 / pi * punch * angle +
                            ((2.0 * a * a - r * r) * angle + a * std::sqrt(r * r - a * a)) / pi;
            }
        }
        return s;
    }
    /// From wide contact to where it would part and a little further, by rings of contact.
    [[nodiscard]] std::vector<Point> touching_branch() const {
        constexpr double widest = 1.9;  // zero load is at 1.817
        auto rings = static_cast<Index>(widest / width_);
        auto s = jkr(static_cast<double>(rings) * width_);
        std::vector<Point> branch;
        while (rings > 3) {
            settle(s, rings, -work / range_);
            branch.push_back(point_of(s));
            if (branch.size() > 1 && s.displacement > branch[branch.size() - 2].displacement) break;
            const Index fewer = std::max<Index>(1, rings / 50);
            // the edge moves inwards as it is
            const Index kept = rings_ - fewer;
            s.gaps.head(kept) = s.gaps.tail(kept).eval();
            s.pressures.head(kept) = s.pressures.tail(kept).eval();
            rings -= fewer;
        }
        return branch;
    }
    /// Of a branch whose displacement runs one way, by the cubic through four points.
    [[nodiscard]] static double energy_at(std::vector<Point> branch, double displacement) {
        std::ranges::sort(branch, {}, &Point::displacement);
        const auto above = std::ranges::upper_bound(branch, displacement, {}, &Point::displacement) - branch.begin();
        const auto from = std::clamp<std::ptrdiff_t>(above - 2, 0, std::ssize(branch) - 4);
        double sum = 0.0;
        for (auto i = from; i < from + 4; ++i) {
            double weight = branch[extent(i)].energy;
            for (auto j = from; j < from + 4; ++j)
                if (j != i)
                    weight *= (displacement - branch[extent(j)].displacement) /
                              (branch[extent(i)].displacement - branch[extent(j)].displacement);
            sum += weight;
        }
        return sum;
    }

    double range_, width_ = 0.0;
    Index rings_ = 0;
    Array1D place_, area_, height_;
    Eigen::MatrixXd response_;
};

/// What a JKR sphere at a displacement has less than one apart, in the same units.
inline double jkr_energy(double displacement) {
    const auto too_wide = [&](double a) { return a * a - 2.0 / 3.0 * std::sqrt(6.0 * a) > displacement; };
    double lower = 0.5503212, upper = 4.0;
    while (upper - lower > 1e-14) (too_wide(0.5 * (lower + upper)) ? upper : lower) = 0.5 * (lower + upper);
    const double a = lower, d = displacement;
    return 0.75 * (d * d * a - 2.0 / 3.0 * d * a * a * a + a * a * a * a * a / 5.0) - a * a;
}

}  // namespace setae::half_space
