// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include "byte_builder.hpp"
#include "format_samples.hpp"
#include "setae/core/constants.hpp"
#include "vca_builder.hpp"

using namespace setae::tests;

namespace setae::formats::tests {
namespace {

constexpr int nx = 7, ny = 4, points = 9;
constexpr double pixel = 0.5;  // [µm]
const std::string micrometer = "Micrometer", symbol = "\xc2\xb5m";

std::string settings(const std::string& mode) {
    using namespace vca;
    return container("MeasurementSettings",
                     {string("InstrumentName", "Dektak Profiler"), string("MeasMode", mode),
                      string("StylusType", "Radius: 2 \xce\xbcm"), number<bool>("SoftTouchdown", 0x01, true),
                      number<std::int16_t>("Frames", 0x04, -3), number<std::uint16_t>("Passes", 0x05, 2),
                      number<float>("Speed", 0x0c, 1.5f), number<std::int64_t>("Count", 0x0a, -5),
                      quantity("StylusForce", 3.0, "Milligram", "mg")});
}

std::string file(const std::string& lines, const std::string& maps, const std::string& mode) {
    using namespace vca;
    const auto metadata = container(
        "MetaData",
        {string("DataKind", mode == "Stylus" ? "Surface Profile" : "Surface Height"), string("Date", "2/11/2021"),
         string("Time", "11:39:13 PM"), item("TimeStamp", 0x15, std::string("\x01\x8b\xe1\xab\xc9\xff\xcf\xd7\x01", 9)),
         string("PrimaryData2D", "Height"), container("2D_Channels", {string_list("Height", {"Filled", "Height"})}),
         container("1D_Channels", {string_list("Height", {"Raw"})}), settings(mode)});
    return std::string("VCA DATA\x01\x00\x00\x55", 12) + lines + maps + metadata + item("", 0x7f, "\xff\xff");
}

/// A map whose extents go from the first point to the last.
template <class T>
std::string map(const std::string& title, const Array2D& raw, double scale, bool anonymous) {
    using namespace vca;
    const auto dimension = ByteBuilder()
                               .number(pixel)
                               .text(name(micrometer))
                               .text(name(symbol))
                               .number(1e6)
                               .number<std::int32_t>(1)
                               .number<std::int64_t>(0)
                               .content();
    return container(
        title,
        {item("PositionFunction", 0x7c, name("FixedSpacing2D") + sized(dimension + dimension)),
         number<std::uint32_t>("Dimension1Points", 0x07, ny), number<std::uint32_t>("Dimension2Points", 0x07, nx),
         quantity("Dimension1Extent", (ny - 1) * pixel, micrometer, symbol),
         quantity("Dimension2Extent", (nx - 1) * pixel, micrometer, symbol),
         quantity("DataScale", scale, "Nanometer", "nm"), string("DataKind", "Height"),
         matrix<T>("Matrix", raw, anonymous),
         item("ValueTypeID", 0x0e, name("enum Vca::DataCore::ETypeID") + sized(std::string("\x0c\0\0\0", 4)))},
        0x47);
}

template <class T>
FormatSample map_sample(const std::string& name, bool anonymous) {
    constexpr double scale = 12.5;  // nm
    Array2D raw = lopsided_heights(nx, ny, 1.0), heights = raw * (scale * units::nm);
    raw(3, 2) = std::numeric_limits<double>::quiet_NaN();
    raw(4, 1) = 1e38;
    heights(3, 2) = heights(4, 1) = undefined;
    const auto intensity = vca::container(
        "Intensity", {vca::string("DataKind", "Intensity"), vca::matrix<float>("Matrix", raw, false)}, 0x47);
    const auto maps = vca::container("2D_Data", {intensity, map<T>("Height", raw, scale, anonymous),
                                                 map<float>("Filled", raw * 2.0, scale, anonymous)});
    return {.format = "opdx",
            .name = name,
            .content = file(vca::container("1D_Data", {}), maps, "VSI"),
            .shape = {nx, ny},
            .size = {nx * pixel * units::um, ny * pixel * units::um},
            .heights = heights};
}

template <class T>
FormatSample line_sample(const std::string& name) {
    using namespace vca;
    constexpr double scale = 0.25;  // µm
    const Array1D raw = lopsided_heights(points, 1, 1.0).reshaped();
    const auto line = container(
        "Raw",
        {array<double>("PositionArray", Array1D::LinSpaced(points, 0.0, (points - 1) * pixel)),
         string("DataKind", "Height"), quantity("Extent", (points - 1) * pixel, micrometer, symbol),
         number<std::uint64_t>("NumPoints", 0x0b, points), quantity("DataScale", scale, micrometer, symbol),
         item("PositionUnits", 0x18, sized(vca::name(micrometer) + vca::name(symbol) + std::string(20, '\0'))),
         array<T>("Array", raw)},
        0x46);
    return {.format = "opdx",
            .name = name,
            .content = file(container("1D_Data", {line}), container("2D_Data", {}), "Stylus"),
            .shape = {points},
            .size = {points * pixel * units::um},
            .heights = raw * (scale * units::um)};
}

}  // namespace

std::vector<FormatSample> opdx_samples() {
    return {map_sample<float>("map", false), map_sample<float>("map of anonymous type", true),
            map_sample<double>("map of 8 bytes", false), line_sample<double>("profile"),
            line_sample<float>("profile of 4 bytes")};
}

}  // namespace setae::formats::tests
