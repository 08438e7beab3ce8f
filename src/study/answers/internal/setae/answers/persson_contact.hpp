// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/core/table.hpp"
#include "setae/half_space/body.hpp"
#include "setae/output/json.hpp"
#include "setae/persson/load_curve.hpp"
#include "setae/study/surface_analysis.hpp"

namespace setae::answers {

/// What Persson's theory is told beside the surface, as `setae contact persson`; see docs/concepts/persson.md.
struct PerssonRequest {
    std::string modulus, pressure;  ///< E* "1 GPa"; "10 MPa", "1MPa,10MPa" or "1MPa:100MPa"
    std::string work, layer;        ///< "50 mJ/m2", empty: none; thickness "20 um", empty: a half-space
    double poisson_ratio = 0.5;     ///< of the layer
    double energy_factor = persson::usual_energy_factor;
    bool frictionless = false;  ///< the layer slides on its base

    /// @throws InvalidArgument where something is missing or malformed.
    [[nodiscard]] half_space::Body body() const;
    [[nodiscard]] persson::LoadOptions options() const;
};

/// Contact of a rough surface by Persson's theory, at every pressure and, of a single one, also along wavevectors.
struct PerssonContact {
    persson::Scales scales;
    Table load;
    std::optional<Table> along_scales;
    double contact_modulus = 0.0, energy_factor = 0.0;  ///< E* [Pa]
    std::vector<Alert> alerts;                          ///< of the surface

    /// The one that is shown.
    [[nodiscard]] const Table& table() const { return along_scales ? *along_scales : load; }
};

/// A surface as far as theory needs it: its spectrum, without the replicas behind standard errors.
/// every_measurement: the first failure of one is thrown. @throws as study::analyse_surface().
[[nodiscard]] study::SurfaceResult surface_for_theory(const study::SurfaceInput& input,
                                                      study::SurfaceAnalysisOptions analysis,
                                                      parallel::Threads threads = {}, bool every_measurement = false);

/// surface: that did not fail. @throws as PerssonRequest and persson::load_table().
[[nodiscard]] PerssonContact persson_contact(const study::SurfaceResult& surface, const PerssonRequest& request);

/// Columns of the load by name, "units", "scales", "contact_modulus", "energy_factor", "rms_pressure",
/// "full_contact_energy", "band" and "alerts".
[[nodiscard]] output::Json to_json(const PerssonContact& contact);

}  // namespace setae::answers
