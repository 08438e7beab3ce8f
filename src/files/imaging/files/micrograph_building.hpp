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

/// What a file says of one axis of a picture.
struct AxisScale {
    double scale = 0;
    std::string unit;  ///< UTF-8, as the file spells it
};

/// A micrograph that knows its file and format, and nothing else yet.
[[nodiscard]] Micrograph unread_micrograph(const bytes::Source& file, std::string format);

/// Pixels [m] larger than this stand for what printers and screens are told, not for a microscope.
inline constexpr double coarsest_pixel = 20e-6;

/// Metres of a unit of length as programs of microscopes write it, UTF-8; nothing where it is no length.
[[nodiscard]] std::optional<double> metres_of(std::string_view unit);

/// Puts a pixel size into a micrograph, or the alert that says why there is none: RECIPROCAL_UNITS, UNKNOWN_UNIT,
/// BAD_CALIBRATION; PIXELS_NOT_SQUARE where width and height differ by more than 0.1 %.
void set_pixel_size(Micrograph& micrograph, const AxisScale& x, const AxisScale& y, const std::string& source);

/// Whether a unit is one of energy, as axes of spectra have: "eV", "keV".
[[nodiscard]] bool is_energy(std::string_view unit);

void add_alert(Micrograph& micrograph, std::string code, std::string message, std::string action);

/// Width and height as a file states them, found fit for a picture.
/// @throws FormatError for one row or column (a spectrum) and for more pixels than the options allow.
[[nodiscard]] PictureSize picture_size(const bytes::Source& file, std::uint64_t offset, std::uint64_t width,
                                       std::uint64_t height, const MicrographOptions& options);

/// Which of a file's images is read: the one asked for, else the first picture. Says what is passed over: alert
/// SEVERAL_IMAGES. @throws InvalidArgument for an image the file has not.
std::size_t choose_image(Micrograph& micrograph, std::vector<ImageEntry> images, const MicrographOptions& options);
/// The same of `count` images without titles.
std::size_t choose_image(Micrograph& micrograph, std::uint64_t count, const MicrographOptions& options);

/// A finite number that is the whole text; nothing for other text.
[[nodiscard]] std::optional<double> number_of(std::string_view text);

}  // namespace setae::imaging
