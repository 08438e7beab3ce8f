// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace setae::imaging {

/// Grey levels of a frame as in the file, row-major: pixels(row, column), row 0 on top. The centre of the first pixel
/// is (0, 0); x runs along columns to the right, y along rows downwards. Colour is luminance, 0.299 R + 0.587 G + 0.114
/// B (ITU-R BT.601); transparency is ignored.
using FramePixels = Eigen::Array<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Part of a frame: its left upper pixel and its size, in pixels.
struct PictureRegion {
    long x = 0, y = 0, width = 0, height = 0;
};

/// Metadata given by the user, and limits.
struct FrameOptions {
    std::optional<double> pixel_size;  ///< [m]; required if the files state none
    std::optional<double>
        frame_rate;  ///< [1/s]; replaces the rate in the files: playback rates often differ from the rate of the camera
    bool ignore_stated_pixel_size = false;  ///< use pixel_size even if a file contradicts it
    std::optional<PictureRegion> region;    ///< evaluated region; coordinates of results remain those of the whole
                                            ///< frame
    std::optional<long> first, last;        ///< numbers of frames, both included
    long max_pixels = 100'000'000;          ///< a larger frame is refused
};

/// A frame, or the reason for its absence.
struct FrameRead {
    FramePixels pixels;  ///< of the region; empty with a fault
    std::string fault;   ///< "truncated: …", "480 × 360 pixels, the first frame has 640 × 480", "one grey level, 0"
};

/// A recording: a TIFF stack, an AVI, or pictures (PNG, JPEG, TIFF, BMP) in a folder or listed, opened and read frame
/// by frame.
///
/// Formats are detected by content. TIFF: 8 and 16 bit, float, any compression of libtiff; stacks of ImageJ beyond 4
/// GiB. AVI: frames stored one by one (uncompressed 8, 24, 32 bit, Motion JPEG, PNG); others are refused with
/// instructions for conversion. Pictures of a folder come in natural order (2 before 10); a number missing in their
/// sequence is a gap in time.
///
///   time of frame i = (number_i − number_first)/frame_rate
///
/// number: the last number in the file name if all pictures have one and their names differ only by it, otherwise 1, 2,
/// 3 … Pixel size: from the TIFF resolution with the unit of ImageJ, or per inch or cm if it is finer than print (a
/// pixel below 20 µm).
class FrameSource {
public:
    /// @throws FileError; FormatError for files that are no recording; InvalidArgument for a pixel size that the file
    /// contradicts by more than 1 %, pixels that are not square, a missing frame rate, a region outside the frames, no
    /// frames.
    explicit FrameSource(const std::vector<std::string>& paths, const FrameOptions& options = {});
    explicit FrameSource(const std::string& path, const FrameOptions& options = {});
    ~FrameSource();
    FrameSource(FrameSource&&) noexcept;
    FrameSource& operator=(FrameSource&&) noexcept;

    [[nodiscard]] std::size_t size() const;
    /// Reads frame `index`; may be called from several threads. A frame that cannot be read is a fault, not an
    /// exception.
    [[nodiscard]] FrameRead read(std::size_t index) const;

    [[nodiscard]] double time(std::size_t index) const;       ///< [s] since the first frame of the recording
    [[nodiscard]] long number(std::size_t index) const;       ///< in the numbering of the user
    [[nodiscard]] std::string name(std::size_t index) const;  ///< file, and page if the file has several
    [[nodiscard]] std::optional<double> pixel_size() const;   ///< [m]
    [[nodiscard]] double frame_rate() const;                  ///< [1/s]
    [[nodiscard]] PictureRegion region() const;
    [[nodiscard]] const std::vector<long>& missing() const;  ///< numbers missing in the sequence of names
    /// Origin of pixel size and frame rate, and what was skipped; one sentence each.
    [[nodiscard]] const std::vector<std::string>& notes() const;

private:
    struct Recording;
    std::unique_ptr<Recording> recording_;
};

}  // namespace setae::imaging
