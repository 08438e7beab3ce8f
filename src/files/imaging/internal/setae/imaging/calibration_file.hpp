// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/imaging/calibration.hpp"

namespace setae::imaging {

/// A calibration and the picture it was made with.
struct KeptCalibration {
    Calibration calibration;
    std::string picture;         ///< file name, without its folder
    std::string picture_sha256;  ///< of the bytes of the file, 64 hexadecimal digits
};

/// The calibration made with the picture at `path`, for storage. @throws FileError.
[[nodiscard]] KeptCalibration kept_calibration(const Calibration& calibration, const std::string& picture_path);

/// Writes a calibration as JSON, as a whole: sizes in m, lengths of the bar in px, as stated in the keys. Reading
/// restores the numbers exactly. @throws FileError.
void write_calibration(const std::string& path, const KeptCalibration& kept);

/// Reads the output of write_calibration.
/// @throws FileError; FormatError with file and key: no JSON, another version, keys missing, unknown (with the nearest
/// known one) or of another type, numbers outside their domain.
[[nodiscard]] KeptCalibration read_calibration(const std::string& path);

}  // namespace setae::imaging
