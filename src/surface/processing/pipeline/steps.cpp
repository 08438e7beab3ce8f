// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/processing/steps.hpp"

#include <array>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "text_visitor.hpp"

namespace setae::processing {
namespace {

/// Description of each step of `Step`, in order.
constexpr std::array sentences{
    "The mean height is subtracted.",
    "The plane that fits best is subtracted, for lines the straight line.",
    "The polynomial that fits best is subtracted.",
    "The plane that makes most facets level is subtracted, so that terraces become horizontal.",
    "From each scan line the polynomial that fits it best is subtracted.",
    "Scan lines that jumped against each other are set to one level; structure along the slow axis "
    "is removed with the jumps.",
    "Points that deviate from their surroundings are removed.",
    "Strokes along x, a few scan lines wide, are removed.",
    "The points of a region become undefined.",
    "Heights equal to a value that marks missing ones, or beyond limits, become undefined.",
    "Undefined heights are filled by the harmonic surface through their surroundings.",
    "Gaussian filter of ISO 16610-21 and -61: waves longer or shorter than the cutoff stay.",
    "Robust Gaussian regression filter of ISO 16610-31 and -71: peaks and grooves do not attract "
    "it.",
    "Spline filter of ISO 16610-22; the robust one is that of ISO 16610-32.",
    "Wavelengths outside a band are cut off sharply; only for periodic data.",
    "A window of the measurement is cut out.",
    "Heights are interpolated to other points of the same area.",
    "A map is turned about its centre by any angle.",
    "x and y of a map are exchanged.",
    "The order of points is reversed along a direction.",
    "A map is turned by multiples of 90° from x towards y.",
    "The heights of another file are added, on request after a shift onto these.",
    "The heights of another file are subtracted: a reference or a repeated scan.",
};
static_assert(sentences.size() == std::variant_size_v<Step>, "a sentence for each step");

/// body(step, sentence) for every step with its defaults.
template <class Body, std::size_t... numbers>
void for_each_step(const Body& body, std::index_sequence<numbers...>) {
    (body(std::variant_alternative_t<numbers, Step>{}, sentences[numbers]), ...);
}
template <class Body>
void for_each_step(const Body& body) {
    for_each_step(body, std::make_index_sequence<std::variant_size_v<Step>>{});
}

/// A step with another file.
template <class S>
concept NamesFile = requires(const S& step) { step.file; };

}  // namespace

Processed apply(const Step& step, topography::Measurement measurement, const LoadMeasurement& load,
                parallel::Threads threads) {
    return std::visit(
        [&]<class S>(const S& known) -> Processed {
            if constexpr (NamesFile<S>) {
                if (!load)
                    throw InvalidArgument(fmt::format(
                        "{}: the step needs the file '{}', and the caller gave no function that reads files",
                        step_name(known), known.file));
                const auto other = load(known.file, known.channel);
                return apply(known, std::move(measurement), other, threads);
            } else {
                return apply(known, std::move(measurement), threads);
            }
        },
        step);
}

std::string name(const Step& step) {
    return std::visit([](const auto& known) { return std::string(step_name(known)); }, step);
}

namespace {

/// The step that removes a trend, by the name of the trend; other names are unchanged.
std::string_view step_of_trend(std::string_view name) {
    if (name == "mean") return step_name(LevelMean{});
    if (name == "tilt") return step_name(LevelPlane{});
    return name == "parabola" ? step_name(LevelPolynomial{}) : name;
}

}  // namespace

Step step_named(std::string_view name) {
    std::vector<std::string> names;
    std::optional<Step> found;
    for_each_step([&](const auto& step, const char*) {
        names.emplace_back(step_name(step));
        if (names.back() == step_of_trend(name)) found = step;
    });
    if (found) return *found;
    const auto nearest = nearest_match(name, names);
    throw InvalidArgument(fmt::format("unknown step '{}'{}; setae level --explain lists them", name,
                                      nearest.empty() ? "" : "; did you mean '" + nearest + "'?"));
}

std::vector<StepDescription> step_descriptions() {
    std::vector<StepDescription> descriptions;
    for_each_step([&](auto step, const char* sentence) {
        StepDescription description{std::string(step_name(step)), sentence, {}};
        TextVisitor visitor{[&](std::string_view parameter, std::string_view values, const std::string& value,
                                std::string_view meaning, const auto&) {
            description.parameters.push_back(
                {std::string(parameter), std::string(values), value, std::string(meaning)});
        }};
        visit_parameters(step, visitor);
        descriptions.push_back(std::move(description));
    });
    return descriptions;
}

}  // namespace setae::processing
