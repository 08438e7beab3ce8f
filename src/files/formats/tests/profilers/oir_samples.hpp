// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/core/arrays.hpp"

namespace setae::formats::tests {

/// An OIR file of an image of intensity and one of heights; steps 0.5, 0.25 and 0.01 µm, calibrations 1, 2 and 3.
struct OirFile {
    Array2D raw;
    int depth = 2;
    int parts = 1;  ///< name of the image with the points of the heights
    bool camera = false;
};

[[nodiscard]] std::string oir_file(const OirFile& file);

}  // namespace setae::formats::tests
