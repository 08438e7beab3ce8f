// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>
#include <string>

#include "setae/statistics/replicate_data.hpp"

namespace setae::statistics {

/// Replicates with known variances: 4 between spots, 2.25 between repeats.
struct SimulatedReplicates {
    int surfaces = 1, lenses = 3, spots = 4, repeats = 2;
    double between_lenses = 3.0;  ///< standard deviation
    double mean = 40.0;           ///< of the first surface; the next are 5 higher each
    double fit_error = 0.0;       ///< rows' standard errors are 0.5 to 1.5 of it; 0: unknown
    double dropped = 0.0;         ///< share of rows that are left out, never the first of a lens
    unsigned seed = 1;
};

inline ReplicateData simulated(const SimulatedReplicates& plan) {
    std::mt19937_64 engine(plan.seed);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> uniform;
    ReplicateData data;
    for (int surface = 0; surface < plan.surfaces; ++surface)
        for (int lens = 0; lens < plan.lenses; ++lens) {
            const double lens_value = plan.between_lenses * normal(engine);
            for (int spot = 0; spot < plan.spots; ++spot) {
                const double spot_value = 2.0 * normal(engine);
                for (int repeat = 0; repeat < plan.repeats; ++repeat) {
                    const double error = plan.fit_error > 0.0 ? plan.fit_error * (0.5 + uniform(engine)) : undefined;
                    double value = plan.mean + 5.0 * surface + lens_value + spot_value + 1.5 * normal(engine);
                    if (plan.fit_error > 0.0) value += error * normal(engine);
                    if (uniform(engine) < plan.dropped && (spot > 0 || repeat > 0)) continue;
                    data.rows.push_back(
                        {value,
                         error,
                         {"S" + std::to_string(surface), "L" + std::to_string(lens), "P" + std::to_string(spot)},
                         "S" + std::to_string(surface) + "L" + std::to_string(lens) + "P" + std::to_string(spot) + "R" +
                             std::to_string(repeat)});
                }
            }
        }
    return data;
}

}  // namespace setae::statistics
