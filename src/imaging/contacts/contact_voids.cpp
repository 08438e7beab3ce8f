// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact_voids.hpp"

#include <cmath>

#include <opencv2/imgproc.hpp>

#include "setae/core/units.hpp"

namespace setae::imaging {
namespace {

constexpr double margin = 4.0, smoothing = 1.0;  // px

}  // namespace

std::vector<ContactVoid> contact_voids(const FramePixels& pixels, const Array1D& radius, double centre_x,
                                       double centre_y, double inner, double outer, double smallest) {
    const cv::Mat grey(static_cast<int>(pixels.rows()), static_cast<int>(pixels.cols()), CV_32F,
                       const_cast<float*>(pixels.data()));
    cv::Mat smooth, labels, statistics, centres;
    cv::GaussianBlur(grey, smooth, {}, smoothing);
    const double middle = 0.5 * (inner + outer), sign = outer > inner ? 1.0 : -1.0,
                 a_radian = static_cast<double>(radius.size()) / (2.0 * pi);
    cv::Mat apart(grey.size(), CV_8U, cv::Scalar(0));
    for (int row = 0; row < grey.rows; ++row)
        for (int column = 0; column < grey.cols; ++column) {
            const double dx = column - centre_x, dy = row - centre_y;
            const auto ray =
                static_cast<Index>(std::lround(std::atan2(dy, dx) * a_radian) + radius.size()) % radius.size();
            const bool inside = std::hypot(dx, dy) < radius[ray] - margin;
            if (inside && sign * (static_cast<double>(smooth.at<float>(row, column)) - middle) > 0.0)
                apart.at<std::uint8_t>(row, column) = 1;
        }
    const int count = cv::connectedComponentsWithStats(apart, labels, statistics, centres, 8);
    std::vector<ContactVoid> voids;
    for (int i = 1; i < count; ++i)  // 0 is the rest
        if (const double area = statistics.at<int>(i, cv::CC_STAT_AREA); area >= smallest)
            voids.push_back({centres.at<double>(i, 0), centres.at<double>(i, 1), area});
    return voids;
}

}  // namespace setae::imaging
