// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "row_passes.hpp"
#include "setae/half_space/elastic_operator.hpp"
#include "setae/half_space/hard_wall.hpp"

namespace setae::half_space {

/// What is prescribed on one grid.
struct Target {
    std::optional<double> mean_pressure;  ///< [Pa]; absent: the level is
    double level = 0.0;                   ///< c [m] of g = G p − h + c
    double hardness = std::numeric_limits<double>::infinity();
};

/// Solves the contact of one grid: see solve() for the method.
///
/// Five maps: heights, pressures, G p − h, and direction and its displacement; a byte a pixel for the set. Every pass
/// over them rides along with a transform but for two of each new set.
class ActiveSetSolver {
public:
    /// `response`: G. `stiffness`: the operator of the preconditioner, of periodic edges; may be the same.
    ActiveSetSolver(ElasticOperator& response, const fourier::Multiplier& compliance, ElasticOperator& stiffness,
                    const Array2D& heights, const Target& target, parallel::Threads threads);

    /// From pressures that stand in pressures(). `report` is called for every new set.
    SolveStatus solve(double tolerance, Index most_iterations, const std::function<void(const SolveProgress&)>& report);

    [[nodiscard]] Array2D& pressures() { return p_; }
    /// g, negative where the body overlaps or flows.
    [[nodiscard]] Array2D gaps() const { return v_ + level_; }
    [[nodiscard]] double level() const { return level_; }
    /// Σ p G p.
    [[nodiscard]] double elastic_work() const { return elastic_work_; }
    [[nodiscard]] const Certificate& certificate() const { return certificate_; }
    [[nodiscard]] Index iterations() const { return iterations_; }
    [[nodiscard]] Index transform_pairs() const { return pairs_; }

private:
    struct Residual {
        double points = 0.0;  ///< of the set
        double level = 0.0;   ///< c of r = v + c
        double square = 0.0;  ///< Σ r²
    };
    struct Preconditioned {
        double sum = 0.0;       ///< Σ z
        double coupling = 0.0;  ///< Σ z w, w the response to the last direction
        double response = 0.0;  ///< Σ w on the set
    };
    struct Response {
        double work = 0.0;       ///< Σ t w
        double sum = 0.0;        ///< Σ w on the set, as the next two
        double square = 0.0;     ///< Σ w²
        double product = 0.0;    ///< Σ r w
        double direction = 0.0;  ///< Σ t
        double slope = 0.0;      ///< Σ r t
    };
    void cut_pressures(double step);
    void carry_load();
    void respond();
    void certify();
    double overlap_without_flow();
    Residual choose_set(bool careful);
    Preconditioned precondition(double step, double level);
    Response respond_to_direction(double mean, double memory, double level);
    double reduce_residual(const Residual& start, Index most, bool remembers);
    double activation_step();
    void activate(double step);

    ElasticOperator& response_;
    const fourier::Multiplier& compliance_;
    ElasticOperator& preconditioner_;
    fourier::Multiplier stiffness_;
    const Array2D& heights_;
    Target target_;
    RowPasses rows_;
    Array2D p_, v_, t_, w_;
    std::vector<std::uint8_t> set_;
    double highest_;  ///< max |h|
    double level_ = 0.0;
    double load_ = 0.0, work_ = 0.0, elastic_work_ = 0.0, least_ = 0.0;  ///< Σ p, Σ p v, Σ p G p, min v
    Certificate certificate_;
    double curvature_ = 0.0;  ///< of the last direction
    Index iterations_ = 0, pairs_ = 0;
};

}  // namespace setae::half_space
