// SPDX-License-Identifier: GPL-3.0-or-later
#include "answer.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

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

/// Result of the test of the full-contact balance.
std::string sentences_of_test(const adhesion::PredictionTest& test) {
    if (test.probability >= improbable)
        return fmt::format("Roughness explains the loss of adhesion on approach within the errors ({}, {}).",
                           pairs_text(test.n), test_text(test));
    auto text = fmt::format(
        "Roughness does not explain the loss of adhesion on approach within the errors: the full-contact balance (Eq. "
        "7) does not fit {} ({}).",
        test.n == 1 ? "the pair" : fmt::format("the {} pairs", test.n), test_text(test));
    if (test.extra_scatter > 0.0 && test.probability_with_scatter >= improbable)
        text += fmt::format(" It fits with an additional scatter of {} between pairs.",
                            format_value(test.extra_scatter, "J/m2", 2));
    return text;
}

/// W_int from the loss, compared with that of approach.
std::string sentence_of_loss(const StudyResult& result) {
    if (!result.loop) return "";
    const auto loss = work_of(result.loop->through_origin);
    const auto number = format_interval(loss, "J/m2");
    const auto sentence = fmt::format("The energy loss of loops gives W_int = {}", number);
    if (!result.modified) return sentence + ".";
    const auto excess = *loss_minus_approach(result);
    if (!interval_of(excess)) return sentence + ".";
    if (!may_be_zero(excess))
        return fmt::format(
            "{}, which differs from the W_int of approach. By generalised least squares, with correlated "
            "errors, the difference is {}.",
            sentence, format_uncertain(excess, "J/m2"));
    if (could_have_refused(excess, result)) return sentence + ", consistent with the W_int of approach.";
    return fmt::format("{}. The data of {} cannot decide whether this agrees with the W_int of approach.", sentence,
                       pairs_text(result.loop->through_origin.n));
}

/// The model that is likeliest by all measured pairs; empty where none was ranked.
std::string sentence_of_retraction(const study::Hysteresis& h) {
    const auto* best = h.all.best();
    if (!best) return "";
    const auto& model = best->fitted.model;
    const auto fitted =
        model.fitted() ? fmt::format(" ({} = {})", model.parameter().symbol, fitted_number(*best)) : std::string();
    const auto others = h.all.possible().size() - 1;
    const std::string beside =
        h.all.all_refused() ? "Every model is off by a constant."
        : others > 0        ? fmt::format("{} cannot be excluded.", counted(others, "other model", "other models"))
                            : "This model is clearly better than every other model.";
    auto text = fmt::format(
        "Retraction: the model {}, W_ret = {}, describes W_ret at pull-off of {} best{}. Leaving out one surface at a "
        "time, this model predicts that surface to {} (rms). {}",
        model.name(), model.formula(), pairs_text(h.measured_pairs), fitted,
        format_value(best->surface_left_out, "J/m2", 2), beside);
    for (const auto& sentence : smooth_limit_sentences(h)) text += " " + sentence + ".";
    return text;
}

/// Where W_int in proportion to the smooth references describes the approach better than one W_int.
std::string sentence_of_references(const StudyResult& result) {
    const auto& scaled = result.reference_scaled;
    if (!scaled || !result.modified || !result.hysteresis) return "";
    const auto& compared = result.hysteresis->all.proportional_work;
    using hysteresis::Distinction;
    if (!compared || !(compared->elastomers_left_out.value > hysteresis::better_odds)) return "";
    const auto words = [](Distinction distinction, const char* otherwise) {
        return distinction == Distinction::cannot_be_distinguished ? otherwise : hysteresis::name_of(distinction);
    };
    return fmt::format(
        "W_int in proportion to W_app of each elastomer's smooth reference gives R² = {:.2f} instead of {:.2f} on the same "
        "pairs. Compared with one W_int, this form is {} on elastomers left out and {} on both branches.",
        scaled->r_squared, result.modified->r_squared,
        words(compared->elastomers_left_out.distinction(), "more likely, but not distinguished,"),
        words(compared->both_branches.distinction(), "not distinguished"));
}

/// Predicted loss of loops with the measured works, compared with the published energies; empty without them.
std::string sentence_of_energies(const StudyResult& result) {
    const auto& slope = result.loss_slope_of_works;
    const auto reported = std::ranges::find_if(result.study.reported, [](const auto& value) {
        return value.fit == "loop" && value.quantity == "work_of_adhesion";
    });
    if (!slope || reported == result.study.reported.end()) return "";
    return fmt::format(
        "Loops with these W_app and W_ret would lose {} per unit true area; the reported value is {}. W_ret at pull-off {} "
        "the work of the whole retraction.",
        format_uncertain(slope->work_per_true_area, "J/m2"), format_uncertain(reported->value, "J/m2"),
        may_be_zero(difference(slope->work_per_true_area, reported->value)) ? "may be" : "is not");
}

/// W_int with its interval: fitted to the pairs, or given.
std::string sentence_of_work(const StudyResult& result) {
    if (!result.modified)
        return fmt::format("The given W_int is {}.", format_interval(*result.work_of_adhesion, "J/m2"));
    const auto work =
        format_interval(result.study.work_of_adhesion ? work_of(*result.modified) : *result.work_of_adhesion, "J/m2");
    if (result.prediction_test) return fmt::format("W_int = {}.", work);
    return fmt::format("The fit to {} gives W_int = {}.", pairs_text(result.modified->n), work);
}

/// Conclusions from measured and predicted works of adhesion: whether roughness explains the approach, W_int,
/// retraction, further results; empty without measurements.
std::vector<std::string> sentences_of_approach(const StudyResult& result) {
    const bool fitted = static_cast<bool>(result.modified);
    if (!result.prediction_test && !fitted) return {};
    const std::string asked = result.prediction_test
                                  ? sentences_of_test(*result.prediction_test)
                                  : "The data do not test whether roughness explains the loss of adhesion on approach.";
    std::vector<std::string> sentences{asked + " " + sentence_of_work(result)};
    const auto add = [&sentences](std::string sentence) {
        if (!sentence.empty()) sentences.push_back(std::move(sentence));
    };
    add(sentence_of_loss(result));
    if (result.hysteresis) add(sentence_of_retraction(*result.hysteresis));
    add(sentence_of_energies(result));
    add(sentence_of_references(result));
    if (const auto budgets = budgets_of(result);
        fitted && !budgets.empty() && budgets.front().quantity == "intrinsic_work_of_adhesion")
        add(budget_sentence(budgets.front()) + ".");
    return sentences;
}

/// W_app of pairs that were not measured.
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
    const auto predicted = [&](const study::PairResult* pair) {
        const auto answer = study::recommended_answer(*pair);
        return fmt::format("{} for {} ({:.3g} % of the area in contact)",
                           format_uncertain(answer.work_of_adhesion, "J/m2"), name(pair),
                           100.0 * answer.area_fraction.value);
    };
    if (pairs.size() == 1)
        return {fmt::format("The predicted W_app is {}. No experiment tests this prediction.", predicted(*most))};
    return {fmt::format("The predicted W_app ranges from {} to {}. No experiment tests these predictions.",
                        predicted(*least), predicted(*most))};
}

std::vector<std::string> sentences_of_roughness(const StudyResult& result) {
    std::vector<std::string> sentences;
    for (const auto& surface : result.surfaces) {
        if (surface.failed()) continue;
        const auto& spectrum = surface.used();
        sentences.push_back(
            fmt::format("{}: h_rms = {}, h'_rms = {}, A_true/A_app = {}.", surface.name,
                        format_uncertain(spectrum.estimate([](const auto& p) { return p.rms_height; }), "m"),
                        format_uncertain(spectrum.estimate([](const auto& p) { return p.rms_slope; }), "1"),
                        format_uncertain(spectrum.estimate([](const auto& p) { return p.area_ratio(); }, 1.0), "1")));
        if (sentences.size() == 3) break;
    }
    return sentences;
}

/// Measured values of studies with one or two measured pairs, where a fit says little.
std::vector<std::string> sentences_of_measured(const StudyResult& result) {
    constexpr std::size_t max_pairs = 2;
    std::vector<std::string> sentences;
    for (const auto& pair : result.pairs) {
        std::vector<std::string> values;
        const auto add = [&](const char* name, const std::optional<Estimate>& value, const char* unit) {
            if (value) values.push_back(fmt::format("{} = {}", name, format_uncertain(*value, unit)));
        };
        add("W_app", pair.approach, "J/m2");
        add("W_ret", pair.retraction, "J/m2");
        add("E_loss", pair.loss, "J");
        if (values.empty()) continue;
        sentences.push_back(
            fmt::format("Measured with {} on {}: {}.", pair.elastomer, pair.surface, fmt::join(values, ", ")));
    }
    if (sentences.size() > max_pairs) sentences.clear();
    return sentences;
}

}  // namespace

std::string pairs_text(int n) { return counted(static_cast<std::size_t>(n), "pair", "pairs"); }

std::string test_text(const adhesion::PredictionTest& test) {
    return fmt::format(
        "χ² = {:.1f} for {}, p = {}", test.chi_squared,
        counted(static_cast<std::size_t>(test.degrees_of_freedom), "degree of freedom", "degrees of freedom"),
        probability_text(test.probability));
}

std::optional<Estimate> loss_minus_approach(const StudyResult& result) {
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
                                   ? "Loops were analysed. Without an analysed surface, nothing is predicted for them."
                                   : "Nothing can be concluded: no part of the study gave a result.");
    const auto measured = sentences_of_measured(result);
    sentences.insert(sentences.begin(), measured.begin(), measured.end());
    return sentences;
}

}  // namespace setae::output
