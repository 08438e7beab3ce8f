// SPDX-License-Identifier: GPL-3.0-or-later
#include "mrc_file.hpp"

#include <array>
#include <bit>
#include <cmath>

#include <fmt/format.h>

#include "micrograph_building.hpp"
#include "raw_pixels.hpp"
#include "setae/bytes/stored_numbers.hpp"
#include "setae/core/errors.hpp"

namespace setae::imaging {
namespace {

constexpr std::uint64_t header_bytes = 1024;

namespace at {  // offsets in the header
constexpr std::size_t sides = 0, mode = 12, sampling = 28, cell = 40, extended_bytes = 92, extended_kind = 104,
                      mark = 208, stamp = 212;
}

namespace fei {  // offsets in an entry of FEI's extended header
constexpr std::size_t size = 0, voltage = 84, pixel_x = 156, pixel_y = 164, min_size = 172;
}

std::optional<SampleType> sample_type(std::uint64_t mode) {
    switch (mode) {
        case 0: return SampleType::int8;
        case 1: return SampleType::int16;
        case 2: return SampleType::float32;
        case 3: return SampleType::complex_int16;
        case 4: return SampleType::complex_float32;
        case 6: return SampleType::uint16;
        case 12: return SampleType::float16;
        default: return std::nullopt;
    }
}

/// A pixel between a tenth of a picometre and a micrometre.
bool sensible(double size) { return size > 1e-13 && size < 1e-6; }

/// Pixel size [m] of FEI's extended header, entry by entry; true if there is one. Its numbers are little endian in
/// practice.
bool read_fei_header(const bytes::Source& file, std::uint64_t section, Micrograph& micrograph) {
    const auto first = file.up_to(header_bytes, fei::min_size);
    if (first.size() < fei::min_size) return false;
    const auto entry_bytes = bytes::number_in(first, fei::size, 4);
    if (entry_bytes < fei::min_size || entry_bytes > 4096) return false;
    const auto entry = file.up_to(header_bytes + section * entry_bytes, fei::min_size);
    if (entry.size() < fei::min_size) return false;
    const auto real = [&](std::size_t offset) { return std::bit_cast<double>(bytes::number_in(entry, offset, 8)); };
    if (!sensible(real(fei::pixel_x)) || !sensible(real(fei::pixel_y))) return false;
    set_pixel_size(micrograph, {real(fei::pixel_x), "m"}, {real(fei::pixel_y), "m"}, "MRC extended header of FEI");
    if (real(fei::voltage) > 0 && real(fei::voltage) < 1e7)
        micrograph.attributes["voltage"] = fmt::format("{:g} V", real(fei::voltage));
    return true;
}

/// Pixel size from the dimensions of the cell [Å] over its sampling. A cell without positive dimensions gives none:
/// programs write 0 if unknown, and damaged files contain arbitrary numbers.
void set_cell(Micrograph& micrograph, std::array<double, 2> cell, std::array<std::int32_t, 2> sampling) {
    const std::string source = "MRC cell dimensions";
    const bool positive = cell[0] > 0.0 && cell[1] > 0.0 && std::isfinite(cell[0]) && std::isfinite(cell[1]) &&
                          sampling[0] > 0 && sampling[1] > 0;
    if (!positive)
        return add_alert(
            micrograph, "BAD_CALIBRATION",
            fmt::format("the cell is {:g} × {:g} Å for {} × {} samples, expected positive lengths; it gives no pixel "
                        "size",
                        cell[0], cell[1], sampling[0], sampling[1]),
            "give the pixel size, or calibrate on the scale bar");
    set_pixel_size(micrograph, {cell[0] / sampling[0], "angstrom"}, {cell[1] / sampling[1], "angstrom"}, source);
    if (cell[0] == sampling[0] && cell[1] == sampling[1])
        add_alert(micrograph, "DEFAULT_CALIBRATION",
                  "the cell has as many Å as samples, so that a pixel is 1 Å; programs write this value if no "
                  "pixel size is known",
                  "check the pixel size, or give `pixel` and set `ignore_stated_pixel_size`");
}

}  // namespace

bool is_mrc(std::string_view head) {
    if (head.size() < at::stamp + 4 || head.substr(at::mark, 3) != "MAP") return false;
    const auto stamp = bytes::number_in(head, at::stamp, 2, true);
    return stamp == 0x4444 || stamp == 0x4441 || stamp == 0x1111;
}

Micrograph read_mrc(const bytes::Source& file, const MicrographOptions& options) {
    auto micrograph = unread_micrograph(file, "mrc");
    const auto header = file.up_to(0, header_bytes);
    if (header.size() < header_bytes)
        throw FormatError(file.name, {.offset = header.size()},
                          fmt::format("an MRC begins with a header of {} bytes; this one is truncated", header_bytes));
    const bool big_endian = header[at::stamp] == 0x11;
    const auto whole = [&](std::size_t offset) {
        return static_cast<std::int32_t>(bytes::number_in(header, offset, 4, big_endian));
    };
    const auto real = [&](std::size_t offset) { return static_cast<double>(std::bit_cast<float>(whole(offset))); };
    const auto positive = [&](std::size_t offset) { return static_cast<std::uint64_t>(std::max(0, whole(offset))); };
    const auto size = picture_size(file, at::sides, positive(at::sides), positive(at::sides + 4), options);
    const auto sections = positive(at::sides + 8);
    const std::uint64_t image = choose_image(micrograph, std::max<std::uint64_t>(1, sections), options);
    const auto type = sample_type(positive(at::mode));
    if (!type || whole(at::mode) < 0)
        throw FormatError(file.name, {.offset = at::mode},
                          fmt::format("mode {}, expected 0, 1, 2, 3, 4, 6 or 12", whole(at::mode)));
    const auto extended = positive(at::extended_bytes);
    const auto section_bytes =
        static_cast<std::uint64_t>(size.width) * static_cast<std::uint64_t>(size.height) * bytes_of(*type);
    if (section_bytes > file.size || image > file.size / section_bytes)
        throw FormatError(
            file.name, {.offset = header_bytes},
            fmt::format("sections of {} bytes in a file of {}; it is truncated", section_bytes, file.size));
    micrograph.pixels = read_pixels(file, {header_bytes + extended + image * section_bytes, *type, big_endian, size});
    if (is_complex(*type))
        add_alert(micrograph, "COMPLEX_MAGNITUDE", "pixels are complex numbers; their magnitude is read",
                  "if this is a Fourier transform, read the real image");

    const bool from_fei = extended > 0 && std::string_view(header).substr(at::extended_kind, 3) == "FEI" &&
                          read_fei_header(file, image, micrograph);
    if (!from_fei)
        set_cell(micrograph, {real(at::cell), real(at::cell + 4)}, {whole(at::sampling), whole(at::sampling + 4)});
    add_alert(micrograph, "UNTESTED_FORMAT",
              "MRC is read according to its description and was not tested on an instrument file",
              "compare picture and pixel size with those of another program");
    return micrograph;
}

}  // namespace setae::imaging
