// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawn_bars.hpp"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace setae::imaging {
namespace {

constexpr double shortest_share = 0.03;   // of the picture's width
constexpr int shortest = 12;              // px
constexpr int thickest = 40;              // px
constexpr double least_aspect = 1.5;      // length over thickness
constexpr double rounding = 0.3;          // px: standard error of a length that a program rounded to whole pixels
constexpr int thickest_outline = 8;       // px

/// Columns, counted from the end of a bar inwards, that stand out above or below it.
struct Tick {
    int first = 0, last = 0;
    int reach = 0;  // rows
    [[nodiscard]] int width() const { return last - first + 1; }
    [[nodiscard]] double middle() const { return 0.5 * (first + last + 1); }  // from the end of the bar
};

/// A candidate: its whole pixels, both ends included, and how it stands out.
struct Candidate {
    int left = 0, right = 0, top = 0, bottom = 0;
    double level = 0, deviation = 0;
    double contrast = 0;  // bar less surroundings: positive for bright bars
    bool drawn = false;   // clean enough to be drawn, not photographed
    int outline = 0;
    double outline_level = 0;
    std::optional<Tick> left_tick, right_tick;
    [[nodiscard]] int length() const { return right - left + 1; }
    [[nodiscard]] int thickness() const { return bottom - top + 1; }
    [[nodiscard]] cv::Rect box() const {
        const int y = std::max({outline, left_tick ? left_tick->reach : 0, right_tick ? right_tick->reach : 0});
        return {left - outline, top - y, length() + 2 * outline, thickness() + 2 * y};
    }
};

double median(std::vector<double> values) {
    if (values.empty()) return 0;
    const auto middle = values.begin() + static_cast<long>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

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
    Measurement(const cv::Mat1f& levels, int least_length) : levels_(levels), least_length_(least_length) {}

    /// A bar within `box`, the place of something long and thin that stands out by `height`; nothing where it is none.
    [[nodiscard]] std::optional<Candidate> operator()(const cv::Rect& box, double height, double sign) const {
        Candidate bar;
        if (!rows(bar, box, height) || !columns(bar, box, height, sign)) return std::nullopt;
        if (!stands_apart(bar) || !ends_straight(bar)) return std::nullopt;
        bar.drawn = looks_drawn(bar);
        find_outline(bar);
        find_ticks(bar);
        return bar;
    }

private:
    [[nodiscard]] double at(int y, int x) const { return static_cast<double>(levels_(y, x)); }
    /// How much darker (for bright bars) a pixel is than the bar, in contrasts.
    [[nodiscard]] double apart(const Candidate& bar, int y, int x) const { return (bar.level - at(y, x)) / bar.contrast; }

    [[nodiscard]] bool rows(Candidate& bar, const cv::Rect& box, double height) const {
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
        while (bar.top > 0 && best - bar.top <= thickest && belongs(bar.top - 1)) --bar.top;
        while (bar.bottom < levels_.rows - 1 && bar.bottom - best <= thickest && belongs(bar.bottom + 1)) ++bar.bottom;
        return bar.top >= 2 && bar.bottom < levels_.rows - 2 && bar.thickness() <= thickest;
    }

    [[nodiscard]] bool columns(Candidate& bar, const cv::Rect& box, double height, double sign) const {
        const auto belongs = [&](int x) { return std::abs(moments_of(levels_, {x, bar.top, 1, bar.thickness()}).mean - bar.level) <= 0.25 * height; };
        bar.left = bar.right = box.x + box.width / 2;
        while (bar.left > 0 && belongs(bar.left - 1)) --bar.left;
        while (bar.right < levels_.cols - 1 && belongs(bar.right + 1)) ++bar.right;
        if (bar.left < 2 || bar.right > levels_.cols - 3 || bar.length() < least_length_ || bar.length() < least_aspect * bar.thickness()) return false;
        std::vector<double> differences;
        for (int x = bar.left; x <= bar.right; ++x) {
            differences.push_back(sign * (bar.level - at(bar.top - 1, x)));
            differences.push_back(sign * (bar.level - at(bar.bottom + 1, x)));
            differences.push_back(sign * (bar.level - at(bar.top - 2, x)));
            differences.push_back(sign * (bar.level - at(bar.bottom + 2, x)));
        }
        bar.contrast = sign * median(std::move(differences));
        const auto core = moments_of(levels_, {bar.left + 1, bar.top, bar.length() - 2, bar.thickness()});
        bar.deviation = core.deviation;
        return sign * bar.contrast > 0.5 * height && bar.deviation <= 0.12 * std::abs(bar.contrast);
    }

    [[nodiscard]] bool stands_apart(const Candidate& bar) const {
        const auto share = [&](int first, int second) {
            int count = 0;
            for (int x = bar.left; x <= bar.right; ++x) count += std::max(apart(bar, first, x), apart(bar, second, x)) > 0.3;
            return static_cast<double>(count) / bar.length();
        };
        return share(bar.top - 1, bar.top - 2) >= 0.85 && share(bar.bottom + 1, bar.bottom + 2) >= 0.85;
    }

    /// Rows end at one place, and nothing goes on beyond it.
    [[nodiscard]] bool ends_straight(const Candidate& bar) const {
        constexpr int beyond = 8;
        for (const int way : {-1, 1}) {
            const int end = way < 0 ? bar.left : bar.right;
            int straight = 0, apart_beyond = 0;
            for (int y = bar.top; y <= bar.bottom; ++y)
                straight += apart(bar, y, end - way) < 0.35 && std::max(apart(bar, y, end + way), apart(bar, y, end + 2 * way)) > 0.3;
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

    /// Deviation of a pixel's noise, from differences of neighbours in a row.
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
        return std::sqrt(robust ? median(std::move(squares)) / 0.4549 / 2 : sum / static_cast<double>(squares.size()) / 2);  // 0.4549: median of χ² with 1
    }

    [[nodiscard]] bool looks_drawn(const Candidate& bar) const {
        const double contrast = std::abs(bar.contrast);
        // edges above and below within two pixels
        for (const int way : {-1, 1}) {
            const int edge = way < 0 ? bar.top : bar.bottom;
            double near = 0, far = 0;
            for (int k = 1; k <= 5; ++k) {
                const int y = edge + k * way;
                if (y < 0 || y >= levels_.rows) break;
                const double mean = (bar.level - moments_of(levels_, {bar.left, y, bar.length(), 1}).mean) / bar.contrast;
                if (k <= 2) near = std::max(near, mean);
                far = std::max(far, mean);
            }
            if (near < 0.7 * far) return false;
        }
        const double inside = noise(bar.top, bar.bottom, bar.left + 1, bar.right - 1, false);
        const double around = std::max(noise(bar.top - 14, bar.top - 4, bar.left, bar.right, true), noise(bar.bottom + 4, bar.bottom + 14, bar.left, bar.right, true));
        const bool cleaner = inside <= 0.5 * around && bar.deviation <= 0.1 * contrast;
        const bool clean = bar.deviation <= 0.03 * contrast && around <= 0.02 * contrast;
        const bool extreme = (bar.level <= 0.1 || bar.level >= 0.9) && bar.thickness() >= 3 && contrast >= 8 * bar.deviation && contrast >= 0.4;
        return cleaner || clean || extreme;
    }

    void find_outline(Candidate& bar) const {
        const double tolerance = 0.15 * std::abs(bar.contrast);
        double first = 0;
        for (int k = 1; k <= thickest_outline + 1; ++k) {
            const int left = bar.left - k, right = bar.right + k, top = bar.top - k, bottom = bar.bottom + k;
            if (left < 0 || top < 0 || right >= levels_.cols || bottom >= levels_.rows) return;
            std::vector<double> ring;
            for (int x = left; x <= right; ++x) {
                ring.push_back(at(top, x));
                ring.push_back(at(bottom, x));
            }
            for (int y = top + 1; y < bottom; ++y) {
                ring.push_back(at(y, left));
                ring.push_back(at(y, right));
            }
            const double level = median(ring);
            const auto off = std::count_if(ring.begin(), ring.end(), [&](double value) { return std::abs(value - level) > tolerance; });
            const bool one_level = static_cast<double>(off) <= 0.02 * static_cast<double>(ring.size());
            const bool mixed = static_cast<double>(off) > 0.3 * static_cast<double>(ring.size());  // a texture, not some letters
            if (k == 1) {
                if (!one_level) return;
                first = level;
            } else if (mixed || std::abs(level - first) > tolerance) {
                bar.outline = k - 1;
                bar.outline_level = first;
                return;
            } else if (!one_level) {
                return;
            }
        }
    }

    /// A tick at one end: narrow, near it, and standing out by three rows, or by as many above as below.
    [[nodiscard]] std::optional<Tick> tick(const Candidate& bar, int end, int inwards) const {
        const int most = std::min(bar.length() / 4, bar.thickness() + 6);
        const auto reach = [&](int x, int row, int way) {
            int count = 0;
            for (int y = row + way; y >= 0 && y < levels_.rows && count <= 2 * thickest && std::abs(apart(bar, y, x)) < 0.3; y += way) ++count;
            return count;
        };
        std::optional<Tick> found;
        for (int k = 0; k < most; ++k) {
            const int x = end + k * inwards, up = reach(x, bar.top, -1), down = reach(x, bar.bottom, 1);
            const bool stands_out = std::max(up, down) >= 3 || (up == down && up > 0);
            if (!stands_out) {
                if (found) return found;
                if (k > 1) return std::nullopt;
            } else {
                if (!found) found = Tick{k, k, 0};
                found->last = k;
                found->reach = std::max({found->reach, up, down});
            }
        }
        return std::nullopt;
    }

    void find_ticks(Candidate& bar) const {
        if (bar.outline > 0) return;
        bar.left_tick = tick(bar, bar.left, 1);
        bar.right_tick = tick(bar, bar.right, -1);
    }

    const cv::Mat1f& levels_;
    int least_length_;
};

double length_overlap(const Candidate& first, const Candidate& second) {
    const int common = std::min(first.right, second.right) - std::max(first.left, second.left) + 1;
    return static_cast<double>(common) / std::min(first.length(), second.length());
}

/// Candidates of one polarity: what a long opening along rows keeps and one across them removes.
void collect(const cv::Mat1b& bytes, const Measurement& measure, int least_length, double sign, std::vector<Candidate>& found) {
    cv::Mat1b rows, thick, raised, mask;
    cv::morphologyEx(bytes, rows, cv::MORPH_OPEN, cv::getStructuringElement(cv::MORPH_RECT, {least_length, 1}));
    cv::morphologyEx(rows, thick, cv::MORPH_OPEN, cv::getStructuringElement(cv::MORPH_RECT, {1, thickest + 3}));
    raised = rows - thick;
    cv::Mat labels, statistics, centres;
    for (const int threshold : {24, 48, 96, 160}) {
        mask = raised > threshold;
        const int count = cv::connectedComponentsWithStats(mask, labels, statistics, centres, 4, CV_32S);
        for (int k = 1; k < count; ++k) {
            const int* box = statistics.ptr<int>(k);
            if (box[cv::CC_STAT_HEIGHT] > thickest + 3 || box[cv::CC_STAT_WIDTH] < least_length) continue;
            const cv::Rect where(box[cv::CC_STAT_LEFT], box[cv::CC_STAT_TOP], box[cv::CC_STAT_WIDTH], box[cv::CC_STAT_HEIGHT]);
            const auto bar = measure(where, threshold / 255.0, sign);
            const auto same = [&](const Candidate& other) { return other.left == bar->left && other.right == bar->right && other.top == bar->top && other.bottom == bar->bottom; };
            if (bar && std::none_of(found.begin(), found.end(), same)) found.push_back(*bar);
        }
    }
}

/// Fringes repeat, bars do not: at least two others of the same polarity, length and thickness beside it.
bool repeats(const Candidate& bar, const std::vector<Candidate>& all) {
    int count = 0;
    for (const auto& other : all) {
        if (&other == &bar || other.contrast * bar.contrast < 0 || (other.top <= bar.bottom && other.bottom >= bar.top)) continue;
        const bool alike = std::abs(other.length() - bar.length()) <= 0.2 * bar.length() + 2 && std::abs(other.thickness() - bar.thickness()) <= 1 + bar.thickness() / 2;
        count += alike && length_overlap(bar, other) > 0.5;
    }
    return count >= 2;
}

std::optional<BarTick> tick_of(const std::optional<Tick>& tick) {
    if (!tick) return std::nullopt;
    return BarTick{tick->middle(), static_cast<double>(tick->width()), tick->reach};
}

/// Where both ends have the same tick, the length runs between their middles.
void settle_ticks(DrawnBar& bar) {
    const auto &left = bar.left_tick, &right = bar.right_tick;
    if (!left || !right || std::abs(left->middle - right->middle) > 1 || std::abs(left->width - right->width) > 1 || std::abs(left->reach - right->reach) > 2) return;
    bar.begin_x += left->middle;
    bar.end_x -= right->middle;
    bar.length_standard_error = std::hypot(bar.length_standard_error, left->width / std::sqrt(12.0));
    bar.left_tick.reset();
    bar.right_tick.reset();
}

DrawnBar measured(const cv::Mat1f& levels, const Candidate& bar) {
    constexpr int inside = 4, around = 7;
    const int outside = bar.outline > 0 ? bar.outline : around;
    const int before = std::min(bar.left, outside), after = std::min(levels.cols - 1 - bar.right, outside);
    cv::Mat1f left, right = levels(cv::Rect(bar.right + 1 - inside, bar.top, inside + after, bar.thickness()));
    cv::flip(levels(cv::Rect(bar.left - before, bar.top, inside + before, bar.thickness())), left, 1);
    const auto begin = bar_end(left, inside, bar.level, bar.deviation), end = bar_end(right, inside, bar.level, bar.deviation);
    // programs place corners of an outlined bar in the middle of the outline
    const double half_outline = 0.5 * bar.outline;
    DrawnBar drawn;
    drawn.begin_x = bar.left - 0.5 - begin.place - half_outline;
    drawn.end_x = bar.right + 0.5 + end.place + half_outline;
    const double outline_error = bar.outline / std::sqrt(3.0);
    drawn.length_standard_error = std::sqrt(rounding * rounding + outline_error * outline_error + begin.standard_error * begin.standard_error + end.standard_error * end.standard_error);
    drawn.y = 0.5 * (bar.top + bar.bottom);
    drawn.thickness = bar.thickness() + 2 * half_outline;
    drawn.box = bar.box();
    drawn.level = bar.level;
    drawn.contrast = std::abs(bar.contrast);
    if (bar.outline > 0) drawn.outline_level = bar.outline_level;
    const double clean = 1 - bar.deviation / (0.12 * drawn.contrast);
    drawn.left_tick = tick_of(bar.left_tick);
    drawn.right_tick = tick_of(bar.right_tick);
    drawn.quality = std::clamp(0.5 * std::min(1.0, drawn.contrast / 0.4) + 0.5 * clean, 0.0, 1.0);
    return drawn;
}

/// Two halves with the label between them, as FEI's data bars have: one bar.
std::vector<DrawnBar> joined(const cv::Mat1f& levels, std::vector<DrawnBar> bars) {
    for (std::size_t i = 0; i < bars.size(); ++i)
        for (std::size_t k = 0; k < bars.size(); ++k) {
            auto &first = bars[i], &second = bars[k];
            const double length = first.end_x - first.begin_x, gap = second.begin_x - first.end_x;
            if (i == k || first.gap || second.gap || gap < 4 || gap > 2 * length || std::abs(first.y - second.y) > 0.6 || std::abs(first.thickness - second.thickness) > 0.6) continue;
            if (std::abs(second.end_x - second.begin_x - length) > 0.1 * length + 2 || std::abs(first.level - second.level) > 0.1 * first.contrast) continue;
            const cv::Rect united = first.box | second.box;
            const int reach = std::max(2 * united.height, 8);
            const cv::Rect between = cv::Rect(first.box.x + first.box.width, united.y - reach, second.box.x - first.box.x - first.box.width, united.height + 2 * reach) & cv::Rect(0, 0, levels.cols, levels.rows);
            int ink = 0;
            for (int y = between.y; y < between.y + between.height; ++y)
                for (int x = between.x; x < between.x + between.width; ++x) ink += std::abs(static_cast<double>(levels(y, x)) - first.level) < 0.3 * first.contrast;
            if (ink < 0.03 * between.area() || ink > 0.6 * between.area()) continue;
            first.end_x = second.end_x;
            first.right_tick = second.right_tick;
            first.length_standard_error = std::hypot(first.length_standard_error, second.length_standard_error) / std::sqrt(2.0);
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
        const auto quantile = [&](double share) {
            const auto place = sample.begin() + static_cast<long>(share * static_cast<double>(sample.size() - 1));
            std::nth_element(sample.begin(), place, sample.end());
            return static_cast<double>(*place);
        };
        const double lower = quantile(0.001), upper = quantile(0.999);
        if (upper > lower) {
            low = lower;
            high = upper;
        }
    }
    for (long i = 0; i < pixels.size(); ++i)
        if (const float value = pixels.data()[i]; std::isfinite(value)) levels(static_cast<int>(i / pixels.cols()), static_cast<int>(i % pixels.cols())) = static_cast<float>((static_cast<double>(value) - low) / (high - low));
    return levels;
}

std::vector<DrawnBar> drawn_bars(const cv::Mat1f& levels) {
    const int least_length = std::max(shortest, static_cast<int>(std::ceil(shortest_share * levels.cols)));
    if (levels.rows < 8 || levels.cols < least_length + 6) return {};
    const Measurement measure(levels, least_length);
    cv::Mat1b bytes, inverse;
    levels.convertTo(bytes, CV_8U, 255.0);
    std::vector<Candidate> found;
    collect(bytes, measure, least_length, 1.0, found);
    cv::bitwise_not(bytes, inverse);
    collect(inverse, measure, least_length, -1.0, found);

    std::vector<Candidate> chosen;
    for (const auto& bar : found)
        if (bar.drawn && !repeats(bar, found)) chosen.push_back(bar);
    // the inside of an outlined bar stands for its outline, too, which looks like two thin bars
    std::stable_sort(chosen.begin(), chosen.end(), [](const Candidate& a, const Candidate& b) {
        if ((a.outline > 0) != (b.outline > 0)) return a.outline > 0;
        return a.length() * a.thickness() > b.length() * b.thickness();
    });
    std::vector<DrawnBar> bars;
    for (const auto& bar : chosen) {
        const auto box = bar.box();
        const cv::Rect near(box.x - 2, box.y - 2, box.width + 4, box.height + 4);
        if (std::none_of(bars.begin(), bars.end(), [&](const DrawnBar& other) { return (other.box & near).area() > 0; })) bars.push_back(measured(levels, bar));
    }
    bars = joined(levels, std::move(bars));
    for (auto& bar : bars) settle_ticks(bar);
    std::stable_sort(bars.begin(), bars.end(), [](const DrawnBar& a, const DrawnBar& b) { return a.quality > b.quality; });
    return bars;
}

}  // namespace setae::imaging
