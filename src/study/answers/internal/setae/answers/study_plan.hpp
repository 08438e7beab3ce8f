// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Planned steps of a study, as the JSON of `setae study --dry-run` has them.

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "setae/core/arrays.hpp"
#include "setae/fields/describe.hpp"
#include "setae/study/run_options.hpp"
#include "setae/study/study_gaps.hpp"
#include "setae/study/study_result.hpp"

namespace setae::answers {

/// Steps of a run of a study, and missing metadata of its file.
struct StudyPlan {
    std::string study;
    std::string output;
    std::string cache;
    std::vector<study::PlannedStep> steps;
    std::vector<study::StudyGap> missing;

    /// Number of steps in a state.
    [[nodiscard]] Index count(std::string_view state) const;
};

/// States of a step: its result is not yet computed, is kept from an earlier run, or cannot be computed.
inline constexpr std::array<std::string_view, 3> step_states{"to do", "kept", "fails"};

/// State of a step, one of step_states.
[[nodiscard]] std::string_view state_of(const study::PlannedStep& step);

/// The plan of a study; `options` states the store of kept results.
/// @throws as study::planned_steps() and study::study_gaps().
[[nodiscard]] StudyPlan plan_of(const study::Study& study, const study::RunOptions& options);

}  // namespace setae::answers

template <>
struct setae::fields::Described<setae::study::PlannedStep> {
    using T = study::PlannedStep;
    static constexpr std::array<std::string_view, 3> stages{"measurement", "surface", "experiment"};
    static constexpr std::array rows{
        field<&T::stage>("stage", "kind of the step").one_of(stages),
        field<&T::item>("item", "file of the measurement or experiment, or name of the surface"),
        made<T>("state", "whether the result is to be computed, is kept from an earlier run, or cannot be computed",
                [](const T& of) { return answers::state_of(of); })
            .one_of(answers::step_states),
        field<&T::error>("error", "reason for which the result cannot be computed").with(Missing::left_out),
        inner<&T::cached>(),
    };
    static constexpr Description description{"", "a step of a study", rows};
};
static_assert(setae::fields::complete<setae::study::PlannedStep>);

template <>
struct setae::fields::Described<setae::study::StudyGap> {
    using T = study::StudyGap;
    static constexpr std::array rows{
        field<&T::line>("line", "line of the study file"),
        field<&T::item>("item", "file, elastomer or table that lacks the metadata"),
        field<&T::message>("message", "what is missing, and its effect"),
    };
    static constexpr Description description{"", "missing metadata", rows};
};
static_assert(setae::fields::complete<setae::study::StudyGap>);

template <>
struct setae::fields::Described<setae::answers::StudyPlan> {
    using T = answers::StudyPlan;
    static constexpr std::array rows{
        field<&T::study>("study", "path of the study file"),
        field<&T::output>("output", "folder of the results"),
        field<&T::cache>("cache", "folder of the cache; empty without a cache"),
        field<&T::steps>("steps", "measurements, surfaces and loops, and whether their results are in the cache"),
        field<&T::missing>("missing", "missing metadata of the study"),
    };
    static constexpr Description description{"", "with `--dry-run` the planned computations", rows};
};
static_assert(setae::fields::complete<setae::answers::StudyPlan>);
