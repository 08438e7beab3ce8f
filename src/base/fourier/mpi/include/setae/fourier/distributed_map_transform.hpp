// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>

#include <mpi.h>

#include "setae/fourier/inverse_map_transform.hpp"

namespace setae::fourier {

/// The rows of a map that one rank holds: all ny heights of x_i for i = first_row … first_row + heights.rows() − 1.
struct MapSlab {
    Index first_row = 0;
    Array2D heights;  ///< shape (rows, ny); ranks beyond the last row hold none
};

/// inverse_transform_map with work and memory spread over the ranks of a communicator: each rank loads and transforms
/// its share of the lines along x, FFTW's parallel transpose hands the values on, each rank transforms its rows along
/// y.
///
/// The transforms are those of one process, so the rows are the same bytes for any number of ranks and threads. `load`
/// is called on each rank for its own lines only. Memory a rank: its rows twice. Collective; one thread of a rank calls
/// it.
/// @throws InvalidArgument for nx or ny < 1; what `load` throws, on every rank (InternalError on those where it did
/// not).
[[nodiscard]] MapSlab distributed_inverse_transform_map(MPI_Comm communicator, const SpectrumLine& load, Index nx,
                                                        Index ny, parallel::Threads threads = {1});

/// Rethrows on every rank of the communicator if some rank has failed, so that none waits for another for ever.
/// @throws what `own` holds; InternalError where it holds nothing but another rank's does.
void rethrow_together(MPI_Comm communicator, const std::exception_ptr& own);

}  // namespace setae::fourier
