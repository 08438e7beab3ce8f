// SPDX-License-Identifier: GPL-3.0-or-later
#include "avi_file.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

#include <fmt/format.h>

#include "setae/bytes/stored_numbers.hpp"
#include "setae/core/errors.hpp"

namespace setae::imaging {
namespace {

constexpr int deepest_list = 8;

std::string upper(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return text;
}

std::string printable(std::string text) {
    for (auto& c : text)
        if (!std::isprint(static_cast<unsigned char>(c))) c = '?';
    return text;
}

}  // namespace

bool is_avi(std::string_view head) {
    return head.size() >= 12 && head.starts_with("RIFF") && head.substr(8, 4) == "AVI ";
}

AviFile::AviFile(bytes::Source file) : file_(std::move(file)) {
    const auto& path = file_.name;
    read_list(0, file_.size, 0);
    if (!video_ || size_.width <= 0 || size_.height <= 0)
        throw FormatError(path, {.offset = 0}, "an AVI without video; the file may be truncated");
    if (frames_.empty()) throw FormatError(path, {.offset = 0}, "an AVI without frames; the file may be truncated");
}

void AviFile::read_list(std::uint64_t begin, std::uint64_t end, int depth) {
    for (auto at = begin; at + 8 <= end;) {
        const auto head = file_.up_to(at, 12);
        if (head.size() < 8) return;
        const auto id = head.substr(0, 4);
        const auto bytes = bytes::number_in(head, 4, 4);
        const auto body = at + 8;
        if ((id == "RIFF" || id == "LIST") && head.size() == 12 && depth < deepest_list) {
            const auto kind = head.substr(8, 4);
            const auto list_end =
                bytes < 4 ? end : std::min(end, body + bytes);  // an interrupted recording has 0 or a larger number
            if (kind != "INFO" && kind != "odml") read_list(body + 4, list_end, depth + 1);
            at = list_end + list_end % 2;
            continue;
        }
        if (id == "strh" || id == "strf" || id == "avih")
            read_header(id, file_.up_to(body, std::min<std::uint64_t>(bytes, 4096)));
        else if (video_ && id.size() == 4 && std::isdigit(static_cast<unsigned char>(id[0])) &&
                 std::isdigit(static_cast<unsigned char>(id[1])) && (id[0] - '0') * 10 + (id[1] - '0') == *video_ &&
                 id[2] == 'd' && (id[3] == 'b' || id[3] == 'c'))
            frames_.push_back({body, bytes});
        at = body + bytes + bytes % 2;
    }
}

void AviFile::read_header(const std::string& id, const std::string& bytes) {
    if (id == "strh" && bytes.size() >= 28) {
        in_video_header_ = bytes.starts_with("vids") && !video_;
        if (in_video_header_) {
            video_ = streams_;
            const auto scale = bytes::number_in(bytes, 20, 4), rate = bytes::number_in(bytes, 24, 4);
            if (scale > 0 && rate > 0) rate_ = static_cast<double>(rate) / static_cast<double>(scale);
        }
        ++streams_;
    } else if (id == "strf" && in_video_header_ && bytes.size() >= 40) {
        in_video_header_ = false;
        const auto height = static_cast<std::int32_t>(bytes::number_in(bytes, 8, 4));
        size_ = {static_cast<std::int32_t>(bytes::number_in(bytes, 4, 4)),
                 height < 0 ? -static_cast<long>(height) : height};
        top_down_ = height < 0;
        bits_ = static_cast<int>(bytes::number_in(bytes, 14, 2));
        require_known_codec(bytes.substr(16, 4));
        for (std::size_t at = 40; bits_ == 8 && at + 4 <= bytes.size() && palette_.size() < 256; at += 4) {
            const auto part = [&](std::size_t k) {
                return static_cast<float>(static_cast<unsigned char>(bytes[at + k]));
            };
            palette_.push_back(0.299f * part(2) + 0.587f * part(1) + 0.114f * part(0));
        }
    }
}

void AviFile::require_known_codec(const std::string& codec) {
    const auto name = upper(codec);
    if (codec == std::string(4, '\0') || name == "DIB " || name == "RGB " || name == "RAW ") layout_ = Layout::rgb;
    else if (name == "MJPG" || name == "JPEG" || name == "AVI1" || name == "PNG " || name == "MPNG")
        layout_ = Layout::compressed;
    else if (name == "Y800" || name == "GREY" || name == "Y8  " || name == "I420" || name == "IYUV" || name == "YV12" ||
             name == "NV12")
        layout_ = Layout::planar_luminance;
    else if (name == "YUY2" || name == "YUYV") layout_ = Layout::yuyv;
    else if (name == "UYVY") layout_ = Layout::uyvy;
    else
        throw FormatError(
            file_.name, {.offset = 0},
            fmt::format("video of codec '{}', whose frames depend on each other; convert it without loss: ffmpeg -i "
                        "IN.avi -pix_fmt gray frame_%05d.png",
                        printable(codec)));
    if (layout_ == Layout::rgb && bits_ != 8 && bits_ != 24 && bits_ != 32)
        throw FormatError(
            file_.name, {.offset = 0},
            fmt::format("uncompressed video of {} bits per pixel, expected 8, 24 or 32; convert it: ffmpeg -i IN.avi "
                        "frame_%05d.png",
                        bits_));
}

FrameRead AviFile::uncompressed(const std::string& bytes) const {
    const long bytes_per_pixel = layout_ == Layout::rgb ? bits_ / 8 : layout_ == Layout::planar_luminance ? 1 : 2;
    const long stride =
        layout_ == Layout::rgb ? (size_.width * bytes_per_pixel + 3) / 4 * 4 : size_.width * bytes_per_pixel;
    if (static_cast<long>(bytes.size()) < stride * size_.height)
        return {{}, fmt::format("truncated: {} of {} bytes of pixels", bytes.size(), stride * size_.height)};
    FramePixels pixels(size_.height, size_.width);
    for (long row = 0; row < size_.height; ++row) {
        const bool flipped = layout_ == Layout::rgb && !top_down_;
        const auto* at =
            reinterpret_cast<const unsigned char*>(bytes.data()) + (flipped ? size_.height - 1 - row : row) * stride;
        for (long column = 0; column < size_.width; ++column, at += bytes_per_pixel) {
            float grey = 0;
            if (bytes_per_pixel >= 3) grey = 0.299f * at[2] + 0.587f * at[1] + 0.114f * at[0];
            else if (layout_ == Layout::rgb) grey = at[0] < palette_.size() ? palette_[at[0]] : at[0];
            else grey = at[layout_ == Layout::uyvy ? 1 : 0];
            pixels(row, column) = grey;
        }
    }
    return {std::move(pixels), {}};
}

FrameRead AviFile::read(std::size_t index) const {
    const auto& place = frames_[index];
    if (place.bytes == 0) return {{}, "the recorder dropped this frame and left it empty"};
    const auto bytes = file_.up_to(place.offset, place.bytes);
    if (bytes.size() < place.bytes)
        return {{}, fmt::format("truncated: {} of {} bytes at byte {}", bytes.size(), place.bytes, place.offset)};
    if (layout_ != Layout::compressed) return uncompressed(bytes);
    if (const auto stated = stated_size(bytes); stated && *stated != size_)
        return {{},
                fmt::format("{} × {} pixels, but the film has {} × {}", stated->width, stated->height, size_.width,
                            size_.height)};
    return decoded_picture(bytes);
}

}  // namespace setae::imaging
