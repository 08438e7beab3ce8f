// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>

#include "row_passes.hpp"
#include "set_model.hpp"
#include "setae/half_space/elastic_operator.hpp"
#include "setae/half_space/hard_wall.hpp"

namespace setae::half_space {

/// Prescribed quantity on one grid.
struct Target {
    std::optional<double> mean_pressure;  ///< [Pa]; absent: the level is
    double level = 0.0;                   ///< c [m] of g = G p − h + c
    double hardness = std::numeric_limits<double>::infinity();
};

/// Solves the contact of one grid: see solve() for the method.
///
/// Three maps: heights, pressures and G p − h, and five of the model's in float. Every pass over them rides along with
/// a transform but for four of each new set.
class ActiveSetSolver {
public:
    /// `response`: G. `stiffness`: the operator of the preconditioner, of periodic edges; may be the same.
    ActiveSetSolver(ElasticOperator& response, const fourier::Multiplier& compliance, const ElasticOperator& stiffness,
                    const Array2D& heights, const Target& target, parallel::Threads threads);

    /// Starts from the content of pressures(). `report` is called for every new set.
    SolveStatus solve(double tolerance, Index max_iterations, const std::function<void(const SolveProgress&)>& report);

    [[nodiscard]] Array2D& pressures() { return p_; }
    /// g, negative where the body overlaps or flows.
    [[nodiscard]] Array2D gaps() const { return v_ + level_; }
    [[nodiscard]] double level() const { return level_; }
    /// Σ p G p.
    [[nodiscard]] double elastic_work() const { return elastic_work_; }
    [[nodiscard]] const Certificate& certificate() const { return certificate_; }
    [[nodiscard]] Index iterations() const { return iterations_; }
    [[nodiscard]] Index transform_pairs() const { return pairs_ + model_.transform_pairs(); }

private:
    void cut_pressures();
    void carry_load();
    void respond();
    void certify();
    double overlap_without_flow();
    SetModel::Aim choose_set(bool careful);
    double activation_step();
    void activate(double step);

    ElasticOperator& response_;
    const fourier::Multiplier& compliance_;
    double softest_;  ///< stiffness of the longest wave [Pa/m]
    const Array2D& heights_;
    Target target_;
    RowPasses rows_;
    double highest_;  ///< max |h|
    ModelUnits units_;
    SetModel model_;
    Array2D p_, v_;
    double level_ = 0.0;
    double load_ = 0.0, work_ = 0.0, elastic_work_ = 0.0, least_ = 0.0;  ///< Σ p, Σ p v, Σ p G p, min v
    Certificate certificate_;
    Index iterations_ = 0, pairs_ = 0;
};

}  // namespace setae::half_space
