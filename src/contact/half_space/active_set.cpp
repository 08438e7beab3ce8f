// SPDX-License-Identifier: GPL-3.0-or-later
#include "active_set.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace setae::half_space {
namespace {

/// Largest number of iterations of a set before the next estimate of the set.
constexpr Index max_per_set = 16;
/// A new set whose gap is not smaller than this times the last one's was guessed too boldly.
constexpr double progress_ratio = 0.7;
/// Sets without a new best gap before the solution counts as stuck.
constexpr Index patience = 100;
/// Rounding of displacements, relative to heights and to the response of the longest wave to the mean pressure.
constexpr double rounding = 1e-13;

ModelUnits units_of(double highest, const ElasticOperator& stiffness) {
    const double length = highest > 0.0 ? highest : 1.0, steepest = stiffness.greatest_stiffness();
    return {.length = length, .pressure = length * (steepest > 0.0 ? steepest : 1.0)};
}

}  // namespace

ActiveSetSolver::ActiveSetSolver(ElasticOperator& response, const fourier::Multiplier& compliance,
                                 const ElasticOperator& stiffness, const Array2D& heights, const Target& target,
                                 parallel::Threads threads)
    : response_(response),
      compliance_(compliance),
      softest_(softest_stiffness(stiffness)),
      heights_(heights),
      target_(target),
      rows_(response.slab(), heights.cols(), threads),
      highest_(rows_.largest([&](Index i) { return heights.row(i).abs().maxCoeff(); })),
      units_(units_of(highest_, stiffness)),
      model_(response, compliance, stiffness, units_, heights, threads),
      p_(heights.rows(), heights.cols()),
      v_(heights.rows(), heights.cols()) {}

/// p − d between 0 and the hardness, d the result of the model.
void ActiveSetSolver::cut_pressures() {
    rows_.each([&](Index i) {
        auto p = row(p_, i);
        p = (p - units_.pressure * model_.change(i).cast<double>()).max(0.0).min(target_.hardness);
    });
    if (target_.mean_pressure) carry_load();
}

/// Scales the pressures that do not flow until they carry the load.
void ActiveSetSolver::carry_load() {
    const double load = *target_.mean_pressure * rows_.points(), hardness = target_.hardness;
    constexpr int max_rounds = 100;  // one is enough where nothing flows
    for (int round = 0; round < max_rounds; ++round) {
        const auto sums = rows_.numbers<3>([&](Index i) {
            double elastic = 0.0, flowing = 0.0, places = 0.0;
            for (Index j = 0; j < p_.cols(); ++j) {
                const double p = p_(i, j);
                (p < hardness ? elastic : flowing) += p;
                places += p < hardness ? 1.0 : 0.0;
            }
            return std::array{elastic, flowing, places};
        });
        const double elastic = sums.sum(0), rest = load - sums.sum(1);
        if (std::abs(rest - elastic) <= 1e-15 * load) return;
        const double factor = elastic > 0.0 ? rest / elastic : 1.0;
        const double share = elastic > 0.0 ? 0.0 : rest / std::max(1.0, sums.sum(2));
        rows_.each([&](Index i) {
            for (Index j = 0; j < p_.cols(); ++j)
                if (p_(i, j) < hardness) p_(i, j) = std::min(hardness, p_(i, j) * factor + share);
        });
        if (std::isinf(hardness)) return;
    }
}

/// v = G p − h, and the sums for the certificate.
void ActiveSetSolver::respond() {
    const Index ny = p_.cols();
    auto sums = rows_.sums<6>();
    response_.apply(
        compliance_, [&](Index i, double* line) { std::copy_n(p_.data() + i * ny, ny, line); },
        [&](Index i, const double* line) {
            const double *p = p_.data() + i * ny, *h = heights_.data() + i * ny;
            double* v = v_.data() + i * ny;
            double load = 0.0, work = 0.0, height_work = 0.0, contact = 0.0, points = 0.0;
            double least = std::numeric_limits<double>::infinity();
            for (Index j = 0; j < ny; ++j) {
                const double value = line[j] - h[j];
                const double elastic = p[j] > 0.0 && p[j] < target_.hardness ? 1.0 : 0.0;
                v[j] = value;
                load += p[j];
                work += p[j] * value;
                height_work += p[j] * h[j];
                contact += elastic * value;
                points += elastic;
                least = std::min(least, value);
            }
            sums.store(i, {load, work, height_work, contact, points, least});
        });
    ++pairs_;
    load_ = sums.sum(0);
    work_ = sums.sum(1);
    elastic_work_ = work_ + sums.sum(2);
    least_ = sums.least(5);
    if (!target_.mean_pressure) level_ = target_.level;
    else level_ = sums.sum(4) > 0.0 ? -sums.sum(3) / sums.sum(4) : -work_ / load_;
    certify();
}

void ActiveSetSolver::certify() {
    const double mean = load_ / rows_.points();
    certificate_ = {.penetration = std::max(0.0, -(least_ + level_))};
    if (target_.mean_pressure) certificate_.load_error = std::abs(mean / *target_.mean_pressure - 1.0);
    if (!(load_ > 0.0)) return;
    const double displacement = std::max(elastic_work_ / load_, rounding * (mean / softest_ + highest_));
    double excess = work_ - load_ * least_;
    if (std::isfinite(target_.hardness)) excess = work_ + load_ * level_ - target_.hardness * overlap_without_flow();
    certificate_.duality_gap = excess / (load_ * displacement);
    if (!target_.mean_pressure) certificate_.level_error = std::abs(work_ / load_ + level_) / displacement;
}

/// Σ min(g, 0), while the penetration is set to that of points that do not flow.
double ActiveSetSolver::overlap_without_flow() {
    const auto sums = rows_.numbers<2>([&](Index i) {
        double overlap = 0.0, least = 0.0;
        for (Index j = 0; j < p_.cols(); ++j) {
            const double g = std::min(0.0, v_(i, j) + level_);
            overlap += g;
            if (p_(i, j) < target_.hardness) least = std::min(least, g);
        }
        return std::array{overlap, least};
    });
    certificate_.penetration = -sums.least(1);
    return sums.sum(0);
}

/// Points under pressure or, unless careful, overlapping; without those that yield under an increasing load. Their
/// gaps, minus the mean for a fixed load, are the residual.
SetModel::Aim ActiveSetSolver::choose_set(bool careful) {
    const Index ny = p_.cols();
    const double hardness = target_.hardness;
    const auto sums = rows_.numbers<3>([&](Index i) {
        const double *p = p_.data() + i * ny, *v = v_.data() + i * ny;
        float* face = model_.face(i).data();
        double points = 0.0, sum = 0.0, square = 0.0;
        for (Index j = 0; j < ny; ++j) {
            const double g = v[j] + level_;
            const bool pressed = p[j] > 0.0 || (!careful && g < 0.0);
            const bool flows = p[j] >= hardness && (careful || g <= 0.0);
            const double inside = pressed && !flows ? 1.0 : 0.0;
            face[j] = static_cast<float>(inside);
            points += inside;
            sum += inside * g;
            square += inside * g * g;
        }
        return std::array{points, sum, square};
    });
    const double points = sums.sum(0), mean = target_.mean_pressure && points > 0.0 ? sums.sum(1) / points : 0.0;
    rows_.each([&](Index i) {
        model_.residual(i) = model_.face(i) * ((row(v_, i) + (level_ - mean)) / units_.length).cast<float>();
    });
    return {.points = points,
            .square = std::max(0.0, sums.sum(2) - points * mean * mean) / (units_.length * units_.length),
            .load_held = target_.mean_pressure.has_value()};
}

/// The step of steepest descent along the gaps of points pressed or overlapping: how far the careful mode presses
/// points that overlap.
double ActiveSetSolver::activation_step() {
    const Index ny = p_.cols();
    const auto gap = [&](Index i, Index j) {
        const double g = v_(i, j) + level_;
        return p_(i, j) > 0.0 || g < 0.0 ? g : 0.0;
    };
    auto squares = rows_.sums<1>();
    const double curvature = response_.quadratic_form(compliance_, [&](Index i, double* line) {
        double square = 0.0;
        for (Index j = 0; j < ny; ++j) {
            line[j] = gap(i, j);
            square += line[j] * line[j];
        }
        squares.store(i, {square});
    });
    ++pairs_;
    return curvature > 0.0 ? squares.sum() / curvature : 0.0;
}

void ActiveSetSolver::activate(double step) {
    rows_.each([&](Index i) {
        for (Index j = 0; j < p_.cols(); ++j) {
            const double g = v_(i, j) + level_;
            const bool overlaps = p_(i, j) <= 0.0 && g < 0.0, recovers = p_(i, j) >= target_.hardness && g > 0.0;
            if (overlaps || recovers) model_.change(i)[j] = static_cast<float>(step * g / units_.pressure);
        }
    });
}

SolveStatus ActiveSetSolver::solve(double tolerance, Index max_iterations,
                                   const std::function<void(const SolveProgress&)>& report) {
    Index most = max_per_set, without_progress = 0;
    double last = std::numeric_limits<double>::infinity(), best = last;
    while (true) {
        cut_pressures();
        respond();
        const bool apart = !(load_ > 0.0), overlaps = certificate_.penetration > 0.0;
        const double error = !apart     ? std::max(certificate_.duality_gap, certificate_.level_error)
                             : overlaps ? std::numeric_limits<double>::infinity()
                                        : 0.0;
        const auto& grid = response_.grid();
        if (report) report({.nx = grid.nx, .ny = grid.ny, .iterations = iterations_, .duality_gap = error});
        if (error <= tolerance) return SolveStatus::converged;
        without_progress = error < best ? 0 : without_progress + 1;
        best = std::min(best, error);
        if (iterations_ >= max_iterations || without_progress > patience) return SolveStatus::not_converged;
        most = error > progress_ratio * last ? most / 2 : std::min(max_per_set, std::max<Index>(1, 2 * most));
        const bool remembers = error <= progress_ratio * last;
        last = error;
        const bool careful = most == 0;
        auto aim = choose_set(careful);
        const double activation = careful ? activation_step() : 0.0;
        aim.max_iterations = careful ? 1 : most;
        aim.remembers = remembers && !careful;
        iterations_ += model_.reduce(aim);
        if (careful) {
            model_.forget();
            activate(activation);
        }
    }
}

}  // namespace setae::half_space
