// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "files/emd_file.hpp"
#include "fuzz_target.hpp"
#include "setae/bytes/rehearsal.hpp"
#include "tests/emd_files.hpp"

using namespace setae::imaging;

namespace {

constexpr std::size_t max_written = 4096;

/// An EMD file described by bytes: layout, packing, type, number of sides, sides, step; then the units and what is left
/// as metadata.
///
/// Not the file's own bytes, which fuzz_hdf5_bytes damages: HDF5 1.10.8 crashes on them, and what is looked for here
/// are faults of the reader above it.
tests::EmdFile described(std::string_view bytes) {
    const auto next = [&]() -> unsigned {
        if (bytes.empty()) return 0;
        const auto value = static_cast<unsigned char>(bytes.front());
        bytes.remove_prefix(1);
        return value;
    };
    const auto text = [&] {
        const auto end = std::min(bytes.find('\n'), bytes.size());
        const std::string line(bytes.substr(0, end));
        bytes.remove_prefix(std::min(end + 1, bytes.size()));
        return line.substr(0, line.find('\0'));
    };
    const hid_t types[] = {H5T_STD_I8LE,   H5T_STD_U16BE,  H5T_STD_I32LE, H5T_STD_U64LE,
                           H5T_IEEE_F32LE, H5T_IEEE_F64BE, H5T_C_S1,      H5T_STD_REF_OBJ};
    tests::EmdFile file;
    const auto layout = next();
    file.velox = layout & 1;
    file.packed = layout & 2;
    file.type = types[next() % std::size(types)];
    file.sides.resize(1 + next() % 4);
    std::size_t numbers = 1;
    for (auto& side : file.sides) {
        side = next();
        numbers *= side;
    }
    if (layout & 4) file.sides.front() *= 1'000'000;
    file.pixels_written = !(layout & 4) && numbers <= max_written && H5Tget_class(file.type) <= H5T_FLOAT;
    file.step_x = static_cast<double>(next()) - 128.0;
    file.unit_x = text();
    file.unit_y = text();
    if (!bytes.empty()) file.metadata = std::string(bytes);
    return file;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    setae::bytes::disable_rehearsals();
    const auto bytes = described(setae::fuzz::text_of(data, size)).bytes();
    setae::fuzz::read_or_refuse(
        [&] { return read_emd(setae::bytes::memory_source("input", std::string(bytes)), setae::fuzz::options); });
    return 0;
}
