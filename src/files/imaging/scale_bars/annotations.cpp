// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "drawn_bars.hpp"
#include "found_bars.hpp"
#include "letter_lines.hpp"
#include "setae/core/statistics.hpp"
#include "setae/imaging/opencv_session.hpp"
#include "setae/imaging/scale_bar.hpp"

namespace setae::imaging {
namespace {

constexpr double same_level = 0.01;       // of scaled levels: drawn, not photographed
constexpr double highest_data_bar = 0.3;  // of the picture's height
constexpr int min_data_bar = 12;          // rows
constexpr int margin = 3;                 // px around letters
constexpr int min_letter = 8;             // px of height, for text only
constexpr double max_ink = 0.03;          // share of a picture covered by letters

double share_near(const cv::Mat1f& levels, int row, double level) {
    int count = 0;
    for (int x = 0; x < levels.cols; ++x) count += std::abs(static_cast<double>(levels(row, x)) - level) <= same_level;
    return static_cast<double>(count) / levels.cols;
}

/// The level of most pixels of a row, to same_level.
double common_level(const cv::Mat1f& levels, int row) {
    std::map<long, int> counts;
    for (int x = 0; x < levels.cols; ++x)
        ++counts[std::lround(std::clamp(static_cast<double>(levels(row, x)), -10.0, 1e6) / same_level)];
    return same_level *
           static_cast<double>(std::max_element(counts.begin(), counts.end(), [](const auto& a, const auto& b) {
                                   return a.second < b.second;
                               })->first);
}

cv::Mat1b mask_where(const cv::Mat1f& levels, double level, double tolerance, bool near) {
    cv::Mat1b mask(levels.size());
    for (int y = 0; y < levels.rows; ++y)
        for (int x = 0; x < levels.cols; ++x)
            mask(y, x) = (std::abs(static_cast<double>(levels(y, x)) - level) <= tolerance) == near ? 255 : 0;
    return mask;
}

/// Rows along the lower edge (the upper edge of an inverted picture) of one drawn level, with letters on them, across
/// the whole width; 0 if there are none.
int rows_of_data_bar(const cv::Mat1f& levels) {
    const int most = static_cast<int>(highest_data_bar * levels.rows);
    double level = 0, best = 0;
    for (int k = 0; k < std::min(4, levels.rows); ++k) {  // the outermost row may be a line
        const double candidate = common_level(levels, levels.rows - 1 - k),
                     share = share_near(levels, levels.rows - 1 - k, candidate);
        if (share > best + 0.01 || k == 2) {
            best = share;
            level = candidate;
        }
    }
    int rows = 0;
    while (rows <= most && rows < levels.rows) {
        const int row = levels.rows - 1 - rows;
        if (share_near(levels, row, level) < 0.4 && share_near(levels, row, common_level(levels, row)) < 0.9) break;
        ++rows;
    }
    if (rows < min_data_bar || rows > most || share_near(levels, levels.rows - 1 - rows, level) > 0.3) return 0;
    const auto ink = mask_where(levels.rowRange(levels.rows - rows, levels.rows), level, 0.3, false);
    const auto lines = letter_lines(ink, {});
    return std::any_of(lines.begin(), lines.end(), [](const LetterLine& line) { return line.letters.size() >= 3; })
               ? rows
               : 0;
}

/// Whether a line of letters is text: high enough, letters on one baseline.
bool is_text(const LetterLine& line) {
    if (line.letters.size() < 3 || line.box.height < min_letter) return false;
    std::vector<int> bottoms;
    for (const auto& letter : line.letters) bottoms.push_back(letter.br().y);
    const int baseline = upper_median(bottoms);
    const auto aligned = std::count_if(bottoms.begin(), bottoms.end(), [&](int bottom) {
        return std::abs(bottom - baseline) <= 0.08 * line.box.height;
    });
    return static_cast<double>(aligned) >= 0.6 * static_cast<double>(bottoms.size());
}

/// Text in the darkest or the brightest level.
std::vector<cv::Rect> text(const cv::Mat1f& levels) {
    std::vector<cv::Rect> found;
    double least = 0, most = 0;
    cv::minMaxLoc(levels, &least, &most);
    for (const double level : {least, most}) {
        const auto mask = mask_where(levels, level, same_level, true);
        if (cv::countNonZero(mask) > max_ink * static_cast<double>(levels.total()))
            continue;  // a background, a mask, a saturated picture
        const auto lines = letter_lines(mask, {});
        std::size_t letters = 0, of_text = 0;
        for (const auto& line : lines) {
            letters += line.letters.size();
            of_text += is_text(line) ? line.letters.size() : 0;
        }
        if (2 * of_text < letters) continue;  // blobs of a truncated texture
        for (const auto& line : lines)
            if (is_text(line)) found.push_back(line.box);
    }
    return found;
}

}  // namespace

std::vector<PictureRegion> annotations(const FramePixels& pixels) {
    limit_opencv();
    const auto levels = scaled_levels(pixels);
    std::vector<PictureRegion> regions;
    for (const auto& found : found_bars(levels)) regions.push_back(found.bar.annotation);
    if (levels.rows < 2 * min_data_bar || levels.cols < 2 * min_data_bar) return regions;
    cv::Mat1f upside_down;
    cv::flip(levels, upside_down, 0);
    if (const long rows = rows_of_data_bar(levels); rows > 0)
        regions.push_back({0, levels.rows - rows, levels.cols, rows});
    if (const long rows = rows_of_data_bar(upside_down); rows > 0) regions.push_back({0, 0, levels.cols, rows});
    for (const auto& box : text(levels)) {
        const auto wide = cv::Rect(box.x - margin, box.y - margin, box.width + 2 * margin, box.height + 2 * margin) &
                          cv::Rect(0, 0, levels.cols, levels.rows);
        const bool known = std::any_of(regions.begin(), regions.end(), [&](const PictureRegion& other) {
            return wide.x >= other.x && wide.y >= other.y && wide.br().x <= other.x + other.width &&
                   wide.br().y <= other.y + other.height;
        });
        if (!known) regions.push_back({wide.x, wide.y, wide.width, wide.height});
    }
    return regions;
}

}  // namespace setae::imaging
