// SPDX-License-Identifier: GPL-3.0-or-later
#include "scale_bar_label.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include "label_meaning.hpp"
#include "letter_lines.hpp"
#include "setae/core/statistics.hpp"

namespace setae::imaging {
namespace {

constexpr std::array<int, 2> magnified{36, 46};  // px of the height of a line suitable for Tesseract
constexpr std::size_t max_lines = 2;             // lines read in each mask

struct Ink {
    double level = 0, tolerance = 0;
    double bridge = 0;  // tolerance within broken strokes
};

/// A reading of a line that is probably the label of a bar.
struct Reading {
    LabelMeaning meaning;
    cv::Rect box;
    double distance = 0;
    std::size_t ink = 0;  // number of the mask
};

double distance_between(const cv::Rect& first, const cv::Rect& second) {
    const double dx = std::max({first.x - second.br().x, second.x - first.br().x, 0}),
                 dy = std::max({first.y - second.br().y, second.y - first.br().y, 0});
    return std::hypot(dx, dy);
}

/// The letters in black on white, enlarged.
cv::Mat1b enlarged(const LetterLine& line, int height) {
    cv::Mat1b letters, framed;
    cv::bitwise_not(line.ink, letters);
    const double factor = static_cast<double>(height) / line.box.height;
    cv::copyMakeBorder(letters, framed, 4, 4, 4, 4, cv::BORDER_CONSTANT, 255);
    cv::resize(framed, framed, {}, factor, factor, factor > 1 ? cv::INTER_CUBIC : cv::INTER_AREA);
    cv::GaussianBlur(framed, framed, {}, 0.25 * std::max(factor, 1.0));
    cv::copyMakeBorder(framed, framed, 16, 16, 16, 16, cv::BORDER_CONSTANT, 255);
    return framed;
}

/// Unit by the shapes of the last two letters, if the reading agrees or is similar: Tesseract has no µ and confuses m
/// with n.
std::string with_unit_by_shape(const std::string& text, const LetterLine& line, char shape) {
    if (shape == 0 || text.size() < 3) return text;
    const std::string_view last = "mn";
    const bool micro = text.size() > 3 && text.compare(text.size() - 3, 2, "\u00b5") == 0;
    const char prefix = micro ? 'u' : text[text.size() - 2];
    const auto& letter = line.letters[line.letters.size() - 2];
    const bool descends = letter.br().y > line.letters.back().br().y + line.letters.back().height / 10;
    const std::string_view looks_like = shape == 'n'   ? "nm"
                                        : shape == 'm' ? "mn"
                                        : shape == 'p' ? "p"
                                        : descends     ? "up"
                                                       : "u";
    if (last.find(text.back()) == std::string_view::npos || looks_like.find(prefix) == std::string_view::npos)
        return text;
    return text.substr(0, text.size() - (micro ? 3 : 2)) + shape + 'm';
}

/// Whether there is a letter for each digit of the reading, all higher than an m: a broken digit looks like another
/// one.
bool digits_whole(const LetterLine& line, long digits, const std::string& unit) {
    const std::size_t of_unit = unit == "A" ? 1 : 2;
    if (static_cast<long>(line.letters.size() - of_unit) != digits) return false;
    const double least = (unit == "A" ? 0.6 : 1.15) * line.letters.back().height;
    return std::all_of(line.letters.begin(), line.letters.begin() + digits,
                       [least](const cv::Rect& letter) { return letter.height >= least; });
}

/// The meaning of a reading, if the letters have the corresponding shapes.
LabelMeaning checked(const LetterLine& line, const std::string& reading) {
    const char shape = prefix_by_shape(line);
    const auto text = with_unit_by_shape(reading, line, shape);
    auto meaning = meaning_of_label(text);
    const auto unsure = [&](const std::string& why) {
        meaning.length.reset();
        meaning.fault = fmt::format("label read as '{}', but {}", meaning.text, why);
    };
    if (!meaning.length) return meaning;
    const auto points =
        std::count_if(text.begin(), text.end(), [](char letter) { return letter == '.' || letter == ','; });
    const auto digits =
        std::count_if(text.begin(), text.end(), [](char letter) { return letter >= '0' && letter <= '9'; });
    if (meaning.unit == "A" ? !last_letter_closed(line) : shape != meaning.unit.front())
        unsure("the letters of the unit have another shape");
    else if (!digits_whole(line, digits, meaning.unit))
        unsure("the letters of the number are incomplete, or their count differs");
    else if (points != static_cast<long>(line.points.size()))
        unsure("its decimal points differ from those of the picture");
    else if (points > 0 && line.specks > 0) unsure("the decimal point may be a speck");
    return meaning;
}

double median_level(const cv::Mat1f& patch) {
    std::vector<float> values;
    for (int y = 0; y < patch.rows; ++y)
        values.insert(values.end(), patch.ptr<float>(y), patch.ptr<float>(y) + patch.cols);
    return static_cast<double>(upper_median(std::move(values)));
}

cv::Mat1b mask_near(const cv::Mat1f& patch, double level, double tolerance) {
    cv::Mat1b mask(patch.size());
    for (int y = 0; y < patch.rows; ++y)
        for (int x = 0; x < patch.cols; ++x)
            mask(y, x) = std::abs(static_cast<double>(patch(y, x)) - level) <= tolerance ? 255 : 0;
    return mask;
}

/// Pixels with the level of the ink. Thin vertical strokes break by blurring: gaps of up to four rows are closed if
/// their level is similar.
cv::Mat1b mask_of(const cv::Mat1f& patch, const Ink& ink) {
    const auto strict = mask_near(patch, ink.level, ink.tolerance);
    if (ink.tolerance >= ink.bridge) return strict;
    cv::Mat1b closed;
    cv::morphologyEx(strict, closed, cv::MORPH_CLOSE, cv::getStructuringElement(cv::MORPH_RECT, {1, 5}));
    const auto loose = mask_near(patch, ink.level, ink.bridge);
    cv::bitwise_and(closed, loose, closed);
    cv::bitwise_or(closed, strict, closed);
    return closed;
}

/// The common result of the readings of the nearest line with a length; empty if there is none.
std::optional<BarLabel> agreed(const std::vector<Reading>& readings) {
    const Reading* best = nullptr;
    for (const auto& reading : readings)
        if (reading.meaning.length && (!best || reading.distance < best->distance)) best = &reading;
    if (!best) return std::nullopt;
    int agreeing = 0, other = 0;
    std::set<std::size_t> masks;
    for (const auto& reading : readings) {
        if (!reading.meaning.length || (reading.box & best->box).empty()) continue;
        const bool agrees = *reading.meaning.length == *best->meaning.length;
        ++(agrees ? agreeing : other);
        if (agrees) masks.insert(reading.ink);
    }
    BarLabel label{.text = best->meaning.text, .box = best->box};
    if (other > 0) label.fault = fmt::format("label read as '{}', and differently in other attempts", label.text);
    else if (agreeing < 3 || masks.size() < 2)
        label.fault = fmt::format("label read as '{}' in some attempts, but not in others", label.text);
    else label.length = best->meaning.length;
    return label;
}

}  // namespace

BarLabel read_label(const cv::Mat1f& levels, const DrawnBar& bar, LabelRecogniser& reader) {
    const int pad_x = std::max(100, levels.cols / 5), pad_y = std::max(40, levels.rows / 14);
    const cv::Rect patch =
        cv::Rect(bar.box.x - pad_x, bar.box.y - pad_y, bar.box.width + 2 * pad_x, bar.box.height + 2 * pad_y) &
        cv::Rect(0, 0, levels.cols, levels.rows);
    std::vector<cv::Rect> own{bar.box - patch.tl()};
    cv::Rect near = own.front();
    if (bar.gap) {
        near = *bar.gap - patch.tl();
        own = {{own[0].x, own[0].y, near.x - own[0].x, own[0].height},
               {near.br().x, own[0].y, own[0].br().x - near.br().x, own[0].height}};
    }
    // letters in the level of the bar, exactly and with blurred edges; in that of the outline
    const double ground = median_level(levels(patch));
    std::vector<Ink> inks;
    for (const double share : {0.06, 0.12, 0.2, 0.3, 0.4, 0.5})
        inks.push_back({bar.level, share * std::abs(bar.level - ground), 0.5 * std::abs(bar.level - ground)});
    if (bar.outline_level)
        for (const double share : {0.06, 0.12})
            inks.push_back({*bar.outline_level, share * std::abs(*bar.outline_level - ground),
                            0.5 * std::abs(*bar.outline_level - ground)});

    std::vector<Reading> readings;
    std::vector<LetterLine> seen;
    std::vector<std::vector<Reading>> readings_of_seen;
    BarLabel label;
    for (std::size_t k = 0; k < inks.size(); ++k) {
        auto lines = letter_lines(mask_of(levels(patch), inks[k]), own);
        std::erase_if(lines, [&](const LetterLine& line) {
            return line.letters.size() > 24 ||
                   distance_between(line.box, near) > 3.0 * line.box.height + 0.5 * bar.box.width;
        });
        std::stable_sort(lines.begin(), lines.end(), [&](const LetterLine& a, const LetterLine& b) {
            return distance_between(a.box, near) < distance_between(b.box, near);
        });
        if (lines.size() > max_lines) lines.resize(max_lines);
        for (const auto& line : lines) {
            const auto same = std::find_if(seen.begin(), seen.end(), [&](const LetterLine& other) {
                return other.box == line.box && cv::countNonZero(other.ink != line.ink) == 0;
            });
            const auto index = static_cast<std::size_t>(same - seen.begin());
            if (same == seen.end()) {
                seen.push_back(line);
                auto& of_line = readings_of_seen.emplace_back();
                for (const int height : magnified)
                    if (const auto read = reader.read(enlarged(line, height)))
                        of_line.push_back({checked(line, *read), line.box, distance_between(line.box, near)});
            }
            for (auto reading : readings_of_seen[index]) {
                reading.ink = k;
                readings.push_back(std::move(reading));
            }
        }
    }
    if (!reader.fault().empty()) {
        label.fault = reader.fault();
        return label;
    }
    if (const auto vote = agreed(readings)) {
        label.text = vote->text;
        label.box = *vote->box + patch.tl();
        label.length = vote->length;
        label.fault = vote->fault;
        return label;
    }
    for (const auto& reading : readings) {
        const bool better = !label.box || (label.fault.find("no number") != std::string::npos &&
                                           reading.meaning.fault.find("no number") == std::string::npos);
        if (!better) continue;
        label.text = reading.meaning.text;
        label.box = reading.box + patch.tl();
        label.fault = reading.meaning.fault;
    }
    if (!label.box) label.fault = "no letters next to the bar";
    return label;
}

}  // namespace setae::imaging
