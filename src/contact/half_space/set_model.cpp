// SPDX-License-Identifier: GPL-3.0-or-later
#include "set_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace setae::half_space {

double softest_stiffness(const ElasticOperator& elastic) {
    return std::max(elastic.min_stiffness(), std::numeric_limits<double>::min());
}

SetModel::SetModel(const ElasticOperator& response, const fourier::Multiplier& compliance,
                   const ElasticOperator& preconditioner, const ModelUnits& units, const Array2D& shape,
                   parallel::Threads threads)
    : filter_(response.float_filter(threads)),
      compliance_(float_multiplier(compliance, units.pressure / units.length)),
      stiffness_(float_multiplier(preconditioner.multiplier([softest = softest_stiffness(preconditioner)](double k) {
          return k > 0.0 && std::isfinite(k) ? k : softest;
      }),
                                  units.length / units.pressure)),
      rows_(response.slab(), shape.cols(), threads) {
    if (&preconditioner != &response) periodic_filter_ = preconditioner.float_filter(threads);
    for (auto* map : {&face_, &residual_, &change_, &direction_, &response_})
        *map = MapOf<float>::Zero(shape.rows(), shape.cols());
}

/// w = z, the preconditioned residual, after subtracting the last step; sums of z and of w before.
SetModel::Preconditioned SetModel::precondition(float step, float mean_response) {
    auto sums = rows_.sums<3>();
    auto& filter = periodic_filter_ ? *periodic_filter_ : filter_;
    filter.apply(
        stiffness_,
        [&](Index i, float* line) {
            auto r = row(residual_, i);
            if (step != 0.0f) {
                row(change_, i) += step * row(direction_, i);
                r -= step * row(face_, i) * (row(response_, i) - mean_response);
            }
            RowOf<float>(line, r.size()) = r;
        },
        [&](Index i, const float* line) {
            const auto face = row(face_, i);
            auto w = row(response_, i);
            const double response = (face * w).sum();
            const auto z = face * ConstRowOf<float>(line, face.size());
            const double coupling = (z * w).sum();
            w = z;
            sums.store(i, {static_cast<double>(w.sum()), coupling, response});
        });
    ++pairs_;
    return {.sum = sums.sum(0), .coupling = sums.sum(1), .response = sums.sum(2)};
}

/// t = w − mean + memory t in the set, w = G t, and the sums of it.
SetModel::Response SetModel::respond(float mean, float memory) {
    auto sums = rows_.sums<4>();
    auto direction = rows_.sums<2>();
    filter_.apply(
        compliance_,
        [&](Index i, float* line) {
            auto t = row(direction_, i);
            t = row(face_, i) * (row(response_, i) - mean + memory * t);
            RowOf<float>(line, t.size()) = t;
            direction.store(i, {static_cast<double>(t.sum()), static_cast<double>((t * row(residual_, i)).sum())});
        },
        [&](Index i, const float* line) {
            const auto face = row(face_, i);
            auto w = row(response_, i);
            w = ConstRowOf<float>(line, face.size());
            sums.store(i, {static_cast<double>((row(direction_, i) * w).sum()), static_cast<double>((face * w).sum()),
                           static_cast<double>((face * w.square()).sum()),
                           static_cast<double>((row(residual_, i) * w).sum())});
        });
    ++pairs_;
    return {.work = sums.sum(0),
            .sum = sums.sum(1),
            .square = sums.sum(2),
            .product = sums.sum(3),
            .direction = direction.sum(0),
            .slope = direction.sum(1)};
}

void SetModel::move(float step) {
    rows_.each([&](Index i) { row(change_, i) += step * row(direction_, i); });
}

Index SetModel::reduce(const Aim& aim) {
    rows_.each([&](Index i) { row(change_, i).setZero(); });
    if (!(aim.square > 0.0)) {
        forget();
        return 0;
    }
    if (!aim.remembers || !(curvature_ > 0.0)) {
        forget();
        rows_.each([&](Index i) {
            row(direction_, i).setZero();
            row(response_, i).setZero();
        });
    }
    Index iterations = 0;
    double step = 0.0, mean_response = 0.0, square = aim.square;
    while (iterations < aim.max_iterations) {
        const auto z = precondition(static_cast<float>(step), static_cast<float>(mean_response));
        step = 0.0;
        const double mean_z = aim.load_held ? z.sum / aim.points : 0.0;
        const double memory = curvature_ > 0.0 ? (mean_z * z.response - z.coupling) / curvature_ : 0.0;
        const auto response = respond(static_cast<float>(mean_z), static_cast<float>(memory));
        mean_response = aim.load_held ? response.sum / aim.points : 0.0;
        curvature_ = response.work - mean_response * response.direction;
        ++iterations;
        if (!(curvature_ > 0.0)) break;
        step = response.slope / curvature_;
        square += step * (step * (response.square - mean_response * response.sum) - 2.0 * response.product);
        if (!(square > aim.reduction * aim.reduction * aim.square)) break;
    }
    if (step != 0.0) move(static_cast<float>(step));
    return iterations;
}

}  // namespace setae::half_space
