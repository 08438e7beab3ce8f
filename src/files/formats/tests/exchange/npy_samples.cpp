// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstdint>

#include <fmt/format.h>

#include "byte_builder.hpp"
#include "format_samples.hpp"
#include "sample_files.hpp"
#include "setae/core/constants.hpp"

using namespace setae::tests;

namespace setae::formats::tests {
namespace {

/// The header of NEP 1: magic, version, length, dictionary padded to a multiple of 64 and a line end.
ByteBuilder npy_header(int version, const std::string& type, const std::string& fortran, const std::string& shape,
                       std::endian order = std::endian::little) {
    auto dictionary = fmt::format("{{'descr': '{}', 'fortran_order': {}, 'shape': ({}), }}", type, fortran, shape);
    const std::size_t before = version == 1 ? 10 : 12;
    dictionary.append((64 - (before + dictionary.size() + 1) % 64) % 64, ' ').append(1, '\n');
    ByteBuilder length;
    if (version == 1) length.number(static_cast<std::uint16_t>(dictionary.size()));
    else length.number(static_cast<std::uint32_t>(dictionary.size()));
    ByteBuilder file(order);
    file.text("\x93NUMPY")
        .number(static_cast<std::uint8_t>(version))
        .number(std::uint8_t{0})
        .text(length.content())
        .text(dictionary);
    return file;
}

FormatSample sample_of(const std::string& name, const ByteBuilder& file, const Array2D& map) {
    return {.format = "npy",
            .name = name,
            .content = file.content(),
            .options = {.size = {{3e-6, 2e-6}}, .unit = "nm"},
            .shape = {map.rows(), map.cols()},
            .size = {3e-6, 2e-6},
            .heights = map * units::nm};
}

/// Values in the order of a map's columns: x slow.
template <class T>
void first_index_slow(ByteBuilder& file, const Array2D& map) {
    for (Index i = 0; i < map.rows(); ++i)
        for (Index j = 0; j < map.cols(); ++j) file.number(static_cast<T>(map(i, j)));
}

ByteBuilder float64_array(const Array2D& map) {
    auto file = npy_header(1, "<f8", "False", fmt::format("{}, {}", map.rows(), map.cols()));
    first_index_slow<double>(file, map);
    return file;
}

}  // namespace

std::vector<FormatSample> npy_samples() {
    const auto map = lopsided_heights(6, 4, 1.0);
    Array2D holed = map;
    holed(5, 1) = std::nan("");
    auto fortran = npy_header(2, ">f4", "True", "6, 4", std::endian::big);
    fortran.rows<float>(holed);
    auto integers = npy_header(3, "<i2", "False", "6, 4");
    first_index_slow<std::int16_t>(integers, map);
    auto line = npy_header(1, ">u8", "False", "5,", std::endian::big);
    for (const std::uint64_t value : {4, 3, 2, 1, 7}) line.number(value);
    Array2D heights(5, 1);
    heights << 4.0, 3.0, 2.0, 1.0, 7.0;
    return {sample_of("float64", float64_array(holed), holed),
            sample_of("float32, big-endian, Fortran order, version 2", fortran, holed),
            sample_of("int16, version 3", integers, map),
            {.format = "npy",
             .name = "line of uint64",
             .content = line.content(),
             .options = {.size = {{3e-6}}, .unit = "um"},
             .shape = {5},
             .size = {3e-6},
             .heights = heights * units::um}};
}

std::vector<FormatSample> npz_samples() {
    const auto map = lopsided_heights(6, 4, 1.0), other = lopsided_heights(3, 5, 1.0);
    auto single = npy_header(1, "<f8", "False", "");
    single.number(0.1);
    auto texts = npy_header(1, "<U3", "False", "2,");
    texts.text(std::string(24, 'a'));
    const auto archive = zip_archive({{"pixel.npy", single.content()},
                                      {"names.npy", texts.content()},
                                      {"other.npy", float64_array(other).content()},
                                      {"height.npy", float64_array(map).content()}});
    return {{.format = "npz",
             .name = "four arrays",
             .content = archive,
             .options = {.size = {{3e-6, 2e-6}}, .unit = "nm"},
             .channel = 2,
             .shape = {6, 4},
             .size = {3e-6, 2e-6},
             .heights = map * units::nm}};
}

}  // namespace setae::formats::tests
