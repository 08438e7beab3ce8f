// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_voids.hpp"

#include <opencv2/imgproc.hpp>

namespace setae::imaging {
namespace {

constexpr double margin = 4.0, smoothing = 1.0;  // px
constexpr int blurred_rim = 3;                   // px about a void, which contain its blurred rim

/// 1 if a pixel is more than the margin inside the edge.
cv::Mat inside_of(const TracedEdge& edge, const cv::Size& size) {
    cv::Mat inside(size, CV_8U, cv::Scalar(0));
    for (int row = 0; row < size.height; ++row)
        for (int column = 0; column < size.width; ++column)
            if (edge.distance(column, row) < -margin) inside.at<std::uint8_t>(row, column) = 1;
    return inside;
}

cv::Mat widened(const cv::Mat& mask, int pixels) {
    cv::Mat result;
    const int size = 2 * pixels + 1;
    cv::dilate(mask, result, cv::getStructuringElement(cv::MORPH_ELLIPSE, {size, size}));
    return result;
}

/// Area [px²] of the void `label` in its box: the sum of (I − inner)/(outer − inner) over it and 3 px about it, which a
/// blur does not change; inner: the mean of the 3 px beyond. Other voids and pixels outside the edge are left out.
double void_area(const cv::Mat& grey, const cv::Mat& counted, const cv::Mat& labels, int label, double step) {
    const cv::Mat own = labels == label, others = (labels != 0) & (labels != label);
    cv::Mat near = widened(own, blurred_rim), beyond = widened(own, 2 * blurred_rim) & ~near;
    for (auto* mask : {&near, &beyond}) {
        mask->setTo(0, others);
        mask->setTo(0, counted == 0);
    }
    if (cv::countNonZero(beyond) == 0) return cv::countNonZero(own);
    return cv::countNonZero(near) * (cv::mean(grey, near)[0] - cv::mean(grey, beyond)[0]) / step;
}

}  // namespace

std::vector<ContactVoid> contact_voids(const FramePixels& pixels, const TracedEdge& edge, double inner, double outer,
                                       double smallest) {
    const cv::Mat grey(static_cast<int>(pixels.rows()), static_cast<int>(pixels.cols()), CV_32F,
                       const_cast<float*>(pixels.data()));
    cv::Mat smooth, labels, statistics, centres;
    cv::GaussianBlur(grey, smooth, {}, smoothing);
    const auto inside = inside_of(edge, grey.size());
    cv::Mat apart = outer > inner ? smooth > 0.5 * (inner + outer) : smooth < 0.5 * (inner + outer);
    apart.setTo(0, inside == 0);
    const int count = cv::connectedComponentsWithStats(apart, labels, statistics, centres, 8);
    std::vector<ContactVoid> voids;
    for (int i = 1; i < count; ++i) {  // 0 is the rest
        if (statistics.at<int>(i, cv::CC_STAT_AREA) < smallest) continue;
        const int about = 2 * blurred_rim;
        const cv::Rect box =
            cv::Rect(statistics.at<int>(i, cv::CC_STAT_LEFT) - about, statistics.at<int>(i, cv::CC_STAT_TOP) - about,
                     statistics.at<int>(i, cv::CC_STAT_WIDTH) + 2 * about,
                     statistics.at<int>(i, cv::CC_STAT_HEIGHT) + 2 * about) &
            cv::Rect({0, 0}, grey.size());
        voids.push_back({centres.at<double>(i, 0), centres.at<double>(i, 1),
                         void_area(grey(box), inside(box), labels(box), i, outer - inner)});
    }
    return voids;
}

}  // namespace setae::imaging
