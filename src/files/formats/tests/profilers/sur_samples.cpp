// SPDX-License-Identifier: GPL-3.0-or-later
#include "sur_samples.hpp"

#include <cmath>
#include <limits>

#include "byte_builder.hpp"
#include "format_samples.hpp"
#include "setae/core/constants.hpp"
#include "zlib_stream.hpp"

using namespace setae::tests;

namespace setae::formats::tests {
namespace {

constexpr int nx = 7, ny = 4;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::string points_of(const SurObject& object) {
    ByteBuilder points(object.order);
    if (object.bits == 16) points.rows<std::int16_t>(object.raw);
    else points.rows<std::int32_t>(object.raw);
    return points.content();
}

/// Number of streams, lengths of each before and after compression, streams.
std::string compressed(const std::string& points, int count, std::endian order) {
    ByteBuilder list(order);
    list.number(static_cast<std::uint32_t>(count));
    std::string streams;
    for (int i = 0; i < count; ++i) {
        const auto part = points.size() / static_cast<std::size_t>(count), first = part * static_cast<std::size_t>(i);
        const auto piece = points.substr(first, i + 1 < count ? part : std::string::npos), stream = zlib_stream(piece);
        list.number(static_cast<std::uint32_t>(piece.size())).number(static_cast<std::uint32_t>(stream.size()));
        streams += stream;
    }
    return list.content() + streams;
}

/// raw · 2 nm + 3 nm, NaN where raw is two below the least.
Array2D heights_of(const SurObject& object) {
    Array2D heights = object.raw * (2.0 * units::nm) + 3.0 * units::nm;
    if (object.special_points == 1) heights = (object.raw == object.least - 2).select(nan, heights);
    return heights;
}

FormatSample sample(const std::string& name, const std::string& content, const Array2D& heights,
                    std::size_t channel = 0) {
    FormatSample made{.format = "sur",
                      .name = name,
                      .content = content,
                      .channel = channel,
                      .shape = {heights.rows()},
                      .size = {static_cast<double>(heights.rows()) * 0.5 * units::um},
                      .heights = heights};
    if (heights.cols() > 1) {
        made.shape.push_back(heights.cols());
        made.size.push_back(static_cast<double>(heights.cols()) * 0.25 * units::um);
    }
    return made;
}

}  // namespace

std::string sur_object(const SurObject& object) {
    const bool plain = object.streams == 0;
    const auto points = plain ? points_of(object) : compressed(points_of(object), object.streams, object.order);
    ByteBuilder file(object.order);
    file.text(plain ? "DIGITAL SURF" : "DSCOMPRESSED")
        .number(std::uint16_t{object.order == std::endian::big ? std::uint16_t{257} : std::uint16_t{0}});
    file.number(object.objects)
        .number(std::uint16_t{1})
        .number(object.type)
        .text("wafer 3", 30, ' ')
        .text("A. Operator", 30, ' ');
    file.number(object.channels)
        .number(object.acquisition)
        .number(std::uint16_t{0})
        .number(object.special_points)
        .number(std::uint16_t{0})
        .number(0.0f)
        .number(0u)
        .number(object.bits);
    file.number(object.least).number(1000);
    file.number(static_cast<std::int32_t>(object.raw.rows()))
        .number(static_cast<std::int32_t>(object.raw.cols()))
        .number(static_cast<std::int32_t>(object.raw.size()));
    file.number(0.5f).number(0.25f).number(2.0f);
    for (const auto* axis : {"X", "Y", "Height"}) file.text(axis, 16, ' ');
    for (int turn = 0; turn < 2; ++turn) file.text("\xe6m", 16, ' ').text("\xb5m", 16).text(object.z_unit, 16, ' ');
    file.number(1.0f)
        .number(1.0f)
        .number(1.0f)
        .number(std::uint16_t{0})
        .number(object.inversion)
        .number(std::uint16_t{0})
        .pad_to(306);
    for (const int field : {26, 58, 10, 29, 9, 2014, 1})
        file.number(static_cast<std::int16_t>(object.dated ? field : 0));
    file.number(0.0f).number(static_cast<std::uint32_t>(plain ? 0 : points.size())).pad_to(334);
    file.number(static_cast<std::uint16_t>(object.comment.size()))
        .number(static_cast<std::uint16_t>(object.private_zone.size()))
        .pad_to(466);
    file.number(1.0f).number(2.0f).number(3.0f).pad_to(512);
    return file.content() + object.comment + object.private_zone + points;
}

std::vector<FormatSample> sur_samples() {
    const SurObject plain{.raw = lopsided_heights(nx, ny, 1.0)};
    SurObject special = plain;
    special.special_points = 1;
    special.least = 10;
    special.raw(2, 1) = special.raw(6, 3) = 8;  // least − 2
    special.comment = "a comment of 31 characters, odd";
    special.private_zone = "private";
    SurObject wide = special;
    wide.bits = 32;
    SurObject streams = wide;
    streams.streams = 2;
    SurObject macintosh = special;
    macintosh.order = std::endian::big;
    SurObject profile{.raw = lopsided_heights(11, 1, 1.0), .type = 1, .bits = 32};
    SurObject upside_down = plain, mirrored = plain, first = plain, second = plain, surface = wide;
    upside_down.inversion = 3;
    mirrored.inversion = 2;
    first.type = 5;
    first.objects = 2;
    second.raw = lopsided_heights(nx, ny, 1.0) + 4.0;
    surface.type = 16;
    surface.channels = 5;
    surface.streams = 1;
    auto colours = sur_object(surface);
    for (int i = 0; i < 4; ++i) colours += sur_object({.raw = plain.raw, .z_unit = "", .streams = 1});
    SurObject by_gwyddion = wide;
    by_gwyddion.type = 1;
    const Array2D negative = 3.0 * units::nm - plain.raw * (2.0 * units::nm);
    return {sample("int16", sur_object(plain), heights_of(plain)),
            sample("int16, special points", sur_object(special), heights_of(special)),
            sample("int32", sur_object(wide), heights_of(wide)),
            sample("compressed in two streams", sur_object(streams), heights_of(streams)),
            sample("from a Macintosh", sur_object(macintosh), heights_of(macintosh)),
            sample("profile", sur_object(profile), heights_of(profile)),
            sample("map called a profile", sur_object(by_gwyddion), heights_of(by_gwyddion)),
            sample("inverted, upside down", sur_object(upside_down), negative.rowwise().reverse()),
            sample("inverted, mirrored", sur_object(mirrored), negative.colwise().reverse()),
            sample("second of a series", sur_object(first) + sur_object(second), heights_of(second), 1),
            sample("surface with colours", colours, heights_of(surface))};
}

}  // namespace setae::formats::tests
