// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/validation/law_recovery.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <mutex>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "data_sets.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/core/uncertain_text.hpp"
#include "setae/study/study_result.hpp"

namespace setae::validation {
namespace {

using hysteresis::Law;
using hysteresis::RetractionModel;
using hysteresis::Tip;
using simulation::Recipe;
using simulation::RetractionChoice;
using tables::TidyTable;

RetractionChoice simulated_choice(Law law) {
    switch (law) {
        case Law::pinning: return RetractionChoice::pinning;
        case Law::conformal_loss: return RetractionChoice::loss;
        case Law::opening_work: return RetractionChoice::opening;
        default: return RetractionChoice::reversible;
    }
}

/// Crack tips of elastomers: as in the recipe, else decreasing from one elastomer to the next.
void set_tip(std::vector<simulation::ElastomerRecipe>& elastomers, Tip tip) {
    const bool stated_value = std::ranges::any_of(elastomers, [&](const auto& e) {
        return tip == Tip::reference ? e.tip_factor > 1.0 : e.body.edge.has_value();
    });
    double factor = 1.5, speed = 1e-6;
    for (auto& elastomer : elastomers) {
        if (tip != Tip::reference) elastomer.tip_factor = 1.0;
        else if (!stated_value) elastomer.tip_factor = factor;
        if (tip != Tip::speed) elastomer.body.edge.reset();
        else if (!stated_value) elastomer.body.edge = hysteresis::EdgeSpeed{.reference_speed = speed, .exponent = 0.6};
        factor = std::max(1.1, factor - 0.1);
        speed *= 2.0;
    }
}

ModelRecovery recovery_of(const study::StudyResult& result, const RetractionModel& law, const Recipe& made) {
    if (!result.hysteresis) throw UndefinedDataError(result.hysteresis.reason);
    const auto& hysteresis = *result.hysteresis;
    const auto& ranking = hysteresis.conforming.best() ? hysteresis.conforming : hysteresis.all;
    const auto* best = ranking.best();
    if (!best)
        throw UndefinedDataError(fmt::format("{} pairs with W_app and W_ret rank no law", hysteresis.measured_pairs));
    ModelRecovery found{.true_model = law.name(), .found = best->fitted.model.name(), .seed = made.seed};
    found.surface_left_out = best->surface_left_out;
    const auto likely = ranking.possible();
    found.possible =
        !found.is_found() && std::ranges::any_of(likely, [&](const auto* score) { return score->fitted.model == law; });
    if (!law.fitted()) return found;
    found.true_parameter = made.loops->opening_work;
    for (const auto& score : ranking.models)
        if (score.fitted.model == law) {
            found.parameter = score.fitted.parameter.value;
            found.parameter_standard_error = score.fitted.parameter.standard_error();
        }
    return found;
}

double mean_of(const std::vector<const ModelRecovery*>& list, double ModelRecovery::*number) {
    double sum = 0.0;
    for (const auto* one : list) sum += one->*number;
    return sum / static_cast<double>(list.size());
}

ModelSummary summary_of(const std::vector<const ModelRecovery*>& list) {
    ModelSummary row{.true_model = list.front()->true_model, .runs = static_cast<int>(list.size())};
    std::map<std::string, int> others;
    for (const auto* one : list) {
        if (one->is_found()) ++row.found;
        else ++others[one->found];
        if (one->possible) ++row.possible;
    }
    row.excluded = row.runs - row.found - row.possible;
    row.true_parameter = mean_of(list, &ModelRecovery::true_parameter);
    row.parameter = mean_of(list, &ModelRecovery::parameter);
    row.parameter_standard_error = mean_of(list, &ModelRecovery::parameter_standard_error);
    row.surface_left_out = mean_of(list, &ModelRecovery::surface_left_out);
    const auto most = std::ranges::max_element(others, {}, [](const auto& entry) { return entry.second; });
    if (most != others.end()) row.most_taken = most->first;
    return row;
}

}  // namespace

std::vector<RetractionModel> simulated_models() {
    std::vector<RetractionModel> laws;
    for (const Tip tip : {Tip::none, Tip::reference, Tip::speed})
        for (const Law law : {Law::reversible, Law::pinning, Law::conformal_loss, Law::opening_work})
            laws.push_back({law, tip});
    return laws;
}

std::vector<RetractionModel> simulated_models(const std::vector<std::string>& names) {
    const auto all = simulated_models();
    std::vector<std::string> known{"all"};
    for (const auto& law : all) known.push_back(law.name());
    std::vector<RetractionModel> laws;
    for (const auto& name : names) {
        const auto place = std::ranges::find(known, name);
        if (place == known.end()) {
            const auto nearest = nearest_match(name, known);
            throw InvalidArgument(fmt::format("no mechanism '{}'; expected {}{}", name, fmt::join(known, ", "),
                                              nearest.empty() ? "" : "; did you mean '" + nearest + "'?"));
        }
        if (place == known.begin()) laws.insert(laws.end(), all.begin(), all.end());
        else laws.push_back(all[static_cast<std::size_t>(place - known.begin()) - 1]);
    }
    return laws;
}

Recipe with_model(Recipe recipe, const RetractionModel& law) {
    if (!recipe.loops) throw InvalidArgument("the recipe has no [loops] to simulate a mechanism with");
    auto& loops = *recipe.loops;
    loops.law = simulated_choice(law.law);
    constexpr double over_intrinsic = 2.0;
    if (law.law == Law::opening_work && !(loops.opening_work > 0.0))
        loops.opening_work = over_intrinsic * recipe.work_of_adhesion;
    if (law.law == Law::conformal_loss) loops.loss_factor = 1.0;
    // pinning on approach leaves some pairs without any contact
    if (law.law == Law::pinning) loops.nonconforming = simulation::PairsWithoutContact::skip;
    if (law.tip != Tip::none && !loops.reference_work)
        throw InvalidArgument(
            fmt::format("{} needs a smooth reference; expected reference_work in the recipe's [loops]", law.name()));
    set_tip(recipe.elastomers, law.tip);
    return recipe;
}

ModelRecoveries model_recoveries(const std::string& recipe, const std::vector<RetractionModel>& laws,
                                 const ModelRecoveryOptions& options) {
    if (options.runs < 1) throw InvalidArgument(fmt::format("{} runs; expected at least 1", options.runs));
    const auto runs = static_cast<std::size_t>(options.runs);
    for (const auto& law : laws) (void)with_model(simulation::read_recipe(recipe), law);  // errors are reported once
    std::filesystem::create_directories(options.folder);
    std::vector<ModelRecovery> found(laws.size() * runs);
    std::vector<std::string> failures(found.size());
    std::mutex counting;
    int done = 0;
    parallel::for_each_index(found.size(), options.threads, [&](std::size_t i) {
        const auto folder = (std::filesystem::path(options.folder) / fmt::format("data_{:04}", i)).string();
        try {
            const auto& law = laws[i / runs];
            const auto made = with_model(simulation::read_recipe(recipe, options.first_seed + i % runs), law);
            with_data_set(made, folder, false, [&] {
                found[i] = recovery_of(study::run_study(study_of_data_set(folder), {parallel::Threads{1}}), law, made);
            });
        } catch (const std::exception& failure) {
            failures[i] = fmt::format("{}: {}", laws[i / runs].name(), reason_of(failure));
        }
        const std::lock_guard lock(counting);
        ++done;
        if (options.progress) options.progress(done);
    });
    ModelRecoveries result;
    for (std::size_t i = 0; i < found.size(); ++i)
        if (failures[i].empty()) result.recoveries.push_back(std::move(found[i]));
        else result.failed.push_back({options.first_seed + i % runs, std::move(failures[i])});
    return result;
}

std::vector<ModelSummary> summary(const std::vector<ModelRecovery>& recoveries) {
    std::vector<ModelSummary> rows;
    for (std::size_t from = 0; from < recoveries.size();) {
        std::vector<const ModelRecovery*> alike;
        std::size_t to = from;
        for (; to < recoveries.size() && recoveries[to].true_model == recoveries[from].true_model; ++to)
            alike.push_back(&recoveries[to]);
        rows.push_back(summary_of(alike));
        from = to;
    }
    return rows;
}

TidyTable model_summary_table(const std::vector<ModelSummary>& rows) {
    constexpr double milli = 1e-3;
    TidyTable table{"mechanisms of simulated loops, and what studies of the loops find [mJ/m²]",
                    {"true model", "found", "possible", "excluded", "W_x", "true W_x", "off", "most often instead"},
                    {}};
    for (const auto& row : rows) {
        const bool fitted = std::isfinite(row.parameter);
        const Estimate work{.value = row.parameter, .standard_error = row.parameter_standard_error};
        table.rows.push_back({row.true_model, fmt::format("{} of {}", row.found, row.runs),
                              fmt::format("{}", row.possible), fmt::format("{}", row.excluded),
                              fitted ? uncertain_number(work, milli) : std::string(),
                              fitted ? fmt::format("{:.4g}", row.true_parameter / milli) : std::string(),
                              fmt::format("{:.2g}", row.surface_left_out / milli), row.most_taken});
    }
    return table;
}

TidyTable model_recovery_table(const std::vector<ModelRecovery>& recoveries) {
    TidyTable table{"",
                    {"true model", "seed", "found", "possible", "true parameter [J/m2]", "parameter [J/m2]",
                     "standard_error [J/m2]", "next surface off [J/m2]"},
                    {}};
    for (const auto& one : recoveries)
        table.rows.push_back({one.true_model, static_cast<double>(one.seed), one.found,
                              std::string(one.possible ? "yes" : "no"), one.true_parameter, one.parameter,
                              one.parameter_standard_error, one.surface_left_out});
    return table;
}

}  // namespace setae::validation
