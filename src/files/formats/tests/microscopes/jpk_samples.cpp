// SPDX-License-Identifier: GPL-3.0-or-later
#include <zlib.h>

#include "byte_builder.hpp"
#include "format_samples.hpp"
#include "setae/core/constants.hpp"
#include "tiff_builder.hpp"

using namespace setae::tests;

namespace setae::formats::tests {
namespace {

constexpr int nx = 9, ny = 5;
constexpr double width = 900 * units::nm, height = 500 * units::nm;
constexpr double factor = -2e-12, offset = 3e-6;

std::string deflated(const std::string& content) {
    std::string packed(compressBound(content.size()), '\0');
    uLongf size = packed.size();
    compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(content.data()),
             content.size());
    packed.resize(size);
    return packed;
}

TiffPageBuilder thumbnail(std::endian order, bool of_curves) {
    TiffPageBuilder page(order);
    page.picture(2, 2, 8, 1).strips(2, {std::string(4, 'x')});
    page.text(0x8000, "6.0.41").text(0x8003, "2017-01-16 16:00:32.334 GMT").real(0x8042, width).real(0x8043, -height);
    if (of_curves)
        page.text(0x8052, "contact")
            .signed_long(0x8062, nx * ny - 1)
            .text(0x8065, "metadata.jpkspm.head.fancyname : Nanowizard 3");
    else page.text(0x8050, "thumbnail");
    return page;
}

void add_slot(TiffPageBuilder& page, int slot, const char* name, const char* unit, double multiply, double add) {
    const auto tag = [slot](int which) { return static_cast<std::uint16_t>(0x8090 + 0x30 * slot + which); };
    page.text(tag(0), name).text(tag(0x13), unit[0] ? "LinearScaling" : "NullScaling");
    if (unit[0]) page.text(tag(0x12), unit).real(tag(0x14), multiply).real(tag(0x15), add);
}

TiffPageBuilder channel(std::endian order, const char* name, bool retrace, bool reflected, int bits,
                        int compression = 1, int points_x = nx, int points_y = ny) {
    TiffPageBuilder page(order);
    page.picture(points_x, points_y, bits, 2, compression)
        .text(0x8050, "measuredHeight")
        .text(0x8052, name)
        .signed_short(0x8051, retrace ? 1 : 0);
    page.signed_long(0x8080, 4).text(0x8081, "nominal");
    add_slot(page, 0, "raw", "", 0, 0);
    add_slot(page, 1, "volts", "V", 1e-6, 50);
    add_slot(page, 2, "nominal", "m", 2 * factor, offset);
    add_slot(page, 3, "calibrated", "m", factor, offset);
    if (reflected) page.signed_short(0x8045, 1);
    return page;
}

/// Raw values as in the file: from the bottom, or from the top of a reflected grid.
template <class Integer>
std::string rows(const Array2D& raw, std::endian order, bool reflected) {
    ByteBuilder builder(order);
    builder.rows<Integer>(reflected ? raw : Array2D(raw.rowwise().reverse()));
    return builder.content();
}

/// PackBits of rows without repetitions: literal runs of at most 128 bytes, each after its length minus one.
std::string packed_rows(const std::string& content, std::size_t row) {
    std::string packed;
    for (std::size_t at = 0; at < content.size(); at += row)
        packed += static_cast<char>(row - 1) + content.substr(at, row);
    return packed;
}

/// Four tiles that extend beyond right and upper border, each value stored as its difference to the one on its left.
FormatSample sample_of_tiles() {
    constexpr int tile = 16, wide = 20, high = 18;
    const Array2D raw = lopsided_heights(wide, high, -700.0);
    std::vector<std::string> tiles;
    for (int top = 0; top < high; top += tile)
        for (int left = 0; left < wide; left += tile) {
            ByteBuilder differences(std::endian::little);
            for (int j = top; j < top + tile; ++j) {
                std::int32_t before = 0;
                for (int i = left; i < left + tile; ++i) {
                    const auto value = i < wide && j < high ? static_cast<std::int32_t>(raw(i, high - 1 - j)) : 0;
                    differences.number(value - before);
                    before = value;
                }
            }
            tiles.push_back(deflated(differences.content()));
        }
    auto page = channel(std::endian::little, "Height", false, false, 32, 8, wide, high);
    page.shorts(317, {2}).tiles(tile, tile, tiles);
    return {.format = "jpk",
            .name = "tiles of deflate, predicted",
            .content = tiff_file(std::endian::little, {thumbnail(std::endian::little, false), page}),
            .shape = {wide, high},
            .size = {width, height},
            .heights = factor * raw + offset};
}

FormatSample sample(const char* format, const char* name, std::string content, const Array2D& raw) {
    return {.format = format,
            .name = name,
            .content = std::move(content),
            .shape = {nx, ny},
            .size = {width, height},
            .heights = factor * raw + offset};
}

}  // namespace

std::vector<FormatSample> jpk_samples() {
    constexpr auto big = std::endian::big, little = std::endian::little;
    const Array2D raw = lopsided_heights(nx, ny, -700.0), small = lopsided_heights(nx, ny, 11.0);
    auto plain = channel(big, "Height (measured)", true, false, 32);
    plain.strips(ny, {rows<std::int32_t>(raw, big, false)});
    auto reflected = channel(little, "Height", false, true, 16);
    reflected.strips(ny, {rows<std::int16_t>(small, little, true)});
    auto packed = channel(big, "Height", false, false, 32, 8);
    const auto stored = rows<std::int32_t>(raw, big, false);
    packed.strips(2, {deflated(stored.substr(0, 8 * nx)), deflated(stored.substr(8 * nx, 8 * nx)),
                      deflated(stored.substr(16 * nx))});
    auto runs = channel(big, "Height", false, false, 32, 32773);
    runs.strips(3, {packed_rows(stored.substr(0, 12 * nx), 4 * nx), packed_rows(stored.substr(12 * nx), 4 * nx)});
    return {sample("jpk", "int32, big-endian", tiff_file(big, {thumbnail(big, false), plain}), raw),
            sample("jpk", "int16, little-endian, reflected", tiff_file(little, {thumbnail(little, false), reflected}),
                   small),
            sample("jpk", "strips of deflate", tiff_file(big, {thumbnail(big, false), packed}), raw),
            sample("jpk", "BigTIFF", tiff_file(big, {thumbnail(big, false), plain}, true), raw),
            sample("jpk", "PackBits", tiff_file(big, {thumbnail(big, false), runs}), raw),
            sample_of_tiles()};
}

std::vector<FormatSample> jpk_qi_samples() {
    constexpr auto big = std::endian::big;
    const Array2D raw = lopsided_heights(nx, ny, -700.0);
    auto plain = channel(big, "Height (measured)", false, false, 32);
    plain.strips(ny, {rows<std::int32_t>(raw, big, false)})
        .text(0x8053, "algorithm.object-name.fancy-name : Ref. Force Height at 40%\nchannel.name : measuredHeight");
    constexpr int tile = 16;  // the minimum for TIFF
    ByteBuilder padded(big);
    for (int j = 0; j < tile; ++j)
        for (int i = 0; i < tile; ++i)
            padded.number(i < nx && j < ny ? static_cast<std::int32_t>(raw(i, ny - 1 - j)) : -1);
    auto tiled = channel(big, "Height", false, false, 32);
    tiled.tiles(tile, tile, {padded.content()});
    return {sample("jpk-qi", "strips", tiff_file(big, {thumbnail(big, true), plain}), raw),
            sample("jpk-qi", "tiles", tiff_file(big, {thumbnail(big, true), tiled}), raw)};
}

}  // namespace setae::formats::tests
