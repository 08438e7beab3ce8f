// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/mrc_file.hpp"
#include "fuzz_target.hpp"

using namespace setae::imaging;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto bytes = setae::fuzz::text_of(data, size);
    if (!is_mrc(bytes)) return 0;
    setae::fuzz::read_or_refuse(
        [&] { return read_mrc(setae::bytes::memory_source("input", std::string(bytes)), setae::fuzz::options); });
    return 0;
}
