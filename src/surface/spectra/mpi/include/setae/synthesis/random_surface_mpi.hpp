// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/fourier/distributed_map_transform.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace setae::synthesis {

/// The rows of random_surface(C_iso, grid, options) that this rank of the communicator holds, with the same bytes for
/// any number of ranks: surfaces larger than one machine's memory.
///
/// options.threads: of each rank. Memory a rank: its rows twice. Collective: all ranks call it with the same arguments,
/// one thread each.
/// @throws on all ranks what random_surface throws.
[[nodiscard]] fourier::MapSlab random_surface_slab(MPI_Comm communicator, const spectra::SpectralDensity& C_iso,
                                                   const SurfaceGrid& grid, const SurfaceOptions& options = {});

}  // namespace setae::synthesis
