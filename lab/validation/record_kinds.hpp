// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "setae/loops/analysis.hpp"
#include "setae/numerics/random_numbers.hpp"
#include "setae/simulation/loop_simulation.hpp"

namespace setae::validation {

/// A simulated record before the changes of its kind.
struct RecordInMaking {
    hysteresis::HystereticSphere specimen;
    simulation::LoadingProtocol protocol;
    double pull_off = 0.0;            ///< 3/2 πRW_ret [N]
    double penetration = 0.0;         ///< at the largest force [m]
    double force_noise = 0.01;        ///< noise of one sample, share of the pull-off
    double force_correlation = 0.0;   ///< correlation of neighbouring samples
    double displacement_noise = 0.0;  ///< share of the penetration
    double displacement_correlation = 0.0;
    double compliance = 0.0;  ///< compliance of the load path, which the displacement contains [m/N]
    bool camera = false;
    bool touches = true;
    loops::AnalysisOptions options{};
    loops::Loop loop{};
    double energy_loss = 0.0;  ///< [J]
    bool closed = true;        ///< the loop's energy is known
    numerics::RandomKey key{};
};

/// Changes the simulation of the record.
void change_experiment(const std::string& kind, RecordInMaking& record);

/// Changes the simulated record before noise is added: free flight, cycles, drift, steps.
void change_course(const std::string& kind, RecordInMaking& record);

/// Changes the record after noise is added: rounding, missing channels, signs.
void change_channels(const std::string& kind, RecordInMaking& record);

}  // namespace setae::validation
