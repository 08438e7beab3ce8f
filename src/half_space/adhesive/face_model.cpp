// SPDX-License-Identifier: GPL-3.0-or-later
#include "adhesive/face_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace setae::half_space {
namespace {

/// A multiplier whose mean is set.
fourier::Multiplier with_mean(fourier::Multiplier multiplier, double mean, Index points) {
    multiplier.values[0] = mean / static_cast<double>(points);
    return multiplier;
}

}  // namespace

FaceModel::FaceModel(const Array2D& shape, ElasticOperator& elastic, parallel::Threads threads)
    : elastic_(&elastic),
      stiffness_(with_mean(elastic.multiplier([](double k) { return std::isinf(k) ? 0.0 : k; }), 0.0, shape.size())),
      preconditioner_(with_mean(elastic.multiplier([&](double k) { return 1.0 / (k + elastic.least_stiffness()); }),
                                1.0 / elastic.least_stiffness(), shape.size())),
      rows_(shape, threads),
      residual_(shape),
      preconditioned_(shape),
      direction_(shape),
      stiff_direction_(shape) {}

void FaceModel::precondition(const FaceProblem& problem, Array2D& step, Array2D& stiff_step, double length,
                             double hold) {
    const Array2D& face = problem.face;
    RowSums<2> before(face.rows()), after(face.rows());
    const auto load = [&](Index i, double* line) {
        auto r = row(residual_, i);
        double largest = 0.0;
        if (length != 0.0) {
            const auto p = row(direction_, i);
            const auto Kp = row(stiff_direction_, i);
            auto d = row(step, i);
            d += length * p;
            row(stiff_step, i) += length * Kp;
            r -= length * row(face, i) * (Kp + row(problem.slopes, i) * p - hold);
            largest = d.abs().maxCoeff();
        }
        before.store(i, {r.square().sum(), largest});
        Row(line, r.size()) = r;
    };
    const auto store = [&](Index i, const double* line) {
        auto z = row(preconditioned_, i);
        z = row(face, i) * ConstRow(line, z.size());
        after.store(i, {z.sum(), (z * row(residual_, i)).sum()});
    };
    elastic_->apply(preconditioner_, load, store);
    ++transforms;
    residual_power_ = before.sum(0);
    largest_ = before.largest(1);
    mean_preconditioned_ = problem.mean_held ? after.sum(0) / count_ : 0.0;
    product_ = after.sum(1);
}

void FaceModel::apply_hessian(const FaceProblem& problem, double along_last) {
    const Array2D& face = problem.face;
    RowSums<1> directions(face.rows());
    RowSums<2> responses(face.rows());
    const auto load = [&](Index i, double* line) {
        auto p = row(direction_, i);
        p = row(face, i) * (row(preconditioned_, i) - mean_preconditioned_) + along_last * p;
        directions.store(i, {p.sum()});
        Row(line, p.size()) = p;
    };
    const auto store = [&](Index i, const double* line) {
        const auto p = row(direction_, i);
        auto Kp = row(stiff_direction_, i);
        Kp = ConstRow(line, Kp.size());
        const auto Hp = Kp + row(problem.slopes, i) * p;
        responses.store(i, {(p * Hp).sum(), (row(face, i) * Hp).sum()});
    };
    elastic_->apply(stiffness_, load, store);
    ++transforms;
    const double sum = directions.sum(), mean = sum / static_cast<double>(direction_.size());
    curvature_ = responses.sum(0);
    if (problem.mean_held) {
        hold_ = responses.sum(1) / count_;
    } else {
        curvature_ += problem.control_stiffness * mean * sum;
        hold_ = -problem.control_stiffness * mean;
    }
}

double FaceModel::reach(const Array2D& step, double radius) {
    return -rows_.largest([&](Index i) {
        const auto d = row(step, i);
        const auto p = row(direction_, i);
        double least = std::numeric_limits<double>::infinity();
        for (Index j = 0; j < d.size(); ++j)
            if (p[j] != 0.0) least = std::min(least, (radius - std::copysign(1.0, p[j]) * d[j]) / std::abs(p[j]));
        return -least;
    });
}

void FaceModel::move(Array2D& step, Array2D& stiff_step, double length) {
    rows_.each([&](Index i) {
        row(step, i) += length * row(direction_, i);
        row(stiff_step, i) += length * row(stiff_direction_, i);
    });
}

FaceOutcome FaceModel::minimise(const FaceProblem& problem, Array2D& step, Array2D& stiff_step) {
    FaceOutcome outcome;
    const auto sums = rows_.numbers<2>([&](Index i) {
        for (auto* map : {&step, &stiff_step, &direction_}) row(*map, i).setZero();
        return std::array{row(problem.face, i).sum(), (row(problem.face, i) * row(problem.gradient, i)).sum()};
    });
    count_ = sums.sum(0);
    if (count_ == 0.0) return outcome;
    const double hold = problem.mean_held ? sums.sum(1) / count_ : 0.0;
    rows_.each([&](Index i) { row(residual_, i) = row(problem.face, i) * (hold - row(problem.gradient, i)); });
    precondition(problem, step, stiff_step, 0.0, 0.0);
    outcome.first_residual = std::sqrt(residual_power_ / count_);
    double along_last = 0.0;
    for (int k = 0; k < problem.most_iterations && std::sqrt(residual_power_ / count_) > problem.tolerance; ++k) {
        apply_hessian(problem, along_last);
        const double before = product_;
        if (!(curvature_ > 0.0)) {
            move(step, stiff_step, reach(step, problem.radius));
            outcome.curves_down = true;
            return outcome;
        }
        const double length = before / curvature_;
        precondition(problem, step, stiff_step, length, hold_);
        if (largest_ > problem.radius) {
            move(step, stiff_step, -length);
            move(step, stiff_step, reach(step, problem.radius));
            outcome.at_radius = true;
            return outcome;
        }
        along_last = product_ / before;
    }
    return outcome;
}

}  // namespace setae::half_space
