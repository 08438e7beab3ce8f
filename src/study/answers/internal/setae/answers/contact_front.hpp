// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "setae/answers/contact_problem.hpp"
#include "setae/contact_line/contact_line.hpp"
#include "setae/crack_front/front_loop.hpp"
#include "setae/crack_front/pinning.hpp"
#include "setae/parallel/for_each.hpp"

namespace setae::answers {

/// What `setae contact front` is told beside the surface; see docs/concepts/crack-front.md.
struct FrontRequest {
    std::string radius, contact_modulus, work_of_adhesion;  ///< "1 mm", "1 MPa", "50 mJ/m2"
    std::string to_force, to_displacement;                  ///< where the loop turns: one of them
    std::string stage_stiffness;                            ///< "100 N/m" of a stage that is moved; empty: δ is held
    bool dead_load = false;                                 ///< the force is moved
    std::string shortest_wavelength;                        ///< that counts; empty: four pixels
    std::string model = "constant_toughness";
    std::string method = "trust_region";
    int steps = 500;       ///< on the way there
    std::string duration;  ///< "100 s" of the way there, at one speed; empty: no edge is kept

    /// @throws InvalidArgument for what is missing, malformed or contradicts itself, before heights are read.
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

/// Loops of surfaces alike.
struct FrontAnswer {
    std::string file;
    contact::AdhesiveContact contact;
    double shortest_wavelength = 0.0;  ///< [m]
    std::vector<FrontRun> runs;
    Table steps;  ///< crack_front::loop_table() of the first
    Table edge;   ///< of the first, where it is kept: contact_line::as_table() with "displacement" and "force"
    std::vector<Quantity> quantities;  ///< means over the surfaces, ± of their mean where there are several
    std::vector<Alert> alerts;
};

/// Share of the way of all loops that is done; false ends them.
using FrontProgress = std::function<bool(double share)>;

/// surfaces: maps, periodic or not, alike in size; the sphere's axis is over their centres. Several run on a thread
/// each; same bytes for any number of them.
/// @throws InvalidArgument for what is no map, undefined heights, a contact larger than a map that is not periodic and
/// fields that fit into no memory, with what would do.
[[nodiscard]] FrontAnswer contact_front(const std::string& file, const std::vector<topography::Measurement>& surfaces,
                                        const FrontRequest& request, parallel::Threads threads = {},
                                        const FrontProgress& progress = {});

/// What the loops say, in a sentence.
[[nodiscard]] std::string front_sentence(const FrontAnswer& answer);

/// Quantities by name, "standard_errors" where there are several surfaces, "runs", "steps" with a list for each column,
/// "file", "processing" and "alerts".
[[nodiscard]] output::Json to_json(const FrontAnswer& answer, const std::vector<processing::StepRecord>& processing);

}  // namespace setae::answers
