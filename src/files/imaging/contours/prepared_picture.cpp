// SPDX-License-Identifier: GPL-3.0-or-later
#include "prepared_picture.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include "setae/core/errors.hpp"
#include "setae/core/statistics.hpp"
#include "setae/imaging/opencv_session.hpp"

namespace setae::imaging {
namespace {

constexpr double spike = 8.0;  // standard deviations

cv::Mat view(FramePixels& pixels) {
    return {static_cast<int>(pixels.rows()), static_cast<int>(pixels.cols()), CV_32F, pixels.data()};
}

void hide(PixelMask& hidden, const std::vector<PictureRegion>& regions) {
    for (const auto& r : regions) {
        if (r.width <= 0 || r.height <= 0 || r.x < 0 || r.y < 0 || r.x + r.width > hidden.cols() ||
            r.y + r.height > hidden.rows())
            throw InvalidArgument(
                fmt::format("hidden region {},{},{},{} does not lie within the picture of {} × {} pixels", r.x, r.y,
                            r.width, r.height, hidden.cols(), hidden.rows()));
        hidden.block(r.y, r.x, r.height, r.width) = 1;
    }
}

/// Undefined pixels take the median of the defined ones and are hidden.
long fill_undefined(PreparedPicture& picture) {
    const long count = (!picture.pixels.isFinite()).count();
    if (count == 0) return 0;
    if (count == picture.pixels.size()) throw UndefinedDataError("all pixels of the picture are undefined");
    std::vector<float> defined;
    for (long i = 0; i < picture.pixels.size(); ++i)
        if (std::isfinite(picture.pixels.data()[i])) defined.push_back(picture.pixels.data()[i]);
    const float median = upper_median(std::move(defined));
    for (long i = 0; i < picture.pixels.size(); ++i)
        if (!std::isfinite(picture.pixels.data()[i])) {
            picture.pixels.data()[i] = median;
            picture.hidden.data()[i] = 1;
        }
    return count;
}

int counted_levels(const PreparedPicture& picture) {
    bool any = false, second_seen = false;
    float first = 0, second = 0;
    for (long i = 0; i < picture.pixels.size(); ++i) {
        if (picture.hidden.data()[i] != 0) continue;
        const float value = picture.pixels.data()[i];
        if (!any) {
            any = true;
            first = value;
        } else if (value != first && !second_seen) {
            second_seen = true;
            second = value;
        } else if (value != first && value != second) return 3;
    }
    if (!any) throw UndefinedDataError("all pixels of the picture are hidden; hide a smaller region");
    return second_seen ? 2 : 1;
}

double noise_of(const FramePixels& pixels) {
    std::vector<float> differences;
    const long stride = std::max(1L, pixels.size() / 200'000);
    for (long i = 1; i < pixels.size(); i += stride)
        differences.push_back(std::abs(pixels.data()[i] - pixels.data()[i - 1]));
    constexpr double to_deviation = 1.4826 / 1.4142135623730951;  // of a normal variate, and of a difference of two
    return to_deviation * static_cast<double>(upper_median(std::move(differences)));
}

long remove_spikes(FramePixels& pixels) {
    FramePixels median = pixels, highest = pixels, lowest = pixels;
    cv::Mat around = cv::Mat::ones(3, 3, CV_8U);
    around.at<unsigned char>(1, 1) = 0;
    cv::Mat target = view(highest);
    cv::dilate(view(pixels), target, around, {-1, -1}, 1, cv::BORDER_REPLICATE);
    target = view(lowest);
    cv::erode(view(pixels), target, around, {-1, -1}, 1, cv::BORDER_REPLICATE);
    target = view(median);
    cv::medianBlur(view(pixels), target, 3);
    const auto least = static_cast<float>(spike * noise_of(pixels));
    long count = 0;
    for (long i = 0; i < pixels.size(); ++i) {
        const float value = pixels.data()[i];
        if (least == 0.0F || (value <= highest.data()[i] + least && value >= lowest.data()[i] - least)) continue;
        pixels.data()[i] = median.data()[i];
        ++count;
    }
    return count;
}

}  // namespace

PreparedPicture prepared_picture(const FramePixels& pixels, const TraceOptions& options) {
    limit_opencv();
    PreparedPicture picture{pixels, PixelMask::Zero(pixels.rows(), pixels.cols())};
    hide(picture.hidden, options.hidden);
    if (const long count = fill_undefined(picture); count > 0)
        picture.alerts.push_back({"UNDEF", "picture", fmt::format("{} pixels are undefined and were left out", count),
                                  "check their position in the overlay"});
    picture.grey_levels = counted_levels(picture);
    if (picture.grey_levels < 3) return picture;
    if (const long count = remove_spikes(picture.pixels); count > 0)
        picture.alerts.push_back(
            {"SPIKES", "picture", fmt::format("{} pixels deviate from all their neighbours and were replaced", count),
             "look at the picture if their number is large; X-rays and dead pixels cause a few of them"});
    if (options.denoise > 0) {
        cv::Mat target = view(picture.pixels);
        cv::GaussianBlur(target, target, {}, options.denoise, options.denoise, cv::BORDER_REPLICATE);
    }
    return picture;
}

}  // namespace setae::imaging
