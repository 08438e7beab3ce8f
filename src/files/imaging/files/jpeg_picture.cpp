// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>  // before jpeglib.h, which needs FILE

#include <jpeglib.h>

#include <jerror.h>

#include <array>
#include <csetjmp>
#include <vector>

#include <fmt/format.h>

#include "picture_decoders.hpp"

// libjpeg returns by longjmp on errors: the functions that call it below have no objects to be destroyed.
namespace setae::imaging {
namespace {

struct Faults : jpeg_error_mgr {
    std::jmp_buf back;
    std::array<char, JMSG_LENGTH_MAX> message{};
};

[[noreturn]] void leave(j_common_ptr jpeg) {
    auto& faults = *static_cast<Faults*>(jpeg->err);
    faults.format_message(jpeg, faults.message.data());
    std::longjmp(faults.back, 1);
}

/// Warnings after which libjpeg continues with invented pixels.
void leave_on_corrupt_data(j_common_ptr jpeg, int level) {
    if (level >= 0) return;
    switch (jpeg->err->msg_code) {
        case JWRN_JPEG_EOF:
        case JWRN_HIT_MARKER:
        case JWRN_HUFF_BAD_CODE:
        case JWRN_ARITH_BAD_CODE: leave(jpeg);
        default: return;
    }
}

void print_nothing(j_common_ptr) {}

struct Reader {
    Faults faults;
    jpeg_decompress_struct jpeg{};

    Reader() {
        jpeg.err = jpeg_std_error(&faults);
        faults.error_exit = leave;
        faults.emit_message = leave_on_corrupt_data;
        faults.output_message = print_nothing;
    }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;
    ~Reader() { jpeg_destroy_decompress(&jpeg); }
};

/// Reads up to the pixels, which become grey, red, green and blue, or cyan, magenta, yellow and black.
bool read_header(Reader& reader, const unsigned char* bytes, unsigned long count) {
    if (setjmp(reader.faults.back)) return false;
    jpeg_create_decompress(&reader.jpeg);
    jpeg_mem_src(&reader.jpeg, bytes, count);
    jpeg_read_header(&reader.jpeg, TRUE);
    const int components = reader.jpeg.num_components;
    reader.jpeg.out_color_space = components == 1 ? JCS_GRAYSCALE : components == 4 ? JCS_CMYK : JCS_RGB;
    jpeg_start_decompress(&reader.jpeg);
    return true;
}

bool read_rows(Reader& reader, JSAMPARRAY rows) {
    if (setjmp(reader.faults.back)) return false;
    while (reader.jpeg.output_scanline < reader.jpeg.output_height)
        jpeg_read_scanlines(&reader.jpeg, rows + reader.jpeg.output_scanline,
                            reader.jpeg.output_height - reader.jpeg.output_scanline);
    jpeg_finish_decompress(&reader.jpeg);
    return true;
}

/// Converts inks, stored inverted, to red, green and blue in place.
void mix_inks(std::vector<JSAMPLE>& pixels) {
    for (std::size_t at = 0; at < pixels.size(); at += 4)
        for (std::size_t ink = 0; ink < 3; ++ink)
            pixels[at + ink] = static_cast<JSAMPLE>(pixels[at + 3] - ((255 - pixels[at + ink]) * pixels[at + 3] >> 8));
}

}  // namespace

FrameRead decoded_jpeg(std::string_view bytes, PictureSize size) {
    Reader reader;
    const auto damaged = [&] {
        return FrameRead{{}, fmt::format("cannot be decoded: {}", reader.faults.message.data())};
    };
    if (!read_header(reader, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size())) return damaged();
    const int channels = reader.jpeg.output_components;
    const auto height = static_cast<std::size_t>(size.height),
               stride = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(channels);
    if (reader.jpeg.output_height != height || reader.jpeg.output_width * static_cast<std::size_t>(channels) != stride)
        return {{}, "cannot be decoded: two sizes are stated; the file is damaged"};
    std::vector<JSAMPLE> pixels(stride * height);
    std::vector<JSAMPROW> rows(height);
    for (std::size_t row = 0; row < height; ++row) rows[row] = pixels.data() + row * stride;
    if (!read_rows(reader, rows.data())) return damaged();
    if (channels == 4) mix_inks(pixels);
    return {luminance(pixels.data(), size, channels, static_cast<long>(stride)), {}};
}

}  // namespace setae::imaging
