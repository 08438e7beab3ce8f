// SPDX-License-Identifier: GPL-3.0-or-later
#include <zlib.h>

#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "byte_builder.hpp"
#include "format_samples.hpp"
#include "hdf5_builder.hpp"
#include "setae/core/constants.hpp"

// Built from the description by MathWorks: a matrix is stored column after column. A map h(x, y) is the matrix of its
// lines, M(row y, column x).
using namespace setae::tests;

namespace setae::formats::tests {
namespace {

FormatSample sample_of(const std::string& name, const std::string& content, const Array2D& map,
                       std::size_t channel = 0) {
    return {.format = "mat",
            .name = name,
            .content = content,
            .options = {.size = {{3e-6, 2e-6}}, .unit = "nm"},
            .channel = channel,
            .shape = {map.rows(), map.cols()},
            .size = {3e-6, 2e-6},
            .heights = map * units::nm};
}

template <class T>
void columns(ByteBuilder& file, const Array2D& map) {
    for (Index i = 0; i < map.rows(); ++i)
        for (Index j = 0; j < map.cols(); ++j) file.number(static_cast<T>(map(i, j)));
}

template <class T>
std::string level4(const Array2D& map, std::endian order, std::uint32_t precision) {
    ByteBuilder file(order);
    const std::uint32_t machine = order == std::endian::little ? 0 : 1000;
    file.number(machine + 1u)
        .number(std::uint32_t{1})
        .number(std::uint32_t{3})
        .number(std::uint32_t{0})
        .number(std::uint32_t{5})
        .text("text", 5);
    for (const char c : std::string("abc")) file.number(static_cast<double>(c));
    file.number(machine + 10 * precision)
        .number(static_cast<std::uint32_t>(map.cols()))
        .number(static_cast<std::uint32_t>(map.rows()));
    file.number(std::uint32_t{0}).number(std::uint32_t{2}).text("h", 2);
    columns<T>(file, map);
    return file.content();
}

/// An element of level 5: type, length, content padded to 8 bytes.
std::string element(std::uint32_t type, const std::string& content, std::endian order) {
    ByteBuilder file(order);
    file.number(type).number(static_cast<std::uint32_t>(content.size())).text(content);
    file.pad_to((file.size() + 7) / 8 * 8);
    return file.content();
}

/// A matrix of a class, its values as elements of type `stored`.
template <class T>
std::string matrix(const Array2D& map, const std::string& name, std::uint32_t kind, std::uint32_t stored,
                   std::endian order) {
    ByteBuilder flags(order), extents(order), values(order);
    flags.number(kind).number(std::uint32_t{0});
    extents.number(static_cast<std::int32_t>(map.cols())).number(static_cast<std::int32_t>(map.rows()));
    columns<T>(values, map);
    const auto short_name = [&] {
        ByteBuilder small(order);
        small.number(static_cast<std::uint32_t>(name.size() << 16 | 1)).text(name, 4);
        return small.content();
    };
    const auto named = name.size() <= 4 ? short_name() : element(1, name, order);
    return element(14,
                   element(6, flags.content(), order) + element(5, extents.content(), order) + named +
                       element(stored, values.content(), order),
                   order);
}

std::string level5(const std::string& elements, std::endian order) {
    ByteBuilder file(order);
    file.text("MATLAB 5.0 MAT-file, made by a test", 116, ' ').text("", 8).number(std::uint16_t{0x0100});
    file.number(static_cast<std::uint16_t>('M' << 8 | 'I')).text(elements);
    return file.content();
}

std::string compressed(const std::string& content, std::endian order) {
    std::string packed(compressBound(content.size()), '\0');
    uLongf size = packed.size();
    if (compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(content.data()),
                 content.size()) != Z_OK)
        throw std::runtime_error("sample cannot be compressed");
    ByteBuilder file(order);
    file.number(std::uint32_t{15}).number(static_cast<std::uint32_t>(size)).text(packed.substr(0, size));
    return file.content();
}

FormatSample version73(const Array2D& map) {
    Hdf5Builder file({.newest = false, .user_block = 512});
    file.dataset("/height", H5T_IEEE_F64LE, {static_cast<hsize_t>(map.rows()), static_cast<hsize_t>(map.cols())},
                 first_index_x(map), {.chunk = {4, 3}, .deflated = true});
    file.attribute("/height", "MATLAB_class", std::string("double"));
    file.dataset("/name", H5T_STD_U16LE, {3, 1}, {104, 105, 106})
        .attribute("/name", "MATLAB_class", std::string("char"));
    file.dataset("/settings/inner", H5T_IEEE_F64LE, {2, 2}, {1, 2, 3, 4});
    auto content = file.bytes();
    ByteBuilder header;
    header
        .text("MATLAB 7.3 MAT-file, Platform: GLNXA64, Created on: Sun Nov 22 04:34:59 2026 HDF5 schema 1.00 .", 116,
              ' ')
        .text("", 8)
        .number(std::uint16_t{0x0200})
        .text("IM");
    content.replace(0, header.size(), header.content());
    return sample_of("version 7.3", content, map);
}

}  // namespace

std::vector<FormatSample> mat_samples() {
    constexpr auto little = std::endian::little, big = std::endian::big;
    const auto map = lopsided_heights(6, 4, 1.0), other = lopsided_heights(3, 5, 1.0);
    Array2D holed = map;
    holed(4, 2) = std::nan("");
    const auto doubles = matrix<double>(holed, "height", 6, 9, little),
               small = matrix<std::int16_t>(map, "h", 6, 3, little);
    return {
        sample_of("level 4, float64", level4<double>(holed, little, 0), holed),
        sample_of("level 4, int16, big-endian", level4<std::int16_t>(map, big, 3), map),
        sample_of("level 5, float64", level5(matrix<double>(other, "other", 6, 9, little) + doubles, little), holed, 1),
        sample_of("level 5, float32, big-endian", level5(matrix<float>(holed, "h", 7, 7, big), big), holed),
        sample_of("level 5, whole doubles kept as int16", level5(small, little), map),
        sample_of("level 5, compressed",
                  level5(compressed(matrix<double>(other, "other", 6, 9, little), little) + compressed(doubles, little),
                         little),
                  holed, 1),
        sample_of("level 5, uint8, compressed, big-endian",
                  level5(compressed(matrix<std::uint8_t>(lopsided_heights(6, 2, 1.0), "h", 9, 2, big), big), big),
                  lopsided_heights(6, 2, 1.0)),
        version73(map)};
}

}  // namespace setae::formats::tests
