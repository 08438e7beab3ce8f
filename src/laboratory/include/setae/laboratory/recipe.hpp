// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "setae/core/estimate.hpp"
#include "setae/laboratory/known_surface.hpp"
#include "setae/laboratory/loop_simulation.hpp"

namespace setae::laboratory {

/// Scans of a stylus: one line a length.
struct StylusProtocol {
    std::vector<double> lengths;             ///< [m]
    double step = 100e-9;                    ///< [m]
    double tip_radius = 5e-6;                ///< what the study is told [m]
    double tip_radius_standard_error = 0.0;  ///< [m]; the radius used is drawn about the one told
    double noise = 0.0;                      ///< standard deviation of a point [m]
    double bow = 0.0;                        ///< height of the arc over a scan [m]
    double tilt = 0.0;                       ///< [1]
};

/// Square maps of a force microscope: one a size.
struct AfmProtocol {
    std::vector<double> sizes;               ///< [m]
    Index pixels = 256;                      ///< a side
    double tip_radius = 10e-9;               ///< what the study is told [m]
    double tip_radius_standard_error = 0.0;  ///< [m]; the radius used is drawn about the one told
    double noise = 0.0;                      ///< standard deviation of a pixel [m]
    double line_offset = 0.0;                ///< standard deviation of the offset of a line [m]
};

/// Traced contours of a cross-section: one a length.
struct TemProtocol {
    std::vector<double> lengths;  ///< [m]
    double step = 0.2e-9;         ///< mean distance of the traced points [m]
    double noise = 0.0;           ///< standard deviation of a traced point [m]
};

/// A surface and how it is measured; an instrument without entry is not used.
struct SurfaceRecipe {
    KnownSurface surface;
    std::optional<StylusProtocol> stylus;
    std::optional<AfmProtocol> afm;
    std::optional<TemProtocol> tem;
};

/// A soft sphere.
struct ElastomerRecipe {
    std::string name;
    double youngs_modulus = 0.0;       ///< E [Pa], > 0
    double poisson_ratio = 0.5;        ///< ν
    Estimate surface_energy;           ///< γ1 [J/m²]: the value is true, the study is told both
    double sphere_radius = 0.0;        ///< R [m], > 0
};

/// Where W_ret comes from.
enum class RetractionLaw {
    loss,     ///< the loop loses f W_int A_true
    pinning,  ///< the roughness pins the edge
};

/// How loops are made: one a surface and elastomer, and references on a smooth standard before and after.
struct LoopRecipe {
    LoadingProtocol protocol;
    LoopArtefacts artefacts;  ///< the key is the recipe's
    RetractionLaw law = RetractionLaw::loss;
    double loss_factor = 1.0;                        ///< f
    std::optional<double> reference_work;            ///< W of both branches on the standard [J/m²]; none: no references
};

/// Everything that determines a data set.
struct Recipe {
    std::string title;
    std::string description;
    std::uint64_t seed = 1;
    double work_of_adhesion = 0.0;        ///< W_int [J/m²]
    double counter_youngs_modulus = 0.0;  ///< of the rough solid [Pa]
    double counter_poisson_ratio = 0.0;
    std::vector<SurfaceRecipe> surfaces;
    std::vector<ElastomerRecipe> elastomers;
    std::optional<LoopRecipe> loops;
};

/// Reads a recipe from TOML; docs/laboratory.md describes every key.
/// @throws FileError; FormatError with the line for text that is no TOML, an unknown key (with the nearest known one), a
/// missing or wrong unit, a spectrum whose parameters contradict each other, a protocol that is not declared.
[[nodiscard]] Recipe read_recipe(const std::string& path);

}  // namespace setae::laboratory
