// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "setae/core/arrays.hpp"

namespace setae::formats::tests {

/// Variable parts of a WSxM header; lines end with CR LF.
struct WsxmFile {
    std::string first_line = "WSxM file copyright Nanotec Electronica";
    std::string second_line = "SxM Image file";
    std::string lateral = "    X Amplitude: 600 nm\r\n    Y Amplitude: 400 nm\r\n";
    std::string type;
    std::string amplitude;
    std::string range;
};

/// An image of 6 × 4 points, stored from the bottom, each row from the right.
template <class Number>
[[nodiscard]] std::string wsxm_file(const WsxmFile& file, const Array2D& raw);

}  // namespace setae::formats::tests
