// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "setae/imaging/micrograph.hpp"
#include "tiff_stack.hpp"

namespace setae::imaging {

/// Adds what the tags of a page say of pixel size, microscope and time to a micrograph. The first of these that states
/// a size counts: FEI/Thermo Fisher, Olympus SIS, DigitalMicrograph, Zeiss, OME-XML, JEOL, ImageJ, resolution finer
/// than print.
void read_tiff_calibration(const TiffStack& stack, std::size_t page, Micrograph& micrograph);

/// Whether a page holds the block of data that Olympus' programs put beside the image proper, not beside its thumbnail.
[[nodiscard]] bool has_olympus_block(const bytes::TiffPage& page);

}  // namespace setae::imaging
