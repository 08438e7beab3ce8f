// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Figures of a study, as the JSON of `setae plot` has them.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "setae/fields/describe.hpp"
#include "setae/study_figures/study_figures.hpp"

namespace setae::study_figures {

/// A figure and the file that it was written to.
struct PlottedFigure {
    const StudyFigure* figure;
    std::string file;
};

/// All figures of a study.
struct FigureList {
    const std::vector<StudyFigure>* figures;
};

/// Length [m] of a side of a figure that can be drawn.
[[nodiscard]] inline std::optional<double> drawn_length(const StudyFigure& figure, double millimetres) {
    return figure.drawable() ? std::optional(1e-3 * millimetres) : std::nullopt;
}

}  // namespace setae::study_figures

namespace setae::fields {

template <>
struct Described<study_figures::StudyFigure> {
    using T = study_figures::StudyFigure;
    static constexpr std::array rows{
        field<&T::identifier>("identifier", "identifier of the figure"),
        field<&T::name>("name", "stem of the files of the figure"),
        field<&T::title>("title", "title of the figure"),
        made<T>("drawable", "whether the study contains the data of the figure",
                [](const T& of) { return of.drawable(); }),
        made<T>("caption", "caption of the figure",
                [](const T& of) { return of.drawable() ? std::optional(of.caption) : std::nullopt; }),
        made_value<T>("width", "m", "width of the figure",
                      [](const T& of) { return study_figures::drawn_length(of, of.figure.width_mm); }),
        made_value<T>("height", "m", "height of the figure",
                      [](const T& of) { return study_figures::drawn_length(of, of.figure.height_mm); }),
        field<&T::reason>("reason", "reason for which the figure cannot be drawn").with(Missing::left_out),
        inner<&T::caption>(),
        inner<&T::figure>(),
        inner<&T::command>(),
    };
    static constexpr Description description{"", "a figure of a study", rows};
};
static_assert(complete<study_figures::StudyFigure>);

template <>
struct Described<study_figures::PlottedFigure> {
    using T = study_figures::PlottedFigure;
    static constexpr std::array rows{
        fields_of<T>([](const T& of) -> const study_figures::StudyFigure& { return *of.figure; }),
        field<&T::file>("file", "path of the file that was written"),
        inner<&T::figure>(),
    };
    static constexpr Description description{"", "a figure that was written", rows};
};
static_assert(complete<study_figures::PlottedFigure>);

template <>
struct Described<study_figures::FigureList> {
    using T = study_figures::FigureList;
    static constexpr std::array rows{
        made<T>("figures", "figures of the study", [](const T& of) -> const auto& { return *of.figures; }),
    };
    static constexpr Description description{"", "with `--list` the figures of the study", rows};
};

}  // namespace setae::fields
