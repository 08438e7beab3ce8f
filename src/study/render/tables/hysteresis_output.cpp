// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/output/hysteresis_output.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "setae/core/layout.hpp"
#include "setae/core/uncertain_text.hpp"
#include "setae/core/units.hpp"
#include "setae/core/words.hpp"
#include "setae/output/field_table.hpp"
#include "smooth_limit_output.hpp"

namespace setae::output {
namespace {

using hysteresis::EnergyShares;
using hysteresis::ModelScore;
using hysteresis::Ranking;
using tables::TidyTable;

constexpr double milli = 1e-3, micro = 1e-6, nano = 1e-9;

struct NamedRanking {
    const char* name;  ///< as a choice
    std::string words;
    const Ranking& ranking;
};

/// " (7 to 13 within their ±)"; empty where inputs leave no choice.
std::string range_of_conforming(const study::Hysteresis& h) {
    const auto& range = h.conforming_range;
    return range.lower == range.upper ? "" : fmt::format(" ({} to {} within their ±)", range.lower, range.upper);
}

/// The one of pairs in full contact only where it differs.
std::vector<NamedRanking> rankings_of(const study::Hysteresis& h) {
    std::vector<NamedRanking> list;
    if (h.conforming_pairs < h.measured_pairs && h.conforming.best())
        list.push_back({"conforming_pairs",
                        fmt::format("{}{} in spontaneous full contact",
                                    counted(static_cast<std::size_t>(h.conforming_pairs), "pair", "pairs"),
                                    range_of_conforming(h)),
                        h.conforming});
    if (h.all.best())
        list.push_back(
            {"all_pairs",
             fmt::format(
                 "all {} pairs{}", h.measured_pairs,
                 h.conforming_pairs < h.measured_pairs ? ", each with the contact area of simulated patches" : ""),
             h.all});
    if (h.by_area.best())
        list.push_back({"loop_areas",
                        fmt::format("{}, from the energy loss",
                                    counted(static_cast<std::size_t>(h.pairs_by_area), "loop", "loops")),
                        h.by_area});
    return list;
}

std::string work(double value) { return fmt::format("{:.3g} mJ/m²", value / milli); }

/// k and N of simulated fronts on both branches of the pairs of a ranking.
std::string pinning_cell(const study::Hysteresis& h, const Ranking& ranking) {
    double k_min = INFINITY, k_max = 0.0, least = INFINITY, most = 0.0;
    for (const auto& pair : h.pairs) {
        if (!pair.pinning || !pair.measured_retraction || (&ranking == &h.conforming && !pair.conforms)) continue;
        for (const auto* branch : {&pair.pinning->approach, &pair.pinning->retraction}) {
            k_min = std::min(k_min, branch->coefficient.value);
            k_max = std::max(k_max, branch->coefficient.value);
            least = std::min(least, branch->larkin_lengths);
            most = std::max(most, branch->larkin_lengths);
        }
    }
    if (k_max == 0.0) return "";
    return fmt::format("k {:.1f}…{:.1f}, N {:.0f}…{:.0f}", k_min, k_max, least, most);
}

/// θ as columns have it, works in mJ/m².
std::string parameter_cell(const study::Hysteresis& h, const Ranking& ranking, const ModelScore& score) {
    if (score.fitted.model.law == hysteresis::Law::pinning) return pinning_cell(h, ranking);
    if (!score.fitted.model.fitted()) return "";
    const auto parameter = score.fitted.model.parameter();
    return fmt::format("{} {}", parameter.symbol,
                       uncertain_number(score.fitted.parameter.estimate(), parameter.unit == "1" ? 1.0 : milli));
}

std::string parameter_text(const ModelScore& score) {
    if (!score.fitted.model.fitted()) return "";
    const auto parameter = score.fitted.model.parameter();
    return fmt::format("{} = {}", parameter.symbol, fitted_number(score));
}

/// "opening_work (21 mJ/m²)"
std::string with_miss(const ModelScore& score) {
    return fmt::format("{} ({})", score.fitted.model.name(), work(score.surface_left_out));
}

/// Result of a ranking: the most likely model, those that cannot be excluded, and those with a constant error.
std::string best_sentence(const NamedRanking& of) {
    const auto& best = *of.ranking.best();
    const auto parameter = parameter_text(best);
    const bool refused_all = of.ranking.all_refused();
    auto text = fmt::format(
        "For {}, the model {} fits W_ret at pull-off best{}: W_ret = {}{}. Leaving out one surface at a time, this model "
        "predicts that surface to {} (rms)",
        of.words, best.fitted.model.name(), refused_all ? ", although every model is off by a constant" : "",
        best.fitted.model.formula(), parameter.empty() ? "" : " with " + parameter, work(best.surface_left_out));
    std::vector<std::string> possible, refused;
    for (const auto* score : of.ranking.possible())
        if (score != &best) possible.push_back(with_miss(*score));
    for (const auto& score : of.ranking.models)
        if (score.bias.refuses_model) refused.push_back(score.fitted.model.name());
    text += possible.empty() ? ". This model is clearly better than every other model"
                             : fmt::format(". These models cannot be excluded: {}", fmt::join(possible, ", "));
    if (!refused.empty() && !refused_all)
        text += fmt::format(". These models are off by a constant on all pairs and are refused: {}",
                            fmt::join(refused, ", "));
    return text;
}

std::string deciding_sentence(const study::DecidingPair& pair) {
    constexpr double apart = 2.0;
    const auto difference =
        fmt::format("{} on {}: W_ret at pull-off would be {} or {}, {:.2g} standard errors apart", pair.elastomer,
                    pair.surface, work(pair.first_work), work(pair.second_work), pair.standard_errors);
    const auto uncertain =
        pair.largest_input.empty()
            ? ""
            : fmt::format(". The largest uncertainty of this difference comes from {}", pair.largest_input);
    if (pair.standard_errors >= apart)
        return fmt::format("The pair that best distinguishes {} from {} is {}{}", pair.first, pair.second, difference,
                           uncertain);
    return fmt::format("No pair of the study distinguishes {} from {}. The largest difference is for {}{}", pair.first,
                       pair.second, difference, uncertain);
}

/// One digit, at most "> 10⁴": odds are not known better.
std::string odds_number(double odds) {
    if (odds > 1e4) return "> 10⁴";
    if (odds < 1.0) return "< 1";
    const double unit = std::pow(10.0, std::floor(std::log10(odds)));
    return fmt::format("{:.0f}", std::round(odds / unit) * unit);
}

/// "200 : 1 [20, 1000]"; an end of the interval that is written like the value is left out: "> 10⁴ : 1 [≥ 300]", "1 :
/// 1".
std::string odds_text(const hysteresis::Odds& odds) {
    const auto value = odds_number(odds.value), lower = odds_number(odds.lower), upper = odds_number(odds.upper);
    const auto text = value + " : 1";
    if (lower == value && upper == value) return text;
    if (upper == value) return fmt::format("{} [≥ {}]", text, lower);
    if (lower == value) return fmt::format("{} [≤ {}]", text, upper);
    return fmt::format("{} [{}, {}]", text, lower, upper);
}

/// Comparison of a model with the most likely one.
std::string verdict_cell(const Ranking& ranking, const ModelScore& score) {
    if (score.bias.refuses_model) return fmt::format("constant error {}", uncertain_number(score.bias.value, milli));
    if (&score == ranking.best()) return "most likely";
    switch (score.odds_against.distinction()) {
        case hysteresis::Distinction::clearly_better: return "clearly worse";
        case hysteresis::Distinction::better: return "worse";
        case hysteresis::Distinction::cannot_be_distinguished: return "not distinguished";
    }
    return "";
}

/// Models for a reader, those that cannot be ranked below the others.
TidyTable shown_models(const study::Hysteresis& h, const NamedRanking& of) {
    TidyTable table{fmt::format("models of W_ret at pull-off, {}", of.words),
                    {"model", "fitted [mJ/m²]", "left-out error [mJ/m²]", "odds against it", "rating"},
                    {}};
    const auto in_milli = [](double value) { return fmt::format("{:.1f}", value / milli); };
    for (const auto& s : of.ranking.models)
        table.rows.push_back({s.fitted.model.name(), parameter_cell(h, of.ranking, s), in_milli(s.surface_left_out),
                              odds_text(s.odds_against), verdict_cell(of.ranking, s)});
    for (const auto& u : of.ranking.unranked)
        table.rows.push_back({u.model.name(), u.reason, std::string(), std::string(), std::string()});
    return table;
}

std::string in_unit(const TracedValue& value, double unit) { return uncertain_number(value.estimate(), unit); }

/// By which model, and which more likely one is shown with it.
struct Answered {
    std::string by, likelier;

    friend bool operator==(const Answered&, const Answered&) = default;
};

/// Pairs by one model.
TidyTable shown_pairs(const Answered& answered, const std::vector<const study::PairHysteresis*>& pairs) {
    static constexpr auto view = fields::view_of<study::PairHysteresis>({
        {"W_app", "work_of_adhesion_approach", milli},
        {"W_ret at pull-off", "work_of_adhesion_retraction", milli},
        {"measured", "measured", milli},
        {"pull-off", "pull_off_force", milli},
        {"E_loss", "energy_loss", nano},
        {"more likely", "likelier.work_of_adhesion_retraction", milli},
    });
    const auto shown = std::span(view).first(view.size() - (answered.likelier.empty() ? 1 : 0));
    TidyTable table{
        fmt::format("predicted from roughness only, by {} [mJ/m², mN, nJ]", answered.by), {"pair", "contact"}, {}};
    if (!answered.likelier.empty())
        table.title += fmt::format("; last column: W_ret by the more likely {}", answered.likelier);
    for (const auto& column : shown) table.columns.emplace_back(column.heading);
    for (const auto* p : pairs) {
        auto& row = table.rows.emplace_back();
        row = {fmt::format("{} × {}", p->surface, p->elastomer), fmt::format("{:.2f}", p->contact_fraction)};
        put_shown_cells(row, *p, shown);
    }
    return table;
}

std::string shown_pairs(const study::Hysteresis& h, std::size_t width) {
    std::vector<std::pair<Answered, std::vector<const study::PairHysteresis*>>> by_law;
    for (const auto& p : h.pairs) {
        const Answered law{p.model.name(), p.likelier ? p.likelier->model.name() : ""};
        auto place = std::find_if(by_law.begin(), by_law.end(), [&](const auto& entry) { return entry.first == law; });
        if (place == by_law.end()) place = by_law.insert(by_law.end(), {law, {}});
        place->second.push_back(&p);
    }
    std::string text;
    for (const auto& [law, pairs] : by_law) text += "\n" + tables::as_text_within(shown_pairs(law, pairs), width);
    return text;
}

/// Differences between records and predicted loops; empty without records.
std::string shown_residuals(const study::Hysteresis& h, std::size_t width) {
    TidyTable table{"record minus predicted loop: rms of the force at equal displacement [µN]",
                    {"pair", "approach", "retraction", "largest force"},
                    {}};
    const auto in_micro = [](double force) { return fmt::format("{:.3g}", force / micro); };
    for (const auto& p : h.pairs)
        if (p.residuals)
            table.rows.push_back({fmt::format("{} × {}", p.surface, p.elastomer), in_micro(p.residuals->approach),
                                  in_micro(p.residuals->retraction), in_micro(p.residuals->largest_force)});
    return table.rows.empty() ? "" : "\n" + tables::as_text_within(table, width);
}

/// Names of the models that measured loops are decomposed by.
std::vector<std::string> decomposing_models(const study::Hysteresis& h) {
    std::vector<std::string> names;
    for (const auto& p : h.pairs)
        if (p.decomposition && std::ranges::find(names, p.decomposition->model) == names.end())
            names.push_back(p.decomposition->model);
    return names;
}

/// Contributions without their standard errors, which the JSON contains, so that a row fits into one line.
TidyTable shown_losses(const study::Hysteresis& h) {
    TidyTable table{fmt::format("energy budget of the loops, by {} [nJ]", fmt::join(decomposing_models(h), " and ")),
                    {"pair", "E_loss"},
                    {}};
    std::vector<TracedValue EnergyShares::*> shown;  // that of the bulk only where an elastomer's relaxes
    for (const auto& [name, share] : EnergyShares::all()) {
        const bool some = std::ranges::any_of(
            h.pairs, [&](const auto& p) { return p.decomposition && (p.decomposition->shares.*share).value != 0.0; });
        if (share == &EnergyShares::bulk && !some) continue;
        table.columns.emplace_back(name);
        shown.push_back(share);
    }
    table.columns.emplace_back("unexplained");
    for (const auto& p : h.pairs) {
        if (!p.decomposition) continue;
        const auto& d = *p.decomposition;
        std::vector<TidyTable::Cell> row{fmt::format("{} × {}", p.surface, p.elastomer),
                                         in_unit(d.measured, nano) + (d.of_works ? " *" : "")};
        for (const auto share : shown) row.emplace_back(fmt::format("{:.3g}", (d.shares.*share).value / nano));
        row.emplace_back(in_unit(d.unexplained, nano));
        table.rows.push_back(std::move(row));
    }
    return table;
}

TidyTable shown_trials(const study::Hysteresis& h) {
    TidyTable table{fmt::format("ranking of {} simulated studies of each true model, with every ± of this study",
                                h.trials.front().runs),
                    {"true model", "found", "possible", "excluded", "most frequent other"},
                    {}};
    for (const auto& trial : h.trials)
        table.rows.push_back({trial.true_model.name(), fmt::format("{}", trial.found),
                              fmt::format("{}", trial.possible), fmt::format("{}", trial.excluded), trial.most_taken});
    return table;
}

std::string speed_text(const Estimate& speed) { return uncertain_number(speed, 1e-6) + " µm/s"; }

/// One line per elastomer with a rate-dependent contact edge or a bulk that relaxes.
std::string shown_times(const study::Hysteresis& h) {
    std::string text;
    for (const auto& times : h.elastomers) {
        if (const auto& edge = times.edge) {
            const auto& law = edge->law;
            text += fmt::format("edge on {}: W_ret(v) = φ W [1 + (v/v0)^n], φ {}, v0 {}, n {}; {}\n", times.elastomer,
                                uncertain_number(law.rest_factor.estimate()),
                                speed_text(law.reference_speed.estimate()), uncertain_number(law.exponent.estimate()),
                                edge->references == 0 ? std::string("as stated")
                                                      : "from " + counted(static_cast<std::size_t>(edge->references),
                                                                          "reference", "references"));
        }
        if (times.relaxation.empty()) continue;
        std::vector<std::string> terms;
        for (const auto& term : times.relaxation)
            terms.push_back(fmt::format("{} in {}", uncertain_number(term.share.estimate()),
                                        format_uncertain(term.time.estimate(), "s")));
        text += fmt::format("bulk of {}: relaxes by {} of E∞\n", times.elastomer, fmt::join(terms, ", "));
    }
    return text.empty() ? text : "\n" + text;
}

/// Shares of which only the sum is known, with the pairs concerned.
std::string shown_not_distinguished(const study::Hysteresis& h, std::size_t width) {
    std::vector<std::pair<std::string, std::vector<std::string>>> found;
    for (const auto& p : h.pairs) {
        if (!p.decomposition) continue;
        for (const auto& shares : p.decomposition->indistinguishable) {
            auto place = std::ranges::find_if(found, [&](const auto& entry) { return entry.first == shares; });
            if (place == found.end()) place = found.insert(found.end(), {shares, {}});
            place->second.push_back(fmt::format("{} × {}", p.surface, p.elastomer));
        }
    }
    std::string text;
    for (const auto& [shares, pairs] : found)
        text += wrapped(fmt::format("the sum of {} is known at least three times better than each share, for {}",
                                    shares, fmt::join(pairs, ", ")),
                        width, 2) +
                "\n";
    return text;
}

/// Inputs before and after the joint fit of all loops.
std::string shown_joint(const study::Hysteresis& h, std::size_t width) {
    if (!h.joint) return "";
    const auto& joint = *h.joint;
    std::vector<std::string> what;
    if (joint.energies > 0) what.push_back(counted(static_cast<std::size_t>(joint.energies), "energy", "energies"));
    if (joint.works > 0) what.push_back(counted(static_cast<std::size_t>(joint.works), "work", "works"));
    auto sentence = fmt::format("joint fit of {}: χ² = {:.3g} for {} values", fmt::join(what, " and "), joint.chi2,
                                joint.energies + joint.works);
    if (joint.energies > 0)
        sentence += fmt::format("; the energies have an additional scatter of {}", work(joint.unexplained_per_area));
    const auto text = "\n" + wrapped(sentence, width, 2) + "\n";
    TidyTable table{"inputs before and after the joint fit", {"input", "before", "after"}, {}};
    for (const auto& input : joint.inputs) {
        const auto shown = [&](const Estimate& value) {
            if (input.unit == "m/s") return speed_text(value);
            return input.unit == "1" ? uncertain_number(value) : format_uncertain(value, input.unit);
        };
        table.rows.push_back({input.name, shown(input.before), shown(input.after)});
    }
    return text + tables::as_text_within(table, width) + shown_not_distinguished(h, width);
}

}  // namespace

std::string fitted_number(const ModelScore& score) {
    const auto unit = score.fitted.model.parameter().unit;
    const auto estimate = score.fitted.parameter.estimate();
    return unit == "1" ? uncertain_number(estimate) : format_uncertain(estimate, unit);
}

std::vector<std::string> hysteresis_sentences(const study::Hysteresis& h) {
    std::vector<std::string> sentences;
    for (const auto& ranking : rankings_of(h)) sentences.push_back(best_sentence(ranking));
    if (sentences.empty())
        sentences.push_back(fmt::format(
            "W_app and W_ret are measured for {}; a ranking of retraction models needs at least {} pairs on {} surfaces. The "
            "predictions below are a lower bound, W_ret = W_app",
            counted(static_cast<std::size_t>(h.measured_pairs), "pair", "pairs"), hysteresis::min_ranked_pairs,
            hysteresis::min_ranked_surfaces));
    for (auto& sentence : smooth_limit_sentences(h)) sentences.push_back(std::move(sentence));
    if (h.deciding) sentences.push_back(deciding_sentence(*h.deciding));
    for (auto& sentence : sentences) sentence += ".";
    return sentences;
}

std::string hysteresis_answer(const study::Hysteresis& h, std::size_t width) {
    std::string text;
    for (const auto& sentence : hysteresis_sentences(h)) text += wrapped(sentence, width, 2) + "\n";
    return text;
}

std::string hysteresis_text(const study::Hysteresis& h, std::size_t width) {
    auto text = hysteresis_answer(h, width);
    for (const auto& ranking : rankings_of(h)) text += "\n" + tables::as_text_within(shown_models(h, ranking), width);
    if (!h.trials.empty()) text += "\n" + tables::as_text_within(shown_trials(h), width);
    text += shown_times(h) + shown_pairs(h, width) + shown_residuals(h, width);
    for (const auto& s : h.skipped) text += fmt::format("{} × {}: {}\n", s.surface, s.elastomer, s.reason);
    if (!h.smooth_limits.empty()) text += "\n" + tables::as_text_within(smooth_limit_table(h), width);
    const auto losses = shown_losses(h);
    if (losses.rows.empty()) return text;
    text += "\n" + tables::as_text_within(losses, width);
    if (std::ranges::any_of(h.pairs, [](const auto& p) { return p.decomposition && p.decomposition->of_works; }))
        text += "* from W_app, W_ret at pull-off and the contact area; the measured loop energy is not known\n";
    return text + shown_joint(h, width);
}

TidyTable model_table(const study::Hysteresis& h) {
    static constexpr auto view = fields::view_of<ModelScore>({
        {"rms residual", "rms_residual"},
        {"rms residual surface left out", "rms_residual_surface_left_out"},
        {"rms residual elastomer left out", "rms_residual_elastomer_left_out"},
        {"log_likelihood"},
        {"log_likelihood surface left out", "log_likelihood_surface_left_out"},
        {"weight"},
        {"odds against", "odds_against.value"},
        {"odds against 5 %", "odds_against.lower"},
        {"odds against 95 %", "odds_against.upper"},
        {"distinction", "odds_against.distinction"},
        {"constant", "constant"},
        {"p constant", "constant_probability"},
        {"refused"},
        {"W_int", "work_of_adhesion"},
    });
    TidyTable table{"", {"ranking", "model", "formula", "parameter", "unit", "value", "standard_error"}, {}};
    put_headings(table, view);
    for (const auto& of : rankings_of(h))
        for (const auto& s : of.ranking.models) {
            const auto& model = s.fitted.model;
            const auto parameter = model.fitted() ? model.parameter() : hysteresis::ModelParameter{};
            const auto value = model.fitted() ? s.fitted.parameter.estimate() : Estimate{.value = undefined};
            auto& row = table.rows.emplace_back();
            row = {of.name,        model.name(), model.formula(),     parameter.quantity,
                   parameter.unit, value.value,  value.standard_error};
            put_cells(row, s, view);
        }
    return table;
}

TidyTable trial_table(const study::Hysteresis& h) {
    static constexpr auto view =
        fields::view_of<hysteresis::ModelTrials>({{"planted"}, {"runs"}, {"found"}, {"possible"}, {"excluded"}});
    auto table = table_of(h.trials, view);
    table.columns.emplace_back("most often in its place");
    for (std::size_t i = 0; i < h.trials.size(); ++i) table.rows[i].emplace_back(h.trials[i].most_taken);
    return table;
}

TidyTable hysteresis_table(const study::Hysteresis& h) {
    using fields::Errors;
    static constexpr auto view = fields::view_of<study::PairHysteresis>({
        {"surface"},
        {"elastomer"},
        {"model"},
        {"chosen by", "chosen_by"},
        {"U_el/AW", "energy_share"},
        {"area in contact/A", "contact_fraction"},
        {"W_app", "work_of_adhesion_approach"},
        {"W_ret", "work_of_adhesion_retraction"},
        {"W_ret measured", "measured"},
        {"pull-off force", "pull_off_force"},
        {"contact radius", "contact_radius"},
        {"E_loss", "energy_loss"},
        {"jump in", "energy_loss_shares.jump_in", Errors::left_out},
        {"jump out", "energy_loss_shares.jump_out", Errors::left_out},
        {"crack tip", "energy_loss_shares.crack_tip", Errors::left_out},
        {"roughness", "energy_loss_shares.roughness", Errors::left_out},
        {"bulk", "energy_loss_shares.bulk", Errors::left_out},
        {"rms force off on approach", "residuals.approach"},
        {"rms force off on retraction", "residuals.retraction"},
        {"likelier model", "likelier.model"},
        {"W_ret by it", "likelier.work_of_adhesion_retraction"},
        {"N approach", "pinning.approach.larkin_lengths"},
        {"k approach", "pinning.approach.pinning_coefficient"},
        {"N retraction", "pinning.retraction.larkin_lengths"},
        {"k retraction", "pinning.retraction.pinning_coefficient"},
    });
    return table_of(h.pairs, view);
}

TidyTable joint_table(const study::Hysteresis& h) {
    TidyTable table{"", {"input", "unit", "before", "before standard_error", "after", "after standard_error"}, {}};
    for (const auto& input : h.joint->inputs)
        table.rows.push_back({input.name, input.unit, input.before.value, input.before.standard_error,
                              input.after.value, input.after.standard_error});
    return table;
}

TidyTable model_work_table(const study::Hysteresis& h) {
    TidyTable table{"",
                    {"surface", "elastomer", "model", "W_ret [J/m2]", "W_ret standard_error [J/m2]",
                     "log_likelihood surface left out", "reason"},
                    {}};
    for (const auto& p : h.pairs)
        for (const auto& m : p.models)
            table.rows.push_back({p.surface, p.elastomer, m.model.name(), m.work_retraction.value,
                                  m.work_retraction.standard_error, m.log_likelihood.value_or(undefined), m.reason});
    return table;
}

TidyTable decomposition_table(const study::Hysteresis& h) {
    using fields::Errors;
    static constexpr auto view = fields::view_of<study::PairHysteresis>({
        {"surface"},
        {"elastomer"},
        {"model", "decomposition.model"},
        {"of", "decomposition.of"},
        {"E_loss measured", "decomposition.energy_loss"},
        {"jump in", "decomposition.energy_loss_shares.jump_in", Errors::left_out},
        {"jump out", "decomposition.energy_loss_shares.jump_out", Errors::left_out},
        {"crack tip", "decomposition.energy_loss_shares.crack_tip", Errors::left_out},
        {"roughness", "decomposition.energy_loss_shares.roughness", Errors::left_out},
        {"bulk", "decomposition.energy_loss_shares.bulk", Errors::left_out},
        {"unexplained", "decomposition.unexplained"},
    });
    TidyTable table;
    put_headings(table, view);
    for (const auto& p : h.pairs)
        if (p.decomposition) put_cells(table.rows.emplace_back(), p, view);
    return table;
}

std::vector<std::pair<std::string, TidyTable>> hysteresis_tables(const study::Hysteresis& h) {
    std::vector<std::pair<std::string, TidyTable>> tables{{"hysteresis.csv", hysteresis_table(h)},
                                                          {"models.csv", model_table(h)},
                                                          {"model_works.csv", model_work_table(h)},
                                                          {"losses.csv", decomposition_table(h)}};
    if (h.joint) tables.emplace_back("joint_fit.csv", joint_table(h));
    if (!h.trials.empty()) tables.emplace_back("trials.csv", trial_table(h));
    return tables;
}

}  // namespace setae::output
