// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "picture.hpp"
#include "setae/bytes/source.hpp"
#include "setae/imaging/micrograph.hpp"

namespace setae::imaging {

/// Calibration of one axis of a picture in a file.
struct AxisScale {
    double scale = 0;
    std::string unit;  ///< UTF-8, as in the file
};

/// A micrograph with only its file and format.
[[nodiscard]] Micrograph unread_micrograph(const bytes::Source& file, std::string format);

/// Larger pixels [m] are those of printers and screens, not of a microscope.
inline constexpr double coarsest_pixel = 20e-6;

/// Metres of a unit of length in the spelling of microscope software, UTF-8; empty if it is no length.
[[nodiscard]] std::optional<double> metres_of(std::string_view unit);

/// Sets the pixel size of a micrograph, or the warning on its absence: RECIPROCAL_UNITS, UNKNOWN_UNIT, BAD_CALIBRATION;
/// PIXELS_NOT_SQUARE if width and height differ by more than 0.1 %.
void set_pixel_size(Micrograph& micrograph, const AxisScale& x, const AxisScale& y, const std::string& source);

/// Whether a unit is one of energy, as on axes of spectra: "eV", "keV".
[[nodiscard]] bool is_energy(std::string_view unit);

void add_alert(Micrograph& micrograph, std::string code, std::string message, std::string action);

/// Width and height in a file, checked for a picture.
/// @throws FormatError for one row or column (a spectrum) and for more pixels than the options allow.
[[nodiscard]] PictureSize picture_size(const bytes::Source& file, std::uint64_t offset, std::uint64_t width,
                                       std::uint64_t height, const MicrographOptions& options);

/// Number of the image that is read: the chosen one, otherwise the first picture. Others are reported: warning
/// SEVERAL_IMAGES. @throws InvalidArgument for an image that the file lacks.
std::size_t choose_image(Micrograph& micrograph, std::vector<ImageEntry> images, const MicrographOptions& options);
/// Number of the image that is read, of `count` images without titles.
std::size_t choose_image(Micrograph& micrograph, std::uint64_t count, const MicrographOptions& options);

/// A finite number that is the whole text; empty for other text.
[[nodiscard]] std::optional<double> number_of(std::string_view text);

}  // namespace setae::imaging
