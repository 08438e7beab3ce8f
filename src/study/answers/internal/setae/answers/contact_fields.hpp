// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Fields that the outputs of several contact commands share.

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "setae/answers/contact_problem.hpp"
#include "setae/fields/describe.hpp"
#include "setae/output/step_fields.hpp"

namespace setae::answers {

/// Output of a contact command: the answer, and the processing of the heights.
template <class Answer>
struct ContactOutput {
    const Answer* answer;
    const std::vector<processing::StepRecord>* processing;
};

/// The file of a contact, the processing of its heights, and warnings.
struct ContactInput {
    const std::string* file;
    const std::vector<processing::StepRecord>* processing;
    const std::vector<Alert>* alerts;
};
template <class Answer>
[[nodiscard]] ContactInput input_of(const ContactOutput<Answer>& output) {
    return {&output.answer->file, output.processing, &output.answer->alerts};
}

/// The grid and the body of a contact.
struct GridAndBody {
    const half_space::Grid* grid;
    const half_space::Body* body;
};

/// The attraction of the surfaces, and its resolution by the grid.
struct ResolvedAttraction {
    const half_space::Interaction* interaction;
    GridAndBody problem;
};

/// Words for whether a loop is complete.
inline constexpr std::array<std::string_view, 2> loop_status_words{"complete", "not_converged"};
[[nodiscard]] constexpr std::string_view loop_status(bool complete) { return loop_status_words[complete ? 0 : 1]; }

/// Meanings that several outputs share.
inline constexpr std::string_view units_meaning = "unit of each number";

}  // namespace setae::answers

namespace setae::fields {

template <>
struct Described<answers::ContactInput> {
    using T = answers::ContactInput;
    static constexpr std::array rows{
        made<T>("file", "name of the file as it was given", [](const T& of) -> const auto& { return *of.file; }),
        made<T>("processing", "processing steps that were applied to the heights",
                [](const T& of) -> const auto& { return *of.processing; }),
        made<T>("alerts", "warnings", [](const T& of) -> const auto& { return *of.alerts; }),
        inner<&T::file>(),
        inner<&T::processing>(),
        inner<&T::alerts>(),
    };
    static constexpr Description description{"", "input of a contact", rows};
};
static_assert(complete<answers::ContactInput>);

template <>
struct Described<answers::GridAndBody> {
    using T = answers::GridAndBody;
    static constexpr std::array rows{
        made<T>("points", "number of points along x and y",
                [](const T& of) {
                    return std::array{of.grid->nx, of.grid->ny};
                }),
        made<T>("size", "size along x and y",
                [](const T& of) {
                    return std::array{of.grid->size_x, of.grid->size_y};
                })
            .in_unit("m"),
        made<T>("contact_modulus", "contact modulus E*", [](const T& of) { return of.body->contact_modulus; })
            .in_unit("Pa"),
        inner<&T::grid>(),
        inner<&T::body>(),
    };
    static constexpr Description description{"", "grid and body of a contact", rows};
};
static_assert(complete<answers::GridAndBody>);

template <>
struct Described<answers::ResolvedAttraction> {
    using T = answers::ResolvedAttraction;
    static constexpr std::array rows{
        made<T>("work_of_adhesion", "work of adhesion w of the attraction",
                [](const T& of) { return of.interaction->work_of_adhesion; })
            .in_unit("J/m2"),
        made<T>("interaction_range", "range ρ of the attraction; the greatest tension is w/ρ",
                [](const T& of) { return of.interaction->range; })
            .in_unit("m"),
        made<T>("law", "dependence of the attraction on the gap",
                [](const T& of) { return half_space::name_of(of.interaction->law); })
            .one_of(Asked<answers::InteractionRequest>::laws),
        made<T>("grid_ratio", "resolution of the grid, w dx/(E* ρ²); up to 0.5, works are accurate to 1 %",
                [](const T& of) {
                    return half_space::resolution_of(*of.interaction, *of.problem.body, *of.problem.grid).squared_ratio;
                })
            .in_unit("1"),
        inner<&T::interaction>(),
        inner<&T::problem>(),
    };
    static constexpr Description description{"", "attraction of the surfaces", rows};
};
static_assert(complete<answers::ResolvedAttraction>);

}  // namespace setae::fields
