// SPDX-License-Identifier: GPL-3.0-or-later
#include "scale_bar_label.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include "label_meaning.hpp"
#include "letter_lines.hpp"

namespace setae::imaging {
namespace {

constexpr std::array<int, 2> magnified{24, 36};  // px of a line's height: what Tesseract reads well
constexpr std::size_t most_lines = 2;            // looked at in each mask

struct Ink {
    double level = 0, tolerance = 0;
};

/// A reading of a line that looks like the label of a bar, or nearly.
struct Reading {
    LabelMeaning meaning;
    cv::Rect box;
    double distance = 0;
};

double distance_between(const cv::Rect& first, const cv::Rect& second) {
    const double dx = std::max({first.x - second.br().x, second.x - first.br().x, 0}), dy = std::max({first.y - second.br().y, second.y - first.br().y, 0});
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

/// Unit that the shapes of the last two letters spell, where the reader took them for that or for what looks like it: Tesseract
/// has no µ and confuses m with n.
std::string with_unit_by_shape(const std::string& text, const LetterLine& line, char shape) {
    if (shape == 0 || text.size() < 3) return text;
    const std::string_view last = "mn";
    const bool micro = text.size() > 3 && text.compare(text.size() - 3, 2, "\u00b5") == 0;
    const char prefix = micro ? 'u' : text[text.size() - 2];
    const auto& letter = line.letters[line.letters.size() - 2];
    const bool descends = letter.br().y > line.letters.back().br().y + line.letters.back().height / 10;
    const std::string_view looks_like = shape == 'n' ? "nm" : shape == 'm' ? "mn" : shape == 'p' ? "p" : descends ? "up" : "u";
    if (last.find(text.back()) == std::string_view::npos || looks_like.find(prefix) == std::string_view::npos) return text;
    return text.substr(0, text.size() - (micro ? 3 : 2)) + shape + 'm';
}

/// What the reader says, where the letters have the shapes for it.
LabelMeaning checked(const LetterLine& line, const std::string& reading) {
    const char shape = prefix_by_shape(line);
    const auto text = with_unit_by_shape(reading, line, shape);
    auto meaning = meaning_of_label(text);
    const auto unsure = [&](const std::string& why) {
        meaning.length.reset();
        meaning.fault = fmt::format("label read as '{}', but {}", meaning.text, why);
    };
    if (!meaning.length) return meaning;
    const auto points = std::count_if(text.begin(), text.end(), [](char letter) { return letter == '.' || letter == ','; });
    if (meaning.unit == "A" ? !last_letter_closed(line) : shape != meaning.unit.front()) unsure("the letters of the unit do not have that shape");
    else if (points != static_cast<long>(line.points.size())) unsure("its points are not those of the picture");
    else if (points > 0 && line.specks > 0) unsure("the point may be a speck");
    return meaning;
}

cv::Mat1b mask_of(const cv::Mat1f& patch, const Ink& ink) {
    cv::Mat1b mask(patch.size());
    for (int y = 0; y < patch.rows; ++y)
        for (int x = 0; x < patch.cols; ++x) mask(y, x) = std::abs(static_cast<double>(patch(y, x)) - ink.level) <= ink.tolerance ? 255 : 0;
    return mask;
}

/// What the readings of the nearest line that holds a length agree on; nothing where none holds one.
std::optional<BarLabel> agreed(const std::vector<Reading>& readings) {
    const Reading* best = nullptr;
    for (const auto& reading : readings)
        if (reading.meaning.length && (!best || reading.distance < best->distance)) best = &reading;
    if (!best) return std::nullopt;
    int agreeing = 0, other = 0;
    for (const auto& reading : readings)
        if (reading.meaning.length && (reading.box & best->box).area() > 0) ++(*reading.meaning.length == *best->meaning.length ? agreeing : other);
    BarLabel label{.text = best->meaning.text, .box = best->box};
    if (other > 0) label.fault = fmt::format("label read as '{}' and as something else", label.text);
    else if (agreeing < 2) label.fault = fmt::format("label read as '{}' once alone", label.text);
    else label.length = best->meaning.length;
    return label;
}

}  // namespace

BarLabel read_label(const cv::Mat1f& levels, const DrawnBar& bar, TextReader& reader) {
    const int pad_x = std::max(100, levels.cols / 5), pad_y = std::max(40, levels.rows / 14);
    const cv::Rect patch = cv::Rect(bar.box.x - pad_x, bar.box.y - pad_y, bar.box.width + 2 * pad_x, bar.box.height + 2 * pad_y) & cv::Rect(0, 0, levels.cols, levels.rows);
    std::vector<cv::Rect> own{bar.box - patch.tl()};
    cv::Rect near = own.front();
    if (bar.gap) {
        near = *bar.gap - patch.tl();
        own = {{own[0].x, own[0].y, near.x - own[0].x, own[0].height}, {near.br().x, own[0].y, own[0].br().x - near.br().x, own[0].height}};
    }
    // letters in the level of the bar: exactly, and with edges that are blurred; in that of the outline
    std::vector<Ink> inks{{bar.level, 0.12 * bar.contrast}, {bar.level, 0.5 * bar.contrast}, {bar.level, 0.3 * bar.contrast}};
    if (bar.outline_level) inks.push_back({*bar.outline_level, 0.12 * bar.contrast});

    std::vector<Reading> readings;
    std::vector<LetterLine> seen;
    BarLabel label;
    for (const auto& ink : inks) {
        if (const auto vote = agreed(readings); vote && vote->length) break;
        auto lines = letter_lines(mask_of(levels(patch), ink), own);
        std::erase_if(lines, [&](const LetterLine& line) { return line.letters.size() > 24 || distance_between(line.box, near) > 3.0 * line.box.height + 0.5 * bar.box.width; });
        std::stable_sort(lines.begin(), lines.end(), [&](const LetterLine& a, const LetterLine& b) { return distance_between(a.box, near) < distance_between(b.box, near); });
        if (lines.size() > most_lines) lines.resize(most_lines);
        for (const auto& line : lines) {
            const auto same = [&](const LetterLine& other) { return other.box == line.box && cv::countNonZero(other.ink != line.ink) == 0; };
            if (std::any_of(seen.begin(), seen.end(), same)) continue;
            seen.push_back(line);
            for (const int height : magnified)
                if (const auto read = reader.read(enlarged(line, height))) readings.push_back({checked(line, *read), line.box, distance_between(line.box, near)});
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
        const bool better = !label.box || (label.fault.find("no number") != std::string::npos && reading.meaning.fault.find("no number") == std::string::npos);
        if (!better) continue;
        label.text = reading.meaning.text;
        label.box = reading.box + patch.tl();
        label.fault = reading.meaning.fault;
    }
    if (!label.box) label.fault = "no letters beside the bar";
    return label;
}

}  // namespace setae::imaging
