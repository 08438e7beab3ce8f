// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <limits>

#include <fmt/format.h>

#include "byte_builder.hpp"
#include "format_samples.hpp"
#include "gwy_sample_parts.hpp"

using namespace setae::tests;

namespace setae::formats::tests {

std::string gwy_object(const std::string& type, const std::string& components) {
    return type + '\0' + ByteBuilder().number(static_cast<std::uint32_t>(components.size())).content() + components;
}
std::string gwy_component(const std::string& name, char type, const std::string& value) {
    return name + '\0' + type + value;
}
std::string gwy_text(const std::string& name, const std::string& value) {
    return gwy_component(name, 's', value + '\0');
}

std::string gwy_field(const Array2D& heights, double x_real, double y_real, const std::string& unit_xy,
                      const std::string& unit_z) {
    const auto unit = [](const std::string& text) { return gwy_object("GwySIUnit", gwy_text("unitstr", text)); };
    std::string components;
    components += gwy_component("xres", 'i', ByteBuilder().number(static_cast<std::int32_t>(heights.rows())).content());
    components += gwy_component("yres", 'i', ByteBuilder().number(static_cast<std::int32_t>(heights.cols())).content());
    components += gwy_component("xreal", 'd', ByteBuilder().number(x_real).content());
    components += gwy_component("yreal", 'd', ByteBuilder().number(y_real).content());
    for (const char* offset : {"xoff", "yoff"}) components += gwy_component(offset, 'd', std::string(8, '\0'));
    components += gwy_component("si_unit_xy", 'o', unit(unit_xy)) + gwy_component("si_unit_z", 'o', unit(unit_z));
    components += gwy_component(
        "data", 'D', ByteBuilder().number(static_cast<std::uint32_t>(heights.size())).rows<double>(heights).content());
    return gwy_object("GwyDataField", components);
}

std::string gwy_file(const std::string& components) { return "GWYP" + gwy_object("GwyContainer", components); }

std::vector<FormatSample> gwy_samples() {
    const auto heights = lopsided_heights(5, 3, 1e-9);
    Array2D with_undefined = heights;
    with_undefined(4, 1) = std::numeric_limits<double>::quiet_NaN();
    const auto field = gwy_field(heights, 5e-6, 2e-6, "m", "m");
    std::string many;
    for (int k = 0; k < 12; ++k)
        many += gwy_component(fmt::format("/{}/data", k), 'o',
                              gwy_field((k == 11 ? 1.0 : 2.0) * heights, 5e-6, 2e-6, "m", "m"));
    // in addition to the map: every type of component
    std::string all = gwy_component("/0/data", 'o', field) + gwy_text("/0/data/title", "Topography ↑") +
                      gwy_component("/0/data/visible", 'b', "\x01");
    all += gwy_component("letter", 'c', "x") +
           gwy_component("long", 'q', ByteBuilder().number(std::int64_t{-5}).content());
    all += gwy_component("letters", 'C', ByteBuilder().number(std::uint32_t{3}).text("abc").content());
    all +=
        gwy_component("integers", 'I',
                      ByteBuilder().number(std::uint32_t{2}).number(std::int32_t{1}).number(std::int32_t{2}).content());
    all += gwy_component("longs", 'Q', ByteBuilder().number(std::uint32_t{1}).number(std::int64_t{1}).content());
    all += gwy_component("texts", 'S', ByteBuilder().number(std::uint32_t{2}).content() + std::string("one\0two\0", 8));
    all += gwy_component("/0/curves", 'O',
                         ByteBuilder().number(std::uint32_t{2}).content() + gwy_object("GwySelection", "") +
                             gwy_object("GwySelection", gwy_text("a", "b")));
    all += gwy_component("/0/meta", 'o',
                         gwy_object("GwyContainer", gwy_text("Date", "2020-01-02") + gwy_text("Operator", "Tom")));
    const auto sample = [&](const std::string& name, std::string content, const Array2D& expected) {
        return FormatSample{.format = "gwy",
                            .name = name,
                            .content = std::move(content),
                            .shape = {5, 3},
                            .size = {5e-6, 2e-6},
                            .heights = expected};
    };
    std::vector<FormatSample> samples{
        sample("every component", gwy_file(all), heights),
        sample("NaN all the same",
               gwy_file(gwy_component("/0/data", 'o', gwy_field(with_undefined, 5e-6, 2e-6, "m", "m"))),
               with_undefined),
        sample("micrometres", gwy_file(gwy_component("/3/data", 'o', gwy_field(1e6 * heights, 5.0, 2.0, "µm", "um"))),
               heights),
        sample("twelve channels", gwy_file(many), heights)};
    samples.back().channel = 11;
    return samples;
}

}  // namespace setae::formats::tests
