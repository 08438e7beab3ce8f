// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "setae/answers/contact_fields.hpp"
#include "setae/answers/contact_front.hpp"

/// Output of `setae contact front`.
namespace setae::fields {

template <>
struct Described<answers::FrontRun> {
    using T = answers::FrontRun;
    static constexpr std::array number_rows{
        number("work_of_adhesion_approach", "J/m2", "W_appr, by Eq. 1 from the approach"),
        number("work_of_adhesion_retraction", "J/m2",
               "W_ret, by Eq. S2 from the retraction, after the whole edge has started to move"),
        number("pinning_coefficient", "1", "pinning coefficient k, W_ret − W_appr = 2k U_el/A"),
        number("pull_off_force", "N", "magnitude of the smallest force"),
        number("energy_loss", "J", "energy enclosed by the loop"),
        number("approach_dissipation", "J", "energy dissipated by all steps of the approach"),
        number("retraction_dissipation", "J", "energy dissipated by all steps of the retraction"),
        number("jumps", "1", "number of steps that each dissipate at least 1/1000 of the loss of a smooth sphere"),
        number("stored_energy", "J/m2", "U_el/A of the waves that are taken into account"),
        number("energy_share", "1", "stored energy divided by gained energy, U_el/(A W)"),
        number("contact_radius", "m", "√(A/π) at the turning point of the loop"),
        number("front_length", "m", "length of the contact edge, 2π times the contact radius"),
        number("larkin_length", "m",
               "Larkin length: length along which the displacement of the edge equals the correlation length of the "
               "roughness"),
    };
    static constexpr Description numbers{"", "numbers of a loop", number_rows};
    static constexpr std::array rows{
        numbers_among<T>(numbers, [](const T& of) { return quantities_of(of); }),
    };
    static constexpr Description description{"", "loop of one surface", rows};
};

template <>
struct Described<answers::ContactOutput<answers::FrontAnswer>> {
    using T = answers::ContactOutput<answers::FrontAnswer>;
    static constexpr auto quantities = [](const T& of) -> const auto& { return of.answer->quantities; };
    static constexpr auto steps_table = [](const T& of) -> const auto& { return of.answer->steps; };
    static constexpr std::array smooth_sphere_rows{
        number("smooth_sphere_loss", "J", "energy loss of a smooth sphere under fixed grips"),
        number("smooth_sphere_pull_off_force", "N", "pull-off force of a smooth sphere, 3/2 πRW"),
    };
    static constexpr std::array number_rows = joined(Described<answers::FrontRun>::number_rows, smooth_sphere_rows);
    static constexpr Description numbers{"", "means over the surfaces, and numbers of a smooth sphere", number_rows};
    static constexpr std::array given_rows{
        made<T>("radius", "radius of the sphere", [](const T& of) { return of.answer->contact.radius; }).in_unit("m"),
        made<T>("contact_modulus", "contact modulus E*", [](const T& of) { return of.answer->contact.contact_modulus; })
            .in_unit("Pa"),
        made<T>("work_of_adhesion", "energy that is gained per unit area of full contact",
                [](const T& of) { return of.answer->contact.work_of_adhesion; })
            .in_unit("J/m2"),
        made<T>("shortest_wavelength", "shortest wavelength that is taken into account",
                [](const T& of) { return of.answer->shortest_wavelength; })
            .in_unit("m"),
    };
    static constexpr Description given{"", "sphere and shortest wave", given_rows};
    static constexpr std::array step_rows{
        column("position", "", "position of the stage, or force under a dead load").with(Missing::never),
        column("displacement", "m", "displacement of the sphere").with(Missing::never),
        column("force", "N", "force on the sphere").with(Missing::never),
        column("mean_radius", "m", "mean radius of the edge").with(Missing::never),
        column("area_radius", "m", "radius √(A/π) of a circle with the area of the contact").with(Missing::never),
        column("smallest_radius", "m", "smallest radius of the edge").with(Missing::never),
        column("largest_radius", "m", "largest radius of the edge").with(Missing::never),
        column("perimeter", "m", "perimeter of the contact").with(Missing::never),
        column("elastic_energy", "J", "elastic energy; zero for separated bodies").with(Missing::never),
        column("surface_energy", "J", "surface energy that is gained").with(Missing::never),
        column("dissipation", "J", "dissipation of the step").with(Missing::never),
        column("total_dissipation", "J", "dissipation up to the step").with(Missing::never),
        column("approaching", "1", "1 on approach, 0 on retraction").with(Missing::never),
        column("residual", "1", "largest deviation from equilibrium").with(Missing::never),
        column("iterations", "1", "number of iterations of the solver").with(Missing::never),
    };
    static constexpr Description step_columns{"", "columns of the steps", step_rows};
    static constexpr std::array steps_rows{
        columns_among<T>(step_columns, steps_table),
        units_of_columns<T>(steps_table),
    };
    static constexpr Description steps{"", "steps of the loop", steps_rows};
    static std::vector<std::pair<std::string, double>> standard_errors(const answers::FrontAnswer& answer) {
        std::vector<std::pair<std::string, double>> errors;
        if (answer.runs.size() == 1) return errors;
        for (const auto& q : answer.quantities)
            if (q.estimate.uncertain()) errors.emplace_back(q.quantity, q.estimate.standard_error);
        return errors;
    }
    static constexpr std::array rows{
        numbers_among<T>(numbers, quantities),
        made<T>("units", answers::units_meaning,
                [](const T& of) { return answers::units_by_name(of.answer->quantities, {&given}); }),
        made<T>("standard_errors", "standard errors of the means, where several surfaces were generated",
                [](const T& of) { return standard_errors(*of.answer); })
            .with(Missing::left_out),
        fields_of<T>(given, [](const T& of) -> const T& { return of; }),
        made<T>("status", "whether all loops are complete",
                [](const T& of) {
                    return answers::loop_status(
                        std::ranges::all_of(of.answer->runs, [](const auto& run) { return run.loop.complete; }));
                })
            .one_of(answers::loop_status_words),
        made<T>("runs", "one entry per surface", [](const T& of) -> const auto& { return of.answer->runs; }),
        part<T>("steps", "one list per column, one value per step, of the first surface", steps),
        fields_of<T>([](const T& of) { return input_of(of); }),
    };
    static constexpr Description description{"", "contact edge of a soft sphere on a rough surface as a crack front",
                                             rows};
};

}  // namespace setae::fields
