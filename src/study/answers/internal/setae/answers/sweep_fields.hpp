// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

#include "setae/answers/adhesive_sweep.hpp"
#include "setae/answers/contact_fields.hpp"

/// Output of `setae contact sweep`.
namespace setae::fields {

template <>
struct Described<answers::SweepMaps> {
    using T = answers::SweepMaps;
    static constexpr std::array<std::string_view, 4> names{"approach_zero_load", "turn", "separation_zero_load",
                                                           "greatest_tension"};
    static constexpr std::array rows{
        field<&T::name>("name", "name of the state").one_of(names),
        field<&T::step>("step", "number of the step, counted from 0"),
        inner<&T::pressures>(),
        inner<&T::gaps>(),
    };
    static constexpr Description description{"", "state that was saved point by point", rows};
};
static_assert(complete<answers::SweepMaps>);

template <>
struct Described<answers::ContactOutput<answers::SweepAnswer>> {
    using T = answers::ContactOutput<answers::SweepAnswer>;
    static constexpr auto steps_table = [](const T& of) -> const auto& { return of.answer->steps; };
    static constexpr auto problem = [](const T& of) {
        return answers::GridAndBody{&of.answer->grid, &of.answer->body};
    };
    static constexpr std::array number_rows{
        number("approach_work", "J/m2", "work of the attraction on approach"),
        number("separation_work", "J/m2", "work that is required for the separation"),
        number("loss", "J/m2", "energy enclosed by the loop"),
        number("approach_dissipation", "J/m2", "energy dissipated by all steps of the approach"),
        number("separation_dissipation", "J/m2", "energy dissipated by all steps of the separation"),
        number("smallest_dissipation", "J/m2",
               "smallest dissipation of a step; below 0 only by the error of the trapezoidal rule"),
        number("greatest_tension", "Pa", "greatest tension of the loop"),
        number("full_contact_energy", "J/m2", "elastic energy per nominal area in full contact"),
    };
    static constexpr Description numbers{"", "numbers of the loop", number_rows};
    static constexpr std::array step_rows{
        column("position", "m", "mean gap or position of the stage").with(Missing::never),
        column("mean_gap", "m", "mean gap over the cell").with(Missing::never),
        column("tension", "Pa", "mean tension over the cell").with(Missing::never),
        column("elastic_energy", "J/m2", "elastic energy per nominal area").with(Missing::never),
        column("adhesive_energy", "J/m2", "adhesive energy per nominal area").with(Missing::never),
        column("area_fraction", "1", "area fraction of the contact").with(Missing::never),
        column("dissipation", "J/m2", "dissipation of the step").with(Missing::never),
        column("total_dissipation", "J/m2", "dissipation up to the step").with(Missing::never),
        column("approaching", "1", "1 on approach, 0 on retraction").with(Missing::never),
        column("residual", "1", "largest deviation from equilibrium divided by the greatest tension")
            .with(Missing::never),
        column("iterations", "1", "number of iterations of the solver").with(Missing::never),
        column("transforms", "1", "number of pairs of Fourier transforms (forward and inverse)").with(Missing::never),
    };
    static constexpr Description step_columns{"", "columns of the steps", step_rows};
    static constexpr std::array steps_rows{
        columns_among<T>(step_columns, steps_table),
        units_of_columns<T>(steps_table),
    };
    static constexpr Description steps{"", "steps of the loop", steps_rows};
    static constexpr std::array rows{
        numbers_among<T>(numbers, [](const T& of) -> const auto& { return of.answer->quantities; }),
        made<T>("units", answers::units_meaning,
                [](const T& of) {
                    return answers::units_by_name(of.answer->quantities,
                                                  {&Described<answers::GridAndBody>::description,
                                                   &Described<answers::ResolvedAttraction>::description});
                }),
        made<T>("status", "whether the loop is complete",
                [](const T& of) { return answers::loop_status(of.answer->loop.complete); })
            .one_of(answers::loop_status_words),
        part<T>("steps", "one list per column, one value per step", steps),
        made<T>("maps", "states that were saved point by point, on request",
                [](const T& of) -> const auto& { return of.answer->maps; })
            .with(Missing::left_out),
        fields_of<T>(problem),
        fields_of<T>([](const T& of) {
            return answers::ResolvedAttraction{&of.answer->interaction, problem(of)};
        }),
        fields_of<T>([](const T& of) { return input_of(of); }),
    };
    static constexpr Description description{"", "approach and separation of a rough surface and an elastic body",
                                             rows};
};

}  // namespace setae::fields
