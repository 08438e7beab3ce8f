// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawn_bars.hpp"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "bar_candidate.hpp"
#include "setae/core/statistics.hpp"

namespace setae::imaging {
namespace {

constexpr double shortest_share = 0.03;  // of the width of the picture
constexpr double min_quality = 0.5;
constexpr int shortest = 12;      // px
constexpr double rounding = 0.3;  // px: standard error of a length that was rounded to whole pixels

double length_overlap(const BarCandidate& first, const BarCandidate& second) {
    const int common = std::min(first.right, second.right) - std::max(first.left, second.left) + 1;
    return static_cast<double>(common) / std::min(first.length(), second.length());
}

/// Smallest (or largest) level of each range of `size` pixels inside the picture, by doubling ranges.
cv::Mat1b extreme_of_stretches(cv::Mat1b picture, const cv::Size& size, bool least) {
    const auto combined = [least](const cv::Mat1b& from, int right, int down) {
        const int width = from.cols - right, height = from.rows - down;
        cv::Mat result;
        const cv::Mat near = from(cv::Rect(0, 0, width, height)), far = from(cv::Rect(right, down, width, height));
        if (least) cv::min(near, far, result);
        else cv::max(near, far, result);
        return cv::Mat1b(result);
    };
    const int length = std::max(size.width, size.height);
    for (int done = 1; done < length;) {
        const int step = std::min(done, length - done);
        picture = size.width > 1 ? combined(picture, step, 0) : combined(picture, 0, step);
        done += step;
    }
    return picture;
}

/// Opening by a line: structures that are as bright over its length. Dark where no line fits inside the picture.
cv::Mat1b opened(const cv::Mat1b& picture, const cv::Size& line) {
    if (picture.cols < line.width || picture.rows < line.height) return cv::Mat1b(picture.size(), 0);
    cv::Mat1b padded;
    cv::copyMakeBorder(extreme_of_stretches(picture, line, true), padded, line.height - 1, line.height - 1,
                       line.width - 1, line.width - 1, cv::BORDER_CONSTANT, 0);
    return extreme_of_stretches(std::move(padded), line, false);
}

/// Boxes around pixels above a threshold, joined along columns: runs of rows that overlap those of the previous row.
std::vector<cv::Rect> boxes_above(const cv::Mat1b& picture, int threshold) {
    struct Run {
        int left = 0, right = 0;  // right: one beyond
        std::size_t part = 0;
    };
    std::vector<cv::Rect> boxes;
    std::vector<std::size_t> parent;
    const auto root = [&](std::size_t part) {
        while (parent[part] != part) part = parent[part] = parent[parent[part]];
        return part;
    };
    std::vector<Run> before, now;
    for (int y = 0; y < picture.rows; ++y) {
        const unsigned char* row = picture.ptr(y);
        now.clear();
        std::size_t other = 0;
        for (int x = 0; x < picture.cols;) {
            if (row[x] <= threshold) {
                ++x;
                continue;
            }
            Run run{x, x, boxes.size()};
            while (run.right < picture.cols && row[run.right] > threshold) ++run.right;
            x = run.right;
            boxes.emplace_back(run.left, y, run.right - run.left, 1);
            parent.push_back(run.part);
            while (other < before.size() && before[other].right <= run.left) ++other;
            for (auto k = other; k < before.size() && before[k].left < run.right; ++k) {
                const auto first = root(before[k].part), second = root(run.part);
                if (first == second) continue;
                boxes[std::min(first, second)] |= boxes[std::max(first, second)];
                parent[std::max(first, second)] = std::min(first, second);
            }
            now.push_back(run);
        }
        std::swap(before, now);
    }
    std::vector<cv::Rect> roots;
    for (std::size_t part = 0; part < boxes.size(); ++part)
        if (parent[part] == part) roots.push_back(boxes[part]);
    return roots;
}

bool has_two_levels(const cv::Mat1f& levels) {
    double least = 0, most = 0;
    cv::minMaxLoc(levels, &least, &most);
    const float low = static_cast<float>(least), high = static_cast<float>(most);
    return std::all_of(levels.begin(), levels.end(),
                       [low, high](float level) { return level <= low || level >= high; });
}

struct Search {
    int min_length = 0;
    double sign = 0;  // 1: brighter bars
    double byte = 0;  // a step of 8 bits, as scaled_levels
};

/// Candidates of one polarity: structures kept by a long opening along rows and removed by one across them.
void collect(const cv::Mat1b& bytes, const cv::Mat1f& levels, const Search& search, std::vector<BarCandidate>& found) {
    const int min_length = search.min_length;
    const auto rows = opened(bytes, {min_length, 1});
    cv::Mat1b raised;
    cv::subtract(rows, opened(rows, {1, thickest_bar + 3}), raised);
    double highest = 0;
    cv::minMaxLoc(raised, nullptr, &highest);
    for (const int threshold : {12, 24, 40, 60, 85, 120, 160}) {
        if (threshold >= highest) break;
        for (const auto& where : boxes_above(raised, threshold)) {
            if (where.height > thickest_bar + 3 || where.width < min_length) continue;
            const auto bar = bar_within(levels, {where, threshold * search.byte, search.sign}, min_length);
            const auto same = [&](const BarCandidate& other) {
                return other.left == bar->left && other.right == bar->right && other.top == bar->top &&
                       other.bottom == bar->bottom;
            };
            if (bar && std::none_of(found.begin(), found.end(), same)) found.push_back(*bar);
        }
    }
}

/// Fringes repeat, bars do not: at least two others of the same polarity, length and thickness next to it.
bool repeats(const BarCandidate& bar, const std::vector<BarCandidate>& all) {
    int count = 0;
    for (const auto& other : all) {
        if (&other == &bar || other.contrast * bar.contrast < 0 || (other.top <= bar.bottom && other.bottom >= bar.top))
            continue;
        const bool alike = std::abs(other.length() - bar.length()) <= 0.2 * bar.length() + 2 &&
                           std::abs(other.thickness() - bar.thickness()) <= 1 + bar.thickness() / 2;
        count += alike && length_overlap(bar, other) > 0.5;
    }
    return count >= 2;
}

/// If both ends have the same tick, the length is between their middles.
void settle_ticks(DrawnBar& bar) {
    const auto &left = bar.left_tick, &right = bar.right_tick;
    const double asymmetry = left && right ? (left->middle - bar.begin_x) - (bar.end_x - right->middle) : 0;
    if (!left || !right || std::abs(asymmetry) > 1.5 || std::abs(left->width - right->width) > 1 ||
        std::abs(left->reach - right->reach) > 2)
        return;
    bar.begin_x = left->middle;
    bar.end_x = right->middle;
    bar.length_standard_error = std::hypot(bar.length_standard_error, left->width / std::sqrt(12.0));
    bar.left_tick.reset();
    bar.right_tick.reset();
}

DrawnBar measured(const cv::Mat1f& levels, const BarCandidate& bar) {
    constexpr int inside = 4, around = 7;
    DrawnBar drawn;
    if (bar.outline > 0) drawn.outline_level = bar.outline_level;
    const int outside = bar.outline > 0 ? bar.outline : around;
    const int before = std::min(bar.left, outside), after = std::min(levels.cols - 1 - bar.right, outside);
    cv::Mat1f left, right = levels(cv::Rect(bar.right + 1 - inside, bar.top, inside + after, bar.thickness()));
    cv::flip(levels(cv::Rect(bar.left - before, bar.top, inside + before, bar.thickness())), left, 1);
    const auto begin = bar_end(left, inside, bar.level, bar.deviation, drawn.outline_level),
               end = bar_end(right, inside, bar.level, bar.deviation, drawn.outline_level);
    // programs place corners of an outlined bar in the middle of the outline
    const double half_outline = 0.5 * bar.outline;
    drawn.begin_x = bar.left - 0.5 - begin.place - half_outline;
    drawn.end_x = bar.right + 0.5 + end.place + half_outline;
    const double outline_error = bar.outline / std::sqrt(3.0);
    drawn.length_standard_error =
        std::sqrt(rounding * rounding + outline_error * outline_error + begin.standard_error * begin.standard_error +
                  end.standard_error * end.standard_error);
    drawn.y = 0.5 * (bar.top + bar.bottom);
    drawn.thickness = bar.thickness() + 2 * half_outline;
    drawn.box = bar.box();
    drawn.level = bar.level;
    drawn.contrast = std::abs(bar.contrast);
    const double clean = 1 - bar.deviation / (0.12 * drawn.contrast);
    drawn.left_tick = bar.left_tick;
    drawn.right_tick = bar.right_tick;
    drawn.quality = std::clamp(0.5 * std::min(1.0, drawn.contrast / 0.4) + 0.5 * clean, 0.0, 1.0);
    return drawn;
}

/// Two halves with the label between them, as in data bars of FEI: one bar.
std::vector<DrawnBar> joined(const cv::Mat1f& levels, std::vector<DrawnBar> bars) {
    for (std::size_t i = 0; i < bars.size(); ++i)
        for (std::size_t k = 0; k < bars.size(); ++k) {
            auto &first = bars[i], &second = bars[k];
            const double length = first.end_x - first.begin_x, gap = second.begin_x - first.end_x;
            if (i == k || first.gap || second.gap || gap < 4 || gap > 2 * length ||
                std::abs(first.y - second.y) > 0.6 || std::abs(first.thickness - second.thickness) > 0.6)
                continue;
            if (std::abs(second.end_x - second.begin_x - length) > 0.1 * length + 2 ||
                std::abs(first.level - second.level) > 0.1 * first.contrast)
                continue;
            const cv::Rect united = first.box | second.box;
            const int reach = std::max(2 * united.height, 8);
            const cv::Rect between = cv::Rect(first.box.x + first.box.width, united.y - reach,
                                              second.box.x - first.box.x - first.box.width, united.height + 2 * reach) &
                                     cv::Rect(0, 0, levels.cols, levels.rows);
            int ink = 0;
            for (int y = between.y; y < between.y + between.height; ++y)
                for (int x = between.x; x < between.x + between.width; ++x)
                    ink += std::abs(static_cast<double>(levels(y, x)) - first.level) < 0.3 * first.contrast;
            if (ink < 0.03 * between.area() || ink > 0.6 * between.area()) continue;
            first.end_x = second.end_x;
            first.right_tick = second.right_tick;
            first.length_standard_error =
                std::hypot(first.length_standard_error, second.length_standard_error) / std::sqrt(2.0);
            first.box = united;
            first.gap = between;
            bars.erase(bars.begin() + static_cast<long>(k));
            return joined(levels, std::move(bars));
        }
    return bars;
}

}  // namespace

cv::Mat1f scaled_levels(const FramePixels& pixels) {
    constexpr long samples = 250'000;
    cv::Mat1f levels(static_cast<int>(pixels.rows()), static_cast<int>(pixels.cols()), 0.0f);
    const long stride = std::max(1L, pixels.size() / samples);
    std::vector<float> sample;
    float least = 0, most = 0;
    bool any = false;
    for (long i = 0; i < pixels.size(); ++i) {
        const float value = pixels.data()[i];
        if (!std::isfinite(value)) continue;
        least = any ? std::min(least, value) : value;
        most = any ? std::max(most, value) : value;
        any = true;
        if (i % stride == 0) sample.push_back(value);
    }
    if (!(most > least)) return levels;
    double low = static_cast<double>(least), high = static_cast<double>(most);
    if (sample.size() > 1) {
        const auto lower = static_cast<double>(lower_quantile(sample, 0.001)),
                   upper = static_cast<double>(lower_quantile(std::move(sample), 0.999));
        if (upper > lower) {
            low = lower;
            high = upper;
        }
    }
    for (long i = 0; i < pixels.size(); ++i)
        if (const float value = pixels.data()[i]; std::isfinite(value))
            levels(static_cast<int>(i / pixels.cols()), static_cast<int>(i % pixels.cols())) =
                static_cast<float>((static_cast<double>(value) - low) / (high - low));
    return levels;
}

std::vector<DrawnBar> drawn_bars(const cv::Mat1f& levels) {
    const int min_length = std::max(shortest, static_cast<int>(std::ceil(shortest_share * levels.cols)));
    if (levels.rows < 8 || levels.cols < min_length + 6) return {};
    // bars may be darker or brighter than the whole picture, single pixels even more
    double low = 0, high = 0;
    cv::minMaxLoc(levels, &low, &high);
    low = std::max(low, -1.0);
    high = std::min(high, 2.0);
    if (!(high > low)) return {};
    const double byte = (high - low) / 255;
    cv::Mat1b bytes, inverse;
    levels.convertTo(bytes, CV_8U, 1 / byte, -low / byte);
    std::vector<BarCandidate> found;
    collect(bytes, levels, {min_length, 1.0, byte}, found);
    cv::bitwise_not(bytes, inverse);
    collect(inverse, levels, {min_length, -1.0, byte}, found);

    const int thinnest = has_two_levels(levels) ? 3 : 1;  // masks have streaks
    std::vector<BarCandidate> chosen;
    for (const auto& bar : found)
        if (bar.drawn && bar.thickness() >= thinnest && !repeats(bar, found)) chosen.push_back(bar);
    // the inside of an outlined bar represents its outline, too, which looks like two thin bars
    std::stable_sort(chosen.begin(), chosen.end(), [](const BarCandidate& a, const BarCandidate& b) {
        if ((a.outline > 0) != (b.outline > 0)) return a.outline > 0;
        return a.length() * a.thickness() > b.length() * b.thickness();
    });
    std::vector<DrawnBar> bars;
    for (const auto& bar : chosen) {
        const auto box = bar.box();
        const cv::Rect near(box.x - 2, box.y - 2, box.width + 4, box.height + 4);
        if (std::none_of(bars.begin(), bars.end(),
                         [&](const DrawnBar& other) { return (other.box & near).area() > 0; }))
            bars.push_back(measured(levels, bar));
    }
    std::erase_if(bars, [](const DrawnBar& bar) { return bar.quality < min_quality; });
    bars = joined(levels, std::move(bars));
    for (auto& bar : bars) settle_ticks(bar);
    std::stable_sort(bars.begin(), bars.end(),
                     [](const DrawnBar& a, const DrawnBar& b) { return a.quality > b.quality; });
    return bars;
}

}  // namespace setae::imaging
