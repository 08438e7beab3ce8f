// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/ser_file.hpp"
#include "fuzz_target.hpp"

using namespace setae::imaging;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto bytes = setae::fuzz::text_of(data, size);
    Micrograph emi;
    read_emi(bytes, emi);
    if (!is_ser(bytes)) return 0;
    setae::fuzz::read_or_refuse(
        [&] { return read_ser(setae::bytes::memory_source("input", std::string(bytes)), setae::fuzz::options); });
    return 0;
}
