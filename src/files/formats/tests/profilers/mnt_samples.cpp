// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include "byte_builder.hpp"
#include "compound_file.hpp"
#include "format_samples.hpp"
#include "mnt_samples.hpp"
#include "setae/core/constants.hpp"
#include "zlib_stream.hpp"

using namespace setae::tests;

namespace setae::formats::tests {
namespace {

constexpr int nx = 7, ny = 4;
constexpr std::uint16_t base = 0xffff;

std::string entry(std::uint16_t tag, const std::string& content) {
    return ByteBuilder().number(tag).number(static_cast<std::uint64_t>(content.size())).text(content).content();
}
template <class T>
std::string value(std::uint16_t tag, T number) {
    return entry(tag, ByteBuilder().number(number).content());
}
std::string text(std::uint16_t tag, const std::string& latin1) {
    std::string content(1, '\4');
    for (const char c : latin1) content += std::string{c, '\0'};
    return entry(tag, content);
}
std::string object(std::uint32_t kind, const std::string& body) { return entry(1, value(1, kind)) + entry(2, body); }

std::string scale(double step, const std::string& unit, const std::string& shown, double origin) {
    return entry(base, value(1, 1u) + text(2, "axis")) + value(1, step) + text(2, unit) + text(3, shown) +
           value(4, 1000.0) + value(5, origin);
}
std::string lateral_axis(std::uint16_t tag, double step, Index points) {
    return entry(
        tag, entry(base, entry(base, scale(step, "\xb5m", "mm", 10.0)) + value(1, static_cast<std::uint32_t>(points)) +
                             value(2, 0u) + value(3, static_cast<std::uint32_t>(points - 1))));
}

/// An array in zlib blocks of `together` elements, the last block first.
std::string array(const std::string& bytes, std::size_t element_bytes, std::size_t together) {
    const auto elements = bytes.size() / element_bytes;
    std::vector<std::string> blocks;
    for (std::size_t first = 0; first < elements; first += together) {
        const auto count = std::min(together, elements - first);
        const auto stream = zlib_stream(bytes.substr(first * element_bytes, count * element_bytes));
        ByteBuilder block;
        block.number(static_cast<std::uint64_t>(first))
            .number(static_cast<std::uint32_t>(count))
            .number(static_cast<std::uint32_t>(stream.size()))
            .text(stream);
        blocks.insert(blocks.begin(), block.content());
    }
    auto data = ByteBuilder().number(static_cast<std::uint64_t>(bytes.size())).content();
    for (const auto& block : blocks) data += block;
    return value(1, static_cast<std::uint32_t>(elements)) + entry(2, data);
}

std::string mask_of(const Array2D& counts) {
    const auto width = static_cast<std::size_t>(counts.rows()) + 2;
    std::string mask(width * (static_cast<std::size_t>(counts.cols()) + 2), '\0');
    for (Index j = 0; j < counts.cols(); ++j)
        for (Index i = 0; i < counts.rows(); ++i)
            mask[static_cast<std::size_t>(j + 1) * width + static_cast<std::size_t>(i + 1)] =
                counts(i, j) == 0.0 ? 22 : 9;
    return entry(3, object(9056, value(1, static_cast<std::uint32_t>(counts.rows())) +
                                     value(2, static_cast<std::uint32_t>(counts.cols())) +
                                     entry(5, object(9048, array(mask, 1, 20)))));
}

std::string surface(const MntSurface& made) {
    ByteBuilder counts;
    if (made.element_bytes == 2) counts.rows<std::int16_t>(made.counts);
    else counts.rows<std::int32_t>(made.counts);
    const auto grid = entry(base, entry(base, text(1, made.name))) + lateral_axis(1, 2.0, made.counts.rows()) +
                      lateral_axis(2, 1.5, made.counts.cols()) +
                      (made.mask ? mask_of(made.counts) : entry(3, entry(1, value(1, 0u))));
    const auto heights =
        entry(1, object(9049, array(counts.content(), static_cast<std::size_t>(made.element_bytes), 10)));
    const auto z_axis =
        entry(2, entry(base, scale(0.1, made.z_unit, made.z_shown, 50.0)) + value(1, -1000) + value(2, 1000));
    return object(9012, entry(base, text(4, "1 : " + made.name)) +
                            entry(1, object(9062, entry(base, entry(base, grid) + heights + z_axis))));
}

FormatSample sample(const std::string& name, const std::vector<MntSurface>& surfaces, std::size_t channel,
                    unsigned shift) {
    const auto& shown = surfaces[channel];
    Array2D heights = shown.counts * (0.1 * units::nm) + 50.0 * units::um;
    if (shown.mask) heights = (shown.counts == 0.0).select(std::numeric_limits<double>::quiet_NaN(), heights);
    return {.format = "mnt",
            .name = name,
            .content = mnt_file(mnt_contents(surfaces), shift),
            .channel = channel,
            .shape = {nx, ny},
            .size = {nx * 2.0 * units::um, ny * 1.5 * units::um},
            .heights = heights};
}

}  // namespace

std::string mnt_contents(const std::vector<MntSurface>& surfaces, int other_objects) {
    std::string objects;
    const auto add = [&](const std::string& content) {
        objects +=
            ByteBuilder().number(static_cast<std::uint64_t>(content.size() + 10)).text(entry(1, content)).content();
    };
    for (int i = 0; i < other_objects; ++i) add(object(9013, text(4, "levelled")));
    for (const auto& made : surfaces) add(surface(made));
    const auto count = static_cast<std::uint8_t>(surfaces.size() + static_cast<std::size_t>(other_objects));
    const auto version = entry(0xc8, value(1, 9u) + value(2, 2u) + value(3, 0u) + value(4, 9994u));
    const auto document = entry(1, version + entry(0x2bd, value(1, count) + entry(2, entry(1, objects))));
    return ByteBuilder().number(static_cast<std::uint64_t>(document.size())).text(document).content();
}

std::string mnt_file(const std::string& contents, unsigned sector_shift) {
    return CompoundFile({{"ScopedContents", contents},
                         {"XmlHeader", std::string(300, 'x')},
                         {"ImagePreview", std::string(5000, 'j')}},
                        sector_shift)
        .content();
}

std::vector<FormatSample> mnt_samples() {
    const MntSurface whole{.counts = lopsided_heights(nx, ny, 100.0)};
    MntSurface holes = whole, narrow = whole;
    holes.counts(1, 2) = holes.counts(6, 0) = 0.0;
    holes.mask = true;
    narrow.counts = lopsided_heights(nx, ny, 1.0);
    narrow.element_bytes = 2;
    return {sample("int32", {whole}, 0, 9), sample("int32 with a mask", {holes}, 0, 9),
            sample("int16, second surface, sectors of 4096", {holes, narrow}, 1, 12)};
}

}  // namespace setae::formats::tests
