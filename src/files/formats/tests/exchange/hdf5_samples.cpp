// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "format_samples.hpp"
#include "hdf5_builder.hpp"
#include "setae/core/constants.hpp"

using namespace setae::tests;

namespace setae::formats::tests {
namespace {

using Layout = Hdf5Builder::Layout;

std::vector<hsize_t> extents_of(const Array2D& map) {
    return {static_cast<hsize_t>(map.rows()), static_cast<hsize_t>(map.cols())};
}

/// A map [nm] in a group with unit, its size given by the user.
FormatSample map_sample(const std::string& name, hid_t type, const Layout& layout,
                        const Hdf5Builder::Options& options = {}) {
    const auto map = lopsided_heights(7, 5, 1.0);
    Hdf5Builder file(options);
    file.dataset("/scan/height", type, extents_of(map), first_index_x(map), layout)
        .attribute("/scan/height", "unit", std::string("nm"));
    return {.format = "hdf5",
            .name = name,
            .content = file.bytes(),
            .options = {.size = {{7e-6, 5e-6}}, .unit = {}},
            .shape = {7, 5},
            .size = {7e-6, 5e-6},
            .heights = map * units::nm};
}

FormatSample line_sample() {
    const std::vector<double> values{4.0, 3.0, std::nan(""), 1.0, 7.0};
    Hdf5Builder file;
    file.dataset("/line", H5T_IEEE_F32LE, {5}, values)
        .variable_text("/line", "units", "µm")
        .attribute("/line", "element_size_um", std::vector<double>{0.5});
    Array2D heights = Eigen::Map<const Array2D>(values.data(), 5, 1) * units::um;
    return {.format = "hdf5",
            .name = "line with unit and step",
            .content = file.bytes(),
            .shape = {5},
            .size = {2.5e-6},
            .heights = heights};
}

/// A map with a point undefined; pixels of 0.2 × 0.3 µm, heights in `unit` [m].
FormatSample datx_sample(const std::string& name, const std::string& unit, double metres, const Layout& layout,
                         const Hdf5Builder::Options& options) {
    constexpr double no_data = 1.7976931348623157e308;
    Array2D map = lopsided_heights(6, 4, 1.0);
    map(2, 3) = no_data;
    const std::string surface = "/Data/Surface/{7B0A}";
    Hdf5Builder file(options);
    file.text_table("/MetaData", {{"Root", "Measurement", "{1}"}, {"{1}", "Surface", "{2}"}, {"{2}", "Path", surface}},
                    40);
    file.dataset("/Data/Intensity/{11}", H5T_STD_U16LE, {4, 6}, std::vector<double>(24, 5.0))
        .dataset(surface, H5T_IEEE_F64LE, {4, 6}, first_index_y(map), layout);
    file.attribute(surface, "Unit", unit).attribute(surface, "No Data", std::vector<double>{no_data});
    file.converter(surface, "X Converter", {"LateralCat", "Pixels", {0.0, 0.2e-6, 0.0}})
        .converter(surface, "Y Converter", {"LateralCat", "Pixels", {0.0, 0.3e-6, 0.0}});
    file.converter(surface, "Z Converter", {"HeightCat", unit, {0.0, 1.0}});
    file.attribute(surface, "Wavelength", std::vector<double>{632.8e-9})
        .attribute(surface, "Interferometric Scale Factor", std::vector<double>{0.5});
    file.attribute(surface, "Obliquity Factor", std::vector<double>{1.25});
    file.group("/Attributes/{A}")
        .attribute("/Attributes/{A}", "Data Context.Data Attributes.System Type", std::string("NewView 9000"));
    file.attribute("/Attributes/{A}", "Data Context.Data Attributes.System Serial Number", std::string("4711"));
    map(2, 3) = std::nan("");
    return {.format = "datx",
            .name = name,
            .content = file.bytes(),
            .shape = {6, 4},
            .size = {1.2e-6, 1.2e-6},
            .heights = map * metres};
}

/// `frames` frames of 5 × 3 pixels, the k-th 1000 k higher; heights = 2e-9 raw + 1e-9 m. The last frame is that of the
/// sample.
FormatSample jpk_sample(const std::string& name, hsize_t frames, const Layout& layout) {
    const auto map = lopsided_heights(5, 3, 1.0);
    std::vector<double> values;
    for (Index row = 2; row >= 0; --row)
        for (Index i = 0; i < 5; ++i)
            for (hsize_t frame = 0; frame < frames; ++frame)
                values.push_back(map(i, row) + 1000.0 * static_cast<double>(frame));
    const std::string measurement = "/Measurement_000", channel = measurement + "/Channel_001";
    Hdf5Builder file;
    file.dataset(channel + "/Height", H5T_STD_I32LE, {15, frames}, values, layout)
        .attribute(channel, "channel.name", std::string("height"));
    file.attribute(channel, "retrace", std::string("true"));
    file.attribute(channel, "net-encoder.scaling.multiplier", std::vector<double>{2e-9})
        .attribute(channel, "net-encoder.scaling.offset", std::vector<double>{1e-9});
    file.attribute(measurement, "position-pattern.grid.ilength", std::vector<double>{5})
        .attribute(measurement, "position-pattern.grid.jlength", std::vector<double>{3});
    file.attribute(measurement, "position-pattern.grid.ulength", std::vector<double>{500e-9});
    file.attribute(measurement, "position-pattern.grid.vlength", std::vector<double>{300e-9});
    file.attribute(measurement, "timing-settings.scanRate", std::vector<double>{128.0});
    const double above = 1000.0 * static_cast<double>(frames - 1);
    return {.format = "jpk-hdf5",
            .name = name,
            .content = file.bytes(),
            .channel = frames - 1,
            .shape = {5, 3},
            .size = {500e-9, 300e-9},
            .heights = 2e-9 * (map + above) + 1e-9};
}

}  // namespace

std::vector<FormatSample> hdf5_samples() {
    return {map_sample("float64", H5T_IEEE_F64LE, {}),
            map_sample("float32, big-endian, newest structures", H5T_IEEE_F32BE, {}, {.newest = true}),
            map_sample("int16 in pieces", H5T_STD_I16LE, {.chunk = {3, 2}}),
            map_sample("uint32 packed", H5T_STD_U32BE,
                       {.chunk = {2, 5}, .shuffled = true, .deflated = true, .summed = true}, {.newest = true}),
            map_sample("one piece larger than the map", H5T_IEEE_F64LE, {.chunk = {9, 8}, .deflated = true}),
            map_sample("int64 in the header", H5T_STD_I64LE, {.compact = true}),
            map_sample("behind a block of the user's", H5T_STD_U16LE, {}, {.user_block = 1024}),
            line_sample()};
}

std::vector<FormatSample> datx_samples() {
    return {datx_sample("nanometres", "NanoMeters", units::nm, {}, {}),
            datx_sample("fringes, packed", "Fringes", 632.8e-9 * 0.5 * 1.25, {.chunk = {3, 3}, .deflated = true},
                        {.newest = true})};
}

std::vector<FormatSample> jpk_hdf5_samples() {
    return {jpk_sample("an image", 1, {}),
            jpk_sample("a film, packed", 3, {.chunk = {4, 2}, .shuffled = true, .deflated = true})};
}

std::vector<FormatSample> topostats_samples() {
    const auto map = lopsided_heights(7, 5, 1.0);
    std::vector<double> rows;
    for (Index j = 0; j < map.cols(); ++j)
        for (Index i = 0; i < map.rows(); ++i) rows.push_back(map(i, j));
    Hdf5Builder file;
    file.dataset("/grain_mask", H5T_STD_U8LE, {5, 7}, std::vector<double>(35, 1.0))
        .dataset("/image", H5T_IEEE_F64LE, {5, 7}, rows)
        .dataset("/pixel_to_nm_scaling", H5T_IEEE_F64LE, {1}, {2.0});
    return {{.format = "topostats",
             .name = "image with mask",
             .content = file.bytes(),
             .channel = 1,
             .shape = {7, 5},
             .size = {14 * units::nm, 10 * units::nm},
             .heights = map * units::nm}};
}

}  // namespace setae::formats::tests
