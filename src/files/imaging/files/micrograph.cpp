// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/imaging/micrograph.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "digital_micrograph.hpp"
#include "dm_tags.hpp"
#include "emd_file.hpp"
#include "micrograph_file.hpp"
#include "mrc_file.hpp"
#include "picture.hpp"
#include "picture_files.hpp"
#include "plain_picture.hpp"
#include "ser_file.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "tiff_micrograph.hpp"

namespace setae::imaging {
namespace {

enum class Kind { none, dm, tiff, picture, mrc, ser, emd };

Kind kind_of(std::string_view head) {
    switch (picture_kind(head)) {
        case PictureKind::tiff: return Kind::tiff;
        case PictureKind::none: break;
        default: return Kind::picture;
    }
    if (is_mrc(head)) return Kind::mrc;  // before DM: an MRC may begin with the number 3
    if (is_dm(head)) return Kind::dm;
    if (is_ser(head)) return Kind::ser;
    return is_hdf5(head) ? Kind::emd : Kind::none;
}

}  // namespace

bool is_micrograph(std::string_view head) { return kind_of(head) != Kind::none; }

Micrograph read_micrograph_file(const bytes::Source& file, const MicrographOptions& options) {
    auto micrograph = [&] {
        switch (kind_of(file.head(picture_head_bytes))) {
            case Kind::dm: return read_digital_micrograph(file, options);
            case Kind::tiff: return read_tiff(file, options);
            case Kind::picture: return read_plain_picture(file, options);
            case Kind::mrc: return read_mrc(file, options);
            case Kind::ser: return read_ser(file, options);
            case Kind::emd: return read_emd(file, options);
            case Kind::none: break;
        }
        throw FormatError(file.name, {.offset = 0},
                          "unknown kind of picture; expected DM3, DM4, TIFF, PNG, JPEG, BMP, SER, EMD or MRC");
    }();
    if (const auto undefined = micrograph.pixels.size() - micrograph.pixels.isFinite().count(); undefined > 0)
        throw FormatError(
            file.name, {},
            fmt::format("pixels that are not numbers: {}; replace them and save the picture again", undefined));
    return micrograph;
}

Micrograph read_micrograph(const std::string& path, const MicrographOptions& options) {
    auto micrograph = read_micrograph_file(bytes::file_source(path), options);
    if (micrograph.format == "ser")
        if (const auto emi = emi_path(path); std::filesystem::is_regular_file(emi))
            read_emi(bytes::read_file(emi), micrograph);
    return micrograph;
}

std::vector<std::string> micrographs_in(const std::string& folder) {
    auto paths =
        files_in(folder, [](const bytes::Source& file) { return is_micrograph(file.head(picture_head_bytes)); });
    if (paths.empty())
        throw FormatError(folder, {},
                          "no pictures are found; expected DM3, DM4, TIFF, PNG, JPEG, BMP, SER, EMD or MRC files");
    return paths;
}

const std::vector<MicrographFormat>& micrograph_formats() {
    static const std::vector<MicrographFormat> formats{
        {"dm3", "DigitalMicrograph 3", ".dm3", "pixel size of each axis with its unit, every type of number",
         "B. Schaffer, How to read DigitalMicrograph file-format (2014)", true},
        {"dm4", "DigitalMicrograph 4", ".dm4", "the same with 64-bit lengths",
         "B. Schaffer, How to read DigitalMicrograph file-format (2014)", true},
        {"tiff", "TIFF", ".tif .tiff",
         "pixel size of FEI, Olympus SIS, DigitalMicrograph, ImageJ; of Zeiss, JEOL and OME-XML untested on real files",
         "TIFF 6.0 (Adobe 1992), BigTIFF", true},
        {"mrc", "MRC", ".mrc .mrcs .st",
         "modes 0 to 4, 6, 12 in either order of bytes; size of the cell, or of FEI's extended header; marked untested on real files",
         "Cheng et al., J. Struct. Biol. 192, 2015, 146", false},
        {"ser", "TIA series", ".ser",
         "every type of number, metadata of the EMI beside it; marked untested on real files",
         "C. Boothroyd, TIA (Emispec) file format (2006)", false},
        {"emd", "Electron Microscopy Dataset", ".emd", "NCEM's layout and Velox'; marked untested on real files",
         "emdatasets.com, EMD 0.2", false},
        {"png", "PNG", ".png", "pixel size of pHYs where it is finer than print",
         "Portable Network Graphics (third edition)", false},
        {"jpeg", "JPEG", ".jpg .jpeg", "no pixel size; its blocks roughen edges", "ITU-T T.81", false},
        {"bmp", "BMP", ".bmp", "no pixel size", "Microsoft, Bitmap Storage", false}};
    return formats;
}

}  // namespace setae::imaging
