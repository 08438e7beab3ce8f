// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>

#include "electron_files.hpp"
#include "micrograph_checks.hpp"

namespace setae::imaging::tests::mrc_file_test {
namespace {

TEST(MrcFile, ReadsEveryModeInEitherOrder) {
    for (const bool big_endian : {false, true})
        for (const int mode : {0, 1, 2, 3, 4, 6, 12}) {
            SCOPED_TRACE(testing::Message() << "mode " << mode << " big endian " << big_endian);
            MrcFile file{.big_endian = big_endian, .mode = mode};
            const std::uint64_t halves[] = {0x3C00, 0x4000, 0x4200, 0x4400, 0x4500, 0x4600};  // 1 … 6 as binary16
            for (std::uint64_t i = 1; i <= columns * rows; ++i) {
                const auto real = static_cast<float>(i);
                if (mode == 2) file.pixels += file.order().real32(real);
                else if (mode == 4) file.pixels += file.order().real32(0.6f * real) + file.order().real32(0.8f * real);
                else if (mode == 3)
                    file.pixels += file.order().whole(0, 2) +
                                   file.order().whole(static_cast<std::uint64_t>(-static_cast<std::int64_t>(i)), 2);
                else file.pixels += file.order().whole(mode == 12 ? halves[i - 1] : i, mode == 0 ? 1 : 2);
            }
            const auto micrograph = read_bytes(file.bytes());
            expect_common_picture(micrograph, 1e-6f);
            expect_pixel_size(micrograph, 0.5e-10, 0.25e-10);
            EXPECT_TRUE(has_alert(micrograph, "UNTESTED_FORMAT"));
            EXPECT_EQ(has_alert(micrograph, "COMPLEX_MAGNITUDE"), mode == 3 || mode == 4);
        }
}

TEST(MrcFile, ReadsSignedBytesAndSmallHalves) {
    MrcFile bytes{.mode = 0, .pixels = std::string(6, '\xFE')};
    EXPECT_FLOAT_EQ(read_bytes(bytes.bytes()).pixels(0, 0), -2.0f);
    MrcFile halves{.mode = 12};
    for (const std::uint64_t half : {0x0001, 0x03FF, 0x0400, 0x7BFF, 0xC000, 0x8000})
        halves.pixels += Bytes{}.whole(half, 2);
    const auto pixels = read_bytes(halves.bytes()).pixels;
    EXPECT_FLOAT_EQ(pixels(0, 0), 0x1p-24f);         // the smallest
    EXPECT_FLOAT_EQ(pixels(0, 1), 1023 * 0x1p-24f);  // the largest without leading one
    EXPECT_FLOAT_EQ(pixels(0, 2), 0x1p-14f);
    EXPECT_FLOAT_EQ(pixels(1, 0), 65504.0f);  // the largest
    EXPECT_FLOAT_EQ(pixels(1, 1), -2.0f);
    EXPECT_FLOAT_EQ(pixels(1, 2), 0.0f);
}

TEST(MrcFile, SkipsExtendedHeadersAndReadsTheRequestedSection) {
    auto file = mrc_file();
    file.extended = std::string(77, 'x');
    for (int i = 11; i <= 16; ++i) file.pixels += Bytes{}.real32(static_cast<float>(i));
    file.sections = 2;
    const auto first = read_bytes(file.bytes());
    expect_common_picture(first);
    EXPECT_TRUE(has_alert(first, "SEVERAL_IMAGES"));
    EXPECT_FLOAT_EQ(read_bytes(file.bytes(), {.image = "1"}).pixels(1, 2), 16.0f);
    EXPECT_THROW((void)read_bytes(file.bytes(), {.image = "2"}), InvalidArgument);
}

TEST(MrcFile, UsesAPlausiblePixelSizeOfTheFeiHeader) {
    auto file = mrc_file();
    file.extended_kind = "FEI1";
    const auto entry = [&](double size) {
        std::string text = Bytes{}.whole(768, 4) + std::string(80, '\0') + Bytes{}.real64(3e5) + std::string(64, '\0') +
                           Bytes{}.real64(size) + Bytes{}.real64(2 * size);
        text.resize(768, '\0');
        return text;
    };
    file.extended = entry(1e-10);
    const auto micrograph = read_bytes(file.bytes());
    expect_pixel_size(micrograph, 1e-10, 2e-10);
    EXPECT_EQ(micrograph.attributes.at("voltage"), "300000 V");
    expect_common_picture(micrograph);
    file.extended = entry(1.0);
    expect_pixel_size(read_bytes(file.bytes()), 0.5e-10, 0.25e-10);
}

TEST(MrcFile, HasNoPixelSizeWithoutAPositiveCell) {
    for (const float x : {0.0f, -1.5f, std::nanf(""), std::numeric_limits<float>::infinity()}) {
        auto file = mrc_file();
        file.cell_x = x;
        const auto micrograph = read_bytes(file.bytes());
        EXPECT_FALSE(micrograph.pixel_size) << x;
        EXPECT_TRUE(has_alert(micrograph, "BAD_CALIBRATION")) << x;
    }
}

TEST(MrcFile, WarnsOfAPixelSizeOfOneAngstrom) {
    auto file = mrc_file();
    file.cell_x = columns;
    file.cell_y = rows;
    const auto micrograph = read_bytes(file.bytes());
    expect_pixel_size(micrograph, 1e-10, 1e-10);
    EXPECT_TRUE(has_alert(micrograph, "DEFAULT_CALIBRATION"));
    EXPECT_FALSE(has_alert(read_bytes(mrc_file().bytes()), "DEFAULT_CALIBRATION"));
}

TEST(MrcFile, RefusesOtherModes) {
    auto file = mrc_file();
    file.mode = 101;
    expect_refusal(file.bytes(), "mode 101");
}

}  // namespace
}  // namespace setae::imaging::tests::mrc_file_test
