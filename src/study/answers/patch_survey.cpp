// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/patch_survey.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "setae/answers/made_surface.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/hysteresis/retraction_model.hpp"
#include "setae/roughness/energy_below.hpp"

namespace setae::answers {
namespace {

using patches::PatchDesign;
using patches::SurveyRow;

/// relative error up to which the full-contact balance (Eq. 7) is treated as correct
constexpr double right_balance = 0.05;

/// Share of U_el in bands.
class StoredEnergy {
public:
    explicit StoredEnergy(const spectra::Spectrum& curve) : cumulative_(roughness::cumulative_parameters(curve)) {}
    [[nodiscard]] bool known() const { return cumulative_.wavevector.size() > 1 && all() > 0.0; }
    [[nodiscard]] double lowest() const { return cumulative_.wavevector[0]; }
    [[nodiscard]] double highest() const { return cumulative_.wavevector[cumulative_.wavevector.size() - 1]; }
    [[nodiscard]] double share(double from, double to) const {
        return (roughness::energy_below(cumulative_, to) - roughness::energy_below(cumulative_, from)) / all();
    }

private:
    [[nodiscard]] double all() const {
        const auto& energy = cumulative_.elastic_energy_per_modulus;
        return energy[energy.size() - 1];
    }
    roughness::CumulativeParameters cumulative_;
};

/// Lower end of the band with a given ratio that contains most of U_el.
double richest_band(const StoredEnergy& stored, double ratio) {
    constexpr int places = 200;
    const double room = std::max(1.0, stored.highest() / stored.lowest() / ratio);
    double best = stored.lowest();
    for (int k = 1; k <= places; ++k) {
        const double lowest = stored.lowest() * std::pow(room, static_cast<double>(k) / places);
        if (stored.share(lowest, lowest * ratio) > stored.share(best, best * ratio)) best = lowest;
    }
    return best;
}

/// Design of the patches of a pair, or the reason for which there are none.
struct PairDesign {
    PatchDesign design;
    PatchPair pair;
    std::string reason;
};

PairDesign design_of(const study::StudyResult& study, const study::PairResult& pair, PatchDesign kind) try {
    PairDesign result{.pair = {.surface = pair.surface, .elastomer = pair.elastomer, .measured = pair.approach}};
    const auto& surface = study.surface(pair.surface);
    if (surface.failed() || !pair.modified) {
        result.reason = surface.failed() ? surface.error : "no modulus is known";
        return result;
    }
    const hysteresis::PairState state{.area_ratio = pair.area_ratio,
                                      .stored_energy = pair.stored_energy.value,
                                      .work_of_adhesion = study.traced_work_of_adhesion.value,
                                      .surface_energy = study.elastomer(pair.elastomer).input.surface_energy.value};
    const auto curve = isotropic_spectrum(surface);
    const StoredEnergy stored(curve);
    if (!(state.full_contact_gain() > 0.0 && state.stored_energy > 0.0 && stored.known())) {
        result.reason = "full contact gains or stores no energy, or W_int is not known";
        return result;
    }
    const double lowest = richest_band(stored, kind.band());
    const double lowest_of_patch = 2.0 * pi * kind.waves_per_side / static_cast<double>(kind.points);
    kind.spectrum = [C_iso = density_of(curve), scale = lowest / lowest_of_patch](double q) {
        return C_iso(q * scale);
    };
    kind.energy_share = state.energy_share();
    result.design = kind;
    result.pair.work = state.full_contact_gain();
    result.pair.energy_in_band = stored.share(lowest, lowest * kind.band());
    result.pair.answers = study::contact_answers(study, pair);
    return result;
} catch (const UndefinedDataError& error) {
    return {.reason = error.what()};
}

patches::SurveyDesign survey_of(std::vector<PatchDesign> designs, const PatchSurveyRequest& request,
                                parallel::Threads threads, const PatchProgress& progress) {
    return {.designs = std::move(designs),
            .seeds = request.seeds,
            .first_seed = request.seed,
            .protocol = {.loop = request.loops},
            .threads = threads,
            .progress = progress};
}

/// Energy share at which related rows, by increasing share, cross a value; empty where they do not.
template <class Value>
std::optional<double> crossing(const std::vector<const SurveyRow*>& rows, double level, const Value& value) {
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const double before = value(*rows[i - 1]) - level, after = value(*rows[i]) - level;
        if (before >= 0.0 && after < 0.0) {
            const double x = rows[i - 1]->design.energy_share;
            return x + (rows[i]->design.energy_share - x) * before / (before - after);
        }
    }
    return std::nullopt;
}

/// Rows of the first kind of patch, by share.
std::vector<const SurveyRow*> first_kind(const std::vector<SurveyRow>& rows) {
    std::vector<const SurveyRow*> kind;
    for (const auto& row : rows)
        if (row.design.like(rows.front().design)) kind.push_back(&row);
    std::ranges::stable_sort(kind, {}, [](const SurveyRow* row) { return row->design.energy_share; });
    return kind;
}

std::string sentence_of_shares(const std::vector<SurveyRow>& rows) {
    const auto kind = first_kind(rows);
    std::string text;
    if (const auto closes =
            crossing(kind, patches::closed_area, [](const SurveyRow& row) { return row.area_from_far.value; }))
        text = fmt::format("Patches come into spontaneous contact on {:.0f} % of their area up to U_el = {:.2f} AW. ",
                           100.0 * patches::closed_area, *closes);
    const auto right = crossing(kind, 1.0 - right_balance, [](const SurveyRow& row) {
        return row.gain_from_far.value > 0.0 ? balance_of(row) / row.gain_from_far.value : 1.0;
    });
    if (right)
        text += fmt::format(
            "The full-contact balance (Eq. 7) is within {:.0f} % of the gained energy up to U_el = {:.2f} AW. ",
            100.0 * right_balance, *right);
    const auto& last = *kind.back();
    text += fmt::format(
        "At U_el = {:.2g} AW, where Eq. 7 gives {:.2f} W, contact gains {:.2f} W on {:.0f} % of the area.",
        last.design.energy_share, balance_of(last), last.gain_from_far.value, 100.0 * last.area_from_far.value);
    return text;
}

std::string sentence_of_pairs(const PatchSurveyAnswer& answer) {
    std::size_t closed = 0, nothing = 0;
    double largest = 0.0;
    std::string where;
    for (std::size_t i = 0; i < answer.rows.size(); ++i) {
        const auto& row = answer.rows[i];
        if (row.area_from_far.value >= patches::closed_area) ++closed;
        if (row.design.energy_share >= 1.0) ++nothing;
        const double more = answer.pairs[i].work * (row.gain_from_far.value - balance_of(row));
        if (more <= largest) continue;
        largest = more;
        where = answer.pairs[i].surface + ", " + answer.pairs[i].elastomer;
    }
    std::string text = fmt::format("{} of {} pairs come into spontaneous contact on {:.0f} % of their area. ", closed,
                                   answer.rows.size(), 100.0 * patches::closed_area);
    if (nothing > 0)
        text += fmt::format("For {} of them, the full-contact balance (Eq. 7) gives no adhesion. ", nothing);
    else text += "The full-contact balance (Eq. 7) gives adhesion for each pair. ";
    if (largest > 0.0)
        text += fmt::format("Contact gains up to {:.2g} mJ/m2 more than Eq. 7 predicts ({}).", 1e3 * largest, where);
    return text;
}

}  // namespace

std::vector<PatchDesign> PatchSurveyRequest::kinds() const {
    std::vector<PatchDesign> kinds;
    for (const Index n : points)
        for (const double wave : points_per_wave)
            for (const double ratio : squared_ratios)
                kinds.push_back({.points = n,
                                 .points_per_wave = wave,
                                 .waves_per_side = waves_per_side,
                                 .hurst_exponent = hurst_exponent,
                                 .squared_ratio = ratio,
                                 .law = half_space::attraction_law_named(law)});
    return kinds;
}

PatchSurveyAnswer patch_survey(const PatchSurveyRequest& request, parallel::Threads threads,
                               const PatchProgress& progress) {
    std::vector<PatchDesign> designs;
    for (auto kind : request.kinds())
        for (const double share : request.energy_shares) {
            kind.energy_share = share;
            designs.push_back(kind);
        }
    return {.rows = patches::survey(survey_of(std::move(designs), request, threads, progress)), .loops = request.loops};
}

PatchSurveyAnswer patch_survey(const study::StudyResult& study, const PatchSurveyRequest& request,
                               parallel::Threads threads, const PatchProgress& progress) {
    PatchSurveyAnswer answer{.loops = request.loops};
    std::vector<PatchDesign> designs;
    for (const auto& kind : request.kinds())
        for (const auto& pair : study.pairs) {
            auto found = design_of(study, pair, kind);
            if (found.reason.empty()) {
                designs.push_back(std::move(found.design));
                answer.pairs.push_back(std::move(found.pair));
            } else {
                answer.skipped.push_back(fmt::format("{} × {}: {}", pair.surface, pair.elastomer, found.reason));
            }
        }
    if (designs.empty())
        throw UndefinedDataError(
            "no pair of the study has a spectrum, a modulus and W_int; expected one at least, see docs/guides/study.md");
    answer.rows = patches::survey(survey_of(std::move(designs), request, threads, progress));
    return answer;
}

double balance_of(const SurveyRow& row) { return std::max(0.0, 1.0 - row.design.energy_share); }

study::ContactAnswers answers_with(const SurveyRow& row, const PatchPair& pair) {
    auto answers = pair.answers;
    answers.answers.push_back({study::ContactTheory::simulated_cell,
                               {.value = pair.work * row.gain_from_far.value,
                                .standard_error = pair.work * row.gain_from_far.standard_error,
                                .method = "mean over patches"},
                               {.value = row.area_from_far.value,
                                .standard_error = row.area_from_far.standard_error,
                                .method = "mean over patches"},
                               false});
    return answers;
}

std::string sentence(const PatchSurveyAnswer& answer) {
    return answer.pairs.empty() ? sentence_of_shares(answer.rows) : sentence_of_pairs(answer);
}

tables::TidyTable patch_survey_table(const PatchSurveyAnswer& answer) {
    tables::TidyTable table;
    const bool of_study = !answer.pairs.empty();
    if (of_study) table.columns = {"surface", "elastomer"};
    for (const char* name :
         {"U_el/AW", "band", "ρ/h", "area", "gain/W", "± gain", "(7)/W", "preloaded", "p closes", "T opens"})
        table.columns.emplace_back(name);
    if (of_study)
        for (const char* name : {"in band", "W_app [J/m2]", "gain [J/m2]", "(7) [J/m2]", "measured [J/m2]"})
            table.columns.emplace_back(name);
    if (answer.loops)
        for (const char* name : {"W_appr/W", "W_sep/W", "loss/W", "± loss", "in jumps", "T most"})
            table.columns.emplace_back(name);
    for (std::size_t i = 0; i < answer.rows.size(); ++i) {
        const auto& row = answer.rows[i];
        std::vector<tables::TidyTable::Cell> cells;
        if (of_study) cells = {answer.pairs[i].surface, answer.pairs[i].elastomer};
        const auto add = [&](double value) { cells.emplace_back(value); };
        add(row.design.energy_share);
        add(row.design.band());
        add(row.range_over_height);
        add(row.area_from_far.value);
        add(row.gain_from_far.value);
        add(row.gain_from_far.standard_error);
        add(balance_of(row));
        add(row.area_after_preload.value);
        add(row.closed == row.patches ? row.closing_pressure.value : undefined);
        add(row.opening_tension.value);
        if (of_study) {
            const auto& pair = answer.pairs[i];
            add(pair.energy_in_band);
            add(pair.answers.recommended().work_of_adhesion.value);
            add(pair.work * row.gain_from_far.value);
            add(pair.work * balance_of(row));
            add(pair.measured ? pair.measured->value : undefined);
        }
        if (answer.loops)
            for (const double value : {row.approach_work.value, row.separation_work.value, row.loss.value,
                                       row.loss.standard_error, row.large_jumps.value, row.greatest_tension.value})
                add(value);
        table.rows.push_back(std::move(cells));
    }
    return table;
}

tables::TidyTable patch_screen_table(const PatchSurveyAnswer& answer) {
    if (answer.pairs.empty()) return patch_survey_table(answer);
    constexpr double milli = 1e-3;
    tables::TidyTable table;
    table.columns = {"surface", "elastomer", "U_el/AW", "W_app [mJ/m2]", "simulated cell",
                     "±",       "its area",  "(7)",     "measured"};
    for (std::size_t i = 0; i < answer.rows.size(); ++i) {
        const auto& row = answer.rows[i];
        const auto& pair = answer.pairs[i];
        const double unit = pair.work / milli;
        table.rows.push_back({pair.surface, pair.elastomer, row.design.energy_share,
                              pair.answers.recommended().work_of_adhesion.value / milli, unit * row.gain_from_far.value,
                              unit * row.gain_from_far.standard_error, row.area_from_far.value, unit * balance_of(row),
                              pair.measured ? pair.measured->value / milli : undefined});
    }
    return table;
}

}  // namespace setae::answers
