// SPDX-License-Identifier: GPL-3.0-or-later
#include "adhesive/face_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace setae::half_space {
namespace {

/// A multiplier whose mean is set.
fourier::Multiplier with_mean(fourier::Multiplier multiplier, double mean, double points) {
    const bool held_here = multiplier.first_line == 0 && !multiplier.values.empty();
    if (held_here) multiplier.values[0] = mean / points;
    return multiplier;
}

}  // namespace

fourier::Multiplier stiffness_of_waves(const ElasticOperator& elastic) {
    const auto finite = elastic.multiplier([](double k) { return std::isinf(k) ? 0.0 : k; });
    return with_mean(finite, 0.0, 1.0);
}

FaceModel::FaceModel(const Array2D& shape, const ElasticOperator& elastic, const ModelUnits& units,
                     parallel::Threads threads)
    : filter_(elastic.float_filter(threads)),
      stiffness_(float_multiplier(stiffness_of_waves(elastic), units.length / units.pressure)),
      preconditioner_(
          float_multiplier(with_mean(elastic.multiplier([&](double k) { return 1.0 / (k + elastic.min_stiffness()); }),
                                     1.0 / elastic.min_stiffness(), static_cast<double>(elastic.grid().points())),
                           units.pressure / units.length)),
      units_(units),
      rows_(elastic.slab(), shape.cols(), threads) {
    for (auto* map : {&step_, &stiff_step_, &residual_, &preconditioned_, &direction_, &stiff_direction_})
        *map = MapOf<Real>::Zero(shape.rows(), shape.cols());
}

void FaceModel::precondition(const Scaled& problem, Real length, Real hold) {
    auto before = rows_.sums<2>(), after = rows_.sums<2>();
    const auto load = [&](Index i, Real* line) {
        auto r = row(residual_, i);
        Real largest = 0;
        if (length != Real(0)) {
            const auto p = row(direction_, i);
            const auto Kp = row(stiff_direction_, i);
            auto d = row(step_, i);
            d += length * p;
            row(stiff_step_, i) += length * Kp;
            r -= length * row(problem.face, i) * (Kp + row(problem.slopes, i) * p - hold);
            largest = d.abs().maxCoeff();
        }
        before.store(i, {static_cast<double>(r.square().sum()), static_cast<double>(largest)});
        RowOf<Real>(line, r.size()) = r;
    };
    const auto store = [&](Index i, const Real* line) {
        auto z = row(preconditioned_, i);
        z = row(problem.face, i) * ConstRowOf<Real>(line, z.size());
        after.store(i, {static_cast<double>(z.sum()), static_cast<double>((z * row(residual_, i)).sum())});
    };
    filter_.apply(preconditioner_, load, store);
    ++transforms_;
    residual_power_ = before.sum(0);
    largest_ = before.largest(1);
    mean_preconditioned_ = problem.mean_held ? after.sum(0) / count_ : 0.0;
    product_ = after.sum(1);
}

void FaceModel::apply_hessian(const Scaled& problem, Real along_last) {
    const auto mean_preconditioned = static_cast<Real>(mean_preconditioned_);
    auto directions = rows_.sums<1>();
    auto responses = rows_.sums<2>();
    const auto load = [&](Index i, Real* line) {
        auto p = row(direction_, i);
        p = row(problem.face, i) * (row(preconditioned_, i) - mean_preconditioned) + along_last * p;
        directions.store(i, {static_cast<double>(p.sum())});
        RowOf<Real>(line, p.size()) = p;
    };
    const auto store = [&](Index i, const Real* line) {
        const auto p = row(direction_, i);
        auto Kp = row(stiff_direction_, i);
        Kp = ConstRowOf<Real>(line, Kp.size());
        const auto Hp = Kp + row(problem.slopes, i) * p;
        responses.store(i,
                        {static_cast<double>((p * Hp).sum()), static_cast<double>((row(problem.face, i) * Hp).sum())});
    };
    filter_.apply(stiffness_, load, store);
    ++transforms_;
    const double sum = directions.sum(), mean = sum / rows_.points();
    curvature_ = responses.sum(0);
    if (problem.mean_held) {
        hold_ = responses.sum(1) / count_;
    } else {
        curvature_ += problem.control_stiffness * mean * sum;
        hold_ = -problem.control_stiffness * mean;
    }
}

FaceModel::Real FaceModel::reach(Real radius) {
    return static_cast<Real>(-rows_.largest([&](Index i) {
        const auto d = row(step_, i);
        const auto p = row(direction_, i);
        Real least = std::numeric_limits<Real>::infinity();
        for (Index j = 0; j < d.size(); ++j)
            if (p[j] != Real(0))
                least = std::min(least, (radius - std::copysign(Real(1), p[j]) * d[j]) / std::abs(p[j]));
        return -static_cast<double>(least);
    }));
}

void FaceModel::move(Real length) {
    rows_.each([&](Index i) {
        row(step_, i) += length * row(direction_, i);
        row(stiff_step_, i) += length * row(stiff_direction_, i);
    });
}

void FaceModel::load(const FaceProblem& problem) {
    count_ = problem.points;
    rows_.each([&](Index i) {
        for (auto* map : {&step_, &stiff_step_, &direction_}) row(*map, i).setZero();
        row(residual_, i) =
            row(problem.face, i) * ((problem.level - row(problem.gradient, i)) / units_.pressure).cast<Real>();
    });
}

FaceOutcome FaceModel::descend(const Scaled& problem, int max_iterations) {
    FaceOutcome outcome;
    precondition(problem, 0, 0);
    double along_last = 0.0;
    for (int k = 0; k < max_iterations && std::sqrt(residual_power_ / count_) > problem.tolerance; ++k) {
        apply_hessian(problem, static_cast<Real>(along_last));
        const double before = product_;
        if (!(curvature_ > 0.0)) {
            move(reach(problem.radius));
            outcome.curves_down = true;
            return outcome;
        }
        const auto length = static_cast<Real>(before / curvature_);
        precondition(problem, length, static_cast<Real>(hold_));
        if (largest_ > problem.radius) {
            move(-length);
            move(reach(problem.radius));
            outcome.at_radius = true;
            return outcome;
        }
        along_last = product_ / before;
    }
    return outcome;
}

FaceOutcome FaceModel::minimise(const FaceProblem& problem) {
    load(problem);
    if (count_ == 0.0) return {};
    return descend({.face = problem.face,
                    .slopes = problem.slopes,
                    .mean_held = problem.mean_held,
                    .control_stiffness = problem.control_stiffness * units_.length / units_.pressure,
                    .radius = static_cast<Real>(problem.radius / units_.length),
                    .tolerance = problem.tolerance / units_.pressure},
                   problem.max_iterations);
}

}  // namespace setae::half_space
