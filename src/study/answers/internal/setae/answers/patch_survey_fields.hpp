// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Patches in adhesive contact, as JSON has them.

#include <array>
#include <optional>
#include <vector>

#include "setae/answers/patch_survey.hpp"
#include "setae/fields/describe.hpp"
#include "setae/output/contact_answer_fields.hpp"

namespace setae::answers {

/// Loop of approach, full contact and separation.
struct LoopOfPatches {
    const patches::SurveyRow* row;
};

/// Patches with the spectrum of a pair.
struct PatchesOfPair {
    const patches::SurveyRow* row;
    const PatchPair* pair;
};

/// One row of a survey.
struct PatchEntry {
    const patches::SurveyRow* row;
    const PatchPair* pair = nullptr;  ///< nullptr without a study
    bool loops = false;
};

[[nodiscard]] inline std::vector<PatchEntry> entries_of(const PatchSurveyAnswer& answer) {
    std::vector<PatchEntry> entries;
    for (std::size_t i = 0; i < answer.rows.size(); ++i)
        entries.push_back({&answer.rows[i], answer.pairs.empty() ? nullptr : &answer.pairs[i], answer.loops});
    return entries;
}

}  // namespace setae::answers

namespace setae::fields {

template <>
struct Described<patches::PatchMean> {
    using T = patches::PatchMean;
    static constexpr std::array rows{
        field<&T::value>("value", "mean"),
        field<&T::standard_error>("standard_error", "standard error of the mean"),
    };
    static constexpr Description description{"patch_mean", "mean over patches", rows};
};
static_assert(complete<patches::PatchMean>);

template <>
struct Described<patches::JumpClass> {
    using T = patches::JumpClass;
    static constexpr std::array rows{
        field<&T::from>("from", "smallest loss of a jump, divided by W"),
        field<&T::to>("to", "largest loss of a jump, divided by W"),
        field<&T::jumps>("jumps", "number of jumps"),
        field<&T::loss>("loss", "loss of all these jumps, divided by W"),
    };
    static constexpr Description description{"jump_class", "jumps of a loop with similar loss", rows};
};
static_assert(complete<patches::JumpClass>);

template <>
struct Described<answers::LoopOfPatches> {
    using T = answers::LoopOfPatches;
    static constexpr std::array rows{
        made<T>("approach_work", "energy gained on approach",
                [](const T& of) -> const auto& { return of.row->approach_work; }),
        made<T>("separation_work", "work spent on separation",
                [](const T& of) -> const auto& { return of.row->separation_work; }),
        made<T>("loss", "difference of separation work and approach work",
                [](const T& of) -> const auto& { return of.row->loss; }),
        made<T>("large_jumps", "share of the loss in jumps that each lose more than W/100",
                [](const T& of) -> const auto& { return of.row->large_jumps; }),
        made<T>("approach_jumps", "jumps on approach by size, per patch",
                [](const T& of) -> const auto& { return of.row->approach_jumps; }),
        made<T>("separation_jumps", "jumps on separation by size, per patch",
                [](const T& of) -> const auto& { return of.row->separation_jumps; }),
        made<T>("greatest_tension", "greatest tension divided by the greatest tension of the attraction",
                [](const T& of) -> const auto& { return of.row->greatest_tension; }),
        inner<&T::row>(),
    };
    static constexpr Description description{
        "", "loop of approach, full contact and separation; divided by W, including the loss of the cell", rows};
};
static_assert(complete<answers::LoopOfPatches>);

template <>
struct Described<answers::PatchesOfPair> {
    using T = answers::PatchesOfPair;
    static constexpr std::array rows{
        made<T>("surface", "surface of the pair", [](const T& of) -> const auto& { return of.pair->surface; }),
        made<T>("elastomer", "elastomer of the pair", [](const T& of) -> const auto& { return of.pair->elastomer; }),
        made<T>("work", "work of adhesion W of the pair", [](const T& of) { return of.pair->work; }).in_unit("J/m2"),
        made<T>("energy_in_band", "share of U_el of the surface in the band of the patches",
                [](const T& of) { return of.pair->energy_in_band; }),
        made<T>("gain", "energy gained on approach from separated bodies",
                [](const T& of) { return of.pair->work * of.row->gain_from_far.value; })
            .in_unit("J/m2"),
        made<T>("answers", "results of the pair without load by each theory, including this row",
                [](const T& of) { return answers::answers_with(*of.row, *of.pair); }),
        made<T>("measured_work", "measured W_app of the pair; null where it was not measured",
                [](const T& of) { return of.pair->measured ? std::optional(of.pair->measured->value) : std::nullopt; })
            .or_null()
            .in_unit("J/m2"),
        inner<&T::row>(),
        inner<&T::pair>(),
    };
    static constexpr Description description{"", "patches with the spectrum of a pair", rows};
};
static_assert(complete<answers::PatchesOfPair>);

template <>
struct Described<answers::PatchEntry> {
    using T = answers::PatchEntry;
    static constexpr std::array rows{
        made<T>("energy_share", "U_el/(A W): stored energy divided by gained energy in full contact",
                [](const T& of) { return of.row->design.energy_share; }),
        made<T>("points", "number of points of a patch per side", [](const T& of) { return of.row->design.points; }),
        made<T>("band", "longest divided by shortest wavelength", [](const T& of) { return of.row->design.band(); }),
        made<T>("squared_ratio", "ratio w dx/(E* ρ²) of the grid",
                [](const T& of) { return of.row->design.squared_ratio; }),
        made<T>("range_over_height", "range of the attraction divided by the rms height",
                [](const T& of) { return of.row->range_over_height; }),
        made<T>("patches", "number of patches", [](const T& of) { return of.row->patches; }),
        made<T>("area_from_far",
                "contact area without load after approach from separated bodies, divided by the nominal area",
                [](const T& of) -> const auto& { return of.row->area_from_far; }),
        made<T>("gain_from_far", "energy gained by that contact, divided by W",
                [](const T& of) -> const auto& { return of.row->gain_from_far; }),
        made<T>("area_after_preload",
                "contact area without load after a pressure of h' E*, divided by the nominal area",
                [](const T& of) -> const auto& { return of.row->area_after_preload; }),
        made<T>("gain_after_preload", "energy gained by that contact, divided by W",
                [](const T& of) -> const auto& { return of.row->gain_after_preload; }),
        made<T>("balance", "gained energy by the full-contact balance (Eq. 7), divided by W; at least 0",
                [](const T& of) { return answers::balance_of(*of.row); }),
        made<T>("closed_patches", "number of patches in full contact at some pressure up to 8 h' E*",
                [](const T& of) { return of.row->closed; }),
        made<T>("closing_pressure",
                "pressure divided by h' E* at which 99 % of the area is in contact; 0 for spontaneous contact; null "
                "without such patches",
                [](const T& of) { return of.row->closed > 0 ? std::optional(of.row->closing_pressure) : std::nullopt; })
            .or_null(),
        made<T>("opening_tension",
                "tension divided by the greatest tension of the attraction, at which full contact starts to open; "
                "below 0 where a pressure is required",
                [](const T& of) -> const auto& { return of.row->opening_tension; }),
        made<T>("converged", "whether every state is in equilibrium", [](const T& of) { return of.row->converged; }),
        made<T>("loop", "loop of approach, full contact and separation; divided by W, including the loss of the cell",
                [](const T& of) { return of.loops ? std::optional(answers::LoopOfPatches{of.row}) : std::nullopt; }),
        fields_of<T>([](const T& of) {
            return of.pair ? std::optional(answers::PatchesOfPair{of.row, of.pair}) : std::nullopt;
        }),
        inner<&T::row>(),
        inner<&T::pair>(),
        inner<&T::loops>(),
    };
    static constexpr Description description{"", "patches of one design", rows};
};
static_assert(complete<answers::PatchEntry>);

template <>
struct Described<answers::PatchSurveyAnswer> {
    using T = answers::PatchSurveyAnswer;
    static constexpr std::array rows{
        made<T>("answer", "result in one or two sentences", [](const T& of) { return answers::sentence(of); }),
        made<T>("rows", "one entry per kind of patch and share of energy, or per kind and pair",
                [](const T& of) { return answers::entries_of(of); }),
        field<&T::skipped>("skipped", "pairs of the study without patches, with the reason"),
        inner<&T::rows>(),
        inner<&T::pairs>(),
        inner<&T::loops>(),
    };
    static constexpr Description description{
        "", "patches in adhesive contact: whether full contact forms, and the gained energy", rows};
};
static_assert(complete<answers::PatchSurveyAnswer>);

}  // namespace setae::fields
