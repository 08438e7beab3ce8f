// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "setae/core/estimate.hpp"
#include "setae/simulation/calibrations.hpp"
#include "setae/simulation/known_surface.hpp"
#include "setae/simulation/loop_simulation.hpp"
#include "setae/simulation/side_view.hpp"
#include "setae/simulation/stated_quantity.hpp"

namespace setae::simulation {

/// Scans of a stylus: one line per length.
struct StylusProtocol {
    std::vector<double> lengths;              ///< [m]
    std::vector<double> steps{100e-9};        ///< [m], one for all or one per length
    double tip_radius = 5e-6;                 ///< radius given to the study [m]; 0: points are read without a tip
    double tip_radius_standard_error = 0.0;   ///< standard error [m]; the true radius is drawn about the given one …
    std::optional<double> shared_tip_radius;  ///< … for each surface, unless this is the tip of all surfaces [m]
    double noise = 0.0;                       ///< standard deviation of a point [m]
    double bow = 0.0;                         ///< height of the arc over a scan [m]
    double tilt = 0.0;                        ///< [1]
    double artefact = 0.0;  ///< rms of the curve that the drive adds to all scans [m]; references are made, too, if > 0
    double artefact_wavelength = 1e-3;  ///< longest wavelength of that curve [m]

    [[nodiscard]] double step(std::size_t scan) const { return steps.size() == 1 ? steps.front() : steps[scan]; }
};

/// Square maps of a force microscope: one per size.
struct AfmProtocol {
    std::vector<double> sizes;                ///< [m]
    std::vector<Index> pixels{256};           ///< number of pixels per side, one for all or one per size
    double tip_radius = 10e-9;                ///< radius given to the study [m]; 0: pixels are read without a tip
    double tip_radius_standard_error = 0.0;   ///< standard error [m]; the true radius is drawn about the given one …
    std::optional<double> shared_tip_radius;  ///< … for each surface, unless this is the tip of all surfaces [m]
    double noise = 0.0;                       ///< standard deviation of a pixel [m]
    double line_offset = 0.0;                 ///< standard deviation of the offset of a line [m]
    double line_drift = 0.0;                  ///< standard deviation of a step of the walk from line to line [m]
    double tilt = 0.0;                        ///< slope along the fast axis [1]
    double bow = 0.0;                         ///< height of the scanner's arc along the fast axis [m]
    double feedback_lag = 0.0;                ///< distance over which the tip follows a step to 1/e [m]

    [[nodiscard]] Index pixels_of(std::size_t map) const { return pixels.size() == 1 ? pixels.front() : pixels[map]; }
};

/// Traced contours of a cross-section: one per length.
struct TemProtocol {
    std::vector<double> lengths;  ///< [m]
    double step = 0.2e-9;         ///< mean distance of the traced points [m]
    ContourSteps steps = ContourSteps::gamma;
    double step_spread = 0.5;     ///< rms of the distance divided by its mean
    double noise = 0.0;           ///< standard deviation of a traced point [m]
    double foil_thickness = 0.0;  ///< thickness along the beam [m]; 0: the contour is a line
};

/// A parameter of a surface's spectrum as given, or drawn from its range.
struct SpectrumParameter {
    std::string key;     ///< as in the recipe: "rms_slope"
    double value = 0.0;  ///< SI
    bool drawn = false;  ///< whether it is drawn from a range
};

/// A surface and its measurements; an instrument without entry is not used.
struct SurfaceRecipe {
    KnownSurface surface;
    std::vector<SpectrumParameter> parameters;  ///< parameters of the spectrum, and the skewness where one is given
    std::optional<StylusProtocol> stylus;
    std::optional<AfmProtocol> afm;
    std::optional<TemProtocol> tem;
};

/// A soft sphere.
struct ElastomerRecipe {
    std::string name;
    StatedQuantity youngs_modulus;  ///< E [Pa], > 0
    bool tell_modulus = false;      ///< whether the study contains E; otherwise it determines E from loops
    double poisson_ratio = 0.5;     ///< ν
    StatedQuantity surface_energy;  ///< γ1 [J/m²]
    StatedQuantity sphere_radius;   ///< R [m], > 0
    double tip_factor = 1.0;        ///< factor φ of W_ret on every surface, including smooth ones; >= 1
    hysteresis::ViscousBody body;   ///< rate-dependent edge, relaxing bulk
};

/// A surface and an elastomer.
struct SpecimenPair {
    std::string surface, elastomer;
    bool operator==(const SpecimenPair&) const = default;
};

/// Origin of W_ret.
enum class RetractionChoice {
    loss,        ///< energy loss f W_int A_true
    pinning,     ///< roughness pins the edge: hysteresis::Law::pinning
    opening,     ///< constant work per unit true area: hysteresis::Law::opening_work
    reversible,  ///< W_ret = W_app
};

/// Contact of the soft body.
enum class KnownContact {
    full,     ///< full contact, as the full-contact balance (Eq. 7) assumes
    patches,  ///< contact of simulated patches without load: adhesion::unloaded_contact
};

/// Treatment of pairs of surface and elastomer without a loop: W_app <= 0, or jumps that dissipate more than E_loss.
enum class PairsWithoutContact {
    refuse,  ///< an error that names the pair
    skip,    ///< left out
};

/// Deviation of W_app from its balance: standard deviations of normal numbers, one for each pair, one for all pairs of
/// a surface, one for all pairs of an elastomer [J/m²].
struct WorkScatter {
    double pair = 0.0, surface = 0.0, elastomer = 0.0;
};

/// Simulation of loops: one per surface and elastomer unless the pair is listed below, and references on a smooth
/// reference before and after.
struct LoopRecipe {
    LoadingProtocol protocol;
    LoopArtefacts artefacts;  ///< the key is that of the recipe
    RetractionChoice law = RetractionChoice::loss;
    KnownContact contact = KnownContact::full;
    double loss_factor = 1.0;   ///< f
    double opening_work = 0.0;  ///< W_x of the retraction model `opening` [J/m²]
    WorkScatter work_scatter;
    PairsWithoutContact nonconforming = PairsWithoutContact::refuse;
    /// pairs whose loop is simulated, but not recorded: the study only predicts it
    std::vector<SpecimenPair> unmeasured;
    std::vector<SpecimenPair> further;  ///< pairs with one more loop, once for each time that a pair is named
    /// W of both branches on the smooth reference [J/m²]; without it no references
    std::optional<double> reference_work;
    /// speed of the motor on the smooth reference [m/s]; without it that of all loops
    std::optional<double> reference_speed;

    /// Protocol of loops on a surface; without a name, on the smooth reference.
    [[nodiscard]] LoadingProtocol protocol_on(const std::string& surface) const {
        auto made = protocol;
        if (surface.empty() && reference_speed) made.approach_speed = made.retraction_speed = *reference_speed;
        return made;
    }

    [[nodiscard]] bool is_unmeasured(const SpecimenPair& pair) const {
        return std::find(unmeasured.begin(), unmeasured.end(), pair) != unmeasured.end();
    }
};

/// All inputs of a data set.
struct Recipe {
    std::string title;
    std::string description;
    std::uint64_t seed = 1;
    double work_of_adhesion = 0.0;        ///< W_int [J/m²]
    double counter_youngs_modulus = 0.0;  ///< Young's modulus of the rough solid [Pa]
    double counter_poisson_ratio = 0.0;
    std::vector<SurfaceRecipe> surfaces;
    std::vector<ElastomerRecipe> elastomers;
    std::optional<LoopRecipe> loops;
    Calibrations calibrations;
    std::optional<StatedQuantity> stylus_tip, afm_tip;  ///< radius [m] of one tip for all surfaces, where they share it
};

/// Named inputs in the study of a recipe, each once: calibrations and tips of the instruments in use, calibrations of
/// the testing machine where there are loops, lenses and batches of elastomers.
[[nodiscard]] std::vector<StatedQuantity> named_inputs(const Recipe& recipe);

/// Reads a recipe from TOML; docs/reference/recipes.md describes every key.
///
/// Where a parameter of a spectrum, a skewness, a modulus of an elastomer or the work of adhesion is a pair [from, to],
/// it is
///
///   from (to/from)^u,  u uniform in (0, 1), from only the seed and the names of table and key
///
/// so that another surface, or another order, changes no other number. Inputs with a standard error are drawn once per
/// scope (an instrument, a testing machine, a tip, a lens, a batch of elastomers), from only the seed and the name of
/// the scope. seed: in place of the recipe's.
/// @throws FileError; FormatError with the line for text that is no TOML, an unknown key (with the nearest known one),
/// a missing or wrong unit, a pair that is not 0 < from <= to, a spectrum whose parameters contradict each other, a
/// protocol that is not declared, two different values of one scope, a calibration with a unit or not above 0.
[[nodiscard]] Recipe read_recipe(const std::string& path, std::optional<std::uint64_t> seed = {});

}  // namespace setae::simulation
