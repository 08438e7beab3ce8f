// SPDX-License-Identifier: GPL-3.0-or-later
// Contacts that several processes solve together are those of one, byte by byte and iteration by iteration.
#include <cmath>
#include <cstring>
#include <limits>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/half_space/adhesive_loop.hpp"
#include "setae/half_space/hard_wall.hpp"
#include "setae/parallel/mpi_ranks.hpp"
#include "setae/spectra/self_affine.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace {

using namespace setae;
using namespace setae::half_space;

const parallel::MpiRanks& ranks() {
    static const parallel::MpiRanks made(MPI_COMM_WORLD);
    return made;
}

Array2D heights(const Grid& grid, double rms) {
    const spectra::SelfAffine model{1e-28, 2.0 * pi / 0.25, 0.8, 2.0 * pi / 0.05};
    return synthesis::random_surface(spectra::density(model), {grid.nx, grid.ny, grid.size_x, grid.size_y},
                                     {.key = {7, 1}, .exact_rms_height = rms, .threads = {1}})
        .heights;
}

Array2D own(const Array2D& map, const Grid& grid) {
    const auto slab = slab_of(grid, &ranks());
    return map.middleRows(slab.first(), slab.rows());
}

bool same(const Array2D& mine, const Array2D& whole, const Grid& grid) {
    const Array2D wanted = own(whole, grid);
    return mine.rows() == wanted.rows() && mine.cols() == wanted.cols() &&
           std::memcmp(mine.data(), wanted.data(), static_cast<std::size_t>(mine.size()) * sizeof(double)) == 0;
}

void expect_same(HardWall problem, SolveOptions options = {}) {
    options.threads = {1};
    const auto whole = solve(problem, options);
    problem.heights = own(problem.heights, problem.grid);
    options.ranks = &ranks();
    const auto shared = solve(problem, options);
    EXPECT_TRUE(same(shared.pressures, whole.pressures, problem.grid));
    EXPECT_TRUE(same(shared.gaps, whole.gaps, problem.grid));
    EXPECT_EQ(shared.status, SolveStatus::converged);
    EXPECT_EQ(shared.iterations, whole.iterations);
    EXPECT_EQ(shared.transform_pairs, whole.transform_pairs);
    EXPECT_EQ(shared.certificate.duality_gap, whole.certificate.duality_gap);
    EXPECT_EQ(shared.mean_pressure, whole.mean_pressure);
    EXPECT_EQ(shared.mean_gap, whole.mean_gap);
    EXPECT_EQ(shared.displacement, whole.displacement);
    EXPECT_EQ(shared.stored_energy, whole.stored_energy);
    EXPECT_EQ(shared.flowing_area, whole.flowing_area);
    EXPECT_EQ(shared.deepest_dent, whole.deepest_dent);
    EXPECT_EQ(shared.area.patches, whole.area.patches);
    EXPECT_EQ(shared.area.largest_patch, whole.area.largest_patch);
    EXPECT_EQ(shared.area.perimeter, whole.area.perimeter);
    EXPECT_EQ(shared.area.corrected_fraction, whole.area.corrected_fraction);
}

TEST(HardWallOnRanks, HasTheBytesOfOneProcess) {
    for (const Grid& grid :
         {Grid{256, 128, 1.0, 0.5}, Grid{192, 100, 1.0, 1.0}, Grid{75, 90, 1.0, 1.0}, Grid{81, 77, 1.0, 1.0}}) {
        expect_same({.grid = grid, .body = {1.0, {}}, .heights = heights(grid, 0.01), .control = MeanPressure{0.01}});
        expect_same({.grid = grid, .body = {1.0, {}}, .heights = heights(grid, 0.01), .control = MeanGap{0.02}});
    }
}

TEST(HardWallOnRanks, HasTheBytesOfOneProcessForLayersAndHardness) {
    const Grid grid{128, 64, 1.0, 0.5};
    expect_same({.grid = grid,
                 .body = {1.0, Layer{.thickness = 0.2, .poisson_ratio = 0.4}},
                 .heights = heights(grid, 0.01),
                 .control = Displacement{0.03}});
    expect_same({.grid = grid,
                 .body = {1.0, {}},
                 .heights = heights(grid, 0.01),
                 .control = MeanPressure{0.01},
                 .hardness = 0.15});
}

TEST(HardWallOnRanks, StartsFromGivenPressures) {
    const Grid grid{128, 64, 1.0, 0.5};
    const HardWall lighter{
        .grid = grid, .body = {1.0, {}}, .heights = heights(grid, 0.01), .control = MeanPressure{0.01}};
    auto problem = lighter;
    problem.control = MeanPressure{0.011};
    const auto before = solve(lighter, {.threads = {1}}).pressures;
    const auto whole = solve(problem, {.start = before, .threads = {1}});
    problem.heights = own(problem.heights, grid);
    const auto shared = solve(problem, {.start = own(before, grid), .threads = {1}, .ranks = &ranks()});
    EXPECT_TRUE(same(shared.pressures, whole.pressures, grid));
}

TEST(HardWallOnRanks, RefusesOnAllRanksTogether) {
    const Grid grid{64, 48, 1.0, 1.0};
    const Array2D whole = heights(grid, 0.01);
    HardWall problem{.grid = grid, .body = {1.0, {}}, .heights = own(whole, grid), .control = MeanPressure{0.01}};
    auto undefined_height = problem;
    if (ranks().own() == ranks().count() - 1) undefined_height.heights(0, 3) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW((void)solve(undefined_height, {.ranks = &ranks()}), InvalidArgument);
    auto too_few = problem;
    if (ranks().own() == 0) too_few.heights = Array2D::Zero(1, grid.ny);
    EXPECT_THROW((void)solve(too_few, {.ranks = &ranks()}), InvalidArgument);
    if (ranks().count() == 1) return;
    auto free = problem;
    free.edges = Edges::free;
    EXPECT_THROW((void)solve(free, {.ranks = &ranks()}), InvalidArgument);
    const Grid narrow{2, 48, 1.0, 1.0};
    if (ranks().count() > 2) {
        EXPECT_THROW((void)slab_of(narrow, &ranks()), InvalidArgument);
    }
}

TEST(AdhesiveCellOnRanks, HasTheLoopOfOneProcess) {
    const Grid grid{64, 64, 1.0, 1.0};
    const Array2D map = heights(grid, 0.004);
    const Interaction law{.work_of_adhesion = 1e-3, .range = 0.006};
    AdhesiveCell whole(map, grid, {1.0, {}}, law, {}, {1}),
        shared(own(map, grid), grid, {1.0, {}}, law, {.ranks = &ranks()}, {1});
    EXPECT_EQ(shared.conformal_energy(), whole.conformal_energy());
    const auto expected = adhesive_loop(whole), found = adhesive_loop(shared);
    ASSERT_EQ(found.steps.size(), expected.steps.size());
    for (std::size_t i = 0; i < found.steps.size(); ++i) {
        EXPECT_EQ(found.steps[i].state.tension, expected.steps[i].state.tension);
        EXPECT_EQ(found.steps[i].state.iterations, expected.steps[i].state.iterations);
    }
    EXPECT_TRUE(expected.complete);
    EXPECT_EQ(found.loss(), expected.loss());
    EXPECT_TRUE(same(shared.gaps(), whole.gaps(), grid));
}

}  // namespace
