// SPDX-License-Identifier: GPL-3.0-or-later
#include "patch_multigrid.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/core/extent.hpp"

namespace setae::processing {
namespace {

constexpr double converged = 1e-13;
constexpr int max_steps = 400;
constexpr Index coarsest_points = 16;
constexpr int coarsest_sweeps = 8;

/// For every fine place along a direction: its coarse place and the next one, with their shares.
struct Steps {
    std::vector<Index> own, other;
    std::vector<double> own_share, other_share;
    Index coarse;

    Steps(Index fine, bool halve, bool wraps, std::array<bool, 2> ends) : coarse(halve ? (fine + 1) / 2 : fine) {
        for (Index i = 0; i < fine; ++i) {
            Index near = halve ? i / 2 : i, next = halve ? (i % 2 == 0 ? near - 1 : near + 1) : near;
            double share = halve ? 0.25 : 0.0, mine = 1.0 - share;
            if (wraps) {
                next = (next + coarse) % coarse;
            } else if (next < 0 || next >= coarse) {
                if (ends[next < 0 ? 0 : 1]) mine = 1.0;  // the map ends: no slope across its border
                share = 0.0;
                next = near;
            }
            own.push_back(near);
            other.push_back(next);
            own_share.push_back(mine);
            other_share.push_back(share);
        }
    }
};

/// One grid: −sum of couplings to neighbours, diagonal the sum of all with the leaks; couplings are 0 unless both
/// points are unknowns.
struct Level {
    Index nx, ny;
    std::array<bool, 2> wraps;
    std::array<std::array<bool, 2>, 2> ends;
    Couplings nominal;
    Array2D to_x, to_y;  ///< coupling with the next point along x, y (the last one's: across the wrap)
    Array2D leak_x, leak_y;
    Array2D inverse;  ///< 1/diagonal, 0 for other points
    Array2D value, right, rest;

    Level(Index rows, Index columns, const PatchBox& box, const Couplings& couplings)
        : nx(rows), ny(columns), wraps(box.wraps), ends(box.ends), nominal(couplings) {
        for (Array2D* field : {&to_x, &to_y, &leak_x, &leak_y, &inverse, &value, &right, &rest}) field->setZero(nx, ny);
    }

    void set_diagonal() {
        Array2D diagonal = leak_x + leak_y + to_x + to_y;
        if (nx > 1) diagonal.bottomRows(nx - 1) += to_x.topRows(nx - 1);
        if (ny > 1) diagonal.rightCols(ny - 1) += to_y.leftCols(ny - 1);
        if (wraps[0]) diagonal.row(0) += to_x.row(nx - 1);
        if (wraps[1]) diagonal.col(0) += to_y.col(ny - 1);
        inverse = (diagonal > 0.0).select(1.0 / diagonal, 0.0);
    }

    /// Sum of couplings times values of the neighbours.
    [[nodiscard]] double neighbours(const Array2D& field, Index i, Index j) const {
        double sum = 0.0;
        if (i + 1 < nx) sum += to_x(i, j) * field(i + 1, j);
        else if (wraps[0]) sum += to_x(i, j) * field(0, j);
        if (i > 0) sum += to_x(i - 1, j) * field(i - 1, j);
        else if (wraps[0]) sum += to_x(nx - 1, j) * field(nx - 1, j);
        if (j + 1 < ny) sum += to_y(i, j) * field(i, j + 1);
        else if (wraps[1]) sum += to_y(i, j) * field(i, 0);
        if (j > 0) sum += to_y(i, j - 1) * field(i, j - 1);
        else if (wraps[1]) sum += to_y(i, ny - 1) * field(i, ny - 1);
        return sum;
    }
    /// Sum for points away from the sides of the box.
    [[nodiscard]] double inner_neighbours(const double* at, const double* x, const double* y) const {
        return (x[0] * at[ny] + x[-ny] * at[-ny]) + (y[0] * at[1] + y[-1] * at[-1]);
    }

    void relax(Index i, Index j) {
        if (inverse(i, j) > 0.0) value(i, j) = (right(i, j) + neighbours(value, i, j)) * inverse(i, j);
    }

    /// Points of one colour in place; backwards is the transpose.
    void sweep(Index colour, bool backwards) {
        for (Index k = 0; k < nx; ++k) {
            const Index i = backwards ? nx - 1 - k : k;
            const Index begin = (i + colour) % 2;
            if (i == 0 || i == nx - 1) {
                const Index count = (ny - begin + 1) / 2;
                for (Index m = 0; m < count; ++m) relax(i, begin + 2 * (backwards ? count - 1 - m : m));
                continue;
            }
            // inner points of one colour are independent, so their order is arbitrary
            const bool left = begin == 0, right_side = (ny - 1 - begin) % 2 == 0 && ny > 1;
            if (left && !backwards) relax(i, 0);
            if (right_side && backwards) relax(i, ny - 1);
            double* values = &value(i, 0);
            const double *x = &to_x(i, 0), *y = &to_y(i, 0), *b = &right(i, 0), *d = &inverse(i, 0);
            for (Index j = left ? 2 : 1; j < ny - 1; j += 2)
                values[j] = (b[j] + inner_neighbours(values + j, x + j, y + j)) * d[j];
            if (right_side && !backwards) relax(i, ny - 1);
            if (left && backwards) relax(i, 0);
        }
    }

    /// product = A field, 0 for other points.
    void multiply(const Array2D& field, Array2D& product) const {
        for (Index i = 0; i < nx; ++i)
            for (Index j = 0; j < ny; ++j) {
                if (!(inverse(i, j) > 0.0)) {
                    product(i, j) = 0.0;
                    continue;
                }
                const bool inner = i > 0 && j > 0 && i + 1 < nx && j + 1 < ny;
                const double sum =
                    inner ? inner_neighbours(&field(i, j), &to_x(i, j), &to_y(i, j)) : neighbours(field, i, j);
                product(i, j) = field(i, j) / inverse(i, j) - sum;
            }
    }

    void find_rest() {
        multiply(value, rest);
        rest = right - rest;
    }
};

class Multigrid {
public:
    Multigrid(const PatchGraph& graph, const PatchBoundary& boundary, const Couplings& couplings) {
        Level finest(graph.box.shape[0], graph.box.shape[1], graph.box, couplings);
        Array2D unknown = Array2D::Zero(finest.nx, finest.ny);
        for (std::size_t r = 0; r < graph.runs.size(); ++r) {
            const Run& run = graph.runs[r];
            unknown.row(run.i).segment(run.first, run.count) = 1.0;
            finest.leak_x.row(run.i).segment(run.first, run.count) =
                boundary.leak_x.segment(graph.run_first[r], run.count).transpose();
            finest.leak_y.row(run.i).segment(run.first, run.count) =
                boundary.leak_y.segment(graph.run_first[r], run.count).transpose();
        }
        for (Index i = 0; i < finest.nx; ++i)
            for (Index j = 0; j < finest.ny; ++j) {
                const bool next_x = i + 1 < finest.nx || (finest.wraps[0] && finest.nx > 1),
                           next_y = j + 1 < finest.ny || (finest.wraps[1] && finest.ny > 1);
                finest.to_x(i, j) = next_x ? couplings.x * unknown(i, j) * unknown((i + 1) % finest.nx, j) : 0.0;
                finest.to_y(i, j) = next_y ? couplings.y * unknown(i, j) * unknown(i, (j + 1) % finest.ny) : 0.0;
            }
        finest.set_diagonal();
        levels_.push_back(std::move(finest));
        while (levels_.back().nx * levels_.back().ny > coarsest_points && coarsen()) {
        }
    }

    [[nodiscard]] Level& finest() { return levels_.front(); }

    /// value ≈ A⁻¹ right on the finest grid.
    void cycle(std::size_t number = 0) {
        Level& level = levels_[number];
        level.value.setZero();
        const bool coarsest = number + 1 == levels_.size();
        for (int k = 0; k < (coarsest ? coarsest_sweeps : 1); ++k) {
            level.sweep(0, false);
            level.sweep(1, false);
        }
        if (!coarsest) {
            level.find_rest();
            Level& below = levels_[number + 1];
            below.right.setZero();
            transfer(
                number, [](double& fine, double& coarse, double share) { coarse += share * fine; }, level.rest,
                below.right);
            cycle(number + 1);
            transfer(
                number, [](double& fine, double& coarse, double share) { fine += share * coarse; }, level.value,
                below.value);
        }
        for (int k = 0; k < (coarsest ? coarsest_sweeps : 1); ++k) {
            level.sweep(1, true);
            level.sweep(0, true);
        }
    }

private:
    /// Visits every unknown with its coarse unknowns.
    template <class Visit>
    void transfer(std::size_t number, const Visit& visit, Array2D& fine, Array2D& coarse) {
        const Level& level = levels_[number];
        const Steps &x = steps_[number][0], &y = steps_[number][1];
        for (Index i = 0; i < level.nx; ++i) {
            const std::size_t a = extent(i);
            const double own_x = x.own_share[a], other_x = x.other_share[a];
            for (Index j = 0; j < level.ny; ++j) {
                if (!(level.inverse(i, j) > 0.0)) continue;
                const std::size_t b = extent(j);
                visit(fine(i, j), coarse(x.own[a], y.own[b]), own_x * y.own_share[b]);
                visit(fine(i, j), coarse(x.other[a], y.own[b]), other_x * y.own_share[b]);
                visit(fine(i, j), coarse(x.own[a], y.other[b]), own_x * y.other_share[b]);
                visit(fine(i, j), coarse(x.other[a], y.other[b]), other_x * y.other_share[b]);
            }
        }
    }

    bool coarsen() {
        const Level& fine = levels_.back();
        const bool halve_x = fine.nx > 1 && (fine.ny == 1 || fine.nominal.x > 0.5 * fine.nominal.y),
                   halve_y = fine.ny > 1 && (fine.nx == 1 || fine.nominal.y > 0.5 * fine.nominal.x);
        const Steps x(fine.nx, halve_x, fine.wraps[0], fine.ends[0]), y(fine.ny, halve_y, fine.wraps[1], fine.ends[1]);
        Couplings nominal = fine.nominal;
        if (halve_x != halve_y) (halve_x ? nominal.x : nominal.y) *= 0.5, (halve_x ? nominal.y : nominal.x) *= 2.0;
        PatchBox box;
        box.wraps = fine.wraps;
        box.ends = fine.ends;
        Level coarse(x.coarse, y.coarse, box, nominal);
        for (Index i = 0; i < fine.nx; ++i)
            for (Index j = 0; j < fine.ny; ++j) {
                if (!(fine.inverse(i, j) > 0.0)) continue;
                const Index ci = x.own[extent(i)], cj = y.own[extent(j)];
                const Index next_i = x.own[extent((i + 1) % fine.nx)], next_j = y.own[extent((j + 1) % fine.ny)];
                if (next_i != ci) coarse.to_x(ci, cj) += (halve_x ? 0.5 : 1.0) * fine.to_x(i, j);
                if (next_j != cj) coarse.to_y(ci, cj) += (halve_y ? 0.5 : 1.0) * fine.to_y(i, j);
                // the coarse point is half a step further from the border
                coarse.leak_x(ci, cj) +=
                    halve_x ? fine.leak_x(i, j) / (1.0 + 0.5 * fine.leak_x(i, j) / fine.nominal.x) : fine.leak_x(i, j);
                coarse.leak_y(ci, cj) +=
                    halve_y ? fine.leak_y(i, j) / (1.0 + 0.5 * fine.leak_y(i, j) / fine.nominal.y) : fine.leak_y(i, j);
            }
        coarse.set_diagonal();
        steps_.push_back({x, y});
        levels_.push_back(std::move(coarse));
        return halve_x || halve_y;
    }

    std::vector<Level> levels_;
    std::vector<std::array<Steps, 2>> steps_;
};

double product(const Array2D& a, const Array2D& b) { return (a * b).sum(); }

}  // namespace

Array1D solve_by_multigrid(const PatchGraph& graph, const PatchBoundary& boundary, const Couplings& couplings) {
    Multigrid grids(graph, boundary, couplings);
    Level& finest = grids.finest();
    for (std::size_t r = 0; r < graph.runs.size(); ++r) {
        const Run& run = graph.runs[r];
        finest.right.row(run.i).segment(run.first, run.count) =
            boundary.right.segment(graph.run_first[r], run.count).transpose();
    }
    Array2D solution = Array2D::Zero(finest.nx, finest.ny), direction, image(finest.nx, finest.ny);
    double before = 0.0;
    for (int step = 0;; ++step) {
        // the right-hand side of the finest grid is the residual of the current solution
        grids.cycle();
        const double gain = product(finest.right, finest.value);
        if (finest.value.abs().maxCoeff() <= converged * boundary.range || gain == 0.0) break;
        if (step == max_steps)
            throw InternalError(fmt::format(
                "filling {} undefined points: no solution was found within {} steps; please report this error",
                graph.points, max_steps));
        if (step == 0) direction = finest.value;
        else direction = finest.value + (gain / before) * direction;
        finest.multiply(direction, image);
        const double length = gain / product(direction, image);
        solution += length * direction;
        finest.right -= length * image;
        before = gain;
    }
    Array1D values(graph.points);
    for (std::size_t r = 0; r < graph.runs.size(); ++r)
        values.segment(graph.run_first[r], graph.runs[r].count) =
            solution.row(graph.runs[r].i).segment(graph.runs[r].first, graph.runs[r].count).transpose();
    return values;
}

}  // namespace setae::processing
