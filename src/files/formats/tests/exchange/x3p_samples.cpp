// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "byte_builder.hpp"
#include "format_samples.hpp"
#include "sample_files.hpp"
#include "setae/bytes/digest.hpp"

using namespace setae::tests;

namespace setae::formats::tests {
namespace {

constexpr const char* incremental =
    "<AxisType>I</AxisType><DataType>D</DataType><Increment>1e-6</Increment><Offset>3</Offset>";
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

std::string matrix(Index nx, Index ny, Index layers = 1) {
    return fmt::format("<MatrixDimension><SizeX>{}</SizeX><SizeY>{}</SizeY><SizeZ>{}</SizeZ></MatrixDimension>", nx, ny,
                       layers);
}

std::string height_axis(char type, double increment, double offset) {
    return fmt::format("<AxisType>A</AxisType><DataType>{}</DataType><Increment>{}</Increment><Offset>{}</Offset>",
                       type, increment, offset);
}

template <class Value>
std::string archive(char type, const Array2D& raw, double increment, double offset, const std::string& folder = "") {
    const auto data = ByteBuilder().rows<Value>(raw).content();
    const auto link = fmt::format(
        "<DataLink><PointDataLink>bindata/data.bin</PointDataLink><MD5ChecksumPointData>{}</MD5ChecksumPointData></DataLink>",
        bytes::md5(data));
    return zip_archive({{folder + "main.xml", x3p_document("SUR", incremental, height_axis(type, increment, offset),
                                                           matrix(raw.rows(), raw.cols()), link)},
                        {folder + "bindata/data.bin", data}});
}

FormatSample map_sample(const std::string& name, std::string content, Array2D heights, double tolerance = 1e-12) {
    const std::vector<Index> shape{heights.rows(), heights.cols()};
    return {.format = "x3p",
            .name = name,
            .content = std::move(content),
            .shape = shape,
            .size = {1e-6 * static_cast<double>(shape[0]), 2e-6 * static_cast<double>(shape[1])},
            .heights = std::move(heights),
            .tolerance = tolerance};
}

FormatSample with_valid_points() {
    Array2D heights = lopsided_heights(5, 3, 1e-9);
    const auto data = ByteBuilder().rows<std::int32_t>(lopsided_heights(5, 3, 1.0)).content();
    heights(1, 0) = heights(4, 2) = nan;  // points 1 and 14, counted along x
    const auto valid = ByteBuilder().number<std::uint8_t>(0xfd).number<std::uint8_t>(0x3f).content();
    const auto link =
        "<DataLink><PointDataLink>data.bin</PointDataLink><ValidPointsLink>valid.bin</ValidPointsLink></DataLink>";
    return map_sample(
        "int32 with valid points",
        zip_archive({{"main.xml", x3p_document("SUR", incremental, height_axis('L', 1e-9, 0.0), matrix(5, 3), link)},
                     {"data.bin", data},
                     {"valid.bin", valid}}),
        heights);
}

FormatSample with_undefined_double() {
    Array2D heights = lopsided_heights(5, 3, 1e-9);
    heights(2, 1) = nan;
    return map_sample("float64 with NaN", archive<double>('D', heights, 1.0, 0.0), heights);
}

/// The second of two layers; each has its own channel.
FormatSample layered() {
    const Array2D heights = lopsided_heights(4, 6, 1e-9);
    const auto data = ByteBuilder().rows<double>(Array2D::Constant(4, 6, 1.0)).rows<double>(heights).content();
    auto sample = map_sample(
        "second layer",
        zip_archive({{"main.xml", x3p_document("SUR", incremental, height_axis('D', 1.0, 0.0), matrix(4, 6, 2),
                                               "<DataLink><PointDataLink>d</PointDataLink></DataLink>")},
                     {"d", data}}),
        heights);
    sample.channel = 1;
    return sample;
}

FormatSample listed() {
    Array2D heights = lopsided_heights(3, 2, 1e-3);
    std::string points = "<DataList>";
    for (Index j = 0; j < 2; ++j)
        for (Index i = 0; i < 3; ++i)
            points += i == 1 && j == 1 ? std::string("<Datum/>")
                                       : fmt::format("<Datum>{}</Datum>", std::lround(heights(i, j) * 1e3));
    heights(1, 1) = nan;
    return map_sample(
        "bare document with listed points",
        x3p_document("SUR", incremental, height_axis('I', 1e-3, 0.0), matrix(3, 2), points + "</DataList>"), heights);
}

/// x, y and z of each point, the first two on a grid.
FormatSample absolute() {
    const Array2D heights = lopsided_heights(3, 4, 1e-9);
    ByteBuilder data;
    for (Index j = 0; j < 4; ++j)
        for (Index i = 0; i < 3; ++i) data.number(0.5e-6 + 1e-6 * static_cast<double>(i)).number(heights(i, j));
    const auto x = "<AxisType>A</AxisType><DataType>D</DataType>";
    return map_sample("absolute x",
                      zip_archive({{"main.xml", x3p_document("SUR", x, height_axis('D', 1.0, 0.0), matrix(3, 4),
                                                             "<DataLink><PointDataLink>d</PointDataLink></DataLink>")},
                                   {"d", data.content()}}),
                      heights);
}

FormatSample profile() {
    const Array2D heights = lopsided_heights(7, 1, 1e-9);
    const auto data = ByteBuilder().rows<double>(heights).content();
    return {
        .format = "x3p",
        .name = "profile",
        .content = zip_archive({{"main.xml", x3p_document("PRF", incremental, height_axis('D', 1.0, 0.0), matrix(7, 1),
                                                          "<DataLink><PointDataLink>d</PointDataLink></DataLink>")},
                                {"d", data}}),
        .shape = {7},
        .size = {7e-6},
        .heights = heights};
}

}  // namespace

std::vector<FormatSample> x3p_samples() {
    const auto raw = lopsided_heights(5, 3, 1.0);
    const Array2D shifted = 1e-9 * (raw - 200.0) - 5e-7;  // some negative: the integers are signed
    const auto inner = archive<std::int16_t>('I', raw - 200.0, 1e-9, -5e-7);
    std::vector<FormatSample> samples{
        map_sample("int16 with offset", inner, shifted),
        map_sample("float32", archive<float>('F', raw, 1e-9, 0.0), 1e-9 * raw),
        with_undefined_double(),
        with_valid_points(),
        map_sample("in a folder", archive<double>('D', raw, 1e-9, 0.0, "folder/"), 1e-9 * raw),
        map_sample("archive of archives",
                   zip_archive({{"first.x3p", archive<float>('F', raw, 1e-9, 0.0)}, {"second.X3P", inner}}), shifted),
        layered(),
        listed(),
        absolute(),
        profile()};
    samples[5].channel = 1;
    return samples;
}

}  // namespace setae::formats::tests
