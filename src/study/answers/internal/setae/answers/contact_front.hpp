// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "setae/answers/contact_problem.hpp"
#include "setae/contact_line/contact_line.hpp"
#include "setae/crack_front/front_loop.hpp"
#include "setae/crack_front/pinning.hpp"
#include "setae/fields/option.hpp"
#include "setae/parallel/for_each.hpp"

namespace setae::answers {

/// Request of `setae contact front` without the surface; see docs/concepts/crack-front.md.
struct FrontRequest {
    std::string radius, contact_modulus, work_of_adhesion;
    std::string to_force, to_displacement;  ///< one of them
    std::string stage_stiffness;            ///< empty: the displacement is prescribed
    bool dead_load = false;                 ///< the force is prescribed
    std::string shortest_wavelength;        ///< empty: four pixels
    std::string model = "constant_toughness";
    std::string method = "trust_region";
    int steps = 500;
    std::string duration;  ///< empty: no edge is kept

    /// @throws InvalidArgument for missing, malformed or contradictory values, before heights are read.
    void require_complete() const;
    [[nodiscard]] contact::AdhesiveContact contact() const;
    [[nodiscard]] crack_front::FrontOptions options() const;
};

/// The loop of one surface.
struct FrontRun {
    crack_front::FrontLoop loop;
    crack_front::FrontValidity validity;
    double stored_energy = 0.0;   ///< U_el/A of the waves that count [J/m²]
    double contact_radius = 0.0;  ///< √(A/π) where it turns [m]
    std::optional<crack_front::BranchWorks> works;
    std::string reason;              ///< why there are none
    contact_line::ContactLine edge;  ///< where it is kept, while there is contact: at up to 512 angles …
    Array1D displacement, force;     ///< … and with these at each time [m], [N]

    /// k of W_ret − W_appr = 2k U_el/A; NaN without works.
    [[nodiscard]] double pinning_coefficient() const;
};

/// Loops of equivalent surfaces.
struct FrontAnswer {
    std::string file;
    contact::AdhesiveContact contact;
    double shortest_wavelength = 0.0;  ///< [m]
    std::vector<FrontRun> runs;
    Table steps;  ///< crack_front::loop_table() of the first
    Table edge;   ///< edge of the first surface, on request: contact_line::as_table() with "displacement" and "force"
    /// means over the surfaces, with the standard error of the mean where there are several
    std::vector<Quantity> quantities;
    std::vector<Alert> alerts;
};

/// Share of the way of all loops that is done; false ends them.
using FrontProgress = std::function<bool(double share)>;

/// surfaces: maps, periodic or not, of equal size; the sphere's axis is over their centres. Several run on a thread
/// each; equal bytes for any number of them.
/// @throws InvalidArgument for other data than maps, undefined heights, a contact larger than a map that is not
/// periodic and fields that exceed the memory, with a remedy.
[[nodiscard]] FrontAnswer contact_front(const std::string& file, const std::vector<topography::Measurement>& surfaces,
                                        const FrontRequest& request, parallel::Threads threads = {},
                                        const FrontProgress& progress = {});

/// Result of the loops in one sentence.
[[nodiscard]] std::string front_sentence(const FrontAnswer& answer);

/// Numbers of one loop.
[[nodiscard]] std::vector<Quantity> quantities_of(const FrontRun& run);

}  // namespace setae::answers

template <>
struct setae::fields::Asked<setae::answers::FrontRequest> {
    using R = answers::FrontRequest;
    static constexpr std::array<std::string_view, 5> models{"constant_toughness", "variational", "energy_release_rate",
                                                            "stress_intensity", "mean_circle"};
    static constexpr std::array<std::string_view, 2> methods{"trust_region", "rosso_krauth"};
    static constexpr std::array options{
        option<&R::radius>("radius", "radius of the sphere")
            .of(positive(dimension::length))
            .such_as("1.25 mm")
            .required(),
        option<&R::contact_modulus>("contact_modulus", "contact modulus E* of sphere and surface together")
            .of(positive(dimension::pressure))
            .such_as("1 MPa")
            .required(),
        option<&R::work_of_adhesion>("work_of_adhesion", "energy gained per unit area of full contact")
            .of(positive(dimension::surface_energy))
            .such_as("50 mJ/m2")
            .short_name("w")
            .in_python("W_int")
            .required(),
        option<&R::to_force>("to_force", "force of a smooth sphere where the loop turns")
            .of(positive(dimension::force))
            .such_as("0.1 mN"),
        option<&R::to_displacement>("to_displacement", "displacement of a smooth sphere where the loop turns")
            .of(positive(dimension::length))
            .such_as("1 um"),
        option<&R::stage_stiffness>("stage_stiffness", "stiffness of the stage that is moved")
            .of(positive(dimension::stiffness))
            .such_as("100 N/m")
            .or_else("the displacement of the sphere is prescribed"),
        option<&R::dead_load>("dead_load", "the force is prescribed; the loop ends at pull-off"),
        option<&R::shortest_wavelength>("shortest_wavelength", "shortest wavelength that counts")
            .of(positive(dimension::length))
            .such_as("1 um")
            .or_else("four pixels")
            .advanced(),
        option<&R::steps>("steps", "steps on approach; halved where the edge jumps")
            .within(domain::positive)
            .default_shown()
            .advanced(),
        option<&R::duration>("duration", "duration of the approach: times of the edge that is saved")
            .of(positive(dimension::time))
            .such_as("100 s"),
        option<&R::model>("model", "dependence of the energy on the position of the edge")
            .one_of(models)
            .default_shown()
            .advanced(),
        option<&R::method>("method", "solver for the equilibria").one_of(methods).default_shown().advanced(),
    };
};
