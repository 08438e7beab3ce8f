// SPDX-License-Identifier: GPL-3.0-or-later
// ranking_survey estimators [SETS]: the tables of docs/validation/estimators.md, W_int of designs like the published
// one ranking_survey floored [SETS]: the same by the number of pairs whose true balance is below 0 ranking_survey
// classes [SETS] [SCATTER mJ/m²] [MODEL …]: docs/validation/ranking.md, data sets of each model ranked ranking_survey
// against [SETS] [SCATTER] [MODEL …]: the same, the true model and `reversible` alone ranking_survey bias [SETS]
// [SCATTER]: 60 mJ/m² added to W_ret of every pair ranking_survey jitter [SETS]: the published pairs with W_ret moved
// by 1 mJ/m²
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "estimator_survey.hpp"
#include "published_pairs.hpp"
#include "ranking_survey.hpp"

namespace {

using namespace setae;
using namespace setae::reference;

constexpr double mJ = 1e-3;
constexpr std::uint64_t first_seed = 20261127;

std::vector<EstimatorDesign> designs(const std::vector<adhesion::PairPoint>& pairs) {
    const std::vector<std::string> all{"PUNCD", "UNCD", "NCD", "MCD"}, three{"PUNCD", "UNCD", "NCD"},
        two{"PUNCD", "NCD"}, soft{"E0.7", "E1.0", "E1.9"}, ends{"E0.7", "E1.9"},
        elastomers{"E0.7", "E1.0", "E1.9", "E10"};
    const adhesion::ModelScatter equal{5 * mJ, 5 * mJ, 5 * mJ}, none{}, of_groups{3 * mJ, 8 * mJ, 8 * mJ};
    return {{"16 pairs", pairs, equal, -1},
            {"16 pairs, three floored", pairs, equal, 3},
            {"16 pairs, three floored", pairs, none, 3},
            {"16 pairs, three floored", pairs, of_groups, 3},
            {"12 pairs, none floored", subset(pairs, all, soft), equal, 0},
            {"9 pairs", subset(pairs, three, soft), equal, -1},
            {"9 pairs, three stiff", subset(pairs, three, {"E0.7", "E1.9", "E10"}), equal, -1},
            {"4 pairs", subset(pairs, two, ends), equal, -1}};
}

void print_estimators(const PublishedPairs& published, int sets) {
    fmt::print(
        "| design | scatter of pair, surface, elastomer | estimator | bias | SD of values | SE stated (rms) | width of 95 "
        "% interval | 68 % covers | 95 % covers | data sets |\n|---|---|---|---|---|---|---|---|---|---|\n");
    for (const auto& design : designs(published.points()))
        for (const auto& of : survey_estimators(design, sets, first_seed)) {
            fmt::print(
                "| {} | {:g}, {:g}, {:g} | {} | {:+.1f} | {:.1f} | {:.1f} | {:.1f} | {:.1f} % | {:.1f} % | {} |\n",
                design.name, design.scatter.pair / mJ, design.scatter.surface / mJ, design.scatter.elastomer / mJ,
                of.estimator, of.bias / mJ, of.deviation / mJ, of.stated / mJ, of.width / mJ, 100.0 * of.covered_68,
                100.0 * of.covered_95, of.sets);
            std::fflush(stdout);
        }
}

void print_floored(const PublishedPairs& published, int sets) {
    fmt::print(
        "| floored pairs | bias of the posterior | SD of values | SE stated (rms) | 68 % covers | 95 % covers | bias of "
        "generalised least squares | its 95 % covers |\n|---|---|---|---|---|---|---|---|\n");
    constexpr int most = 7;
    for (int floored = 0; floored <= most; ++floored) {
        const EstimatorDesign design{"16 pairs", published.points(), {5 * mJ, 5 * mJ, 5 * mJ}, floored};
        const auto surveys = survey_estimators(design, sets, 5000 + 100000ULL * static_cast<std::uint64_t>(floored));
        const auto &posterior = surveys.front(), &generalised = surveys.back();
        fmt::print("| {} | {:+.1f} | {:.1f} | {:.1f} | {:.0f} % | {:.0f} % | {:+.1f} | {:.0f} % |\n", floored,
                   posterior.bias / mJ, posterior.deviation / mJ, posterior.stated / mJ, 100.0 * posterior.covered_68,
                   100.0 * posterior.covered_95, generalised.bias / mJ, 100.0 * generalised.covered_95);
        std::fflush(stdout);
    }
}

/// One digit, at most 10⁴ and at least 10⁻⁴.
std::string odds_text(double log_odds) {
    const double most = std::log(1e4);
    if (log_odds > most) return "> 10⁴";
    if (log_odds < -most) return "< 10⁻⁴";
    const double odds = std::exp(log_odds), unit = std::pow(10.0, std::floor(std::log10(odds)));
    return fmt::format("{:g}", std::round(odds / unit) * unit);
}

std::vector<hysteresis::ModelScore> chosen(const hysteresis::Ranking& ranking, double scatter,
                                           const std::vector<std::string>& names) {
    auto models = true_models(ranking, scatter);
    if (names.empty()) return models;
    std::erase_if(models, [&](const hysteresis::ModelScore& score) {
        return std::ranges::find(names, score.fitted.model.name()) == names.end();
    });
    return models;
}

/// against_reversible: the true model and `reversible` alone, not all models.
void print_classes(const PublishedPairs& published, int sets, double scatter, const std::vector<std::string>& names,
                   bool against_reversible) {
    const auto all = hysteresis::retraction_models();
    const auto ranking = hysteresis::rank_models(all, published.ranked(), {}, {1});
    fmt::print(
        "| true model | scatter | data sets | likeliest | cannot be distinguished | another better | another clearly "
        "better | by | refused for a constant | models left | claims of it: clearly better | better | odds against "
        "`reversible`, 5, 50, 95 % | `reversible` excluded | both possible |\n"
        "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (const auto& truth : chosen(ranking, scatter, names)) {
        const auto models = against_reversible ? std::vector{truth.fitted.model, all.front()} : all;
        const auto of = calibrate(models, published.ranked(), truth, sets, first_seed);
        std::vector<std::string> by;
        for (const auto& [name, times] : of.beaten_by) by.push_back(fmt::format("`{}` {}", name, times));
        fmt::print("| `{}` | {:g} | {} | {} | {} | {} | {} | {} | {} | {:.1f} | {} | {} | {}, {}, {} | {} | {} |\n",
                   of.model, scatter / mJ, of.sets, of.best, of.not_distinguished, of.beaten_better, of.beaten_clearly,
                   fmt::join(by, ", "), of.refused, static_cast<double>(of.left) / std::max(1, of.sets),
                   of.claims_clearly, of.claims_better, odds_text(of.odds_lower), odds_text(of.odds_median),
                   odds_text(of.odds_upper), of.reversible_excluded, of.reversible_undecided);
        std::fflush(stdout);
    }
}

void print_bias(const PublishedPairs& published, int sets, double scatter) {
    const auto ranking = hysteresis::rank_models(hysteresis::retraction_models(), published.ranked(), {}, {1});
    fmt::print("| true model | scatter | constant | data sets | refused |\n|---|---|---|---|---|\n");
    for (const auto& truth : true_models(ranking, scatter)) {
        constexpr double constant = 60 * mJ;
        const auto of = calibrate_bias(published.ranked(), truth, constant, sets, first_seed);
        fmt::print("| `{}` | {:g} | {:g} | {} | {} |\n", of.model, scatter / mJ, constant / mJ, of.sets, of.refused);
        std::fflush(stdout);
    }
}

void print_jitter(const PublishedPairs& published, int sets) {
    fmt::print(
        "| model | odds against it [5, 95 % by the data's own errors] | odds with jitter of 1 mJ/m², 5, 50, 95 % | "
        "likeliest | cannot be distinguished | better | clearly better | refused |\n|---|---|---|---|---|---|---|---|\n");
    for (const auto& of : jitter(hysteresis::retraction_models(), published.ranked(), 1 * mJ, sets, first_seed)) {
        const auto text = [](double odds) { return odds_text(std::log(odds)); };
        fmt::print("| `{}` | {} [{}, {}] | {}, {}, {} | {} | {} | {} | {} | {} |\n", of.model, text(of.value),
                   text(of.lower), text(of.upper), text(of.jittered_lower), text(of.jittered_median),
                   text(of.jittered_upper), of.likeliest, of.cannot_be_distinguished, of.better, of.clearly_better,
                   of.refused);
    }
}

}  // namespace

int main(int count, char** arguments) {
    const std::vector<std::string> given(arguments + 1, arguments + count);
    const auto number = [&](std::size_t i, double otherwise) {
        return given.size() > i ? std::strtod(given[i].c_str(), nullptr) : otherwise;
    };
    const std::string what = given.empty() ? "" : given[0];
    const int sets = static_cast<int>(number(1, 400));
    const double scatter = number(2, 8.0) * mJ;
    const auto start = std::chrono::steady_clock::now();
    const PublishedPairs published;
    if (what == "estimators") print_estimators(published, sets);
    else if (what == "floored") print_floored(published, sets);
    else if (what == "classes" || what == "against")
        print_classes(
            published, sets, scatter,
            {given.begin() + std::min<std::ptrdiff_t>(3, static_cast<std::ptrdiff_t>(given.size())), given.end()},
            what == "against");
    else if (what == "bias") print_bias(published, sets, scatter);
    else if (what == "jitter") print_jitter(published, sets);
    else {
        fmt::print(stderr, "ranking_survey estimators | floored | classes | against | bias | jitter [SETS] …\n");
        return 2;
    }
    fmt::print(stderr, "{:.0f} s\n", std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
}
