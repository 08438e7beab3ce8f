// SPDX-License-Identifier: GPL-3.0-or-later
#include "letter_lines.hpp"

#include <algorithm>
#include <numeric>

#include <opencv2/imgproc.hpp>

#include "setae/core/statistics.hpp"

namespace setae::imaging {
namespace {

constexpr int min_height = 5;          // px of a letter
constexpr double small_letter = 0.45;  // of the highest: lower parts are points or specks

struct Part {
    cv::Rect box;
    int label = 0, area = 0;
    std::vector<int> pieces;  // labels of strokes above or below that belong to the letter
};

/// A detached stroke above or below a letter, or the ring of Å: without it a 5 would become a 2.
bool broken_off(const cv::Rect& stroke, const cv::Rect& letter) {
    const int common = std::min(stroke.br().x, letter.br().x) - std::max(stroke.x, letter.x);
    const int gap = std::max(stroke.y, letter.y) - std::min(stroke.br().y, letter.br().y);
    return common >= 0.6 * stroke.width && stroke.width >= 0.3 * letter.width && gap <= 0.6 * letter.height;
}

bool are_adjacent(const cv::Rect& first, const cv::Rect& second) {
    const int common = std::min(first.br().y, second.br().y) - std::max(first.y, second.y);
    const int gap = std::max(first.x, second.x) - std::min(first.br().x, second.br().x);
    const int low = std::min(first.height, second.height), high = std::max(first.height, second.height);
    return common >= 0.4 * low && high <= 2.5 * low && gap <= 1.6 * high;
}

bool is_point(const cv::Rect& part, int area, const cv::Rect& line, int baseline) {
    const double height = line.height, least = std::min(part.width, part.height),
                 most = std::max(part.width, part.height);
    return most <= 0.3 * height && least >= 0.06 * height && most <= 2 * least && area >= 0.6 * part.area() &&
           std::abs(part.br().y - baseline) <= 0.12 * height + 1;
}

/// Parts of the background that a letter encloses.
int holes(const cv::Mat1b& letter) {
    cv::Mat1b ground, padded;
    cv::copyMakeBorder(letter, padded, 1, 1, 1, 1, cv::BORDER_CONSTANT, 0);
    ground = padded == 0;
    cv::Mat labels;
    return cv::connectedComponents(ground, labels, 4, CV_32S) - 2;
}

/// Runs of ink along the row slightly below the middle: 3 of m, 2 of n and u.
int stems(const cv::Mat1b& letter) {
    const int row = std::min(static_cast<int>(0.6 * letter.rows), letter.rows - 1);
    int count = 0;
    for (int x = 0; x < letter.cols; ++x) count += letter(row, x) != 0 && (x == 0 || letter(row, x - 1) == 0);
    return count;
}

}  // namespace

std::vector<LetterLine> letter_lines(const cv::Mat1b& mask, const std::vector<cv::Rect>& not_letters) {
    cv::Mat labels, statistics, centres;
    const int count = cv::connectedComponentsWithStats(mask, labels, statistics, centres, 8, CV_32S);
    std::vector<Part> parts, letters;
    for (int k = 1; k < count; ++k) {
        const int* row = statistics.ptr<int>(k);
        Part part{{row[cv::CC_STAT_LEFT], row[cv::CC_STAT_TOP], row[cv::CC_STAT_WIDTH], row[cv::CC_STAT_HEIGHT]},
                  k,
                  row[cv::CC_STAT_AREA],
                  {}};
        if (std::any_of(not_letters.begin(), not_letters.end(),
                        [&](const cv::Rect& other) { return (other & part.box).area() > 0; }))
            continue;
        parts.push_back(part);
        const bool letter = part.box.height >= min_height && part.box.width <= 2 * part.box.height &&
                            part.box.height <= 0.8 * mask.rows;
        if (letter) letters.push_back(part);
    }
    for (auto& letter : letters) {
        const auto body = letter.box;
        for (const auto& part : parts)
            if (part.box.height < min_height && part.area >= 3 && broken_off(part.box, body)) {
                letter.pieces.push_back(part.label);
                letter.box |= part.box;
            }
    }
    std::sort(letters.begin(), letters.end(),
              [](const Part& a, const Part& b) { return std::pair(a.box.x, a.label) < std::pair(b.box.x, b.label); });
    // lines: letters joined with adjacent ones
    std::vector<std::size_t> line_of(letters.size());
    std::iota(line_of.begin(), line_of.end(), 0U);
    for (std::size_t i = 0; i < letters.size(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            if (line_of[k] != line_of[i] && are_adjacent(letters[i].box, letters[k].box)) {
                const auto from = line_of[i], to = line_of[k];
                std::replace(line_of.begin(), line_of.end(), from, to);
            }
    std::vector<LetterLine> lines;
    for (std::size_t first = 0; first < letters.size(); ++first) {
        LetterLine line;
        std::vector<int> kept;
        for (std::size_t i = 0; i < letters.size(); ++i)
            if (line_of[i] == first) line.box = line.box.empty() ? letters[i].box : (line.box | letters[i].box);
        const int high = line.box.height;
        std::vector<int> bottoms;
        for (std::size_t i = 0; i < letters.size(); ++i)
            if (line_of[i] == first && letters[i].box.height >= small_letter * high) {
                line.letters.push_back(letters[i].box);
                kept.push_back(letters[i].label);
                kept.insert(kept.end(), letters[i].pieces.begin(), letters[i].pieces.end());
                bottoms.push_back(letters[i].box.br().y);
            }
        if (line.letters.size() < 2) continue;
        const int baseline = upper_median(bottoms);
        for (const auto& part : parts) {
            if (std::find(kept.begin(), kept.end(), part.label) != kept.end() || (part.box & line.box).empty())
                continue;
            const bool between =
                part.box.x > line.letters.front().br().x - 1 && part.box.br().x < line.letters.back().x + 1;
            if (between && is_point(part.box, part.area, line.box, baseline)) {
                line.points.push_back(part.box);
                kept.push_back(part.label);
            } else {
                ++line.specks;
            }
        }
        line.ink = cv::Mat1b(line.box.size(), 0);
        for (int y = 0; y < line.box.height; ++y)
            for (int x = 0; x < line.box.width; ++x)
                if (std::find(kept.begin(), kept.end(), labels.at<int>(line.box.y + y, line.box.x + x)) != kept.end())
                    line.ink(y, x) = 255;
        lines.push_back(std::move(line));
    }
    return lines;
}

char prefix_by_shape(const LetterLine& line) {
    if (line.letters.size() < 2) return 0;
    const auto &prefix = line.letters[line.letters.size() - 2], &metre = line.letters.back();
    const cv::Point origin = line.box.tl();
    const cv::Mat1b letter = line.ink(prefix - origin);
    if (stems(line.ink(metre - origin)) != 3) return 0;
    if (holes(letter) > 0) return prefix.br().y > metre.br().y + metre.height / 10 ? 'p' : 0;
    // within the height of the m: the bridge of n is above, that of u below
    const int top = std::max(metre.y - prefix.y, 0), bottom = std::min(metre.br().y - prefix.y, prefix.height);
    if (bottom - top < 4) return 0;
    const int upright = stems(letter.rowRange(top, bottom));
    if (upright == 3) return 'm';
    if (upright != 2) return 0;
    const int band = std::max(1, static_cast<int>(0.3 * (bottom - top)));
    const int left = static_cast<int>(0.4 * prefix.width),
              right = std::max(left + 1, static_cast<int>(0.6 * prefix.width + 0.5));
    if (right > prefix.width) return 0;
    const auto ink = [&](int from, int to) {
        return cv::countNonZero(letter(cv::Range(from, to), cv::Range(left, right)));
    };
    const int above = ink(top, top + band), below = ink(bottom - band, bottom);
    const int sure = (right - left + 1) / 2;
    if (above >= sure && below == 0) return 'n';
    if (below >= sure && above == 0) return 'u';
    return 0;
}

bool last_letter_closed(const LetterLine& line) {
    return !line.letters.empty() && holes(line.ink(line.letters.back() - line.box.tl())) > 0;
}

}  // namespace setae::imaging
