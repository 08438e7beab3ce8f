// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/imaging/calibration.hpp"

namespace setae::imaging {

/// A calibration and the picture it was made with.
struct KeptCalibration {
    Calibration calibration;
    std::string picture;         ///< file name, without its folder
    std::string picture_sha256;  ///< of the file's bytes, 64 hexadecimal digits
};

/// The calibration made with the picture at `path`, to be kept. @throws FileError.
[[nodiscard]] KeptCalibration kept_calibration(const Calibration& calibration, const std::string& picture_path);

/// Writes a calibration as JSON, as a whole: sizes in m, lengths of the bar in px, as the keys say.
/// Reading it gives the same numbers to the last bit. @throws FileError.
void write_calibration(const std::string& path, const KeptCalibration& kept);

/// Reads what write_calibration writes.
/// @throws FileError; FormatError that names file and key: no JSON, another version, keys missing, unknown (with the
/// nearest known one) or of another type, numbers outside their domain.
[[nodiscard]] KeptCalibration read_calibration(const std::string& path);

}  // namespace setae::imaging
