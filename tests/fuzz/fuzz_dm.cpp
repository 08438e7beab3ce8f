// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/digital_micrograph.hpp"
#include "files/dm_tags.hpp"
#include "fuzz_target.hpp"

using namespace setae::imaging;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto bytes = setae::fuzz::text_of(data, size);
    if (!is_dm(bytes)) return 0;
    setae::fuzz::read_or_refuse([&] {
        return read_digital_micrograph(setae::bytes::memory_source("input", std::string(bytes)), setae::fuzz::options);
    });
    return 0;
}
