// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/synthesis/random_surface_mpi.hpp"

#include <cstring>

#include <gtest/gtest.h>

#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace {

using namespace setae;
using namespace setae::synthesis;

const spectra::SelfAffine model{1e-28, 2.0 * pi / 2e-7, 0.8, 2.0 * pi / 1e-8};

/// Rows with other bytes than those of one process, and how many rows all ranks hold together.
struct Comparison {
    Index different = 0;
    long all_rows = 0;
};

Comparison compare(const SurfaceGrid& grid, const SurfaceOptions& options) {
    const auto slab = random_surface_slab(MPI_COMM_WORLD, spectra::density(model), grid, options);
    const auto whole = random_surface(spectra::density(model), grid, options);
    Comparison result;
    for (Index i = 0; i < slab.heights.rows(); ++i)
        if (std::memcmp(slab.heights.row(i).data(), whole.heights.row(slab.first_row + i).data(),
                        static_cast<std::size_t>(grid.ny) * sizeof(double)) != 0)
            ++result.different;
    const long own = slab.heights.rows();
    MPI_Allreduce(&own, &result.all_rows, 1, MPI_LONG, MPI_SUM, MPI_COMM_WORLD);
    return result;
}

TEST(RandomSurfaceSlab, HasTheBytesOfOneProcess) {
    const SurfaceGrid grids[] = {
        {64, 48, 1e-6, 1e-6}, {37, 51, 1e-6, 2e-6}, {128, 2, 1e-6, 1e-7}, {3, 5, 1e-6, 1e-6}, {500, 375, 2e-6, 1.5e-6}};
    for (const auto& grid : grids) {
        const auto found = compare(grid, {.key = {3, 9}, .threads = {1}});
        EXPECT_EQ(found.different, 0) << grid.nx << " x " << grid.ny;
        EXPECT_EQ(found.all_rows, grid.nx);
    }
}

TEST(RandomSurfaceSlab, HasTheBytesOfOneProcessWithEveryOption) {
    const SurfaceGrid grid{96, 81, 1e-6, 1e-6};
    EXPECT_EQ(compare(grid, {.amplitudes = Amplitudes::exact, .anisotropy = {2.0, 0.3}, .threads = {2}}).different, 0);
    EXPECT_EQ(compare(grid, {.key = {1, 0}, .exact_rms_height = 2e-9, .threads = {1}}).different, 0);
}

TEST(RandomSurfaceSlab, FailsOnAllRanksTogether) {
    EXPECT_THROW((void)random_surface_slab(MPI_COMM_WORLD, spectra::density(model), {0, 4, 1e-6, 1e-6}),
                 InvalidArgument);
    EXPECT_THROW((void)random_surface_slab(MPI_COMM_WORLD, [](double) { return -1.0; }, {8, 8, 1e-6, 1e-6}),
                 InvalidArgument);
}

TEST(DistributedTransform, EndsOnAllRanksIfOneFails) {
    const auto load = [](Index m, fourier::Complex* modes) {
        if (m == 0) throw UndefinedDataError("line 0 cannot be made");
        std::fill_n(modes, 8, fourier::Complex{});
    };
    EXPECT_THROW((void)fourier::distributed_inverse_transform_map(MPI_COMM_WORLD, load, 8, 8), Error);
}

}  // namespace
