// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "setae/imaging/micrograph.hpp"
#include "tiff_stack.hpp"

namespace setae::imaging {

/// Adds pixel size, microscope and time in the tags of a page to a micrograph. The first source with a size is used:
/// FEI/Thermo Fisher, Olympus SIS, DigitalMicrograph, Zeiss, OME-XML, JEOL, ImageJ, resolution finer than print.
void read_tiff_calibration(const TiffStack& stack, std::size_t page, Micrograph& micrograph);

/// Whether a page has the data block that Olympus software adds to the main image, not to its thumbnail.
[[nodiscard]] bool has_olympus_block(const bytes::TiffPage& page);

}  // namespace setae::imaging
