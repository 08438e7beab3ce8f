// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/picture.hpp"

#include "recordings.hpp"
#include "setae/imaging/micrograph.hpp"

namespace setae::imaging::tests::picture_decoders_test {
namespace {

std::string bitmap(int width, int height, int bits, int packing, const std::string& between,
                   const std::string& pixels) {
    const auto begin = 54 + between.size();
    return "BM" + number_bytes(begin + pixels.size(), 4) + number_bytes(0, 4) + number_bytes(begin, 4) +
           number_bytes(40, 4) + number_bytes(static_cast<std::uint64_t>(width), 4) +
           number_bytes(static_cast<std::uint64_t>(height), 4) + number_bytes(1, 2) +
           number_bytes(static_cast<std::uint64_t>(bits), 2) + number_bytes(static_cast<std::uint64_t>(packing), 4) +
           std::string(20, '\0') + between + pixels;
}

void expect_levels(const std::string& file, const std::vector<float>& levels) {
    const auto frame = decoded_picture(file);
    ASSERT_EQ(frame.fault, "");
    ASSERT_EQ(frame.pixels.size(), static_cast<long>(levels.size()));
    for (std::size_t i = 0; i < levels.size(); ++i) EXPECT_NEAR(frame.pixels.data()[i], levels[i], 1e-4f) << i;
}

float grey(double red, double green, double blue) { return luminance_of(red, green, blue); }

TEST(Bitmap, ReadsEveryWidthOfPixels) {
    const std::string two_greys("\x0A\x0A\x0A\0\xC8\xC8\xC8\0", 8);
    expect_levels(bitmap(3, 2, 1, 0, two_greys, std::string("\x40\0\0\0\xA0\0\0\0", 8)), {200, 10, 200, 10, 200, 10});
    const std::string sixteen = two_greys + std::string(14 * 4, '\0');
    expect_levels(bitmap(3, 1, 4, 0, sixteen, std::string("\x10\x10\0\0", 4)), {200, 10, 200});
    expect_levels(bitmap(1, -2, 24, 0, "", std::string("\1\2\3\0\4\5\6\0", 8)), {grey(3, 2, 1), grey(6, 5, 4)});
    expect_levels(bitmap(2, 1, 32, 0, "", std::string("\1\2\3\0\4\5\6\0", 8)), {grey(3, 2, 1), grey(6, 5, 4)});
    expect_levels(bitmap(2, 1, 16, 0, "", std::string("\x1F\0\xE0\x7F", 4)), {grey(0, 0, 248), grey(248, 248, 0)});
    const auto masks = number_bytes(0xF800, 4) + number_bytes(0x07E0, 4) + number_bytes(0x001F, 4);
    expect_levels(bitmap(2, 1, 16, 3, masks, std::string("\xE0\7\0\xF8", 4)), {grey(0, 252, 0), grey(248, 0, 0)});
}

TEST(Bitmap, ReadsRunLengths) {
    // three of 7, the pixels 1 2 3, a jump over one row, one of 9
    const std::string runs("\3\7\0\3\1\2\3\0\0\2\0\1\0\0\1\x9\0\1", 18);
    expect_levels(bitmap(6, 4, 8, 1, grey_palette(), runs), {0, 0, 0, 0, 0, 0,  //
                                                             9, 0, 0, 0, 0, 0,  //
                                                             0, 0, 0, 0, 0, 0,  //
                                                             7, 7, 7, 1, 2, 3});
    expect_levels(bitmap(5, 1, 4, 2, grey_palette().substr(0, 64), std::string("\2\x12\0\3\x34\x50\0\1", 8)),
                  {1, 2, 3, 4, 5});
    EXPECT_NE(decoded_picture(bitmap(2, 1, 8, 1, grey_palette(), std::string("\3\7\0\1", 4))).fault, "");
}

TEST(Jpeg, UsesStandardTablesIfAVideoOmitsThem) {
    const auto whole = encoded(FramePixels::Constant(16, 16, 90), ".jpg");
    auto bare = whole;
    for (auto at = bare.find("\xFF\xC4"); at != std::string::npos; at = bare.find("\xFF\xC4"))
        bare.erase(at, 2 + 256 * static_cast<unsigned char>(bare[at + 2]) + static_cast<unsigned char>(bare[at + 3]));
    const auto frame = decoded_picture(bare);
    ASSERT_EQ(frame.fault, "");
    EXPECT_TRUE((frame.pixels == decoded_picture(whole).pixels).all());
}

TEST(Jpeg, RefusesTruncatedData) {
    FramePixels pixels(64, 64);
    for (long i = 0; i < pixels.size(); ++i) pixels.data()[i] = static_cast<float>((i * 37) % 251);
    auto file = encoded(pixels, ".jpg");
    file.erase(file.size() / 2, file.size() / 4);
    file.resize(file.size() - 20);
    EXPECT_NE(decoded_picture(file + "\xFF\xD9").fault.find("cannot be decoded"), std::string::npos);
}

TEST(Png, ReadsInterlacedPalettes) {
    std::string file;
    auto* png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    auto* info = png_create_info_struct(png);
    const auto append = [](png_structp from, png_bytep bytes, std::size_t count) {
        static_cast<std::string*>(png_get_io_ptr(from))->append(reinterpret_cast<const char*>(bytes), count);
    };
    png_set_write_fn(png, &file, append, nullptr);
    png_set_IHDR(png, info, 2, 2, 8, PNG_COLOR_TYPE_PALETTE, PNG_INTERLACE_ADAM7, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    const png_color colours[] = {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}};
    png_set_PLTE(png, info, colours, 3);
    png_write_info(png, info);
    png_byte places[] = {0, 1, 2, 0};
    png_bytep rows[] = {places, places + 2};
    png_write_image(png, rows);
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    expect_levels(file, {grey(255, 0, 0), grey(0, 255, 0), grey(0, 0, 255), grey(255, 0, 0)});
}

/// A page with what `describe` sets; `write` writes its pixels.
template <class Describe, class Write>
FramePixels through_tiff(int width, int height, Describe describe, Write write) {
    const Folder folder;
    auto* const tiff = TIFFOpen((folder / "page.tif").c_str(), "w");
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, width);
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, height);
    describe(tiff);
    write(tiff);
    TIFFClose(tiff);
    return read_micrograph(folder / "page.tif").pixels;
}

TEST(Tiff, ReadsPalettesColoursOfJpegAndTiles) {
    std::vector<std::uint16_t> red(256, 0), green(256, 0), blue(256, 0);
    red[1] = green[2] = blue[3] = 65535;
    const auto palette = through_tiff(
        3, 2,
        [&](TIFF* tiff) {
            TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 8);
            TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_PALETTE);
            TIFFSetField(tiff, TIFFTAG_COLORMAP, red.data(), green.data(), blue.data());
        },
        [](TIFF* tiff) {
            unsigned char line[] = {1, 2, 3};
            for (std::uint32_t row = 0; row < 2; ++row) TIFFWriteScanline(tiff, line, row, 0);
        });
    EXPECT_NEAR(palette(0, 1), grey(0, 255, 0), 1e-4f);
    EXPECT_NEAR(palette(0, 2), grey(0, 0, 255), 1e-4f);

    const auto colours = through_tiff(
        16, 16,
        [](TIFF* tiff) {
            TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 8);
            TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 3);
            TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, 16);
            TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_JPEG);
            TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_YCBCR);
            TIFFSetField(tiff, TIFFTAG_JPEGCOLORMODE, JPEGCOLORMODE_RGB);
        },
        [](TIFF* tiff) {
            std::vector<unsigned char> line(48);
            for (std::size_t k = 0; k < 48; ++k) line[k] = k % 3 == 0 ? 200 : k % 3 == 1 ? 100 : 10;
            for (std::uint32_t row = 0; row < 16; ++row) TIFFWriteScanline(tiff, line.data(), row, 0);
        });
    EXPECT_NEAR(colours(8, 8), grey(200, 100, 10), 2.0f);

    const auto tiles = through_tiff(
        20, 18,
        [](TIFF* tiff) {
            TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 16);
            TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
            TIFFSetField(tiff, TIFFTAG_TILEWIDTH, 16);
            TIFFSetField(tiff, TIFFTAG_TILELENGTH, 16);
        },
        [](TIFF* tiff) {
            for (std::uint32_t number = 0; number < 4; ++number) {
                std::vector<std::uint16_t> tile(256, static_cast<std::uint16_t>(1000 * number));
                TIFFWriteEncodedTile(tiff, number, tile.data(), 512);
            }
        });
    EXPECT_EQ(tiles(15, 15), 0);
    EXPECT_EQ(tiles(15, 16), 1000);
    EXPECT_EQ(tiles(17, 19), 3000);
}

}  // namespace
}  // namespace setae::imaging::tests::picture_decoders_test
