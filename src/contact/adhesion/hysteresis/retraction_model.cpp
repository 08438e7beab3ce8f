// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/hysteresis/retraction_model.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "setae/core/errors.hpp"

namespace setae::hysteresis {
namespace {

constexpr std::array laws{Law::reversible,     Law::pinning,      Law::pinning_by_bands,     Law::fitted_pinning,
                          Law::conformal_loss, Law::opening_work, Law::fitted_conformal_loss};

struct ModelText {
    const char *name, *works;  ///< works: works multiplied by φ
};

ModelText text_of(Law law) {
    switch (law) {
        case Law::reversible: return {"reversible", "W_app"};
        case Law::pinning: return {"pinning", "W_app + 2k(U_el/AW, N) U_el/A"};
        case Law::pinning_by_bands: return {"pinning_by_bands", "W_app + Σ 2k(U_b/AW, N_b) U_b/A"};
        case Law::fitted_pinning: return {"fitted_pinning", "W_app + 2k U_el/A"};
        case Law::conformal_loss: return {"conformal_loss", "W_app + W_int A_true/A"};
        case Law::fitted_conformal_loss: return {"fitted_conformal_loss", "W_app + W_x A_true/A"};
        case Law::opening_work: return {"opening_work", "W_x A_true/A"};
    }
    throw InternalError("a retraction model without a name");
}

void require_valid(const PairState& state) {
    if (!(state.area_ratio >= 1.0 && state.contact_fraction > 0.0 && state.contact_fraction <= 1.0 &&
          state.stored_energy >= 0.0 && state.work_of_adhesion > 0.0 && state.work_approach >= 0.0 &&
          state.tip_factor > 0.0 && state.full_contact_gain() > 0.0))
        throw InvalidArgument(fmt::format(
            "a pair with A_true/A {:.4g}, {:.4g} of it in contact, U_el/A {:.4g} J/m2, W_int {:.4g} J/m2, γ1 {:.4g} J/m2, W_app {:.4g} J/m2 and "
            "W_ret/W_app {:.4g} of its reference; expected an area ratio of at least 1, contact, works and a factor above 0, and a positive "
            "gain W_int A_true/A − γ1 (A_true/A − 1)",
            state.area_ratio, state.contact_fraction, state.stored_energy, state.work_of_adhesion, state.surface_energy,
            state.work_approach, state.tip_factor));
}

/// k U_el/A of simulated fronts [J/m²] on an edge that bends over free_length.
double pinned_energy(Law law, const PairState& state, const std::vector<PinningBand>& bands, double free_length) {
    if (law == Law::pinning_by_bands)
        return state.pinning_factor * pinning_by_bands(state.stored_energy, bands,
                                                       state.contact_fraction * state.full_contact_gain(), free_length);
    const double share = state.energy_share();
    return state.pinning_factor *
           pinning_constant(share, edge_larkin_lengths(free_length, state.mean_wavelength, share)) *
           state.stored_energy;
}

}  // namespace

std::string RetractionModel::name() const {
    if (tip == Tip::none) return text_of(law).name;
    const std::string tip_name = tip == Tip::reference ? "crack_tip" : "crack_speed";
    return law == Law::reversible ? tip_name : fmt::format("{}_{}", tip_name, text_of(law).name);
}

std::string RetractionModel::formula() const {
    const std::string works = text_of(law).works;
    if (tip == Tip::none) return works;
    const std::string factor = tip == Tip::reference ? "φ" : "φ(v)";
    return works.find(" + ") == std::string::npos ? factor + " " + works : fmt::format("{} ({})", factor, works);
}

bool RetractionModel::fitted() const {
    return law == Law::fitted_pinning || law == Law::fitted_conformal_loss || law == Law::opening_work;
}

ModelParameter RetractionModel::parameter() const {
    if (!fitted()) throw InternalError(name() + " has no parameter");
    if (law == Law::fitted_pinning) return {"k", "pinning_coefficient", "1"};
    return {"W_x", "work_per_true_area", "J/m2"};
}

std::vector<RetractionModel> retraction_models(const std::vector<Tip>& tips) {
    std::vector<RetractionModel> models;
    for (const Tip tip : tips)
        for (const Law law : laws) models.push_back({law, tip});
    return models;
}

double PairState::full_contact_gain() const {
    return work_of_adhesion * area_ratio - surface_energy * (area_ratio - 1.0);
}

RetractionLine retraction_line(const RetractionModel& model, const PairState& state,
                               const std::vector<PinningBand>& bands) {
    require_valid(state);
    const double phi = model.tip == Tip::none ? 1.0 : state.tip_factor;
    const auto adds = [&](double excess) { return RetractionLine{0.0, phi * (state.work_approach + excess)}; };
    const auto fits = [&](double slope, double constant) { return RetractionLine{phi * slope, phi * constant}; };
    switch (model.law) {
        case Law::reversible: return adds(0.0);
        case Law::pinning:
        case Law::pinning_by_bands:
            return adds(pinned_energy(model.law, state, bands, state.edge.approach) +
                        pinned_energy(model.law, state, bands, state.edge.retraction));
        case Law::fitted_pinning: return fits(2.0 * state.stored_energy, state.work_approach);
        case Law::conformal_loss: return adds(state.work_of_adhesion * state.true_contact() - state.jumps_per_area);
        case Law::fitted_conformal_loss: return fits(state.true_contact(), state.work_approach - state.jumps_per_area);
        case Law::opening_work: return fits(state.true_contact(), 0.0);
    }
    throw InternalError("a retraction model without a formula");
}

double pinned_on_approach(const RetractionModel& model, const PairState& state, const std::vector<PinningBand>& bands,
                          double parameter) {
    switch (model.law) {
        case Law::pinning:
        case Law::pinning_by_bands: return pinned_energy(model.law, state, bands, state.edge.approach);
        case Law::fitted_pinning: return std::max(0.0, parameter) * state.stored_energy;
        default: return 0.0;
    }
}

}  // namespace setae::hysteresis
