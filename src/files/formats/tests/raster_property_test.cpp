// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "sample_files.hpp"
#include "storage/raster.hpp"

using namespace setae::tests;

namespace setae::formats::tests::raster_property_test {
namespace {

/// A number from its bytes, most significant first, without helpers of the reader.
template <class Number>
double number_from(std::string bytes) {
    std::uint64_t bits = 0;
    for (const char byte : bytes) bits = bits << 8 | static_cast<unsigned char>(byte);
    using Bits =
        std::conditional_t<sizeof(Number) == 1, std::uint8_t,
                           std::conditional_t<sizeof(Number) == 2, std::uint16_t,
                                              std::conditional_t<sizeof(Number) == 4, std::uint32_t, std::uint64_t>>>;
    const auto narrow = static_cast<Bits>(bits);
    Number number;
    std::memcpy(&number, &narrow, sizeof(Number));
    return static_cast<double>(number);
}

double raw_number(const std::string& bytes, Sample sample) {
    switch (sample) {
        case Sample::int8: return number_from<std::int8_t>(bytes);
        case Sample::uint8: return number_from<std::uint8_t>(bytes);
        case Sample::int16: return number_from<std::int16_t>(bytes);
        case Sample::uint16: return number_from<std::uint16_t>(bytes);
        case Sample::int32: return number_from<std::int32_t>(bytes);
        case Sample::uint32: return number_from<std::uint32_t>(bytes);
        case Sample::int64: return number_from<std::int64_t>(bytes);
        case Sample::uint64: return number_from<std::uint64_t>(bytes);
        case Sample::float32: return number_from<float>(bytes);
        case Sample::float64: return number_from<double>(bytes);
    }
    return 0.0;
}

/// The height at a place, computed one by one: reference of read_raster.
double height_at(const std::string& content, const Raster& raster, const RawScale& scale, Index x, Index y) {
    const Index stored_x = raster.right_to_left ? raster.nx - 1 - x : x,
                stored_y = raster.bottom_up ? raster.ny - 1 - y : y;
    const auto line = static_cast<std::uint64_t>(raster.columns ? stored_x : stored_y),
               sample = static_cast<std::uint64_t>(raster.columns ? stored_y : stored_x);
    auto bytes = content.substr(raster.offset + line * raster.row_distance() + sample * raster.sample_distance(),
                                formats::bytes_of(raster.sample));
    if (raster.order == std::endian::little) std::reverse(bytes.begin(), bytes.end());
    const double raw = raw_number(bytes, raster.sample), height = scale.factor * raw + scale.offset;
    const bool listed = std::find(scale.undefined.begin(), scale.undefined.end(), raw) != scale.undefined.end();
    return raw >= scale.least && raw <= scale.greatest && !listed && std::isfinite(height)
               ? height
               : std::numeric_limits<double>::quiet_NaN();
}

constexpr auto samples = {Sample::int8,   Sample::uint8, Sample::int16,  Sample::uint16,  Sample::int32,
                          Sample::uint32, Sample::int64, Sample::uint64, Sample::float32, Sample::float64};

Raster any_raster(Index max_points, std::uint64_t max_between) {
    Raster raster;
    raster.offset = *rc::gen::inRange<std::uint64_t>(0, 100);
    raster.nx = *rc::gen::inRange<Index>(1, max_points);
    raster.ny = *rc::gen::inRange<Index>(1, max_points);
    raster.sample = *rc::gen::elementOf(std::vector<Sample>(samples));
    raster.order = *rc::gen::element(std::endian::little, std::endian::big);
    raster.columns = *rc::gen::arbitrary<bool>();
    raster.bottom_up = *rc::gen::arbitrary<bool>();
    raster.right_to_left = *rc::gen::arbitrary<bool>();
    if (*rc::gen::arbitrary<bool>())
        raster.step = formats::bytes_of(raster.sample) + *rc::gen::inRange<std::uint64_t>(0, max_between);
    if (*rc::gen::arbitrary<bool>())
        raster.line_distance = raster.row_distance() + *rc::gen::inRange<std::uint64_t>(0, 40 * max_between);
    return raster;
}

RawScale any_scale() {
    RawScale scale{.factor = *rc::gen::element(1.0, -0.25, 1e-9, 1e300), .offset = *rc::gen::element(0.0, 3.5)};
    if (*rc::gen::arbitrary<bool>()) scale.least = *rc::gen::element(-100.0, 0.0, 5.0);
    if (*rc::gen::arbitrary<bool>()) scale.greatest = *rc::gen::element(100.0, 60000.0);
    scale.undefined =
        *rc::gen::element(std::vector<double>{}, std::vector<double>{0.0}, std::vector<double>{1.0, 7.0, 32767.0});
    return scale;
}

/// Bytes of a file that ends with the raster; few different ones, so markers of undefined points occur.
std::string content_of(const Raster& raster, std::uint32_t seed) {
    const auto lines = static_cast<std::uint64_t>(raster.columns ? raster.nx : raster.ny),
               values = static_cast<std::uint64_t>(raster.columns ? raster.ny : raster.nx);
    std::string content(raster.offset + (lines - 1) * raster.row_distance() + (values - 1) * raster.sample_distance() +
                            formats::bytes_of(raster.sample),
                        '\0');
    std::minstd_rand random(seed);
    for (auto& byte : content) {
        const auto number = random() >> 8;
        byte = static_cast<char>(number % 3 == 0 ? number / 3 % 256 : 0);
    }
    return content;
}

void expect_heights(const Raster& raster, const RawScale& scale, const std::string& content,
                    const bytes::Source& source) {
    require_raster(raster, source, "test");
    const auto heights = read_raster(source, raster, scale);
    RC_ASSERT(heights.rows() == raster.nx);
    RC_ASSERT(heights.cols() == raster.ny);
    for (Index x = 0; x < raster.nx; ++x)
        for (Index y = 0; y < raster.ny; ++y) {
            const double expected = height_at(content, raster, scale, x, y);
            RC_ASSERT((std::isnan(expected) ? std::isnan(heights(x, y)) : heights(x, y) == expected));
        }
}

RC_GTEST_PROP(Raster, EqualsReadingNumberByNumber, ()) {
    const auto raster = any_raster(150, 6);
    const auto content = content_of(raster, *rc::gen::arbitrary<std::uint32_t>());
    expect_heights(raster, any_scale(), content, bytes::memory_source("raster", content));
}

RC_GTEST_PROP(Raster, WithLongLinesIsReadInParts, ()) {
    auto raster = any_raster(70, 2);
    raster.step = *rc::gen::element<std::uint64_t>(1500, 2500);  // 64 lines are more than the lines read together
    raster.line_distance = raster.step * static_cast<std::uint64_t>(raster.columns ? raster.ny : raster.nx) +
                           *rc::gen::element<std::uint64_t>(0, 3, 20000);
    const TemporaryFolder folder;
    const auto content = content_of(raster, *rc::gen::arbitrary<std::uint32_t>());
    expect_heights(raster, any_scale(), content, bytes::file_source(folder.write("raster", content)));
}

}  // namespace
}  // namespace setae::formats::tests::raster_property_test
