// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>

namespace setae::bytes {

/// Pictures of one size in 256 grey levels, in sequence.
struct GreyPages {
    std::uint32_t width = 0, height = 0;  ///< [px], > 0
    int count = 0;                        ///< > 0
    std::string description;              ///< of the first page
    double pixels_per_unit = 0.0;         ///< along both axes, in the unit of the description
};

/// Writes a TIFF of such pages, compressed without loss, as a whole (write_whole_file). page(k, pixels): writes the
/// pixels of page k, row by row from the top; called in order.
/// @throws FileError if the file cannot be written.
void write_tiff(const std::string& path, const GreyPages& pages,
                const std::function<void(int page, std::span<std::uint8_t> pixels)>& page);

}  // namespace setae::bytes
