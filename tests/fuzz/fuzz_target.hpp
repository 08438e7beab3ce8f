// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "../../src/imaging/random_access.hpp"
#include "setae/core/errors.hpp"
#include "setae/imaging/micrograph.hpp"

/// What libFuzzer calls with every input; without it, replay.cpp does.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace setae::fuzz {

/// Pictures are small, so that a small file that announces a large one is told from one that takes memory.
inline const imaging::MicrographOptions options{.most_pixels = 1'000'000};

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) { return {reinterpret_cast<const char*>(data), size}; }

/// Reads: a picture of the size allowed with a sensible pixel size, or one of setae's errors; anything else ends the program.
template <class Read>
void read_or_refuse(Read read) {
    try {
        const imaging::Micrograph micrograph = read();
        if (micrograph.pixels.rows() < 2 || micrograph.pixels.cols() < 2 || micrograph.pixels.size() > options.most_pixels) std::abort();
        if (micrograph.pixel_size && !(micrograph.pixel_size->x > 0 && micrograph.pixel_size->y > 0)) std::abort();
    } catch (const Error&) {
    }
}

}  // namespace setae::fuzz
