// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "setae/answers/contact_problem.hpp"
#include "setae/answers/sweep_maps.hpp"
#include "setae/fields/option.hpp"
#include "setae/half_space/adhesive_loop.hpp"
#include "setae/parallel/for_each.hpp"

namespace setae::answers {

/// Request of `setae contact sweep` without the surface; see docs/concepts/adhesive-cells.md.
struct SweepRequest : BodyRequest, InteractionRequest {
    std::string stage_stiffness;      ///< empty: the mean gap is prescribed
    std::string to_gap, to_pressure;  ///< the first to be reached is used; both empty: full contact
    double largest_move = 1.0;        ///< largest change of any gap per step, divided by the range
    std::string restart;              ///< file from which a stopped sweep continues
    bool maps = false;                ///< whether states are kept point by point; not with a restart file

    /// @throws InvalidArgument for missing or malformed values, before heights are read.
    void require_complete() const;
    [[nodiscard]] half_space::LoopOptions options(const half_space::Grid& grid) const;
    /// Removes the restart file, after the result is saved.
    void finish() const;
};

/// Progress of a sweep.
struct SweepProgress {
    bool approaching = true;
    double share = 0.0;  ///< share of the way there and back, 0 … 1
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
    std::vector<SweepMaps> maps;  ///< on request
    std::vector<Alert> alerts;
};

/// progress is called after each step; false ends the sweep, which is then incomplete.
/// @throws as touching_surface() and half_space::adhesive_loop(); FileError for a restart file of another sweep.
[[nodiscard]] SweepAnswer adhesive_sweep(const std::string& file, const topography::Measurement& measurement,
                                         const SweepRequest& request, parallel::Threads threads = {},
                                         const std::function<bool(const SweepProgress&)>& progress = {});

}  // namespace setae::answers

template <>
struct setae::fields::Asked<setae::answers::SweepRequest> {
    using R = answers::SweepRequest;
    static constexpr std::array options{
        option<&R::stage_stiffness>("stage_stiffness", "stiffness of the stage that is moved")
            .of(positive(dimension::stiffness))
            .such_as("10 N/m")
            .or_else("the mean gap is prescribed"),
        option<&R::to_gap>("to_gap", "mean gap, or position of the stage, where the sweep turns")
            .of(non_negative(dimension::length))
            .such_as("2 nm")
            .or_else("0, full contact"),
        option<&R::to_pressure>("to_pressure", "mean pressure where the sweep turns")
            .of(positive(dimension::pressure))
            .such_as("10 kPa"),
        option<&R::largest_move>("largest_move",
                                 "largest change of any gap per step, in ranges: 2 takes two thirds of the time, works "
                                 "change by up to 1 %")
            .within(domain::positive)
            .default_shown()
            .advanced(),
        option<&R::restart>("restart",
                            "file written every 20 steps; where it exists the sweep continues from it, to the same "
                            "bytes; removed at the end")
            .advanced(),
    };
};
