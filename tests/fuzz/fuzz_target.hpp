// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>

#include "fuzz_input.hpp"
#include "setae/bytes/source.hpp"
#include "setae/core/errors.hpp"
#include "setae/imaging/micrograph.hpp"

namespace setae::fuzz {

/// Pictures are small, so that a small file that announces a large one is told from one that takes memory.
inline const imaging::MicrographOptions options{.max_pixels = 1'000'000};

/// Reads: a picture of the size allowed with a sensible pixel size, or one of setae's errors; anything else ends the
/// program.
template <class Read>
void read_or_refuse(Read read) {
    try {
        const imaging::Micrograph micrograph = read();
        if (micrograph.pixels.rows() < 2 || micrograph.pixels.cols() < 2 ||
            micrograph.pixels.size() > options.max_pixels)
            std::abort();
        if (micrograph.pixel_size && !(micrograph.pixel_size->x > 0 && micrograph.pixel_size->y > 0)) std::abort();
    } catch (const Error&) {
    }
}

}  // namespace setae::fuzz
