// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fmt/format.h>

#include "pipeline/value_text.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/core/units.hpp"
#include "setae/processing/region.hpp"

namespace setae::processing {
namespace {

constexpr const char* expected_shapes =
    "expected rectangle FROM to TO[, FROM to TO], ellipse X, Y, A, B[, ANGLE], polygon X, Y, X, Y, "
    "X, Y, …, heights FROM to TO or percentiles FROM to TO (also above FROM, below TO), each "
    "followed by grow N if needed";

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (std::size_t begin = 0;;) {
        const auto end = text.find(separator, begin);
        parts.push_back(trimmed(text.substr(begin, end == std::string_view::npos ? end : end - begin)));
        if (end == std::string_view::npos) return parts;
        begin = end + 1;
    }
}

/// The first word, which is removed from `text`.
std::string_view take_word(std::string_view& text) {
    text = trimmed(text);
    const auto end = std::min(text.find_first_of(" \t\r\n"), text.size());
    const auto word = text.substr(0, end);
    text = trimmed(text.substr(end));
    return word;
}

double length(std::string_view text) { return parse_quantity(text, dimension::length); }

/// "FROM to TO", "above FROM", "below TO"; `value` reads an end.
template <class Value>
Range range_from(std::string_view text, Value value) {
    Range range;
    if (text == "all") return range;
    auto rest = text;
    const auto word = take_word(rest);
    if (word == "above") range.from = value(rest);
    else if (word == "below") range.to = value(rest);
    else {
        const auto middle = text.find(" to ");
        if (middle == std::string_view::npos)
            throw InvalidArgument(
                fmt::format("'{}' is not a range; expected FROM to TO, above FROM or below TO", text));
        range.from = value(trimmed(text.substr(0, middle)));
        range.to = value(trimmed(text.substr(middle + 4)));
    }
    return range;
}

Rectangle rectangle_from(std::string_view text) {
    const auto ranges = split(text, ',');
    if (ranges.size() > 2)
        throw InvalidArgument(
            fmt::format("a rectangle needs a range of x and may have one of y, got {} ranges", ranges.size()));
    return {range_from(ranges[0], length), ranges.size() > 1 ? range_from(ranges[1], length) : Range{}};
}

Ellipse ellipse_from(std::string_view text) {
    const auto numbers = split(text, ',');
    if (numbers.size() != 4 && numbers.size() != 5)
        throw InvalidArgument(
            fmt::format("an ellipse needs the centre x, y and two semi-axes, and may have an angle, got {} values",
                        numbers.size()));
    return {{length(numbers[0]), length(numbers[1])},
            {length(numbers[2]), length(numbers[3])},
            numbers.size() > 4 ? parsed_angle(numbers[4]) : 0.0};
}

Polygon polygon_from(std::string_view text) {
    const auto numbers = split(text, ',');
    if (numbers.size() < 6 || numbers.size() % 2 != 0)
        throw InvalidArgument(
            fmt::format("a polygon needs x, y of at least three corners, got {} values", numbers.size()));
    Polygon polygon;
    for (std::size_t k = 0; k < numbers.size(); k += 2)
        polygon.corners.push_back({length(numbers[k]), length(numbers[k + 1])});
    return polygon;
}

Shape shape_from(std::string_view text) {
    Shape shape;
    if (const auto grow = text.rfind(" grow "); grow != std::string_view::npos) {
        shape.grow = static_cast<Index>(parsed_count(text.substr(grow + 6)));
        text = text.substr(0, grow);
    }
    const auto kind = take_word(text);
    if (kind == "rectangle") shape.outline = rectangle_from(text);
    else if (kind == "ellipse") shape.outline = ellipse_from(text);
    else if (kind == "polygon") shape.outline = polygon_from(text);
    else if (kind == "heights") shape.outline = HeightRange{range_from(text, length)};
    else if (kind == "percentiles") shape.outline = PercentileRange{range_from(text, parsed_number)};
    else throw InvalidArgument(fmt::format("'{}' is not a shape; {}", kind, expected_shapes));
    return shape;
}

template <class Value>
std::string range_text(const Range& range, Value value) {
    if (range.from && range.to) return fmt::format("{} to {}", value(*range.from), value(*range.to));
    if (range.from) return "above " + value(*range.from);
    return range.to ? "below " + value(*range.to) : "all";
}

struct OutlineText {
    std::string operator()(const Rectangle& rectangle) const {
        const auto x = range_text(rectangle.x, length_text);
        return rectangle.y == Range{} ? "rectangle " + x
                                      : fmt::format("rectangle {}, {}", x, range_text(rectangle.y, length_text));
    }
    std::string operator()(const Ellipse& ellipse) const {
        auto text =
            fmt::format("ellipse {}, {}, {}, {}", length_text(ellipse.centre[0]), length_text(ellipse.centre[1]),
                        length_text(ellipse.semi_axes[0]), length_text(ellipse.semi_axes[1]));
        return ellipse.angle == 0.0 ? text : text + ", " + angle_text(ellipse.angle);
    }
    std::string operator()(const Polygon& polygon) const {
        std::string text = "polygon ";
        for (const auto& corner : polygon.corners)
            text +=
                fmt::format("{}{}, {}", text.back() == ' ' ? "" : ", ", length_text(corner[0]), length_text(corner[1]));
        return text;
    }
    std::string operator()(const HeightRange& range) const {
        return "heights " + range_text(range.heights, length_text);
    }
    std::string operator()(const PercentileRange& range) const {
        return "percentiles " +
               range_text(range.percentiles, [](double percentile) { return fmt::format("{}", percentile); });
    }
};

void append(std::string& text, const char* word, const std::vector<Shape>& shapes) {
    for (const auto& shape : shapes) {
        text += fmt::format("{}{} {}", text.empty() ? "" : "; ", word, std::visit(OutlineText{}, shape.outline));
        if (shape.grow != 0) text += fmt::format(" grow {}", shape.grow);
    }
}

}  // namespace

Region region_from_text(std::string_view text) {
    Region region;
    for (const auto part : split(text, ';')) {
        if (part.empty()) continue;
        auto rest = part;
        const auto word = take_word(rest);
        if (word != "include" && word != "exclude")
            throw InvalidArgument(fmt::format(
                "region '{}': '{}' begins no shape; expected include or exclude before each shape", part, word));
        try {
            (word == "include" ? region.include : region.exclude).push_back(shape_from(rest));
        } catch (const InvalidArgument& error) {
            throw InvalidArgument(fmt::format("region '{}': {}", part, error.what()));
        }
    }
    return region;
}

std::string text(const Region& region) {
    std::string all;
    append(all, "include", region.include);
    append(all, "exclude", region.exclude);
    return all;
}

}  // namespace setae::processing
