// SPDX-License-Identifier: GPL-3.0-or-later
#include "zon_samples.hpp"

#include <zstd.h>

#include <limits>

#include "byte_builder.hpp"
#include "format_samples.hpp"
#include "profilers/vk_samples.hpp"
#include "setae/core/constants.hpp"

using namespace setae::tests;

namespace setae::formats::tests {
namespace {

constexpr int nx = 7, ny = 4;

/// Rows are padded to a multiple of 8 bytes and 8 more.
template <class Value>
std::string point_array(const Array2D& raw) {
    const auto row_bytes = (static_cast<std::size_t>(raw.rows()) * sizeof(Value) + 15) / 8 * 8;
    ByteBuilder bytes;
    bytes.number(static_cast<std::uint32_t>(raw.rows()))
        .number(static_cast<std::uint32_t>(raw.cols()))
        .number(static_cast<std::uint32_t>(sizeof(Value)))
        .number(static_cast<std::uint32_t>(row_bytes));
    for (Index j = 0; j < raw.cols(); ++j) {
        for (Index i = 0; i < raw.rows(); ++i) bytes.number(static_cast<Value>(raw(i, j)));
        bytes.pad_to(16 + static_cast<std::size_t>(j + 1) * row_bytes);
    }
    return bytes.content();
}

std::string zstd_stream(const std::string& content) {
    std::string stream(ZSTD_compressBound(content.size()), '\0');
    stream.resize(ZSTD_compress(stream.data(), stream.size(), content.data(), content.size(), 3));
    return stream;
}

std::string xml(const std::string& text) { return "\xef\xbb\xbf<?xml version=\"1.0\" encoding=\"utf-8\"?>\r\n" + text; }

FormatSample described(const std::string& format, const std::string& name, const std::string& content,
                       const ZonFile& file, std::size_t channel = 0) {
    Array2D heights = file.raw * (10.0 * units::nm);
    if (file.validity.size() > 0)
        heights = (file.validity == 1.0 || file.validity == 2.0 || file.validity == 131.0)
                      .select(std::numeric_limits<double>::quiet_NaN(), heights);
    return {.format = format,
            .name = name,
            .content = content,
            .channel = channel,
            .shape = {nx, ny},
            .size = {nx * 2.0 * units::um, ny * 2.0 * units::um},
            .heights = heights};
}

}  // namespace

Members zon_members(const ZonFile& file) {
    Members members{
        {"686613b8-27b5-4a29-8ffc-438c2780873e",
         xml("<Calibration><XYCalibration><MeterPerPixel>2E-06</MeterPerPixel></XYCalibration><ZCalibration><MeterPerUnit>1E-08</MeterPerUnit></ZCalibration></Calibration>")},
        {"cbc1d39b-215f-4d56-a20e-cf8e5f570755",
         xml("<DeviceInformations><DeviceModelName>VR-6200</DeviceModelName><DeviceSerialId>1A2</DeviceSerialId></DeviceInformations>")},
        {"1d35862b-3b48-4df2-9235-833ef590b043",
         xml("<ScanInformations><ScanDateTime>2023-05-17T08:12:05.1234567+02:00</ScanDateTime></ScanInformations>")},
        {"4cdb0c75-5706-48cc-a9a1-adf395d609ae", point_array<std::int32_t>(file.raw)}};
    if (file.validity.size() > 0)
        members.emplace_back("9e7ca6dd-0e6a-4d7b-8986-f0a7b773c916", point_array<std::uint8_t>(file.validity));
    if (file.colour) members.emplace_back("c65a358c-2782-481d-9f05-b9b233b3802d", "colours");
    return members;
}

std::string keyence_package(Members members, bool packed) {
    if (packed)
        for (auto& [name, content] : members) content = zstd_stream(content);
    return ByteBuilder()
               .text(packed ? "KPK1" : "KPK0")
               .number(static_cast<std::uint32_t>(bmp_picture().size()))
               .text(bmp_picture())
               .content() +
           zip_archive(members);
}

std::string zon_file(const ZonFile& file) { return keyence_package(zon_members(file), file.packed); }

std::string zag_file(const Members& files) {
    const std::string item = "2b6a2d5e-0c3f-4d53-9d7b-6d9c2f1e7a10",
                      list = item + "/7d0f2c5a-45f5-4f0f-8a8e-0d1f5a9b3c22";
    std::string measurements;
    Members members;
    for (std::size_t i = 0; i < files.size(); ++i) {
        const auto& [name, content] = files[i];
        measurements += fmt::format(
            "<MeasurementData><Path>m{}</Path><OriginalFileName>C:\\data\\{}</OriginalFileName><Visible>{}</Visible></MeasurementData>",
            i, name, !name.starts_with("hidden"));
        members.emplace_back(fmt::format("{}/m{}/84b648d7-e44f-4909-ac11-0476720a67ff", item, i), content);
    }
    members.emplace_back("f1724dc6-686c-4502-9227-2a594bc8ed33",
                         xml("<DeserializeDataMap><Item><Path>" + list +
                             "</Path></Item><Item><Path>t/other</Path></Item></DeserializeDataMap>"));
    members.emplace_back(list, xml("<MeasurementDataMap>" + measurements + "</MeasurementDataMap>"));
    members.emplace_back("t/other", xml("<TemplateDataMap/>"));
    return keyence_package(members, false);
}

std::vector<FormatSample> zon_samples() {
    const ZonFile plain{.raw = lopsided_heights(nx, ny, 10.0) - 2000.0};
    ZonFile judged = plain;
    judged.validity = Array2D::Zero(nx, ny);
    judged.validity(1, 2) = 1.0;
    judged.validity(3, 0) = 2.0;
    judged.validity(6, 3) = 131.0;  // rated and not measured
    judged.validity(0, 1) = 128.0;  // only rated
    judged.colour = true;
    ZonFile packed = judged;
    packed.packed = true;
    return {described("zon", "KPK0", zon_file(plain), plain),
            described("zon", "KPK0 with validity", zon_file(judged), judged),
            described("zon", "KPK1 with validity", zon_file(packed), packed)};
}

std::vector<FormatSample> zag_samples() {
    const ZonFile first{.raw = lopsided_heights(nx, ny, 10.0)},
        second{.raw = lopsided_heights(nx, ny, 7.0) - 300.0, .packed = true};
    return {described("zag", "second of two", zag_file({{"a.zon", zon_file(first)}, {"b.zon", zon_file(second)}}),
                      second, 1)};
}

}  // namespace setae::formats::tests
