// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/tiff_micrograph.hpp"
#include "fuzz_target.hpp"

using namespace setae::imaging;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto bytes = setae::fuzz::text_of(data, size);
    setae::fuzz::read_or_refuse(
        [&] { return read_tiff(setae::bytes::memory_source("input", std::string(bytes)), setae::fuzz::options); });
    return 0;
}
