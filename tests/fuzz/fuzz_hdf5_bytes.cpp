// SPDX-License-Identifier: GPL-3.0-or-later
// Damaged HDF5 files, topographies and pictures: what the library makes of them in a child process must keep them from
// this one.
#include "files/emd_file.hpp"
#include "fuzz_heights.hpp"
#include "fuzz_target.hpp"
#include "setae/bytes/hdf5_handle.hpp"
#include "setae/formats/format.hpp"

using namespace setae;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto source = bytes::memory_source("input", std::string(fuzz::text_of(data, size)));
    if (!bytes::find_hdf5(fuzz::text_of(data, size))) return 0;
    fuzz::read_or_refuse([&] { return imaging::read_emd(source, fuzz::options); });
    try {
        for (const auto& channel : formats::open(source, fuzz::given)) fuzz::read_heights(channel);
    } catch (const Error&) {
    }
    return 0;
}
