// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "picture.hpp"
#include "setae/bytes/source.hpp"

namespace setae::imaging {

/// Whether bytes begin as an AVI.
[[nodiscard]] bool is_avi(std::string_view head);

/// The first video of an AVI whose frames are stored one by one; places of frames are read immediately, frames on
/// request. Source: Microsoft, AVI RIFF File Reference; OpenDML AVI File Format Extensions 1.02 (segments beyond 1
/// GiB).
class AviFile {
public:
    /// @throws FileError; FormatError for an AVI without video, or of a codec that needs other frames to decode one.
    explicit AviFile(const std::string& path) : AviFile(bytes::file_source(path)) {}
    explicit AviFile(bytes::Source file);

    [[nodiscard]] std::size_t size() const { return frames_.size(); }
    [[nodiscard]] PictureSize picture_size() const { return size_; }
    [[nodiscard]] FrameRead read(std::size_t index) const;
    [[nodiscard]] std::optional<double> frame_rate() const { return rate_; }

private:
    enum class Layout { rgb, compressed, planar_luminance, yuyv, uyvy };
    struct Place {
        std::uint64_t offset = 0, bytes = 0;
    };

    void read_list(std::uint64_t begin, std::uint64_t end, int depth);
    void read_header(const std::string& id, const std::string& bytes);
    void require_known_codec(const std::string& codec);
    [[nodiscard]] FrameRead uncompressed(const std::string& bytes) const;

    bytes::Source file_;
    std::vector<Place> frames_;
    int streams_ = 0;
    std::optional<int> video_;
    PictureSize size_;
    bool top_down_ = false, in_video_header_ = false;
    int bits_ = 0;
    Layout layout_ = Layout::rgb;
    std::vector<float> palette_;
    std::optional<double> rate_;
};

}  // namespace setae::imaging
