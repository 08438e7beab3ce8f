// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/fourier/distributed_map_transform.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace setae::synthesis {

/// The rows of random_surface(C_iso, grid, options) on this rank of the communicator, with the same bytes for any
/// number of ranks: for surfaces larger than the memory of one computer.
///
/// options.threads: of each rank. Memory per rank: its rows twice. Collective: all ranks call it with the same
/// arguments, one thread each.
/// @throws on all ranks as random_surface.
[[nodiscard]] fourier::MapSlab random_surface_slab(MPI_Comm communicator, const spectra::SpectralDensity& C_iso,
                                                   const SurfaceGrid& grid, const SurfaceOptions& options = {});

}  // namespace setae::synthesis
