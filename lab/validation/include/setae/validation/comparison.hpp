// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/core/estimate.hpp"
#include "setae/simulation/data_set.hpp"
#include "setae/simulation/known_surface.hpp"
#include "setae/study/study_result.hpp"

/// Comparison of the pipeline with surfaces and loops of known properties.
namespace setae::validation {

/// Form of the deviation of a found value from the true value.
enum class Deviation {
    relative,  ///< found/true − 1
    absolute,  ///< found − true, in the quantity's unit
};

/// One found value with its true value.
struct Comparison {
    int run = 0;
    std::string item;      ///< "A", or "A × E07"
    std::string quantity;  ///< "rms_height"
    std::string method;    ///< "likelihood", "average", "paper", "loops", "pairs", "elastomers"
    std::string unit;      ///< "m"
    Deviation measure = Deviation::relative;
    double true_value = 0.0;
    Estimate found;

    [[nodiscard]] double deviation() const;
    /// Half the width of the 95 % interval divided by 1.96, in the form of the deviation; NaN without an interval.
    [[nodiscard]] double stated_deviation() const;
    /// Whether the 95 % interval covers the true value; false without an interval.
    [[nodiscard]] bool covered() const;
};

/// True values of one data set.
struct TrueValues {
    std::vector<simulation::TrueSurfaceValues> surfaces;  ///< in the recipe's order
    std::vector<simulation::KnownLoop> loops;
};

/// All true values of a recipe. @throws as simulation::true_surface_values and known_loops.
[[nodiscard]] TrueValues true_values_of(const simulation::Recipe& recipe);

/// Surfaces: rms_height, rms_slope, rms_curvature, elastic_energy_per_modulus, true_area_ratio and C1D by decade, by
/// every spectrum of the study; where a spectrum begins above the roll-off, compared with the true waves above its
/// lower end. Loops: work_approach, work_retraction, contact_modulus, energy_loss with only their own noise. Pairs:
/// work_approach and energy_loss of all their loops, with every input; predicted_work and predicted_loss, which are
/// new_pair_work and new_pair_loss where the pair was not measured; next_surface_work and next_elastomer_work by fits
/// without its surface (elastomer). Elastomers: contact_modulus. Study: work_of_adhesion (clustered fit),
/// work_of_predictions (W_int of the predictions) and work_of_adhesion_from_loss. Predictions and W_int by the spectrum
/// used and by the average. Failed or missing values are left out. Surfaces and loops are matched by name.
[[nodiscard]] std::vector<Comparison> comparisons(int run, const simulation::Recipe& recipe,
                                                  const TrueValues& true_values, const study::StudyResult& study);

/// The spectra of [D19]: Eq. 11 and straight segments between contour points; intervals between percentiles of the
/// bootstrap over measurements. Method "paper".
[[nodiscard]] std::vector<Comparison> comparisons_by_paper(int run, const simulation::Recipe& recipe,
                                                           const TrueValues& true_values,
                                                           const study::StudyResult& study);

}  // namespace setae::validation
