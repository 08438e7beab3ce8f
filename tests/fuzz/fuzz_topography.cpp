// SPDX-License-Identifier: GPL-3.0-or-later
// One target a format of topographies: the environment's SETAE_FORMAT names it, "any" is whatever detection finds.
#include <cstdio>
#include <cstdlib>
#include <string>

#include "fuzz_input.hpp"
#include "setae/core/errors.hpp"
#include "setae/io/format.hpp"

namespace {

using namespace setae;

const std::string& identifier() {
    static const std::string name = std::getenv("SETAE_FORMAT") ? std::getenv("SETAE_FORMAT") : "any";
    return name;
}

const io::Format* chosen_format() {
    for (const auto& format : io::formats())
        if (format.identifier == identifier()) return &format;
    if (identifier() == "any") return nullptr;
    std::fprintf(stderr, "SETAE_FORMAT: no format '%s'\n", identifier().c_str());
    std::exit(2);
}

/// A channel's heights are as it said, or refused.
void read(const io::Channel& channel) {
    try {
        const auto measurement = channel.read();
        topography::validate(measurement);
        const auto shape = topography::shape(measurement);
        if (!channel.info.shape.empty() && channel.info.shape[0] != shape[0]) std::abort();
    } catch (const Error&) {
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const auto* format = chosen_format();
    const auto source = io::memory_source("input", std::string(fuzz::text_of(data, size)));
    const io::ReadOptions options{.size = {{1e-6, 1e-6}}, .unit = "nm"};
    try {
        if (format && format->detect(source.head(io::detection_bytes), source) == io::Match::no) return 0;
        for (const auto& channel : format ? format->open(source, options) : io::open(source, options)) read(channel);
    } catch (const Error&) {
    }
    return 0;
}
