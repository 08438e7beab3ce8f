// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/half_space/hard_wall.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include <fmt/format.h>

#include "active_set.hpp"
#include "row_passes.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/summation.hpp"

namespace setae::half_space {
namespace {

/// For results of a coarser grid, whose own error is larger.
constexpr double coarse_tolerance = 1e-3;

double mean_of(const Array2D& map, const RowPasses& rows) {
    return rows.sum([&](Index i) { return pairwise_sum(row(map, i)); }) / rows.points();
}

/// Reports the pixel of the whole map that is not finite, from any of the processes.
void require_heights(const Array2D& heights, const RowPasses& rows) {
    constexpr double none = -1.0;
    const auto found = rows.numbers<2>([&](Index i) {
        for (Index j = 0; j < heights.cols(); ++j)
            if (!std::isfinite(heights(i, j))) return std::array{static_cast<double>(j), heights(i, j)};
        return std::array{none, 0.0};
    });
    for (Index i = 0; i < found.rows(); ++i)
        if (const double column = found.at(i); column != none)
            throw InvalidArgument(
                fmt::format("the height at pixel ({}, {}) is {}; expected finite heights: fill undefined ones first", i,
                            column, found.at(i, 1)));
}

void require_positive(double value, const char* what, const char* unit) {
    if (!(value > 0.0) || !std::isfinite(value))
        throw InvalidArgument(fmt::format("{} must be > 0 and finite, got {} {}", what, value, unit));
}

void require_start(const Array2D& start, const Grid& grid, const parallel::Slab& slab) {
    require_shape(start, grid, slab, "initial pressures");
    if (slab.anywhere(!start.allFinite()) || !slab.anywhere(start.maxCoeff() > 0.0))
        throw InvalidArgument("the initial pressures are not finite or nowhere > 0; expected those of another load");
}

/// Target of the grids, and whether the mean of the displacements is left out: as in MeanGap, which fixes it.
struct Aim {
    Target target;
    bool without_mean = false;
};

/// highest, mean: of the heights.
Aim aim_of(const HardWall& problem, double highest, double mean, MeanDisplacement mean_displacement) {
    Aim aim;
    if (problem.hardness) {
        require_positive(*problem.hardness, "hardness", "Pa");
        aim.target.hardness = *problem.hardness;
    }
    if (const auto* pressure = std::get_if<MeanPressure>(&problem.control)) {
        require_positive(pressure->value, "mean pressure", "Pa");
        if (pressure->value >= aim.target.hardness)
            throw InvalidArgument(
                fmt::format("a hardness of {} Pa does not carry a mean pressure of {} Pa; expected a "
                            "lower pressure",
                            aim.target.hardness, pressure->value));
        aim.target.mean_pressure = pressure->value;
    } else if (const auto* gap = std::get_if<MeanGap>(&problem.control)) {
        require_positive(gap->value, "mean gap", "m");
        if (problem.edges != Edges::periodic)
            throw InvalidArgument("a mean gap is given for free edges; expected a pressure or a displacement");
        aim.target.level = gap->value + mean;
        aim.without_mean = true;
    } else {
        const double displacement = std::get<Displacement>(problem.control).value;
        if (!std::isfinite(displacement))
            throw InvalidArgument(fmt::format("displacement must be finite, got {} m", displacement));
        if (problem.edges == Edges::periodic && mean_displacement != MeanDisplacement::finite &&
            displacement >= highest - mean && highest > mean)
            throw InvalidArgument(
                fmt::format("a displacement of {} m: full contact is reached below {} m, where the pressure increases "
                            "without limit; give the pressure instead",
                            displacement, highest - mean));
        aim.target.level = highest - displacement;
    }
    return aim;
}

struct Level {
    Grid grid;
    Array2D heights;
};

bool halves(Index side) { return parallel::coarsest_side_of(side, coarsest_side) < side; }

/// The grid of half as many points along every side that may be halved, heights averaged; none where neither may.
std::optional<Level> coarser(const Grid& grid, const Array2D& heights) {
    const Index step_x = halves(grid.nx) ? 2 : 1, step_y = halves(grid.ny) ? 2 : 1;
    if (step_x * step_y == 1) return std::nullopt;
    Level level{.grid = {grid.nx / step_x, grid.ny / step_y, grid.size_x, grid.size_y}, .heights = {}};
    level.heights = Array2D::Zero(heights.rows() / step_x, level.grid.ny);
    for (Index i = 0; i < heights.rows(); ++i)
        for (Index j = 0; j < grid.ny; ++j) level.heights(i / step_x, j / step_y) += heights(i, j);
    level.heights /= static_cast<double>(step_x * step_y);
    return level;
}

/// Every pixel gets the pressure of the larger one that contains it.
void inject(const Array2D& coarse, Array2D& fine) {
    const Index step_x = fine.rows() / coarse.rows(), step_y = fine.cols() / coarse.cols();
    for (Index i = 0; i < fine.rows(); ++i)
        for (Index j = 0; j < fine.cols(); ++j) fine(i, j) = coarse(i / step_x, j / step_y);
}

/// One grid with its operators and its solver.
class LevelSolve {
public:
    LevelSolve(const HardWall& problem, const Grid& grid, const Array2D& heights, const Aim& aim,
               const SolveOptions& options)
        : response_(grid, problem.body, problem.edges, options.threads, options.ranks) {
        const auto threads = options.threads;
        if (problem.edges != Edges::periodic)
            preconditioner_ = std::make_unique<ElasticOperator>(grid, problem.body, Edges::periodic, threads);
        if (aim.without_mean)
            without_mean_ = response_.multiplier([zero = stiffness(0.0, problem.body)](double k) {
                return k > 0.0 && std::isfinite(k) && k != zero ? 1.0 / k : 0.0;
            });
        solver_ = std::make_unique<ActiveSetSolver>(
            response_, aim.without_mean ? *without_mean_ : response_.compliance(),
            preconditioner_ ? *preconditioner_ : response_, heights, aim.target, threads);
    }
    [[nodiscard]] ActiveSetSolver& solver() { return *solver_; }
    [[nodiscard]] const ElasticOperator& response() const { return response_; }

private:
    ElasticOperator response_;
    std::unique_ptr<ElasticOperator> preconditioner_;
    std::optional<fourier::Multiplier> without_mean_;
    std::unique_ptr<ActiveSetSolver> solver_;
};

/// Pressures of the coarser grids, coarsest first, on the finest of them.
std::optional<Array2D> first_guess(const HardWall& problem, const Aim& aim, const SolveOptions& options) {
    std::vector<Level> levels;
    auto next = coarser(problem.grid, problem.heights);
    while (next) {
        levels.push_back(std::move(*next));
        next = coarser(levels.back().grid, levels.back().heights);
    }
    std::optional<Array2D> guess;
    for (auto level = levels.rbegin(); level != levels.rend(); ++level) {
        LevelSolve stage(problem, level->grid, level->heights, aim, options);
        auto& pressures = stage.solver().pressures();
        if (guess) inject(*guess, pressures);
        else pressures.setConstant(aim.target.mean_pressure.value_or(0.0));
        stage.solver().solve(std::max(coarse_tolerance, options.tolerance), options.max_iterations, options.progress);
        guess = std::move(pressures);
    }
    return guess;
}

/// Pressure on the rim of a map with free edges means that contact would continue beyond it.
void require_free_rim(const Array2D& pressures, Edges edges) {
    const bool along_x = edges == Edges::free || edges == Edges::periodic_along_y,
               along_y = edges == Edges::free || edges == Edges::periodic_along_x;
    const double x = std::max(pressures.row(0).maxCoeff(), pressures.bottomRows(1).maxCoeff()),
                 y = std::max(pressures.col(0).maxCoeff(), pressures.rightCols(1).maxCoeff());
    const double largest = std::max(along_x ? x : 0.0, along_y ? y : 0.0);
    if (largest > 0.0)
        throw InvalidArgument(
            fmt::format("the rim of the map touches with {} Pa although its edges are free; expected a map larger than "
                        "the contact, a lower load or periodic edges",
                        largest));
}

}  // namespace

HardWallContact solve(const HardWall& problem, const SolveOptions& options) {
    require(problem.grid);
    require(problem.body);
    const auto slab = slab_of(problem.grid, options.ranks);
    require_shape(problem.heights, problem.grid, slab, "heights");
    const RowPasses rows(slab, problem.grid.ny, options.threads);
    require_heights(problem.heights, rows);
    require_positive(options.tolerance, "tolerance", "");
    HardWallContact contact;
    contact.mean_displacement =
        ElasticOperator({1, 1, problem.grid.size_x, problem.grid.size_y}, problem.body).mean_displacement();
    const double highest = rows.largest([&](Index i) { return row(problem.heights, i).maxCoeff(); });
    const Aim aim = aim_of(problem, highest, mean_of(problem.heights, rows), contact.mean_displacement);
    const bool started = options.start.size() > 0;
    if (started) require_start(options.start, problem.grid, slab);
    const auto guess = options.nested_grids && !started ? first_guess(problem, aim, options) : std::nullopt;
    LevelSolve stage(problem, problem.grid, problem.heights, aim, options);
    ActiveSetSolver& solver = stage.solver();
    if (started) solver.pressures() = options.start;
    else if (guess) inject(*guess, solver.pressures());
    else solver.pressures().setConstant(aim.target.mean_pressure.value_or(0.0));
    contact.status = solver.solve(options.tolerance, options.max_iterations, [&](SolveProgress progress) {
        progress.last_grid = true;
        if (options.progress) options.progress(progress);
    });
    contact.mean_displacement = stage.response().mean_displacement();
    contact.certificate = solver.certificate();
    contact.iterations = solver.iterations();
    contact.transform_pairs = solver.transform_pairs();
    contact.gaps = solver.gaps();
    contact.pressures = std::move(solver.pressures());
    require_free_rim(contact.pressures, problem.edges);
    const double pixel = problem.grid.pixel_area();
    if (problem.hardness) {
        const auto flowing = (contact.pressures >= *problem.hardness).eval();
        contact.flowing_area = rows.sum([&](Index i) { return static_cast<double>(flowing.row(i).count()); }) * pixel;
        contact.deepest_dent =
            rows.largest([&](Index i) { return flowing.row(i).select(-contact.gaps.row(i), 0.0).maxCoeff(); });
    }
    contact.gaps = contact.gaps.max(0.0);
    contact.mean_gap = mean_of(contact.gaps, rows);
    contact.mean_pressure = mean_of(contact.pressures, rows);
    contact.displacement = highest - solver.level();
    contact.stored_energy = 0.5 * solver.elastic_work() * pixel;
    if (aim.without_mean && contact.mean_displacement == MeanDisplacement::finite) {
        const double mean = contact.mean_pressure / stiffness(0.0, problem.body);
        contact.displacement += mean;
        contact.stored_energy += 0.5 * contact.mean_pressure * mean * problem.grid.area();
    }
    contact.area = contact_area(contact.pressures, problem.grid, slab, problem.edges);
    return contact;
}

}  // namespace setae::half_space
