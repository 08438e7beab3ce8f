// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "setae/answers/contact_problem.hpp"
#include "setae/answers/pressures.hpp"
#include "setae/core/table.hpp"
#include "setae/fields/option.hpp"
#include "setae/half_space/body.hpp"
#include "setae/persson/load_curve.hpp"
#include "setae/study/surface_analysis.hpp"

namespace setae::answers {

/// Request of `setae contact persson` without the surface; see docs/concepts/persson.md.
struct PerssonRequest : BodyRequest {
    std::string pressure;
    double energy_factor = persson::usual_energy_factor;
    std::string work_of_adhesion;  ///< empty: none

    /// @throws InvalidArgument where the body or the pressure is missing or malformed, before heights are read.
    void require_complete() const;
    [[nodiscard]] persson::LoadOptions options() const;
};

/// Contact of a rough surface by Persson's theory, at every pressure and, of a single one, also along wavevectors.
struct PerssonContact {
    persson::Scales scales;
    Table load;
    std::optional<Table> along_scales;
    double contact_modulus = 0.0, energy_factor = 0.0;  ///< E* [Pa]
    std::vector<Alert> alerts;                          ///< warnings of the surface

    /// The one that is shown.
    [[nodiscard]] const Table& table() const { return along_scales ? *along_scales : load; }
};

/// A surface for Persson's theory: its spectrum, without the replicas for standard errors. every_measurement: the first
/// failure of one is thrown. @throws as study::analyse_surface().
[[nodiscard]] study::SurfaceResult surface_for_theory(const study::SurfaceInput& input,
                                                      study::SurfaceAnalysisOptions analysis,
                                                      parallel::Threads threads = {}, bool every_measurement = false);

/// surface: that did not fail. @throws as PerssonRequest and persson::load_table().
[[nodiscard]] PerssonContact persson_contact(const study::SurfaceResult& surface, const PerssonRequest& request);

}  // namespace setae::answers

template <>
struct setae::fields::Asked<setae::answers::PerssonRequest> {
    using R = answers::PerssonRequest;
    static constexpr std::array options{
        option<&R::pressure>(
            "pressure",
            "mean pressure: one, several as 1MPa,10MPa, or ten per decade as 1MPa:100MPa; below 0 with "
            "adhesion")
            .read_by([](const std::string& text) { (void)answers::pressures_of(text); }),
        option<&R::energy_factor>("energy_factor", "factor of the stored energy of partial contact, in (0, 1]")
            .within(domain::positive)
            .default_shown()
            .advanced(),
    };
    /// Beside those of a contact without adhesion.
    static constexpr std::array adhesion{
        option<&R::work_of_adhesion>("work_of_adhesion", "work of adhesion per unit projected area")
            .of(non_negative(dimension::surface_energy))
            .such_as("50 mJ/m2")
            .or_else("none")
            .short_name("w")
            .in_python("W_int"),
    };
};
