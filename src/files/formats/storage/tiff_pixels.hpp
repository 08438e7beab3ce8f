// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "raster.hpp"
#include "setae/bytes/source.hpp"
#include "setae/bytes/tiff_file.hpp"

namespace setae::formats {

/// Throws the reason why a TIFF file is in no format with heights in TIFF: it is damaged, or a picture. @throws
/// FormatError always.
[[noreturn]] void refuse_tiff(const bytes::Source& source);

/// Place of the samples of a page. Contiguous strips without compression are a raster of the file, read on request; all
/// others become a source in memory that libtiff expands at its first read.
struct TiffPixels {
    bytes::Source source;
    Raster raster;
};

/// Pixels of one sample each. @throws FormatError for several samples per pixel, a type that is no number of 1, 2, 4 or
/// 8 bytes, strips or tiles beyond the end of the file or fewer than the page needs, or a page larger than max_expanded
/// of its bytes.
[[nodiscard]] TiffPixels tiff_pixels(const bytes::TiffFile& file, const bytes::TiffPage& page);

}  // namespace setae::formats
