// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/bytes/tiff_writer.hpp"

#include <memory>
#include <vector>

#include <tiffio.h>

#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"

namespace setae::bytes {
namespace {

struct CloseWrittenTiff {
    void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};

void set_tags(TIFF* tiff, const GreyPages& pages, bool first) {
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, pages.width);
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, pages.height);
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 8);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
    TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_LZW);
    TIFFSetField(tiff, TIFFTAG_PREDICTOR, PREDICTOR_HORIZONTAL);
    TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, pages.height);
    TIFFSetField(tiff, TIFFTAG_RESOLUTIONUNIT, RESUNIT_NONE);
    TIFFSetField(tiff, TIFFTAG_XRESOLUTION, pages.pixels_per_unit);
    TIFFSetField(tiff, TIFFTAG_YRESOLUTION, pages.pixels_per_unit);
    if (first && !pages.description.empty()) TIFFSetField(tiff, TIFFTAG_IMAGEDESCRIPTION, pages.description.c_str());
}

}  // namespace

void write_tiff(const std::string& path, const GreyPages& pages,
                const std::function<void(int page, std::span<std::uint8_t> pixels)>& page) {
    if (pages.width == 0 || pages.height == 0 || pages.count < 1) throw InvalidArgument(path + ": no picture to write");
    const std::function<void(const std::string&)> write = [&](const std::string& temporary) {
        const std::unique_ptr<TIFF, CloseWrittenTiff> tiff(TIFFOpen(temporary.c_str(), "w"));
        if (!tiff) throw FileError(path + ": cannot be written");
        std::vector<std::uint8_t> pixels(std::size_t{pages.width} * pages.height);
        for (int k = 0; k < pages.count; ++k) {
            set_tags(tiff.get(), pages, k == 0);
            page(k, pixels);
            const auto bytes = static_cast<tmsize_t>(pixels.size());
            if (TIFFWriteEncodedStrip(tiff.get(), 0, pixels.data(), bytes) != bytes || !TIFFWriteDirectory(tiff.get()))
                throw FileError(path + ": writing a page failed; is the disk full?");
        }
    };
    write_whole_file(path, write);
}

}  // namespace setae::bytes
