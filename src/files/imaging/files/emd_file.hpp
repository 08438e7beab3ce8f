// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "setae/bytes/source.hpp"
#include "setae/imaging/micrograph.hpp"

namespace setae::imaging {

/// Whether bytes begin as an HDF5 file.
[[nodiscard]] bool is_hdf5(std::string_view head);

/// Reads an image of an EMD: groups with emd_group_type 1 (NCEM) or Data/Image/* (Velox). Untested on real files.
/// @throws as read_micrograph does.
/// Source: emdatasets.com, EMD 0.2; Velox' layout as RosettaSciIO and openNCEM read it.
[[nodiscard]] Micrograph read_emd(const bytes::Source& file, const MicrographOptions& options);

}  // namespace setae::imaging
