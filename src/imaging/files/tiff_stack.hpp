// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "picture.hpp"
#include "random_access.hpp"
#include "setae/bytes/tiff_decoder.hpp"

namespace setae::imaging {

/// An entry of a TIFF directory with the bytes of its value, in the file's byte order.
struct TiffEntry {
    int type = 0;
    std::uint64_t count = 0;
    std::string value;
};

/// A directory: one page.
struct TiffPage {
    std::map<int, TiffEntry> entries;
    std::string fault;            ///< where the directory could not be read
    std::string lost;             ///< an entry whose value lies beyond the end of the file
    std::uint64_t directory = 0;  ///< its place in the file
    std::optional<std::uint64_t>
        offset;  ///< of the pixels of a page without directory of its own (ImageJ beyond 4 GiB)
};

/// A TIFF or BigTIFF of any number of pages; directories are read at once, pixels page by page.
/// Source: TIFF 6.0 (Adobe 1992); BigTIFF; ImageJ's tags from ij.io.TiffEncoder.
class TiffStack {
public:
    /// @throws FileError; FormatError for a file without a page.
    explicit TiffStack(const std::string& path) : TiffStack(RandomAccess(path)) {}
    explicit TiffStack(RandomAccess file);

    [[nodiscard]] std::size_t size() const { return pages_.size(); }
    [[nodiscard]] PictureSize size_of(std::size_t page) const;  ///< 0 × 0 where the directory is damaged
    /// @throws FormatError where libtiff cannot expand the pixels.
    [[nodiscard]] FrameRead read(std::size_t page) const;

    /// Pixel size [m] that the first page states; @throws InvalidArgument for pixels that are not square.
    [[nodiscard]] std::optional<double> pixel_size() const;
    /// Frames a second by ImageJ's "fps" or "finterval".
    [[nodiscard]] std::optional<double> frame_rate() const;

    [[nodiscard]] const TiffPage& page(std::size_t index) const { return pages_[index]; }
    [[nodiscard]] const RandomAccess& file() const { return file_; }
    /// Whole number of an entry; nothing where the page has none.
    [[nodiscard]] std::optional<std::uint64_t> number(const TiffPage& page, int tag, std::uint64_t index = 0) const;
    /// First number of an entry of any type; nothing where it is none or not finite.
    [[nodiscard]] std::optional<double> real(const TiffPage& page, int tag) const;
    /// Text of an entry as UTF-8; empty where the page has none.
    [[nodiscard]] std::string text(const TiffPage& page, int tag) const;
    /// The value of "key=value" in ImageJ's description on the first page.
    [[nodiscard]] std::optional<std::string> description(const std::string& key) const;

private:
    [[nodiscard]] std::optional<double> ratio(const TiffPage& page, int tag) const;
    struct Part {
        std::uint64_t offset = 0, bytes = 0;
    };
    /// Strips or tiles, all of which lie within the file; none where there is a fault.
    [[nodiscard]] std::vector<Part> parts(const TiffPage& page, std::string& fault) const;
    [[nodiscard]] FrameRead colours(const bytes::TiffPieces& pieces) const;
    [[nodiscard]] bytes::Source source() const;
    void read_directories();
    void add_pages_without_directory();

    RandomAccess file_;
    bool big_endian_ = false, big_tiff_ = false;
    std::vector<TiffPage> pages_;
};

}  // namespace setae::imaging
