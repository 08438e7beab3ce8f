// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/core/estimate.hpp"
#include "setae/simulation/data_set.hpp"
#include "setae/simulation/known_surface.hpp"
#include "setae/study/study_result.hpp"

/// The pipeline checked against surfaces and loops of which everything is known.
namespace setae::validation {

/// How far a found value is from the planted one is said in …
enum class Deviation {
    relative,  ///< found/planted − 1
    absolute,  ///< found − planted, in the quantity's unit
};

/// One found value beside the planted one.
struct Comparison {
    int run = 0;
    std::string item;      ///< "A", or "A × E07"
    std::string quantity;  ///< "rms_height"
    std::string method;    ///< "likelihood", "average", "paper", "loops", "pairs", "elastomers"
    std::string unit;      ///< "m"
    Deviation measure = Deviation::relative;
    double planted = 0.0;
    Estimate found;

    [[nodiscard]] double deviation() const;
    /// Half the width of the 95 % interval over 1.96, measured as the deviation is; NaN without an interval.
    [[nodiscard]] double stated_deviation() const;
    /// Whether the 95 % interval holds the planted value; false without an interval.
    [[nodiscard]] bool covered() const;
};

/// What is planted in one data set.
struct Planted {
    std::vector<simulation::SurfaceTruth> surfaces;  ///< in the recipe's order
    std::vector<simulation::PlantedLoop> loops;
};

/// Everything a recipe plants. @throws as simulation::surface_truth and planted_loops.
[[nodiscard]] Planted planted_in(const simulation::Recipe& recipe);

/// Surfaces: rms_height, rms_slope, rms_curvature, elastic_energy_per_modulus, true_area_ratio and C1D by decade, by
/// every spectrum of the study; where a spectrum begins above the roll-off, against the planted waves from there on.
/// Loops: work_approach, work_retraction, contact_modulus, energy_loss by their own noise alone. Pairs: work_approach
/// and energy_loss of all their loops, with every input; predicted_work and predicted_loss, which are new_pair_work and
/// new_pair_loss where the pair was not measured; next_surface_work and next_elastomer_work by fits without its surface
/// (elastomer). Elastomers: contact_modulus. Study: work_of_adhesion (clustered fit), work_of_predictions (W_int that
/// predictions rest on) and work_of_adhesion_from_loss. Predictions and W_int by the spectrum used and by the average.
/// What failed or was not found is left out. Surfaces and loops are matched by name.
[[nodiscard]] std::vector<Comparison> comparisons(int run, const simulation::Recipe& recipe, const Planted& planted,
                                                  const study::StudyResult& study);

/// The spectra of [D19]: eq. (11) and straight segments between contour points; intervals between percentiles of the
/// bootstrap over measurements. Method "paper".
[[nodiscard]] std::vector<Comparison> comparisons_by_paper(int run, const simulation::Recipe& recipe,
                                                           const Planted& planted, const study::StudyResult& study);

}  // namespace setae::validation
