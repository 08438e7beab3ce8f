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

/// One of the images of a file, as messages and listings name it.
struct ImageEntry {
    std::string title = {};      ///< as the file has it; empty where it has none
    std::string kind = "image";  ///< "image", "spectrum", "spectrum image" or "Fourier transform"

    [[nodiscard]] bool is_picture() const { return kind == "image"; }
};

/// A picture of a microscope and what its file says of it.
struct Micrograph {
    FramePixels pixels;                   ///< grey levels as the file spells them, row 0 on top; colour as luminance
    std::optional<PixelSize> pixel_size;  ///< as the file states it; nothing where it states none, or none of a length
    std::string pixel_size_source;        ///< where it stands, such as "DM4 calibration"; empty without one
    std::string unit;                     ///< the file's own, "nm" or, where the axes differ, "nm, A" (x first)
    std::string format;                   ///< identifier in micrograph_formats()
    std::string file, name;
    std::vector<ImageEntry> images;            ///< of the file
    std::size_t image = 0;                     ///< which of them this is
    std::string instrument, acquisition_time;  ///< as the file says; empty where it does not
    std::map<std::string, std::string>
        attributes;             ///< magnification, voltage … with their units, as the file names them
    std::vector<Alert> alerts;  ///< of reading: UNTESTED_FORMAT, PIXELS_NOT_SQUARE, COMPLEX_MAGNITUDE …
};

struct MicrographOptions {
    std::string image = {};  ///< its number, counted from 0, or its title or the beginning of it; empty: the first that
                             ///< is no spectrum and no Fourier transform
    long max_pixels = 100'000'000;  ///< a larger picture is refused before its pixels are read
};

/// Reads a picture: DM3, DM4, TIFF, PNG, JPEG, BMP, SER (EMI beside it), EMD, MRC; told by content, never by name.
/// @throws FileError; FormatError with the offset for content that breaks its format, for spectra (one row, or an axis
/// that is no length) and for pictures above max_pixels, which says how to crop; InvalidArgument for an image the file
/// has not.
[[nodiscard]] Micrograph read_micrograph(const std::string& path, const MicrographOptions& options = {});

/// A format of pictures with a pixel size, for listings and documentation.
struct MicrographFormat {
    std::string identifier, name, extensions, description, reference;
    bool tested_on_real_files = false;
};
[[nodiscard]] const std::vector<MicrographFormat>& micrograph_formats();

/// Files of a folder that read_micrograph may read, by their first bytes, in natural order.
/// @throws FileError; FormatError for a folder without pictures.
[[nodiscard]] std::vector<std::string> micrographs_in(const std::string& folder);

}  // namespace setae::imaging
