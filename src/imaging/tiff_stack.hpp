// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "picture.hpp"
#include "random_access.hpp"

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
    std::string fault;                    ///< where the directory could not be read
    std::optional<std::uint64_t> offset;  ///< of the pixels of a page without directory of its own (ImageJ beyond 4 GiB)
};

/// A TIFF or BigTIFF of any number of pages; directories are read at once, pixels page by page.
/// Source: TIFF 6.0 (Adobe 1992); BigTIFF; ImageJ's tags from ij.io.TiffEncoder.
class TiffStack {
public:
    /// @throws FileError; FormatError for a file without a page.
    explicit TiffStack(const std::string& path);

    [[nodiscard]] std::size_t size() const { return pages_.size(); }
    [[nodiscard]] PictureSize size_of(std::size_t page) const;  ///< 0 × 0 where the directory is damaged
    [[nodiscard]] FrameRead read(std::size_t page) const;

    /// Pixel size [m] that the first page states; @throws InvalidArgument for pixels that are not square.
    [[nodiscard]] std::optional<double> pixel_size() const;
    /// Frames a second by ImageJ's "fps" or "finterval".
    [[nodiscard]] std::optional<double> frame_rate() const;

private:
    [[nodiscard]] std::optional<std::uint64_t> number(const TiffPage& page, int tag, std::uint64_t index = 0) const;
    [[nodiscard]] std::optional<double> ratio(const TiffPage& page, int tag) const;
    [[nodiscard]] std::string strips(const TiffPage& page, std::string& fault) const;
    [[nodiscard]] std::string single_page(const TiffPage& page, const std::string& strips) const;
    [[nodiscard]] std::optional<FrameRead> plain(const TiffPage& page, const std::string& strips) const;
    void read_directories();
    void add_pages_without_directory();
    [[nodiscard]] std::optional<std::string> description(const std::string& key) const;

    RandomAccess file_;
    bool big_endian_ = false, big_tiff_ = false;
    std::vector<TiffPage> pages_;
};

}  // namespace setae::imaging
