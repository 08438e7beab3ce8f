// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "setae/answers/contact_problem.hpp"
#include "setae/fields/option.hpp"
#include "setae/patches/survey.hpp"
#include "setae/study/contact_answers.hpp"
#include "setae/study/study_result.hpp"
#include "setae/tables/tidy_table.hpp"

namespace setae::answers {

/// Request of `setae lab conform`; see docs/concepts/conformity.md.
struct PatchSurveyRequest {
    std::vector<double> energy_shares{0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.7, 1.0, 1.2};
    std::vector<Index> points{256};
    std::vector<double> points_per_wave{16.0};
    std::vector<double> squared_ratios{0.5};
    double waves_per_side = 4.0;
    double hurst_exponent = 0.8;
    std::string law = "exponential";
    int seeds = 8;
    std::uint64_t seed = 1;
    bool loops = false;

    /// Every number of points with every shortest wave and range.
    [[nodiscard]] std::vector<patches::PatchDesign> kinds() const;
};

/// A pair of a study whose spectrum patches have.
struct PatchPair {
    std::string surface, elastomer;
    double work = 0.0;  ///< W = W_int r − γ1 (r − 1), energy gained in full contact [J/m²]
    /// share of U_el of the surface in the band of the patch, in which all of U_el is placed
    double energy_in_band = 0.0;
    std::optional<Estimate> measured;  ///< W_app [J/m²]
    study::ContactAnswers answers;     ///< results of all theories except the simulated cell, which is the row
};

struct PatchSurveyAnswer {
    std::vector<patches::SurveyRow> rows;
    std::vector<PatchPair> pairs;  ///< one per row; empty without a study
    bool loops = false;
    std::vector<std::string> skipped;  ///< pairs of the study without a result, with the reason
};

using PatchProgress = std::function<void(std::size_t done, std::size_t of)>;

/// @throws InvalidArgument as patches::survey().
[[nodiscard]] PatchSurveyAnswer patch_survey(const PatchSurveyRequest& request, parallel::Threads threads = {},
                                             const PatchProgress& progress = {});

/// The pairs of a study: each with its share of energy, and with its surface's spectrum in the band of the patch that
/// holds most of U_el. @throws UndefinedDataError where no pair has both.
[[nodiscard]] PatchSurveyAnswer patch_survey(const study::StudyResult& study, const PatchSurveyRequest& request,
                                             parallel::Threads threads = {}, const PatchProgress& progress = {});

/// Energy share up to which patches come into full contact spontaneously, and error of the full-contact balance (Eq. 7)
/// beyond.
[[nodiscard]] std::string sentence(const PatchSurveyAnswer& answer);

/// One row per design: its parameters and the results of its patches.
[[nodiscard]] tables::TidyTable patch_survey_table(const PatchSurveyAnswer& answer);

/// The table at the width of a terminal: for a study, the energy gained in the contact of its pairs.
[[nodiscard]] tables::TidyTable patch_screen_table(const PatchSurveyAnswer& answer);

/// Gained energy by the full-contact balance (Eq. 7), divided by W; at least 0.
[[nodiscard]] double balance_of(const patches::SurveyRow& row);

/// The results of a pair with the simulated cell of its row.
[[nodiscard]] study::ContactAnswers answers_with(const patches::SurveyRow& row, const PatchPair& pair);

}  // namespace setae::answers

template <>
struct setae::fields::Asked<setae::answers::PatchSurveyRequest> {
    using R = answers::PatchSurveyRequest;
    static constexpr std::array options{
        option<&R::energy_shares>("energy_share", "ratio U_el/(A W) of stored to gained energy of the patches")
            .separated_by(',')
            .default_shown()
            .in_python("energy_shares"),
        option<&R::points>("points", "number of points along each side of a patch").separated_by(',').default_shown(),
        option<&R::points_per_wave>("shortest_wave", "number of points per shortest wavelength")
            .separated_by(',')
            .default_shown()
            .in_python("points_per_wave"),
        option<&R::waves_per_side>("waves", "number of longest wavelengths along each side of a patch")
            .default_shown()
            .in_python("waves_per_side"),
        option<&R::hurst_exponent>("hurst", "Hurst exponent of patches, where no study gives the spectrum")
            .default_shown()
            .in_python("hurst_exponent"),
        option<&R::squared_ratios>("squared_ratio",
                                   "ratio w dx/(E* ρ²) of the grid, at most 1, which sets the range of the attraction")
            .separated_by(',')
            .default_shown()
            .in_python("squared_ratios")
            .advanced(),
        option<&R::law>("law", "decay of the attraction with the gap")
            .one_of(Asked<answers::InteractionRequest>::laws)
            .default_shown()
            .advanced(),
        option<&R::seeds>("seeds", "number of patches of each kind")
            .within(domain::positive)
            .default_shown()
            .advanced(),
        option<&R::seed>("seed", "seed of the first patch; further patches use the next numbers")
            .default_shown()
            .advanced(),
        option<&R::loops>("loops", "whole loops as well, which take minutes instead of seconds"),
    };
};
