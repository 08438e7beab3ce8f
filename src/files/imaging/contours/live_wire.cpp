// SPDX-License-Identifier: GPL-3.0-or-later
#include "live_wire.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include <opencv2/imgproc.hpp>

#include "setae/core/statistics.hpp"

namespace setae::imaging {
namespace {

constexpr double scale = 1.5;        // px
constexpr double min_edge = 0.02;    // of the strongest
constexpr double min_margin = 40.0;  // px around two anchors that a path may use
constexpr std::array<long, 8> step_x{1, 1, 0, -1, -1, -1, 0, 1}, step_y{0, 1, 1, 1, 0, -1, -1, -1};

}  // namespace

LiveWire::LiveWire(const FramePixels& pixels, Vacuum vacuum)
    : rise_x_(pixels.rows(), pixels.cols()), rise_y_(pixels.rows(), pixels.cols()) {
    const cv::Mat grey(static_cast<int>(pixels.rows()), static_cast<int>(pixels.cols()), CV_32F,
                       const_cast<float*>(pixels.data()));
    cv::Mat smooth, x(grey.size(), CV_32F, rise_x_.data()), y(grey.size(), CV_32F, rise_y_.data());
    cv::GaussianBlur(grey, smooth, {}, scale, scale, cv::BORDER_REPLICATE);
    const float sign = vacuum == Vacuum::dark ? -1.0F : 1.0F;
    cv::Sobel(smooth, x, CV_32F, 1, 0, 1, 0.5 * static_cast<double>(sign), 0, cv::BORDER_REPLICATE);
    cv::Sobel(smooth, y, CV_32F, 0, 1, 1, 0.5 * static_cast<double>(sign), 0, cv::BORDER_REPLICATE);
    std::vector<float> rises;
    const long stride = std::max(1L, pixels.size() / 200'000);
    for (long i = 0; i < pixels.size(); i += stride) rises.push_back(std::hypot(rise_x_.data()[i], rise_y_.data()[i]));
    const float strong = upper_quantile(std::move(rises), 0.99);
    const float unit = strong > 0 ? 1.0F / strong : 0.0F;
    rise_x_ *= unit;
    rise_y_ *= unit;
}

LiveWire::Path LiveWire::between(const Anchor& from, const Anchor& to) const {
    const double margin = std::max(min_margin, 0.5 * std::hypot(to.x - from.x, to.y - from.y));
    const auto bound = [](double value, long most) { return std::clamp(std::lround(value), 0L, most); };
    const long left = bound(std::min(from.x, to.x) - margin, rise_x_.cols() - 1),
               right = bound(std::max(from.x, to.x) + margin, rise_x_.cols() - 1);
    const long top = bound(std::min(from.y, to.y) - margin, rise_x_.rows() - 1),
               bottom = bound(std::max(from.y, to.y) + margin, rise_x_.rows() - 1);
    const long columns = right - left + 1, rows = bottom - top + 1;
    const auto index = [&](const Anchor& a) {
        return (bound(a.y, rise_x_.rows() - 1) - top) * columns + bound(a.x, rise_x_.cols() - 1) - left;
    };
    const long start = index(from), end = index(to);
    std::vector<double> cost(static_cast<std::size_t>(rows * columns), std::numeric_limits<double>::infinity());
    std::vector<signed char> came(cost.size(), -1);
    using Entry = std::pair<double, long>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    cost[static_cast<std::size_t>(start)] = 0;
    open.emplace(0.0, start);
    while (!open.empty()) {
        const auto [so_far, at] = open.top();
        open.pop();
        if (so_far > cost[static_cast<std::size_t>(at)]) continue;
        if (at == end) break;
        const long row = at / columns, column = at % columns;
        for (std::size_t d = 0; d < 8; ++d) {
            const long y = row + step_y[d], x = column + step_x[d];
            if (y < 0 || x < 0 || y >= rows || x >= columns) continue;
            const double length = d % 2 == 0 ? 1.0 : 1.4142135623730951;
            // left of the step, as displayed
            const double across_x = static_cast<double>(step_y[d]) / length,
                         across_y = -static_cast<double>(step_x[d]) / length;
            const double rise = static_cast<double>(rise_x_(top + y, left + x)) * across_x +
                                static_cast<double>(rise_y_(top + y, left + x)) * across_y;
            const double next = so_far + length / (min_edge + std::clamp(rise, 0.0, 1.0));
            const auto place = static_cast<std::size_t>(y * columns + x);
            if (next >= cost[place]) continue;
            cost[place] = next;
            came[place] = static_cast<signed char>(d);
            open.emplace(next, static_cast<long>(place));
        }
    }
    Path path;
    path.cost = cost[static_cast<std::size_t>(end)];
    for (long at = end;;) {
        const long row = at / columns, column = at % columns;
        path.x.push_back(static_cast<double>(left + column));
        path.y.push_back(static_cast<double>(top + row));
        if (at == start) break;
        const auto d = static_cast<std::size_t>(came[static_cast<std::size_t>(at)]);
        at -= step_y[d] * columns + step_x[d];
    }
    std::reverse(path.x.begin(), path.x.end());
    std::reverse(path.y.begin(), path.y.end());
    path.x.front() = from.x;
    path.y.front() = from.y;
    path.x.back() = to.x;
    path.y.back() = to.y;
    return path;
}

LiveWire::Path LiveWire::along(const std::vector<Anchor>& anchors) const {
    Path whole;
    for (std::size_t i = 0; i + 1 < anchors.size(); ++i) {
        const auto part = between(anchors[i], anchors[i + 1]);
        const long skipped = i == 0 ? 0 : 1;  // it begins at the end of the last one
        whole.x.insert(whole.x.end(), part.x.begin() + skipped, part.x.end());
        whole.y.insert(whole.y.end(), part.y.begin() + skipped, part.y.end());
        whole.cost += part.cost;
    }
    return whole;
}

PlaneCurve LiveWire::through(const std::vector<Anchor>& anchors) const {
    auto reversed = anchors;
    std::reverse(reversed.begin(), reversed.end());
    const auto forth = along(anchors), back = along(reversed);
    const auto& path = forth.cost <= back.cost ? forth : back;
    const auto n = static_cast<Index>(path.x.size());
    return {Eigen::Map<const Array1D>(path.x.data(), n), Eigen::Map<const Array1D>(path.y.data(), n), false};
}

}  // namespace setae::imaging
