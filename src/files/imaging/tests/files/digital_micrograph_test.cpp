// SPDX-License-Identifier: GPL-3.0-or-later
#include "micrograph_checks.hpp"

namespace setae::imaging::tests::digital_micrograph_test {
namespace {

/// The common picture in every type of number that an image may have, each with the type of its array.
struct Type {
    int data_type, element, bytes;
};
constexpr Type whole_types[] = {{9, 9, 1}, {6, 10, 1}, {14, 8, 1},  {1, 2, 2},  {10, 4, 2},
                                {7, 3, 4}, {11, 5, 4}, {39, 11, 8}, {40, 12, 8}};

DmFile whole_numbers(const Type& type, int version, bool big_endian) {
    DmFile file{.version = version, .big_endian = big_endian, .data_type = type.data_type, .element = type.element};
    for (std::uint64_t i = 1; i <= columns * rows; ++i) file.pixels += file.order().whole(i, type.bytes);
    return file;
}

TEST(DigitalMicrograph, ReadsEveryWholeTypeInEitherVersionAndOrder) {
    for (const int version : {3, 4})
        for (const bool big_endian : {false, true})
            for (const auto& type : whole_types) {
                SCOPED_TRACE(testing::Message()
                             << "version " << version << " big endian " << big_endian << " type " << type.data_type);
                const auto micrograph = read_bytes(whole_numbers(type, version, big_endian).bytes());
                expect_common_picture(micrograph);
                expect_pixel_size(micrograph, 0.5e-9, 0.25e-9);
                EXPECT_EQ(micrograph.format, version == 3 ? "dm3" : "dm4");
            }
}

TEST(DigitalMicrograph, ReadsNegativeNumbers) {
    for (const auto& type : {Type{9, 9, 1}, Type{1, 2, 2}, Type{7, 3, 4}, Type{39, 11, 8}}) {
        DmFile file{.data_type = type.data_type, .element = type.element};
        for (int i = 1; i <= columns * rows; ++i)
            file.pixels += file.order().whole(static_cast<std::uint64_t>(-i), type.bytes);
        EXPECT_FLOAT_EQ(read_bytes(file.bytes()).pixels(1, 2), -6.0f) << type.data_type;
    }
}

TEST(DigitalMicrograph, ReadsRealNumbers) {
    for (const int version : {3, 4})
        for (const bool big_endian : {false, true}) {
            expect_common_picture(read_bytes(dm_file(version, big_endian).bytes()));
            DmFile file{.version = version, .big_endian = big_endian, .data_type = 12, .element = 7};
            for (int i = 1; i <= columns * rows; ++i) file.pixels += file.order().real64(i);
            expect_common_picture(read_bytes(file.bytes()));
        }
}

TEST(DigitalMicrograph, ReadsMagnitudesOfComplexNumbersWithAWarning) {
    for (const int type : {3, 13}) {
        DmFile file{.data_type = type, .element = type == 3 ? 6 : 7, .pairs = true};
        for (int i = 1; i <= columns * rows; ++i)
            for (const double part : {0.6 * i, -0.8 * i})
                file.pixels += type == 3 ? file.order().real32(static_cast<float>(part)) : file.order().real64(part);
        const auto micrograph = read_bytes(file.bytes());
        expect_common_picture(micrograph, 1e-6f);
        EXPECT_TRUE(has_alert(micrograph, "COMPLEX_MAGNITUDE"));
    }
}

TEST(DigitalMicrograph, ReadsLuminanceOfPackedColours) {
    for (const bool big_endian : {false, true}) {
        DmFile file{.big_endian = big_endian, .data_type = 23, .element = 5};
        for (std::uint64_t i = 0; i < columns * rows; ++i)
            file.pixels += file.order().whole(0xFF000000U | (200U << 16) | (100U << 8) | (10 * i), 4);
        EXPECT_NEAR(read_bytes(file.bytes()).pixels(1, 2), 0.299 * 200 + 0.587 * 100 + 0.114 * 50, 1e-4);
    }
}

TEST(DigitalMicrograph, GivesEachAxisItsOwnScaleAndUnit) {
    auto file = dm_file();
    file.scales = {{1.0, "nm"}, {2.0, "A"}};
    const auto micrograph = read_bytes(file.bytes());
    expect_pixel_size(micrograph, 1e-9, 2e-10);
    EXPECT_EQ(micrograph.unit, "nm, A");
    EXPECT_TRUE(has_alert(micrograph, "PIXELS_NOT_SQUARE"));
    file.scales = {{0.25, "\xB5m"}, {0.25, "\xB5m"}};
    const auto square = read_bytes(file.bytes());
    expect_pixel_size(square, 0.25e-6, 0.25e-6);
    EXPECT_FALSE(has_alert(square, "PIXELS_NOT_SQUARE"));
}

TEST(DigitalMicrograph, HasNoPixelSizeIfTheUnitIsNotALength) {
    auto file = dm_file();
    for (const auto& [unit, code] :
         {std::pair{"1/nm", "RECIPROCAL_UNITS"}, {"", ""}, {"pixels", ""}, {"mrad", "UNKNOWN_UNIT"}}) {
        file.scales = {{1.0, unit}, {1.0, unit}};
        const auto micrograph = read_bytes(file.bytes());
        EXPECT_FALSE(micrograph.pixel_size) << unit;
        EXPECT_EQ(micrograph.alerts.size(), *code ? 1U : 0U) << unit;
        EXPECT_TRUE(micrograph.alerts.empty() || has_alert(micrograph, code)) << unit;
    }
    file.scales = {{0.0, "nm"}, {1.0, "nm"}};
    EXPECT_TRUE(has_alert(read_bytes(file.bytes()), "BAD_CALIBRATION"));
}

TEST(DigitalMicrograph, ReadsMicroscopeTimeAndVoltage) {
    const auto micrograph = read_bytes(dm_file(4).bytes());
    EXPECT_EQ(micrograph.instrument, "JEM");
    EXPECT_EQ(micrograph.acquisition_time, "1/2/2020 3:04");
    EXPECT_EQ(micrograph.attributes.at("voltage"), "200000 V");
    EXPECT_EQ(micrograph.attributes.at("magnification"), "100000");
}

TEST(DigitalMicrograph, RefusesSpectra) {
    auto file = dm_file();
    file.scales = {{0.5, "eV"}, {1.0, ""}};
    expect_refusal(file.bytes(), "a spectrum");
    file = dm_file();
    file.dimensions = {columns * rows};
    expect_refusal(file.bytes(), "a spectrum");
    file.dimensions = {columns * rows, 1};
    expect_refusal(file.bytes(), "a spectrum");
}

TEST(DigitalMicrograph, ReadsTheFirstPlaneOfAStackWithAWarning) {
    auto file = dm_file();
    file.pixels += file.pixels;
    file.dimensions = {columns, rows, 2};
    const auto micrograph = read_bytes(file.bytes());
    expect_common_picture(micrograph);
    EXPECT_TRUE(has_alert(micrograph, "STACK"));
}

TEST(DigitalMicrograph, RefusesADamagedTagTree) {
    const auto whole = dm_file().bytes();
    auto kind = whole;
    kind[18] = 99;  // of the first tag
    expect_refusal(kind, "a tag of kind 99");
    auto mark = whole;
    mark[mark.find("%%%%")] = '!';
    expect_refusal(mark, "lack the mark");
    auto many = whole;
    many[14] = 127;  // tags of the root
    expect_refusal(many, "damaged");
    auto few = dm_file();
    few.data_type = 12;  // twice the existing bytes
    expect_refusal(few.bytes(), "24 bytes of pixels, but 3 × 2 of 8 bytes need 48");
    auto unknown = dm_file();
    unknown.data_type = 5;
    expect_refusal(unknown.bytes(), "type 5");
    DmFile nested;
    std::string deep = nested.members({});
    for (int i = 0; i < 200; ++i) deep = nested.members({nested.entry(20, "", deep)});
    expect_refusal(Bytes{true}.whole(3, 4) + Bytes{true}.whole(deep.size(), 4) + Bytes{true}.whole(1, 4) + deep,
                   "deep");
}

TEST(DigitalMicrograph, RefusesOtherImageNumbers) {
    EXPECT_THROW((void)read_bytes(dm_file().bytes(), {.image = "1"}), InvalidArgument);
}

}  // namespace
}  // namespace setae::imaging::tests::digital_micrograph_test
