// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "setae/core/quantity.hpp"
#include "setae/imaging/frames.hpp"

namespace setae::imaging {

/// Width and height of a pixel [m].
struct PixelSize {
    double x = 0, y = 0;
};

/// One of the images of a file, with the name used in messages and listings.
struct ImageEntry {
    std::string title = {};      ///< title in the file; empty if missing
    std::string kind = "image";  ///< "image", "spectrum", "spectrum image" or "Fourier transform"

    [[nodiscard]] bool is_picture() const { return kind == "image"; }
};

/// A picture of a microscope with its metadata.
struct Micrograph {
    FramePixels pixels;                   ///< grey levels as in the file, row 0 on top; colour as luminance
    std::optional<PixelSize> pixel_size;  ///< as stated by the file; empty if missing or no length
    std::string pixel_size_source;        ///< its origin, such as "DM4 calibration"; empty without a pixel size
    std::string unit;                     ///< unit in the file, "nm" or, if the axes differ, "nm, A" (x first)
    std::string format;                   ///< identifier in micrograph_formats()
    std::string file, name;
    std::vector<ImageEntry> images;            ///< all images of the file
    std::size_t image = 0;                     ///< number of this image
    std::string instrument, acquisition_time;  ///< as stated by the file; empty if missing
    std::map<std::string, std::string>
        attributes;             ///< magnification, voltage … with their units, with the names of the file
    std::vector<Alert> alerts;  ///< on reading: UNTESTED_FORMAT, PIXELS_NOT_SQUARE, COMPLEX_MAGNITUDE …
};

struct MicrographOptions {
    std::string image = {};  ///< its number, counted from 0, or its title or the beginning of the title; empty: the
                             ///< first image that is neither a spectrum nor a Fourier transform
    long max_pixels = 100'000'000;  ///< larger pictures are refused before their pixels are read
};

/// Reads a picture: DM3, DM4, TIFF, PNG, JPEG, BMP, SER (with EMI next to it), EMD, MRC; detected by content, not by
/// name.
/// @throws FileError; FormatError with the offset for content that breaks its format, for spectra (one row, or an axis
/// that is no length) and for pictures above max_pixels, with instructions for cropping; InvalidArgument for an image
/// that the file lacks.
[[nodiscard]] Micrograph read_micrograph(const std::string& path, const MicrographOptions& options = {});

/// A format of pictures with a pixel size, for listings and documentation.
struct MicrographFormat {
    std::string identifier, name, extensions, description, reference;
    bool tested_on_real_files = false;
};
[[nodiscard]] const std::vector<MicrographFormat>& micrograph_formats();

/// Files of a folder that read_micrograph can read, by their first bytes, in natural order.
/// @throws FileError; FormatError for a folder without pictures.
[[nodiscard]] std::vector<std::string> micrographs_in(const std::string& folder);

}  // namespace setae::imaging
