// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/avi_file.hpp"
#include "fuzz_target.hpp"

using namespace setae::imaging;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto bytes = setae::fuzz::text_of(data, size);
    constexpr std::size_t max_frames = 4;
    try {
        const AviFile film(setae::bytes::memory_source("input", std::string(bytes)));
        const auto picture = film.picture_size();
        if (picture.width > setae::fuzz::options.max_pixels / picture.height) return 0;  // FrameSource refuses it
        for (std::size_t i = 0; i < std::min(film.size(), max_frames); ++i)
            if (const auto frame = film.read(i); frame.fault.empty() && frame.pixels.size() == 0) std::abort();
    } catch (const setae::Error&) {
    }
    return 0;
}
