// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/imaging/frames.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <variant>

#include <fmt/format.h>

#include "avi_file.hpp"
#include "picture_files.hpp"
#include "setae/bytes/archive_folder.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"
#include "tiff_stack.hpp"

namespace setae::imaging {
namespace {

constexpr double agreement_of_sizes = 0.01;

struct Pictures {
    std::vector<std::string> paths;
};

using Store = std::variant<TiffStack, AviFile, Pictures>;

template <class... F>
struct Overloaded : F... {
    using F::operator()...;
};
template <class... F>
Overloaded(F...) -> Overloaded<F...>;  // clang 16 does not deduce it

Store opened(std::vector<std::string> paths) {
    if (paths.empty())
        throw InvalidArgument("no frames are given; expected a TIFF stack, an AVI, a folder of pictures or pictures");
    if (paths.size() == 1 && (std::filesystem::is_directory(paths.front()) || bytes::is_archive(paths.front()))) {
        const auto folder = paths.front();
        paths = pictures_in(folder);
    }
    if (paths.size() > 1) return Pictures{std::move(paths)};
    const auto& path = paths.front();
    const auto head = bytes::file_source(path).head(64);
    if (is_avi(head)) return AviFile(path);
    switch (picture_kind(head)) {
        case PictureKind::tiff: return TiffStack(path);
        case PictureKind::none:
            throw FormatError(path, {.offset = 0},
                              "the file contains no frames; expected a TIFF, an AVI, or pictures as PNG, JPEG or BMP");
        default: return Pictures{{path}};
    }
}

FrameNumbers numbers_in_store(const Store& store) {
    if (const auto* pictures = std::get_if<Pictures>(&store)) return numbers_of(pictures->paths);
    FrameNumbers numbers;
    numbers.numbers.resize(std::visit(
        Overloaded{[](const Pictures& p) { return p.paths.size(); }, [](const auto& file) { return file.size(); }},
        store));
    std::iota(numbers.numbers.begin(), numbers.numbers.end(), 1L);
    return numbers;
}

/// The size of the first frame with a header.
PictureSize first_size(const Store& store, const std::string& where) {
    std::optional<PictureSize> size;
    std::visit(Overloaded{[&](const AviFile& avi) { size = avi.picture_size(); },
                          [&](const TiffStack& stack) {
                              for (std::size_t i = 0; i < stack.size() && !size; ++i)
                                  if (const auto page = stack.size_of(i); page.width > 0 && page.height > 0)
                                      size = page;
                          },
                          [&](const Pictures& pictures) {
                              for (std::size_t i = 0; i < pictures.paths.size() && !size; ++i)
                                  size = size_of_picture(pictures.paths[i]);
                          }},
               store);
    if (!size || size->width <= 0 || size->height <= 0)
        throw FormatError(where, {}, "no frame states its size; the files may be truncated");
    return *size;
}

struct Stated {
    std::optional<double> pixel_size, frame_rate;
};

Stated stated_by(const Store& store) {
    return std::visit(Overloaded{[](const TiffStack& stack) {
                                     return Stated{stack.pixel_size(), stack.frame_rate()};
                                 },
                                 [](const AviFile& avi) {
                                     return Stated{std::nullopt, avi.frame_rate()};
                                 },
                                 [](const Pictures& pictures) {
                                     const auto& path = pictures.paths.front();
                                     if (picture_kind(bytes::file_source(path).head(32)) != PictureKind::tiff)
                                         return Stated{};
                                     return Stated{TiffStack(path).pixel_size(), std::nullopt};
                                 }},
                      store);
}

std::string other_size(PictureSize found, PictureSize first) {
    return fmt::format("{} × {} pixels, but the first frame has {} × {}", found.width, found.height, first.width,
                       first.height);
}

void require_positive(const std::optional<double>& value, const char* what) {
    if (value && !(*value > 0 && std::isfinite(*value)))
        throw InvalidArgument(fmt::format("{} {}, expected a positive number", what, *value));
}

}  // namespace

struct FrameSource::Recording {
    std::string where;
    Store store;
    FrameOptions options;
    PictureSize size;
    PictureRegion region;
    std::vector<std::size_t> chosen;  ///< index in the store of each frame
    FrameNumbers numbers;             ///< of all frames of the store
    std::optional<double> pixel_size;
    double frame_rate = 0;
    std::vector<std::string> notes;

    explicit Recording(const std::vector<std::string>& paths, const FrameOptions& given)
        : where(paths.empty() ? "" : paths.front()),
          store(opened(paths)),
          options(given),
          size(first_size(store, where)),
          numbers(numbers_in_store(store)) {
        require_positive(options.pixel_size, "pixel size");
        require_positive(options.frame_rate, "frame rate");
        if (size.width > options.max_pixels / size.height)
            throw InvalidArgument(
                fmt::format("{}: frames of {} × {} pixels, more than the {} a frame may have; crop or bin them", where,
                            size.width, size.height, options.max_pixels));
        choose_region();
        choose_frames();
        settle_scale();
        if (!numbers.note.empty()) notes.push_back(numbers.note);
    }

    void choose_region() {
        region = options.region.value_or(PictureRegion{0, 0, size.width, size.height});
        const bool inside = region.x >= 0 && region.y >= 0 && region.width > 0 && region.height > 0 &&
                            region.x <= size.width - region.width && region.y <= size.height - region.height;
        if (!inside)
            throw InvalidArgument(fmt::format(
                "region {},{},{},{} lies outside the frames of {} × {} pixels; expected x,y,width,height within "
                "the frames",
                region.x, region.y, region.width, region.height, size.width, size.height));
    }

    void choose_frames() {
        for (std::size_t i = 0; i < numbers.numbers.size(); ++i)
            if (numbers.numbers[i] >= options.first.value_or(numbers.numbers.front()) &&
                numbers.numbers[i] <= options.last.value_or(numbers.numbers.back()))
                chosen.push_back(i);
        if (chosen.empty())
            throw InvalidArgument(fmt::format("{}: no frame from {} to {}; the recording has frames {} to {}", where,
                                              options.first.value_or(numbers.numbers.front()),
                                              options.last.value_or(numbers.numbers.back()), numbers.numbers.front(),
                                              numbers.numbers.back()));
        std::erase_if(numbers.missing, [&](long number) {
            return number < options.first.value_or(number) || number > options.last.value_or(number);
        });
    }

    void settle_scale() {
        const auto stated = stated_by(store);
        pixel_size = options.pixel_size;
        if (stated.pixel_size && !options.ignore_stated_pixel_size) {
            if (pixel_size && std::abs(*pixel_size / *stated.pixel_size - 1.0) > agreement_of_sizes)
                throw InvalidArgument(fmt::format(
                    "{}: the file states {} per pixel, but {} was given; leave out the given value, or ignore the "
                    "stated one",
                    where, format_value(*stated.pixel_size, "m"), format_value(*pixel_size, "m")));
            if (!pixel_size) {
                pixel_size = stated.pixel_size;
                notes.push_back(fmt::format("pixel size {}, stated by the file", format_value(*pixel_size, "m")));
            }
        }
        if (options.frame_rate) {
            frame_rate = *options.frame_rate;
            if (stated.frame_rate && std::abs(frame_rate / *stated.frame_rate - 1.0) > agreement_of_sizes)
                notes.push_back(fmt::format("frame rate {:g} 1/s, given; the file states {:g} 1/s", frame_rate,
                                            *stated.frame_rate));
        } else if (stated.frame_rate) {
            frame_rate = *stated.frame_rate;
            notes.push_back(fmt::format("frame rate {:g} 1/s, stated by the file", frame_rate));
        } else {
            throw InvalidArgument(
                where +
                ": no frame rate: the files state none; expected it in `frame_rate`, such as 20 frames per "
                "second");
        }
    }
};

FrameSource::FrameSource(const std::vector<std::string>& paths, const FrameOptions& options)
    : recording_(std::make_unique<Recording>(paths, options)) {}
FrameSource::FrameSource(const std::string& path, const FrameOptions& options)
    : FrameSource(std::vector<std::string>{path}, options) {}
FrameSource::~FrameSource() = default;
FrameSource::FrameSource(FrameSource&&) noexcept = default;
FrameSource& FrameSource::operator=(FrameSource&&) noexcept = default;

std::size_t FrameSource::size() const { return recording_->chosen.size(); }
long FrameSource::number(std::size_t index) const { return recording_->numbers.numbers[recording_->chosen[index]]; }
double FrameSource::time(std::size_t index) const {
    return static_cast<double>(number(index) - recording_->numbers.numbers.front()) / recording_->frame_rate;
}
std::optional<double> FrameSource::pixel_size() const { return recording_->pixel_size; }
double FrameSource::frame_rate() const { return recording_->frame_rate; }
PictureRegion FrameSource::region() const { return recording_->region; }
const std::vector<long>& FrameSource::missing() const { return recording_->numbers.missing; }
const std::vector<std::string>& FrameSource::notes() const { return recording_->notes; }

std::string FrameSource::name(std::size_t index) const {
    if (const auto* pictures = std::get_if<Pictures>(&recording_->store))
        return pictures->paths[recording_->chosen[index]];
    return size() == 1 && recording_->numbers.numbers.size() == 1
               ? recording_->where
               : fmt::format("{} frame {}", recording_->where, number(index));
}

FrameRead FrameSource::read(std::size_t index) const {
    const auto& r = *recording_;
    const auto at = r.chosen[index];
    FrameRead frame;
    try {
        frame = std::visit(
            Overloaded{[&](const Pictures& pictures) { return read_picture(pictures.paths[at], r.options.max_pixels); },
                       [&](const TiffStack& stack) {
                           const auto size = stack.size_of(at);
                           if (size.width > 0 && size != r.size) return FrameRead{{}, other_size(size, r.size)};
                           return stack.read(at);
                       },
                       [&](const AviFile& avi) { return avi.read(at); }},
            r.store);
    } catch (const Error& error) {
        return {{}, error.what()};
    }
    if (!frame.fault.empty()) return frame;
    if (frame.pixels.cols() != r.size.width || frame.pixels.rows() != r.size.height)
        return {{}, other_size({frame.pixels.cols(), frame.pixels.rows()}, r.size)};
    if (r.region.width != r.size.width || r.region.height != r.size.height)
        frame.pixels = FramePixels(frame.pixels.block(r.region.y, r.region.x, r.region.height, r.region.width));
    if (const auto undefined = frame.pixels.size() - frame.pixels.isFinite().count(); undefined > 0)
        return {{}, fmt::format("pixels that are not numbers: {}", undefined)};
    if (frame.pixels.minCoeff() == frame.pixels.maxCoeff())
        return {{}, fmt::format("all pixels have the grey level {:g}", frame.pixels(0, 0))};
    return frame;
}

}  // namespace setae::imaging
