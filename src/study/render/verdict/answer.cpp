// SPDX-License-Identifier: GPL-3.0-or-later
#include "answer.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "setae/core/uncertain_text.hpp"
#include "setae/core/units.hpp"
#include "setae/core/words.hpp"
#include "setae/output/budget.hpp"
#include "setae/output/hysteresis_output.hpp"
#include "setae/study/contact_answers.hpp"
#include "tables/smooth_limit_output.hpp"

namespace setae::output {
namespace {

using study::StudyResult;

/// Whether the full-contact balance says what was measured.
std::string sentence_of_test(const adhesion::PredictionTest& test) {
    if (test.probability >= improbable) return "Roughness explains the work of adhesion on approach";
    auto text = fmt::format(
        "Roughness alone does not explain the work of adhesion on approach: the full-contact "
        "balance (Eq. 7) misses {} ({})",
        test.n == 1 ? "the pair" : fmt::format("the {} pairs", test.n), test_text(test));
    if (test.extra_scatter > 0.0 && test.probability_with_scatter >= improbable)
        text += fmt::format("; they scatter by {} more than their errors", format_value(test.extra_scatter, "J/m2", 2));
    return text;
}

/// W_int of loss beside that of approach.
std::string sentence_of_loss(const StudyResult& result) {
    if (!result.loop) return "";
    const auto loss = work_of(result.loop->through_origin);
    const auto number = format_interval(loss, "J/m2");
    if (!result.modified) return fmt::format("By the energy loss, W_int is {}.", number);
    const auto apart = *loss_less_approach(result);
    if (!interval_of(apart)) return fmt::format("The energy loss gives {}.", number);
    if (!may_be_zero(apart))
        return fmt::format("The energy loss gives {}: {} apart.", number, format_uncertain(apart, "J/m2"));
    return could_have_refused(apart, result)
               ? fmt::format("The energy loss gives {}: consistent.", number)
               : fmt::format("The energy loss gives {}: {} cannot tell whether that is the W_int of approach.", number,
                             pairs_text(result.loop->through_origin.n));
}

/// The model that is likeliest by all measured pairs; empty where none was ranked.
std::string sentence_of_retraction(const study::Hysteresis& h) {
    const auto* best = h.all.best();
    if (!best) return "";
    const auto& model = best->fitted.model;
    const auto fitted =
        model.fitted() ? fmt::format(", {} {}", model.parameter().symbol, fitted_number(*best)) : std::string();
    const auto others = h.all.possible().size() - 1;
    const std::string beside =
        h.all.all_refused() ? "every model is off by a constant"
        : others > 0        ? fmt::format("{} cannot be excluded", counted(others, "other model", "other models"))
                            : "clearly better than every other model";
    auto text = fmt::format(
        "On retraction the likeliest model of W_ret at pull-off is {}{}: it misses surfaces left out by {} ({}, {}).",
        model.formula(), fitted, format_value(best->surface_left_out, "J/m2", 2), pairs_text(h.measured_pairs), beside);
    for (const auto& sentence : smooth_limit_sentences(h)) text += " " + sentence + ".";
    return text;
}

/// Where W_int in proportion to the smooth references says the approach better than one W_int.
std::string sentence_of_references(const StudyResult& result) {
    const auto& scaled = result.reference_scaled;
    if (!scaled || !result.modified || !result.hysteresis) return "";
    const auto& compared = result.hysteresis->all.proportional_work;
    using hysteresis::Distinction;
    if (!compared || !(compared->elastomers_left_out.value > hysteresis::better_odds)) return "";
    const auto surely = compared->elastomers_left_out.distinction();
    const bool both = compared->both_branches.distinction() != Distinction::cannot_be_distinguished;
    return fmt::format(
        "W_int in proportion to each elastomer's smooth reference (tried on the same pairs): R² {:.2f}, not {:.2f}; {} on "
        "elastomers left out; {} on both branches.",
        scaled->r_squared, result.modified->r_squared,
        surely == Distinction::cannot_be_distinguished ? "likelier, not surely," : hysteresis::name_of(surely),
        both ? hysteresis::name_of(compared->both_branches.distinction()) : "cannot be distinguished");
}

/// What loops with the measured works would lose, beside what is reported of energies; empty without a report.
std::string sentence_of_energies(const StudyResult& result) {
    const auto& slope = result.loss_slope_of_works;
    const auto reported = std::ranges::find_if(result.study.reported, [](const auto& value) {
        return value.fit == "loop" && value.quantity == "work_of_adhesion";
    });
    if (!slope || reported == result.study.reported.end()) return "";
    return fmt::format(
        "Loops with these W_app and W_ret would lose {} per true area, {} are reported: W_ret at pull-off {} over the whole "
        "retraction.",
        format_uncertain(slope->work_per_true_area, "J/m2"), format_uncertain(reported->value, "J/m2"),
        may_be_zero(difference(slope->work_per_true_area, reported->value)) ? "may hold" : "does not hold");
}

/// What measured and predicted works of adhesion say together; empty where nothing was measured.
std::vector<std::string> sentences_of_approach(const StudyResult& result) {
    const bool fitted = static_cast<bool>(result.modified);
    if (!result.prediction_test && !fitted) return {};
    std::string text;
    if (result.prediction_test) text = sentence_of_test(*result.prediction_test);
    const bool explained = result.prediction_test && result.prediction_test->probability >= improbable;
    if (fitted) {
        const auto work = format_interval(
            result.study.work_of_adhesion ? work_of(*result.modified) : *result.work_of_adhesion, "J/m2");
        if (text.empty())
            text = fmt::format("W_int is {} from {}; nothing tests the full-contact balance (Eq. 7)", work,
                               pairs_text(result.modified->n));
        else text += fmt::format("{}W_int {}", explained ? ": " : ". ", work);
    } else {
        text += fmt::format("{}W_int {}, as given", explained ? ": " : ". ",
                            format_interval(*result.work_of_adhesion, "J/m2"));
    }
    if (explained)
        text += fmt::format(" ({}, {})", pairs_text(result.prediction_test->n), test_text(*result.prediction_test));
    std::vector<std::string> sentences{text + "."};
    if (const auto budgets = budgets_of(result);
        fitted && !budgets.empty() && budgets.front().quantity == "work_of_adhesion")
        sentences.push_back(budget_sentence(budgets.front()) + ".");
    if (auto loss = sentence_of_loss(result); !loss.empty()) sentences.push_back(std::move(loss));
    if (result.hysteresis) {
        if (auto references = sentence_of_references(result); !references.empty())
            sentences.push_back(std::move(references));
        if (auto back = sentence_of_retraction(*result.hysteresis); !back.empty()) sentences.push_back(std::move(back));
    }
    if (auto energies = sentence_of_energies(result); !energies.empty()) sentences.push_back(std::move(energies));
    return sentences;
}

/// W_app of pairs that nobody measured.
std::vector<std::string> sentences_of_prediction(const StudyResult& result) {
    std::vector<const study::PairResult*> pairs;
    for (const auto& pair : result.pairs)
        if (pair.modified) pairs.push_back(&pair);
    if (pairs.empty()) return {};
    const auto work = [](const study::PairResult* pair) {
        return study::recommended_answer(*pair).work_of_adhesion.value;
    };
    const auto name = [](const study::PairResult* pair) {
        return fmt::format("{} on {}", pair->elastomer, pair->surface);
    };
    const auto [least, most] =
        std::minmax_element(pairs.begin(), pairs.end(), [&](auto a, auto b) { return work(a) < work(b); });
    const auto said = [](const study::PairResult* pair) {
        const auto answer = study::recommended_answer(*pair);
        return fmt::format("{} on {:.3g} % of the area", format_uncertain(answer.work_of_adhesion, "J/m2"),
                           100.0 * answer.area_fraction.value);
    };
    auto text = fmt::format("Predicted: W_app of {} is {}", name(*most), said(*most));
    if (pairs.size() > 1) text += fmt::format(", of {} {}", name(*least), said(*least));
    return {text + "; no experiment tests it."};
}

std::vector<std::string> sentences_of_roughness(const StudyResult& result) {
    std::vector<std::string> sentences;
    for (const auto& surface : result.surfaces) {
        if (surface.failed()) continue;
        const auto& spectrum = surface.used();
        sentences.push_back(
            fmt::format("{}: h_rms {}, h'_rms {}, A_true/A_app {}.", surface.name,
                        format_uncertain(spectrum.estimate([](const auto& p) { return p.rms_height; }), "m"),
                        format_uncertain(spectrum.estimate([](const auto& p) { return p.rms_slope; }), "1"),
                        format_uncertain(spectrum.estimate([](const auto& p) { return p.area_ratio(); }, 1.0), "1")));
        if (sentences.size() == 3) break;
    }
    return sentences;
}

}  // namespace

std::string pairs_text(int n) { return counted(static_cast<std::size_t>(n), "pair", "pairs"); }

std::string test_text(const adhesion::PredictionTest& test) {
    return fmt::format("χ² {:.1f} of {}, p = {}", test.chi_squared, test.degrees_of_freedom,
                       probability_text(test.probability));
}

std::optional<Estimate> loss_less_approach(const StudyResult& result) {
    if (!result.loop || !result.modified) return std::nullopt;
    const auto &loss = result.loop->through_origin.generalised.work_of_adhesion,
               &approach = result.modified->generalised.work_of_adhesion;
    return TracedValue{loss.value - approach.value, combined({{1.0, loss.components}, {-1.0, approach.components}})}
        .estimate();
}

bool could_have_refused(const Estimate& difference, const StudyResult& result) {
    const auto interval = interval_of(difference);
    constexpr double share = 0.5;  // of W_int: a difference as large would have shown
    return interval && result.work_of_adhesion &&
           0.5 * (interval->upper - interval->lower) < share * result.work_of_adhesion->value &&
           result.loop->through_origin.r_squared > 0.0;
}

bool may_be_zero(const Estimate& difference) {
    const auto interval = interval_of(difference);
    return interval && interval->lower <= 0.0 && interval->upper >= 0.0;
}

Estimate work_of(const adhesion::WorkFit& fit) { return fit.stated(); }

std::vector<std::string> answer_of(const StudyResult& result) {
    auto sentences = sentences_of_approach(result);
    if (sentences.empty()) sentences = sentences_of_prediction(result);
    if (sentences.empty()) sentences = sentences_of_roughness(result);
    if (sentences.empty())
        sentences.emplace_back(result.successes() > 0
                                   ? "Loops were analysed; no surface says what they should be."
                                   : "Nothing can be concluded: no part of the study gave a result.");
    return sentences;
}

}  // namespace setae::output
