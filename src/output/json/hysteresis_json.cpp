// SPDX-License-Identifier: GPL-3.0-or-later
#include "json_support.hpp"
#include "setae/output/hysteresis_output.hpp"
#include "tables/smooth_limit_output.hpp"

namespace setae::output {
namespace {

using hysteresis::EnergyShares;
using hysteresis::ModelScore;

/// Odds for the likeliest model, with their 5 and 95 % points as data vary within their ±.
Json odds_json(const hysteresis::Odds& odds) {
    return {{"value", number(odds.value)},
            {"lower", number(odds.lower)},
            {"upper", number(odds.upper)},
            {"level", 0.9},
            {"distinction", hysteresis::name_of(odds.distinction())}};
}

/// W_int of elastomers in proportion to their references, against one.
Json proportional_json(const hysteresis::ProportionalWork& of) {
    return {{"surfaces_left_out", odds_json(of.surfaces_left_out)},
            {"elastomers_left_out", odds_json(of.elastomers_left_out)},
            {"both_branches", odds_json(of.both_branches)}};
}

Json scores_json(const hysteresis::Ranking& ranking) {
    Json models = Json::array(), unranked = Json::array();
    for (const auto& s : ranking.models) {
        const auto& model = s.fitted.model;
        Json json{{"model", model.name()}, {"formula", model.formula()}, {"parameters", model.fitted() ? 1 : 0}};
        if (model.fitted()) {
            const auto parameter = model.parameter();
            add(json, quantity(parameter.quantity, parameter.symbol, s.fitted.parameter.estimate(), parameter.unit));
        }
        const auto in_work = [&](const char* name, double value) {
            json[name] = {{"value", number(value)}, {"unit", "J/m2"}};
        };
        in_work("rms_residual", s.rms_residual);
        in_work("rms_residual_surface_left_out", s.surface_left_out);
        in_work("rms_residual_elastomer_left_out", s.elastomer_left_out);
        in_work("scatter", s.fitted.scatter.standard_error);
        json["log_likelihood"] = number(s.log_likelihood);
        json["log_likelihood_surface_left_out"] = number(s.left_out_log_likelihood);
        json["log_likelihood_approach"] = number(s.left_out_approach);
        json["log_likelihood_retraction"] = number(s.left_out_retraction);
        json["weight"] = number(s.weight);
        json["odds_against"] = odds_json(s.odds_against);
        json["constant"] = to_json(quantity("constant", "b", s.bias.value, "J/m2"));
        json["constant_probability"] = number(s.bias.probability);
        json["constant_odds"] = number(s.bias.odds_with_it);
        json["refused"] = s.bias.refuses_model;
        add(json, quantity("work_of_adhesion", "W_int", s.work_of_adhesion, "J/m2"));
        models.push_back(std::move(json));
    }
    for (const auto& u : ranking.unranked)
        unranked.push_back({{"model", u.model.name()}, {"formula", u.model.formula()}, {"reason", u.reason}});
    Json possible = Json::array();
    for (const auto* score : ranking.possible()) possible.push_back(score->fitted.model.name());
    const auto* best = ranking.best();
    return {{"best", best ? Json(best->fitted.model.name()) : Json(nullptr)},
            {"possible", std::move(possible)},
            {"approach_without_pinning",
             ranking.approach_against_pinning ? odds_json(*ranking.approach_against_pinning) : Json(nullptr)},
            {"proportional_work",
             ranking.proportional_work ? proportional_json(*ranking.proportional_work) : Json(nullptr)},
            {"models", std::move(models)},
            {"unranked", std::move(unranked)}};
}

Json shares_json(const EnergyShares& shares) {
    Json json;
    const auto share = [&](const char* name, const char* symbol, const TracedValue& value) {
        add(json, quantity(name, symbol, value.estimate(), "J"));
    };
    share("jump_in", "E_in", shares.jump_in);
    share("jump_out", "E_out", shares.jump_out);
    share("crack_tip", "E_tip", shares.crack_tip);
    share("roughness", "E_rough", shares.roughness);
    share("bulk", "E_bulk", shares.bulk);
    return json;
}

Json decomposition_json(const study::LossDecomposition& d, const std::string& model) {
    Json json{{"model", model}, {"of", d.of_works ? "works" : "loop"}};
    add(json, quantity("energy_loss", "E_loss", d.measured.estimate(), "J"));
    json["energy_loss_shares"] = shares_json(d.shares);
    add(json, quantity("unexplained", "E_loss - Σ", d.unexplained.estimate(), "J"));
    json["not_told_apart"] = d.not_told_apart;
    return json;
}

Json joint_json(const study::JointLossFit& joint) {
    Json json{{"energies", joint.energies}, {"works", joint.works}, {"chi2", number(joint.chi2)}};
    json["unexplained_per_area"] = {{"value", number(joint.unexplained_per_area)}, {"unit", "J/m2"}};
    json["inputs"] = Json::array();
    for (const auto& input : joint.inputs)
        json["inputs"].push_back({{"name", input.name},
                                  {"before", to_json(quantity("before", "", input.before, input.unit))},
                                  {"after", to_json(quantity("after", "", input.after, input.unit))}});
    return json;
}

Json edge_json(const study::ElastomerEdgeSpeed& edge) {
    Json json{{"references", edge.references}};
    add(json, quantity("rest_factor", "φ", edge.law.rest_factor.estimate(), "1"));
    add(json, quantity("reference_speed", "v0", edge.law.reference_speed.estimate(), "m/s"));
    add(json, quantity("exponent", "n", edge.law.exponent.estimate(), "1"));
    if (edge.threshold) add(json, quantity("threshold", "G0", *edge.threshold, "J/m2"));
    return json;
}

Json times_json(const study::ElastomerTimes& times) {
    Json json{{"elastomer", times.elastomer}};
    add_outcome(json, "crack_speed", times.edge, edge_json);
    json["relaxation"] = Json::array();
    for (const auto& term : times.relaxation) {
        Json entry;
        add(entry, quantity("share", "g", term.share.estimate(), "1"));
        add(entry, quantity("time", "τ", term.time.estimate(), "s"));
        json["relaxation"].push_back(std::move(entry));
    }
    if (!times.relaxation.empty()) json["largest_bulk_factor"] = number(times.largest_bulk_factor());
    return json;
}

Json pinned_branch_json(const hysteresis::BranchPinning& branch) {
    Json json{{"larkin_lengths", number(branch.larkin_lengths)}, {"measured", branch.measured}};
    add(json, quantity("pinning_coefficient", "k",
                       {.value = branch.coefficient.value, .standard_error = branch.coefficient.standard_error}, "1"));
    json["contact_radius"] =
        branch.contact_radius ? Json{{"value", number(*branch.contact_radius)}, {"unit", "m"}} : Json(nullptr);
    return json;
}

/// k of simulated fronts as long as the edge of the pair's contact.
Json pinning_json(const hysteresis::PairPinning& pinning) {
    return {{"energy_share", number(pinning.energy_share)},
            {"approach", pinned_branch_json(pinning.approach)},
            {"retraction", pinned_branch_json(pinning.retraction)}};
}

/// The likeliest model where it is not the answer.
Json likelier_json(const study::LikelierModel& likelier) {
    Json json{{"model", likelier.model.name()}};
    add(json, quantity("work_of_adhesion_retraction", "W_ret", likelier.work_retraction.estimate(), "J/m2"));
    if (likelier.pull_off_force)
        add(json, quantity("pull_off_force", "F_po", likelier.pull_off_force->estimate(), "N"));
    return json;
}

Json pair_json(const study::PairHysteresis& p) {
    Json json{{"surface", p.surface},
              {"elastomer", p.elastomer},
              {"model", p.model.name()},
              {"chosen_by", name_of(p.choice)},
              {"energy_share", number(p.energy_share)},
              {"conforms", p.conforms},
              {"contact_fraction", number(p.contact_fraction)}};
    const auto put = [&](const char* name, const char* symbol, const TracedValue& value, const char* unit) {
        add(json, quantity(name, symbol, value.estimate(), unit));
    };
    if (p.tip_factor) put("tip_factor", "φ", *p.tip_factor, "1");
    if (p.speed_factor) put("speed_factor", "φ(v)", *p.speed_factor, "1");
    put("work_of_adhesion_approach", "W_app", p.work_approach, "J/m2");
    put("work_of_adhesion_retraction", "W_ret", p.work_retraction, "J/m2");
    if (p.measured_retraction)
        json["measured"] = to_json(quantity("work_of_adhesion_retraction", "W_ret", *p.measured_retraction, "J/m2"));
    if (p.pull_off_force) put("pull_off_force", "F_po", *p.pull_off_force, "N");
    json["likelier"] = p.likelier ? likelier_json(*p.likelier) : Json(nullptr);
    json["pinning"] = p.pinning ? pinning_json(*p.pinning) : Json(nullptr);
    if (p.loop) {
        put("contact_radius", "a_max", p.loop->contact_radius, "m");
        put("energy_loss", "E_loss", p.loop->energy_loss, "J");
        json["energy_loss_shares"] = shares_json(p.loop->shares);
    } else {
        json["energy_loss"] = nullptr;
        json["energy_loss_reason"] = p.loop.reason;
    }
    add_outcome(json, "decomposition", p.decomposition,
                [&](const study::LossDecomposition& d) { return decomposition_json(d, p.decomposed_by); });
    if (const auto& r = p.residuals) {
        json["residuals"] = {{"loops", r->loops}};
        for (const auto& [name, value] : {std::pair{"approach", r->approach}, {"retraction", r->retraction}})
            json["residuals"][name] = {{"value", number(value)}, {"unit", "N"}};
    }
    Json works, likelihoods;
    for (const auto& m : p.models) {
        works[m.model.name()] = to_json(quantity("work_of_adhesion_retraction", "W_ret", m.work_retraction, "J/m2"));
        likelihoods[m.model.name()] = m.log_likelihood ? number(*m.log_likelihood) : Json(nullptr);
    }
    json["models"] = std::move(works);
    json["log_likelihood"] = std::move(likelihoods);
    return json;
}

}  // namespace

Json to_json(const study::Hysteresis& h) {
    Json json{{"answer", hysteresis_answer(h, 100000)},
              {"measured_pairs", h.measured_pairs},
              {"conforming_pairs", h.conforming_pairs},
              {"conforming_pairs_range", {h.conforming_range.lower, h.conforming_range.upper}},
              {"rankings",
               {{"conforming_pairs", scores_json(h.conforming)},
                {"all_pairs", scores_json(h.all)},
                {"loop_areas", scores_json(h.by_area)}}}};
    json["pairs_by_area"] = h.pairs_by_area;
    json["elastomers"] = Json::array();
    for (const auto& times : h.elastomers) json["elastomers"].push_back(times_json(times));
    add_outcome(json, "joint_fit", h.joint, joint_json);
    json["deciding_pair"] = nullptr;
    if (h.deciding) {
        const auto& d = *h.deciding;
        json["deciding_pair"] = {{"surface", d.surface},
                                 {"elastomer", d.elastomer},
                                 {"models", {d.first, d.second}},
                                 {"work_of_adhesion_retraction",
                                  {{"values", {number(d.first_work), number(d.second_work)}}, {"unit", "J/m2"}}},
                                 {"largest_input", d.largest_input},
                                 {"standard_errors_apart", number(d.standard_errors)}};
    }
    json["smooth_limits"] = smooth_limits_json(h);
    json["alerts"] = to_json(h.alerts);
    if (!h.trials.empty()) {
        json["trials"] = Json::array();
        for (const auto& law : h.trials)
            json["trials"].push_back({{"planted", law.planted.name()},
                                      {"runs", law.runs},
                                      {"found", law.found},
                                      {"possible", law.possible},
                                      {"excluded", law.excluded}});
    }
    json["pairs"] = Json::array();
    for (const auto& p : h.pairs) json["pairs"].push_back(pair_json(p));
    json["skipped"] = Json::array();
    for (const auto& s : h.skipped)
        json["skipped"].push_back({{"surface", s.surface}, {"elastomer", s.elastomer}, {"reason", s.reason}});
    return json;
}

}  // namespace setae::output
