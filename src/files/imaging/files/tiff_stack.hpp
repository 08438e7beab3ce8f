// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "picture.hpp"
#include "setae/bytes/tiff_decoder.hpp"
#include "setae/bytes/tiff_file.hpp"

namespace setae::imaging {

/// Pictures in a TIFF or BigTIFF of any number of pages; directories are read immediately, pixels page by page.
/// Source: TIFF 6.0 (Adobe 1992); BigTIFF; ImageJ's tags from ij.io.TiffEncoder.
class TiffStack {
public:
    /// @throws FileError; FormatError for a file without a page.
    explicit TiffStack(const std::string& path) : TiffStack(bytes::file_source(path)) {}
    explicit TiffStack(const bytes::Source& source);

    [[nodiscard]] std::size_t size() const { return pages_; }
    [[nodiscard]] PictureSize size_of(std::size_t page) const;  ///< 0 × 0 if the directory is damaged
    /// @throws FormatError if the pixels cannot be found or expanded.
    [[nodiscard]] FrameRead read(std::size_t page) const;

    /// Pixel size [m] that the first page states; @throws InvalidArgument for pixels that are not square.
    [[nodiscard]] std::optional<double> pixel_size() const;
    /// Frames per second by ImageJ's "fps" or "finterval".
    [[nodiscard]] std::optional<double> frame_rate() const;

    /// Why a page cannot be read; empty if no problem is known.
    [[nodiscard]] std::string fault(std::size_t page) const;
    /// The directory of a page; for further pages of ImageJ's stacks the only directory.
    [[nodiscard]] const bytes::TiffPage& page(std::size_t index) const;
    [[nodiscard]] const bytes::Source& file() const { return file_.source; }
    /// Whole number of an entry; empty if the page has none.
    [[nodiscard]] std::optional<std::uint64_t> number(const bytes::TiffPage& page, std::uint16_t tag) const;
    /// First number of an entry of any type; empty if it is no number or not finite.
    [[nodiscard]] std::optional<double> real(const bytes::TiffPage& page, std::uint16_t tag) const;
    /// Text of an entry as UTF-8; empty if the page has none.
    [[nodiscard]] std::string text(const bytes::TiffPage& page, std::uint16_t tag) const {
        return file_.text(page, tag);
    }
    /// The value of "key=value" in ImageJ's description on the first page.
    [[nodiscard]] std::optional<std::string> description(const std::string& key) const;

private:
    struct Part {
        std::uint64_t offset = 0, bytes = 0;
    };
    /// Strips or tiles, all of which are inside the file; empty with a fault.
    [[nodiscard]] std::vector<Part> parts(std::size_t index, std::string& fault) const;
    [[nodiscard]] FrameRead colours(const bytes::TiffPieces& pieces) const;
    [[nodiscard]] std::uint64_t picture_bytes() const;
    void count_pages_without_directory();

    bytes::TiffFile file_;
    std::string description_;                   ///< ImageJ's, of the first page
    std::size_t pages_ = 0;                     ///< including those without directory in ImageJ's stacks beyond 4 GiB
    std::optional<std::uint64_t> first_pixel_;  ///< of contiguous pages without directories
};

}  // namespace setae::imaging
