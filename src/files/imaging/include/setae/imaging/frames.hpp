// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace setae::imaging {

/// Grey levels of a frame as the file spells them, row-major: pixels(row, column), row 0 on top. The centre of the
/// first pixel is (0, 0); x runs along columns to the right, y along rows downwards. Colour is luminance, 0.299 R +
/// 0.587 G + 0.114 B (ITU-R BT.601); transparency is left out.
using FramePixels = Eigen::Array<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Part of a frame: its left upper pixel and its size, in pixels.
struct PictureRegion {
    long x = 0, y = 0, width = 0, height = 0;
};

/// What the files may leave open.
struct FrameOptions {
    std::optional<double> pixel_size;  ///< [m]; needed where the files state none
    std::optional<double>
        frame_rate;  ///< [1/s]; in place of what the files state: players' rates are often not the camera's
    bool ignore_stated_pixel_size = false;  ///< take pixel_size even where a file contradicts it
    std::optional<PictureRegion> region;    ///< what is looked at; coordinates of results stay those of the whole frame
    std::optional<long> first, last;        ///< numbers of frames, both included
    long max_pixels = 100'000'000;          ///< a larger frame is refused
};

/// A frame, or why there is none.
struct FrameRead {
    FramePixels pixels;  ///< of the region; empty where fault is not
    std::string fault;   ///< "truncated: …", "480 × 360 pixels, the first frame has 640 × 480", "one grey level, 0"
};

/// A recording: a TIFF stack, an AVI, or pictures (PNG, JPEG, TIFF, BMP) in a folder or listed, opened and read frame
/// by frame.
///
/// Formats are told by content. TIFF: 8 and 16 bit, float, any compression libtiff knows; ImageJ's stacks beyond 4 GiB.
/// AVI: frames stored one by one (uncompressed 8, 24, 32 bit, Motion JPEG, PNG); others are refused with a line that
/// says how to convert. Pictures of a folder come in natural order (2 before 10); a number missing in their sequence
/// leaves a gap in time.
///
///   time of frame i = (number_i − number_first)/frame_rate
///
/// number: the last number in the file's name for pictures where all have one and differ by nothing else, else 1, 2, 3
/// … Pixel size: of TIFF's resolution with ImageJ's unit, or per inch or cm where it is finer than print (a pixel below
/// 20 µm).
class FrameSource {
public:
    /// @throws FileError; FormatError for what is no recording; InvalidArgument for a pixel size that the file
    /// contradicts by more than 1 %, pixels that are not square, a frame rate nobody states, a region outside the
    /// frames, no frames.
    explicit FrameSource(const std::vector<std::string>& paths, const FrameOptions& options = {});
    explicit FrameSource(const std::string& path, const FrameOptions& options = {});
    ~FrameSource();
    FrameSource(FrameSource&&) noexcept;
    FrameSource& operator=(FrameSource&&) noexcept;

    [[nodiscard]] std::size_t size() const;
    /// Reads frame `index`; may be called from several threads. A frame that cannot be read is a fault, not an
    /// exception.
    [[nodiscard]] FrameRead read(std::size_t index) const;

    [[nodiscard]] double time(std::size_t index) const;       ///< [s] since the recording's first frame
    [[nodiscard]] long number(std::size_t index) const;       ///< as users name frames
    [[nodiscard]] std::string name(std::size_t index) const;  ///< file, and page where it has several
    [[nodiscard]] std::optional<double> pixel_size() const;   ///< [m]
    [[nodiscard]] double frame_rate() const;                  ///< [1/s]
    [[nodiscard]] PictureRegion region() const;
    [[nodiscard]] const std::vector<long>& missing() const;  ///< numbers that the sequence of names leaves out
    /// Where pixel size and frame rate are from, what was passed over; one sentence each.
    [[nodiscard]] const std::vector<std::string>& notes() const;

private:
    struct Recording;
    std::unique_ptr<Recording> recording_;
};

}  // namespace setae::imaging
