// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/synthesis/random_surface_mpi.hpp"

#include <cmath>
#include <vector>

#include "setae/core/summation.hpp"
#include "setae/synthesis/rms_height.hpp"
#include "setae/synthesis/surface_modes.hpp"

namespace setae::synthesis {
namespace {

/// √⟨h²⟩ of the whole surface: the sums of all rows are collected on every rank and added as in one process.
double rms(MPI_Comm communicator, const fourier::MapSlab& slab, const SurfaceGrid& grid) {
    int ranks = 0;
    MPI_Comm_size(communicator, &ranks);
    const int own_rows = static_cast<int>(slab.heights.rows()), own_first = static_cast<int>(slab.first_row);
    std::vector<int> rows(static_cast<std::size_t>(ranks)), first(rows.size());
    MPI_Allgather(&own_rows, 1, MPI_INT, rows.data(), 1, MPI_INT, communicator);
    MPI_Allgather(&own_first, 1, MPI_INT, first.data(), 1, MPI_INT, communicator);
    Array1D own(slab.heights.rows()), sums(grid.nx);
    for (Index i = 0; i < own.size(); ++i) own[i] = slab.heights.row(i).square().sum();
    MPI_Allgatherv(own.data(), own_rows, MPI_DOUBLE, sums.data(), rows.data(), first.data(), MPI_DOUBLE, communicator);
    return std::sqrt(pairwise_sum(sums) / (static_cast<double>(grid.nx) * static_cast<double>(grid.ny)));
}

}  // namespace

fourier::MapSlab random_surface_slab(MPI_Comm communicator, const spectra::SpectralDensity& C_iso,
                                     const SurfaceGrid& grid, const SurfaceOptions& options) {
    if (options.exact_rms_height) require_rms_height(*options.exact_rms_height);
    const SurfaceModes modes(C_iso, grid, options);
    auto slab = fourier::distributed_inverse_transform_map(
        communicator, [&](Index ky, fourier::Complex* line) { modes.line(ky, line); }, grid.nx, grid.ny,
        options.threads);
    if (options.exact_rms_height) slab.heights *= scale_to(*options.exact_rms_height, rms(communicator, slab, grid));
    return slab;
}

}  // namespace setae::synthesis
