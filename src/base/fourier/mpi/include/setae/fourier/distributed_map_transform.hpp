// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>

#include <mpi.h>

#include "setae/fourier/inverse_map_transform.hpp"

namespace setae::fourier {

/// The rows of a map on one rank: all ny heights of x_i for i = first_row … first_row + heights.rows() − 1.
struct MapSlab {
    Index first_row = 0;
    Array2D heights;  ///< shape (rows, ny); ranks beyond the last row hold none
};

/// inverse_transform_map with work and memory divided over the ranks of a communicator: each rank loads and transforms
/// its share of the lines along x, FFTW's parallel transpose moves the values, each rank transforms its rows along y.
///
/// The transforms are those of one process, so the rows are the same bytes for any number of ranks and threads. `load`
/// is called on each rank for its own lines only. Memory per rank: its rows twice. Collective; called by one thread per
/// rank.
/// @throws InvalidArgument for nx or ny < 1; exceptions of `load`, on every rank (InternalError on ranks where `load`
/// did not throw).
[[nodiscard]] MapSlab distributed_inverse_transform_map(MPI_Comm communicator, const SpectrumLine& load, Index nx,
                                                        Index ny, parallel::Threads threads = {1});

/// Throws on every rank of the communicator if one rank has failed, so no rank waits for another indefinitely.
/// @throws the exception in `own`; InternalError if `own` is empty but that of another rank is not.
void rethrow_together(MPI_Comm communicator, const std::exception_ptr& own);

}  // namespace setae::fourier
