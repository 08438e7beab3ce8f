// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/validation/next_trials.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "data_sets.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/study/next_measurement.hpp"
#include "setae/study/study_result.hpp"

namespace setae::validation {
namespace {

using adhesion::Candidate;
using simulation::Recipe;
using simulation::StatedQuantity;

double square(double x) { return x * x; }

/// Every named quantity of a recipe.
std::vector<StatedQuantity*> named(Recipe& recipe, const std::string& name) {
    std::vector<StatedQuantity*> found;
    const auto add = [&](StatedQuantity& quantity, const std::string& known) {
        if (known == name) found.push_back(&quantity);
    };
    auto& calibrations = recipe.calibrations;
    for (auto* optional :
         {&calibrations.stylus.height, &calibrations.stylus.lateral, &calibrations.afm.height,
          &calibrations.afm.lateral, &calibrations.tem.height, &calibrations.tem.lateral, &calibrations.force,
          &calibrations.displacement, &calibrations.contact_radius, &recipe.stylus_tip, &recipe.afm_tip})
        if (*optional) add(**optional, (*optional)->input);
    for (auto& elastomer : recipe.elastomers)
        for (const auto& [key, quantity] : {std::pair{"youngs_modulus", &elastomer.youngs_modulus},
                                            {"surface_energy", &elastomer.surface_energy},
                                            {"sphere_radius", &elastomer.sphere_radius}})
            add(*quantity,
                quantity->input.empty() ? fmt::format("elastomers.{}.{}", elastomer.name, key) : quantity->input);
    return found;
}

/// Half the standard error, and half the deviation of the true value from the stated one.
void halve(StatedQuantity& quantity) {
    auto& stated_value = quantity.stated_value;
    quantity.value = stated_value.value + 0.5 * (quantity.value - stated_value.value);
    stated_value.standard_error *= 0.5;
    if (auto& range = stated_value.interval) {
        range->lower += 0.5 * (stated_value.value - range->lower);
        range->upper += 0.5 * (stated_value.value - range->upper);
    }
}

template <class List>
void double_list(List& list) {
    const auto once = list;
    list.insert(list.end(), once.begin(), once.end());
}

/// A list with one entry for all scans stays.
template <class List>
void double_each(List& list) {
    if (list.size() > 1) double_list(list);
}

void measure_again(simulation::SurfaceRecipe& rough) {
    if (auto& stylus = rough.stylus) {
        double_each(stylus->steps);
        double_list(stylus->lengths);
    }
    if (auto& afm = rough.afm) {
        double_each(afm->pixels);
        double_list(afm->sizes);
    }
    if (auto& tem = rough.tem) double_list(tem->lengths);
}

study::StudyResult result_of(const std::string& folder) {
    return study::run_study(study_of_data_set(folder), {parallel::Threads{1}});
}

TracedValue value_in(const study::StudyResult& result, const std::string& target) {
    return adhesion::value_of(study::target_of(result, target));
}

double true_value_of(const Recipe& recipe, const std::string& target) {
    if (target == "W_int") return recipe.work_of_adhesion;
    for (const auto& loop : simulation::known_loops(recipe))
        if (study::pair_target(loop.elastomer, loop.surface) == target) return loop.specimen.work_approach;
    return 0.0;  // two balances of one W_int
}

/// The candidates that are done in every run.
std::vector<Candidate> chosen(const std::vector<adhesion::NextMeasurement>& next, std::vector<std::string> names) {
    constexpr std::size_t max_informative = 3;
    std::vector<std::string> known;
    for (const auto& n : next) known.push_back(name_of(n.candidate));
    if (names.empty()) names.assign(known.begin(), known.begin() + std::min(known.size(), max_informative));
    std::vector<Candidate> list;
    for (const auto& name : names) {
        const auto at = std::find(known.begin(), known.end(), name);
        if (at == known.end()) {
            const auto nearest = nearest_match(name, known);
            throw InvalidArgument(
                fmt::format("'{}' is nothing that could be measured next; expected an input, a surface "
                            "or a pair such as 'E02 on A'{}",
                            name, nearest.empty() ? "" : "; did you mean '" + nearest + "'?"));
        }
        list.push_back(next[static_cast<std::size_t>(at - known.begin())].candidate);
    }
    return list;
}

/// Candidates of the first run; errors in the options are reported before all other runs.
std::vector<Candidate> first_candidates(const std::string& recipe, const NextTrialOptions& options) {
    DataSets one{.recipe = recipe, .folder = options.folder, .runs = 1, .first_seed = options.first_seed};
    std::vector<Candidate> list;
    const auto failures = for_each_data_set(one, [&](int, const Recipe&, const std::string& folder) {
        list = chosen(study::next_measurements(result_of(folder), options.target), options.measured);
    });
    if (!failures.front().empty()) throw InvalidArgument(failures.front());
    return list;
}

double root_mean_square(const std::vector<NextTrial>& trials, const std::function<double(const NextTrial&)>& value,
                        std::size_t without) {
    double sum = 0.0;
    for (std::size_t i = 0; i < trials.size(); ++i)
        if (i != without) sum += square(value(trials[i]));
    return std::sqrt(sum / static_cast<double>(trials.size() - (without < trials.size() ? 1 : 0)));
}

NextSummary summary_of(const std::vector<NextTrial>& trials) {
    const std::size_t all = trials.size();
    const auto rms = [&](auto value, std::size_t without) { return root_mean_square(trials, value, without); };
    const auto off = [](const NextTrial& t) { return t.off; };
    const auto off_later = [](const NextTrial& t) { return t.off_later; };
    NextSummary row{.measured = trials.front().measured, .n = static_cast<int>(all)};
    row.stated = rms([](const NextTrial& t) { return t.stated; }, all);
    row.promised = rms([](const NextTrial& t) { return t.promised; }, all);
    row.stated_later = rms([](const NextTrial& t) { return t.stated_later; }, all);
    row.off = rms(off, all);
    row.off_later = rms(off_later, all);
    row.ratio = row.off_later / row.off;
    row.ratio_error = std::nan("");
    if (all < 2) return row;
    double squares = 0.0;
    for (std::size_t i = 0; i < all; ++i) squares += square(rms(off_later, i) / rms(off, i) - row.ratio);
    row.ratio_error = std::sqrt(squares * static_cast<double>(all - 1) / static_cast<double>(all));
    return row;
}

}  // namespace

std::string name_of(const Candidate& candidate) {
    return candidate.kind == Candidate::Kind::loop ? study::pair_target(candidate.elastomer, candidate.name)
                                                   : candidate.name;
}

Recipe recipe_with(Recipe recipe, const Candidate& candidate) {
    using Kind = Candidate::Kind;
    if (candidate.kind == Kind::loop) {
        recipe.loops.value().further.push_back({candidate.name, candidate.elastomer});
        return recipe;
    }
    if (candidate.kind == Kind::spectrum) {
        for (auto& rough : recipe.surfaces)
            if (rough.surface.name == candidate.name) measure_again(rough);
        return recipe;
    }
    const auto quantities = named(recipe, candidate.name);
    if (quantities.empty())
        throw InvalidArgument(
            fmt::format("the recipe gives no '{}' with a ±, so it cannot be known better", candidate.name));
    for (auto* quantity : quantities) halve(*quantity);
    for (auto& rough : recipe.surfaces) {
        if (rough.stylus && recipe.stylus_tip) rough.stylus->shared_tip_radius = recipe.stylus_tip->value;
        if (rough.afm && recipe.afm_tip) rough.afm->shared_tip_radius = recipe.afm_tip->value;
    }
    return recipe;
}

NextTrials next_trials(const std::string& recipe, const NextTrialOptions& options) {
    const auto candidates = first_candidates(recipe, options);
    const DataSets sets{recipe, options.folder,  options.runs,    options.first_seed,
                        false,  options.threads, options.progress};
    std::vector<std::vector<NextTrial>> found(static_cast<std::size_t>(std::max(options.runs, 0)));
    auto failures = for_each_data_set(sets, [&](int run, const Recipe& made, const std::string& folder) {
        const auto result = result_of(folder);
        const auto promises = study::next_measurements(result, options.target);
        const auto now = value_in(result, options.target);
        for (const auto& candidate : candidates) {
            const auto name = name_of(candidate);
            const auto promise = std::find_if(promises.begin(), promises.end(),
                                              [&](const auto& next) { return name_of(next.candidate) == name; });
            if (promise == promises.end()) continue;  // a pair without contact in this run
            const auto changed = recipe_with(made, candidate);
            with_data_set(changed, folder + "_next", false, [&] {
                const auto later = value_in(result_of(folder + "_next"), options.target);
                found[static_cast<std::size_t>(run)].push_back(
                    {.run = run,
                     .measured = name,
                     .off = now.value - true_value_of(made, options.target),
                     .off_later = later.value - true_value_of(changed, options.target),
                     .stated = now.standard_error(),
                     .promised = promise->standard_error,
                     .stated_later = later.standard_error()});
            });
        }
    });
    NextTrials result;
    for (std::size_t r = 0; r < failures.size(); ++r) {
        result.trials.insert(result.trials.end(), found[r].begin(), found[r].end());
        if (!failures[r].empty()) result.failed.push_back({options.first_seed + r, std::move(failures[r])});
    }
    return result;
}

std::vector<NextSummary> summary(const std::vector<NextTrial>& trials) {
    std::vector<std::vector<NextTrial>> groups;
    for (const auto& trial : trials) {
        const auto group = std::find_if(groups.begin(), groups.end(),
                                        [&](const auto& known) { return known.front().measured == trial.measured; });
        (group == groups.end() ? groups.emplace_back() : *group).push_back(trial);
    }
    std::vector<NextSummary> rows;
    for (const auto& group : groups) rows.push_back(summary_of(group));
    return rows;
}

tables::TidyTable next_summary_table(const std::string& target, const std::vector<NextSummary>& rows) {
    tables::TidyTable table{fmt::format("{} with one further measurement, in mJ/m²", target),
                            {"measured", "±", "± promised", "± found", "off", "off later", "ratio", "promised"},
                            {}};
    const auto milli = [](double value) { return fmt::format("{:.3f}", 1e3 * value); };
    for (const auto& row : rows)
        table.rows.push_back({row.measured, milli(row.stated), milli(row.promised), milli(row.stated_later),
                              milli(row.off), milli(row.off_later),
                              fmt::format("{:.3f} ± {:.3f}", row.ratio, row.ratio_error),
                              fmt::format("{:.3f}", row.promised / row.stated)});
    return table;
}

tables::TidyTable next_trials_table(const std::vector<NextTrial>& trials) {
    tables::TidyTable table{"",
                            {"run", "measured", "off [J/m2]", "off later [J/m2]", "stated [J/m2]", "promised [J/m2]",
                             "stated later [J/m2]"},
                            {}};
    for (const auto& trial : trials)
        table.rows.push_back({static_cast<double>(trial.run), trial.measured, trial.off, trial.off_later, trial.stated,
                              trial.promised, trial.stated_later});
    return table;
}

}  // namespace setae::validation
