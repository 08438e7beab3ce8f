// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Outputs of `setae contact solve`, without and with attraction.

#include <array>
#include <string_view>

#include "setae/answers/adhesive_contact.hpp"
#include "setae/answers/contact_fields.hpp"
#include "setae/answers/hard_wall.hpp"
#include "setae/half_space/contact_quantities.hpp"

namespace setae::answers {

/// Words of half_space::name_of().
inline constexpr std::array<std::string_view, 2> solve_status_words{"converged", "not_converged"};
inline constexpr std::array<std::string_view, 3> mean_displacement_words{"finite", "undefined", "blocked"};

}  // namespace setae::answers

namespace setae::fields {

/// Numbers of a contact without and with attraction.
inline constexpr std::array rows_of_contact{
    number("area_fraction", "1", "area fraction of the contact"),
    number("area_fraction_corrected", "1", "area fraction, corrected for pixels at the edges of the contact"),
    number("perimeter", "m", "perimeter of the contact"),
    number("patches", "1", "number of patches of the contact"),
    number("largest_patch", "m2", "area of the largest patch"),
    number("mean_pressure", "Pa", "mean pressure over the cell"),
    number("mean_gap", "m", "mean gap over the cell"),
    number("displacement", "m", "displacement from first contact"),
    number("stored_energy_per_area", "J/m2", "elastic energy per nominal area"),
};

template <>
struct Described<answers::ContactOutput<answers::HardWallAnswer>> {
    using T = answers::ContactOutput<answers::HardWallAnswer>;
    static constexpr std::array further_rows{
        number("largest_pressure", "Pa", "largest pressure of all points"),
        number("contact_stiffness", "Pa/m", "contact stiffness dp/du"),
        number("stored_energy", "J", "elastic energy of the cell"),
        number("flowing_fraction", "1", "area at the hardness divided by the nominal area, with a hardness")
            .with(Missing::left_out),
        number("deepest_dent", "m", "largest plastic displacement, with a hardness").with(Missing::left_out),
    };
    static constexpr std::array number_rows = joined(rows_of_contact, further_rows);
    static constexpr Description numbers{"", "numbers of the contact", number_rows};
    static constexpr std::array accuracy_rows{
        made<T>("status", "whether the solver converged",
                [](const T& of) { return half_space::name_of(of.answer->contact.status); })
            .one_of(answers::solve_status_words),
        made<T>("duality_gap", "upper bound of the energy above its minimum, divided by twice the stored energy",
                [](const T& of) { return of.answer->contact.certificate.duality_gap; }),
        made<T>("penetration", "largest penetration",
                [](const T& of) { return of.answer->contact.certificate.penetration; })
            .in_unit("m"),
        made<T>("level_error", "error of the far level divided by the mean displacement of the load",
                [](const T& of) { return of.answer->contact.certificate.level_error; }),
        made<T>("load_error", "relative error of the load; 0 where the load is not prescribed",
                [](const T& of) { return of.answer->contact.certificate.load_error; }),
        made<T>("iterations", "number of iterations of the solver",
                [](const T& of) { return of.answer->contact.iterations; }),
        made<T>("transform_pairs", "number of pairs of Fourier transforms (forward and inverse)",
                [](const T& of) { return of.answer->contact.transform_pairs; }),
        made<T>(
            "mean_displacement",
            "response of the mean displacement to a mean pressure: finite, undefined for an infinite body, or blocked by an incompressible layer",
            [](const T& of) { return half_space::name_of(of.answer->contact.mean_displacement); })
            .one_of(answers::mean_displacement_words),
    };
    static constexpr Description accuracy{"", "accuracy of the solution", accuracy_rows};
    static constexpr std::array rows{
        numbers_among<T>(numbers, [](const T& of) -> const auto& { return of.answer->quantities; }),
        made<T>("units", answers::units_meaning,
                [](const T& of) {
                    return answers::units_by_name(of.answer->quantities,
                                                  {&accuracy, &Described<answers::GridAndBody>::description});
                }),
        fields_of<T>(accuracy, [](const T& of) -> const T& { return of; }),
        fields_of<T>([](const T& of) {
            return answers::GridAndBody{&of.answer->problem.grid, &of.answer->problem.body};
        }),
        fields_of<T>([](const T& of) { return input_of(of); }),
    };
    static constexpr Description description{"", "contact of a rough surface with an elastic body", rows};
};

template <>
struct Described<answers::ContactOutput<answers::AdhesiveContactAnswer>> {
    using T = answers::ContactOutput<answers::AdhesiveContactAnswer>;
    static constexpr auto problem = [](const T& of) {
        return answers::GridAndBody{&of.answer->grid, &of.answer->body};
    };
    static constexpr std::array further_rows{
        number("adhesive_energy_per_area", "J/m2", "energy of the attraction per nominal area, below 0"),
        number("full_contact_energy", "J/m2", "elastic energy per nominal area in full contact"),
    };
    static constexpr std::array number_rows = joined(rows_of_contact, further_rows);
    static constexpr Description numbers{"", "numbers of the contact", number_rows};
    static constexpr std::array rows{
        numbers_among<T>(numbers, [](const T& of) -> const auto& { return of.answer->quantities; }),
        made<T>("units", answers::units_meaning,
                [](const T& of) {
                    return answers::units_by_name(of.answer->quantities,
                                                  {&Described<answers::GridAndBody>::description,
                                                   &Described<answers::ResolvedAttraction>::description});
                }),
        made<T>("status", "whether the solver converged",
                [](const T& of) {
                    using half_space::SolveStatus;
                    return half_space::name_of(of.answer->state.converged ? SolveStatus::converged
                                                                          : SolveStatus::not_converged);
                })
            .one_of(answers::solve_status_words),
        made<T>("residual", "largest deviation from equilibrium divided by the greatest tension",
                [](const T& of) { return of.answer->state.residual; }),
        made<T>("iterations", "number of iterations of the solver",
                [](const T& of) { return of.answer->state.iterations; }),
        made<T>("transform_pairs", "number of pairs of Fourier transforms (forward and inverse)",
                [](const T& of) { return of.answer->state.transforms; }),
        fields_of<T>(problem),
        fields_of<T>([](const T& of) {
            return answers::ResolvedAttraction{&of.answer->interaction, problem(of)};
        }),
        fields_of<T>([](const T& of) { return input_of(of); }),
    };
    static constexpr Description description{
        "", "contact of a rough surface with an elastic body that it attracts, in equilibrium", rows};
};

}  // namespace setae::fields
