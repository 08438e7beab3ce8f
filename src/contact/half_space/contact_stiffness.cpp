// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <optional>

#include "row_passes.hpp"
#include "set_model.hpp"
#include "setae/half_space/hard_wall.hpp"

namespace setae::half_space {
namespace {

/// For the residual; the result then has twice as many exact digits.
constexpr double stiffness_tolerance = 1e-6;
/// Reduction by gradients in float before the residual is computed again in double.
constexpr double reduction = 1e-3;
constexpr Index max_iterations = 500;

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

    // G s = 1 on the set, by gradients in float and residuals in double
    const ModelUnits units{.length = 1.0, .pressure = preconditioner.greatest_stiffness()};
    SetModel model(response, response.compliance(), preconditioner, units, set, threads);
    const RowPasses rows(response.slab(), set.cols(), threads);
    rows.each([&](Index i) { model.face(i) = row(set, i).cast<float>(); });
    Array2D s = Array2D::Zero(set.rows(), set.cols()), left = set;
    double square = points;
    for (Index iterations = 0;
         square > stiffness_tolerance * stiffness_tolerance * points && iterations < max_iterations;) {
        rows.each([&](Index i) { model.residual(i) = row(left, i).cast<float>(); });
        const Index taken = model.reduce({.points = points,
                                          .square = square,
                                          .load_held = false,
                                          .reduction = reduction,
                                          .max_iterations = max_iterations - iterations});
        if (taken == 0) break;
        iterations += taken;
        auto squares = rows.sums<1>();
        response.apply(
            response.compliance(),
            [&](Index i, double* line) {
                row(s, i) += units.pressure * model.change(i).cast<double>();
                Row(line, s.cols()) = row(s, i);
            },
            [&](Index i, const double* line) {
                row(left, i) = row(set, i) * (1.0 - ConstRow(line, s.cols()));
                squares.store(i, {row(left, i).square().sum()});
            });
        square = squares.sum();
    }
    // 2 Σ s − s·G s, whose error is that of the residual squared
    return rows.sum([&](Index i) { return (row(s, i) * (1.0 + row(left, i))).sum(); }) /
           static_cast<double>(set.size());
}

}  // namespace setae::half_space
