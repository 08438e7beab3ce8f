// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "setae/answers/contact_problem.hpp"
#include "setae/answers/sweep_maps.hpp"
#include "setae/half_space/adhesive_loop.hpp"
#include "setae/parallel/for_each.hpp"

namespace setae::answers {

/// What `setae contact sweep` is told beside the surface; see docs/concepts/adhesive-cells.md.
struct SweepRequest : BodyRequest, InteractionRequest {
    std::string stage_stiffness;  ///< "10 N/m"; empty: the mean gap is moved
    std::string to_gap;           ///< where it turns; empty: full contact
    std::string to_pressure;      ///< or there, where that comes first
    double largest_move = 1.0;    ///< of any gap in a step, over the range
    std::string restart;          ///< file a stopped sweep goes on from
    bool maps = false;            ///< whether states are kept point by point; not with a restart file

    /// @throws InvalidArgument for what is missing or malformed, before heights are read.
    void require_complete() const;
    [[nodiscard]] half_space::LoopOptions options(const half_space::Grid& grid) const;
    /// Removes the restart file, once what came out is safe.
    void finish() const;
};

/// Where a sweep stands.
struct SweepProgress {
    bool approaching = true;
    double share = 0.0;  ///< of the way there and back, 0 … 1
};

/// A loop from far into contact and back.
struct SweepAnswer {
    std::string file;
    half_space::Grid grid;
    half_space::Body body;
    half_space::Interaction interaction;
    half_space::AdhesiveLoop loop;
    Table steps;  ///< half_space::loop_table()
    std::vector<Quantity> quantities;
    std::vector<SweepMaps> maps;  ///< where wanted
    std::vector<Alert> alerts;
};

/// progress is called after each step; false ends the sweep, which is then incomplete.
/// @throws as touching_surface() and half_space::adhesive_loop(); FileError for a restart file of another sweep.
[[nodiscard]] SweepAnswer adhesive_sweep(const std::string& file, const topography::Measurement& measurement,
                                         const SweepRequest& request, parallel::Threads threads = {},
                                         const std::function<bool(const SweepProgress&)>& progress = {});

/// Quantities by name, "status", "steps" with a list for each column, "maps" where they are kept, the attraction,
/// "file", "processing" and "alerts".
[[nodiscard]] output::Json to_json(const SweepAnswer& answer, const std::vector<processing::StepRecord>& processing);

}  // namespace setae::answers
