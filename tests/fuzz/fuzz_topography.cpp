// SPDX-License-Identifier: GPL-3.0-or-later
// One target a format of topographies: the environment's SETAE_FORMAT names it, "any" is whatever detection finds.
// Formats that are HDF5 (hdf5, datx, jpk-hdf5, nc of version 4, mat of version 7.3) are tested by fuzz_hdf5,
// and damaged by fuzz_hdf5_bytes.
#include <cstdio>
#include <cstdlib>
#include <string>

#include "fuzz_heights.hpp"
#include "setae/bytes/hdf5_handle.hpp"
#include "setae/core/errors.hpp"
#include "setae/formats/format.hpp"

namespace {

using namespace setae;

const std::string& identifier() {
    static const std::string name = std::getenv("SETAE_FORMAT") ? std::getenv("SETAE_FORMAT") : "any";
    return name;
}

const formats::Format* chosen_format() {
    for (const auto& format : formats::formats())
        if (format.identifier == identifier()) return &format;
    if (identifier() == "any") return nullptr;
    std::fprintf(stderr, "SETAE_FORMAT: no format '%s'\n", identifier().c_str());
    std::exit(2);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const auto* format = chosen_format();
    if (bytes::find_hdf5(fuzz::text_of(data, size))) return 0;
    const auto source = bytes::memory_source("input", std::string(fuzz::text_of(data, size)));
    try {
        if (format && format->detect(source.head(bytes::detection_bytes), source) == formats::Match::no) return 0;
        for (const auto& channel : format ? format->open(source, fuzz::given) : formats::open(source, fuzz::given))
            fuzz::read_heights(channel);
    } catch (const Error&) {
    }
    return 0;
}
