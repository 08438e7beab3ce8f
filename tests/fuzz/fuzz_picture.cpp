// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/picture.hpp"
#include "files/plain_picture.hpp"
#include "fuzz_target.hpp"

using namespace setae::imaging;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto bytes = setae::fuzz::text_of(data, size);
    if (!(picture_kind(bytes) != PictureKind::none && picture_kind(bytes) != PictureKind::tiff)) return 0;
    setae::fuzz::read_or_refuse([&] {
        return read_plain_picture(setae::bytes::memory_source("input", std::string(bytes)), setae::fuzz::options);
    });
    return 0;
}
