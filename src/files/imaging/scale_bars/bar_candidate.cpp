// SPDX-License-Identifier: GPL-3.0-or-later
#include "bar_candidate.hpp"

#include <cmath>
#include <vector>

#include "setae/core/statistics.hpp"

namespace setae::imaging {
namespace {

constexpr double min_aspect = 1.5;  // length over thickness
constexpr int max_outline = 8;      // px

struct Moments {
    double mean = 0, deviation = 0;
};

Moments moments_of(const cv::Mat1f& levels, const cv::Rect& where) {
    double sum = 0, square = 0;
    for (int y = where.y; y < where.y + where.height; ++y)
        for (int x = where.x; x < where.x + where.width; ++x) {
            const double level = static_cast<double>(levels(y, x));
            sum += level;
            square += level * level;
        }
    const double n = where.area();
    return {sum / n, std::sqrt(std::max(square / n - sum / n * sum / n, 0.0))};
}

class Measurement {
public:
    Measurement(const cv::Mat1f& levels, int min_length) : levels_(levels), min_length_(min_length) {}

    /// A bar within `box`, the place of a long and thin object that differs by `height`; empty if it is none.
    [[nodiscard]] std::optional<BarCandidate> operator()(const cv::Rect& box, double height, double sign) const {
        BarCandidate bar;
        if (!rows(bar, box, height) || !columns(bar, box, height, sign)) return std::nullopt;
        if (!is_separate(bar) || !ends_straight(bar)) return std::nullopt;
        bar.drawn = looks_drawn(bar);
        find_outline(bar);
        find_ticks(bar);
        return bar;
    }

private:
    [[nodiscard]] double at(int y, int x) const { return static_cast<double>(levels_(y, x)); }
    /// Difference of a pixel from the bar (darker for bright bars), in contrasts.
    [[nodiscard]] double apart(const BarCandidate& bar, int y, int x) const {
        return (bar.level - at(y, x)) / bar.contrast;
    }

    [[nodiscard]] bool rows(BarCandidate& bar, const cv::Rect& box, double height) const {
        const int margin = box.width / 10;
        const auto middle = [&](int y) { return moments_of(levels_, {box.x + margin, y, box.width - 2 * margin, 1}); };
        double least = 0.15 * height;
        int best = -1;
        for (int y = box.y; y < box.y + box.height; ++y)
            if (const auto row = middle(y); row.deviation < least) {
                least = row.deviation;
                best = y;
                bar.level = row.mean;
            }
        if (best < 0) return false;
        const auto belongs = [&](int y) {
            const auto row = middle(y);
            return std::abs(row.mean - bar.level) <= 0.2 * height && row.deviation <= 0.2 * height;
        };
        bar.top = bar.bottom = best;
        while (bar.top > 0 && best - bar.top <= thickest_bar && belongs(bar.top - 1)) --bar.top;
        while (bar.bottom < levels_.rows - 1 && bar.bottom - best <= thickest_bar && belongs(bar.bottom + 1))
            ++bar.bottom;
        return bar.top >= 2 && bar.bottom < levels_.rows - 2 && bar.thickness() <= thickest_bar;
    }

    [[nodiscard]] bool columns(BarCandidate& bar, const cv::Rect& box, double height, double sign) const {
        const auto belongs = [&](int x) {
            return std::abs(moments_of(levels_, {x, bar.top, 1, bar.thickness()}).mean - bar.level) <= 0.25 * height;
        };
        bar.left = bar.right = box.x + box.width / 2;
        while (bar.left > 0 && belongs(bar.left - 1)) --bar.left;
        while (bar.right < levels_.cols - 1 && belongs(bar.right + 1)) ++bar.right;
        if (bar.left < 2 || bar.right > levels_.cols - 3 || bar.length() < min_length_ ||
            bar.length() < min_aspect * bar.thickness())
            return false;
        std::vector<double> differences;
        for (int x = bar.left; x <= bar.right; ++x)
            for (const int way : {-1, 1}) {  // the row next to it may be blurred
                const int edge = way < 0 ? bar.top : bar.bottom;
                differences.push_back(
                    std::max(sign * (bar.level - at(edge + way, x)), sign * (bar.level - at(edge + 2 * way, x))));
            }
        bar.contrast = sign * upper_median(std::move(differences));
        const auto core = moments_of(levels_, {bar.left + 1, bar.top, bar.length() - 2, bar.thickness()});
        bar.deviation = core.deviation;
        // blurred ends belong to the bar if their level is near that of the bar relative to its contrast
        const auto nearly = [&](int x) {
            return std::abs(moments_of(levels_, {x, bar.top, 1, bar.thickness()}).mean - bar.level) <=
                   0.2 * std::abs(bar.contrast);
        };
        while (bar.left > 2 && nearly(bar.left - 1)) --bar.left;
        while (bar.right < levels_.cols - 3 && nearly(bar.right + 1)) ++bar.right;
        return sign * bar.contrast > 0.5 * height && bar.deviation <= 0.12 * std::abs(bar.contrast);
    }

    [[nodiscard]] bool is_separate(const BarCandidate& bar) const {
        const auto share = [&](int first, int second) {
            int count = 0;
            for (int x = bar.left; x <= bar.right; ++x)
                count += std::max(apart(bar, first, x), apart(bar, second, x)) > 0.3;
            return static_cast<double>(count) / bar.length();
        };
        return share(bar.top - 1, bar.top - 2) >= 0.85 && share(bar.bottom + 1, bar.bottom + 2) >= 0.85;
    }

    /// Rows end at one place, and nothing continues beyond it.
    [[nodiscard]] bool ends_straight(const BarCandidate& bar) const {
        constexpr int beyond = 8;
        for (const int way : {-1, 1}) {
            const int end = way < 0 ? bar.left : bar.right;
            int straight = 0, apart_beyond = 0;
            for (int y = bar.top; y <= bar.bottom; ++y)
                straight += apart(bar, y, end - way) < 0.35 &&
                            std::max(apart(bar, y, end + way), apart(bar, y, end + 2 * way)) > 0.3;
            for (int y = bar.top - 2; y <= bar.bottom + 2; ++y) {
                double sum = 0;
                int count = 0;
                for (int k = 2; k <= beyond; ++k)
                    if (const int x = end + k * way; x >= 0 && x < levels_.cols) {
                        sum += apart(bar, y, x);
                        ++count;
                    }
                apart_beyond += sum > 0.25 * count;
            }
            if (straight < 0.8 * bar.thickness() || apart_beyond < 0.7 * (bar.thickness() + 4)) return false;
        }
        return true;
    }

    /// Deviation of the noise of a pixel, from differences of neighbours in a row.
    [[nodiscard]] double noise(int first_row, int last_row, int left, int right, bool robust) const {
        std::vector<double> squares;
        double sum = 0;
        for (int y = std::max(first_row, 0); y <= std::min(last_row, levels_.rows - 1); ++y)
            for (int x = left; x < right; ++x) {
                const double difference = at(y, x + 1) - at(y, x);
                squares.push_back(difference * difference);
                sum += difference * difference;
            }
        if (squares.empty()) return 0;
        return std::sqrt(robust ? upper_median(std::move(squares)) / 0.4549 / 2
                                : sum / static_cast<double>(squares.size()) / 2);  // 0.4549: median of χ² with 1
    }

    [[nodiscard]] bool looks_drawn(const BarCandidate& bar) const {
        const double contrast = std::abs(bar.contrast);
        // edges above and below within two pixels
        for (const int way : {-1, 1}) {
            const int edge = way < 0 ? bar.top : bar.bottom;
            double near = 0, far = 0;
            for (int k = 1; k <= 5; ++k) {
                const int y = edge + k * way;
                if (y < 0 || y >= levels_.rows) break;
                const double mean =
                    (bar.level - moments_of(levels_, {bar.left, y, bar.length(), 1}).mean) / bar.contrast;
                if (k <= 2) near = std::max(near, mean);
                far = std::max(far, mean);
            }
            if (near < 0.7 * far) return false;
        }
        const double inside = noise(bar.top, bar.bottom, bar.left + 1, bar.right - 1, false);
        const double around = std::max(noise(bar.top - 14, bar.top - 4, bar.left, bar.right, true),
                                       noise(bar.bottom + 4, bar.bottom + 14, bar.left, bar.right, true));
        const bool at_the_end = bar.level <= 0.1 || bar.level >= 0.9;  // of the levels of the picture
        const bool cleaner = inside <= 0.5 * around && bar.deviation <= 0.1 * contrast;
        const bool clean = bar.deviation <= 0.03 * contrast && around <= 0.02 * contrast;
        const bool extreme = at_the_end && bar.thickness() >= 3 && contrast >= 8 * bar.deviation && contrast >= 0.4;
        // a few pixels of a texture may be equal by chance
        if (bar.length() * bar.thickness() < 50 && bar.deviation > 0.03 * contrast) return false;
        if (bar.thickness() <= 2 && (bar.deviation > 0.06 * contrast || !at_the_end)) return false;
        return cleaner || clean || extreme;
    }

    /// Whether the lines above and below continue around the ends.
    [[nodiscard]] bool framed(const BarCandidate& bar, int outline, double level) const {
        for (const int way : {-1, 1}) {
            const int end = way < 0 ? bar.left : bar.right;
            double farthest = 0;  // towards the level of the outline, in its difference from the bar
            for (int k = 1; k <= outline + 1; ++k) {
                const int x = std::clamp(end + k * way, 0, levels_.cols - 1);
                farthest = std::max(farthest, (moments_of(levels_, {x, bar.top, 1, bar.thickness()}).mean - bar.level) /
                                                  (level - bar.level));
            }
            const int beyond = std::clamp(end + (outline + 2) * way, 0, levels_.cols - 1);
            const auto ground = moments_of(levels_, {beyond, bar.top, 1, bar.thickness()});
            const double other = 0.1 * std::abs(bar.contrast);
            if (farthest < 0.4 || (std::abs(ground.mean - level) < other && ground.deviation < other)) return false;
        }
        return true;
    }

    void find_outline(BarCandidate& bar) const {
        // as noisy as the bar
        const double tolerance =
            std::clamp(3 * bar.deviation, 0.15 * std::abs(bar.contrast), 0.3 * std::abs(bar.contrast));
        double first = 0;
        for (int k = 1; k <= max_outline + 1; ++k) {
            const int left = bar.left - k, right = bar.right + k, top = bar.top - k, bottom = bar.bottom + k;
            if (left < 0 || top < 0 || right >= levels_.cols || bottom >= levels_.rows) return;
            std::vector<double> ring;  // ends of bars may cover parts of pixels, rows are whole
            for (int x = bar.left; x <= bar.right; ++x) {
                ring.push_back(at(top, x));
                ring.push_back(at(bottom, x));
            }
            const double level = upper_median(ring);
            const auto off = std::count_if(ring.begin(), ring.end(),
                                           [&](double value) { return std::abs(value - level) > tolerance; });
            const bool one_level = static_cast<double>(off) <= 0.1 * static_cast<double>(ring.size());
            const bool mixed =
                static_cast<double>(off) > 0.3 * static_cast<double>(ring.size());  // a texture, not some letters
            if (k == 1) {
                // a ring between the levels of bar and background is blur
                if (!one_level || std::abs(level - bar.level) < 0.6 * std::abs(bar.contrast)) return;
                first = level;
            } else if (mixed || std::abs(level - first) > tolerance) {
                if (!framed(bar, k - 1, first)) return;
                bar.outline = k - 1;
                bar.outline_level = first;
                return;
            } else if (!one_level) {
                return;
            }
        }
    }

    /// A tick at one end: narrow, near it, and three rows high, or equally high above and below.
    [[nodiscard]] std::optional<BarTick> tick(const BarCandidate& bar, int end, int inwards) const {
        const int most = std::min(bar.length() / 4, bar.thickness() + 6);
        const auto reach = [&](int x, int row, int way) {
            int count = 0;
            for (int y = row + way;
                 y >= 0 && y < levels_.rows && count <= 2 * thickest_bar && std::abs(apart(bar, y, x)) < 0.3; y += way)
                ++count;
            return count;
        };
        int first = -1, last = -1, up = 0, down = 0;
        for (int k = 0; k < most; ++k) {
            const int x = end + k * inwards, above = reach(x, bar.top, -1), below = reach(x, bar.bottom, 1);
            if (std::max(above, below) >= 3 || (above == below && above > 0)) {
                if (first < 0) first = k;
                last = k;
                up = std::max(up, above);
                down = std::max(down, below);
            } else if (first >= 0 || k > 1) {
                break;
            }
        }
        if (first < 0 || last >= most - 1) return std::nullopt;
        // edges of the tick by the share of pixels, from the rows beyond the bar
        double weight = 0, middle = 0;
        for (int k = first - 1; k <= last + 1; ++k) {
            const int x = end + k * inwards;
            if (x < 0 || x >= levels_.cols) continue;
            double covered = 0;
            for (int step = 1; step <= std::max(up, down); ++step) {
                if (step <= up) covered += std::clamp(1 - apart(bar, bar.top - step, x), 0.0, 1.0);
                if (step <= down) covered += std::clamp(1 - apart(bar, bar.bottom + step, x), 0.0, 1.0);
            }
            covered /= up + down;
            if (covered < 0.3 && (k < first || k > last)) continue;  // the background next to it
            weight += covered;
            middle += covered * x;
        }
        return BarTick{middle / weight, weight, std::max(up, down)};
    }

    void find_ticks(BarCandidate& bar) const {
        if (bar.outline > 0) return;
        bar.left_tick = tick(bar, bar.left, 1);
        bar.right_tick = tick(bar, bar.right, -1);
    }

    const cv::Mat1f& levels_;
    int min_length_;
};

}  // namespace

std::optional<BarCandidate> bar_within(const cv::Mat1f& levels, const LongRun& run, int min_length) {
    return Measurement(levels, min_length)(run.box, run.height, run.sign);
}

}  // namespace setae::imaging
