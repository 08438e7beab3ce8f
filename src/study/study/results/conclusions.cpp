// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <type_traits>

#include <fmt/format.h>

#include "failed_part.hpp"
#include "pairs.hpp"
#include "setae/adhesion/contact_scales.hpp"
#include "setae/adhesion/partial_contact.hpp"
#include "setae/adhesion/unmeasured_waves.hpp"
#include "setae/adhesion/work_posterior.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/rectified.hpp"
#include "setae/core/words.hpp"
#include "setae/study/next_measurement.hpp"

namespace setae::study {
namespace {

using adhesion::PairPoint;
using adhesion::RoughnessInContact;
using adhesion::RoughSide;
using adhesion::SoftSide;
using roughness::SpectralParameters;

/// Whether the full-contact balance (Eq. 7) can be evaluated for a pair: a spectrum and a modulus.
bool predictable(const SurfaceResult& surface, const ElastomerResult& elastomer) {
    return !surface.failed() && elastomer.contact_modulus.value > 0.0;
}

/// Conclusions on their way: fits first, then predictions at the W_int they lead to.
class Concluding {
public:
    Concluding(const StudyResult& result, Conclusions& conclusions) : result_(result), to_(conclusions) {}

    void fit();
    void predict();
    void test();
    void draw();

private:
    using Balance = PairPoint (*)(const RoughSide&, const SoftSide&);
    using ParametersOf = std::function<const SpectralParameters&(std::size_t surface)>;

    /// A surface within the contact of one pair: without waves longer than the contact and the depth of the soft body.
    void find_shares();
    [[nodiscard]] RoughnessInContact in_contact(const PairResult& pair, const SpectralParameters& parameters) const;
    [[nodiscard]] ParametersOf whole_spectra() const {
        return [this](std::size_t i) -> const SpectralParameters& {
            return to_.spectrum_of(result_.surfaces[i]).parameters;
        };
    }
    [[nodiscard]] std::vector<PairPoint> points(Balance balance, const ParametersOf& parameters_of) const;
    /// A fit, or why it cannot be made.
    template <class Fit>
    [[nodiscard]] std::invoke_result_t<Fit> attempted(const char* part, const Fit& fit) {
        std::invoke_result_t<Fit> outcome;
        if (!isolated(to_.failed_parts, part, [&] { outcome = fit(); }))
            outcome = std::invoke_result_t<Fit>::missing(to_.failed_parts.back().message);
        return outcome;
    }
    [[nodiscard]] Outcome<adhesion::WorkFit> fit_approach(Balance balance) const;
    [[nodiscard]] Outcome<adhesion::LossFits> fit_losses() const;
    [[nodiscard]] std::vector<adhesion::FreeEnergyPoint> free_points(const ParametersOf& parameters_of,
                                                                     double factor) const;
    [[nodiscard]] Outcome<adhesion::FreeEnergyFit> fit_free() const;
    [[nodiscard]] std::vector<adhesion::PartialContactPoint> partial_points(const ParametersOf& parameters_of,
                                                                            double factor) const;
    [[nodiscard]] Outcome<adhesion::StrainedInterfaceFit> fit_interface() const;
    [[nodiscard]] Outcome<std::vector<PairPoint>> reference_scaled(std::vector<PairPoint> modified) const;
    [[nodiscard]] Outcome<adhesion::WorkFit> fit_reference_scaled() const;
    [[nodiscard]] std::vector<CutoffPoint> scan_cutoffs() const;
    [[nodiscard]] std::vector<std::string> profiled_inputs() const;
    [[nodiscard]] std::vector<double> compared_cuts() const;
    [[nodiscard]] std::vector<ComparedBalance> compare_balances() const;
    void compare(std::vector<ComparedBalance>& balances, const std::vector<SpectralParameters>& surfaces,
                 double shortest, double factor) const;
    [[nodiscard]] std::vector<SpectralParameters> cut_at(double shortest) const;
    void add_departure(PairResult& pair) const;
    void predict(PairResult& pair, const SurfaceResult& surface, const ElastomerResult& elastomer) const;

    const StudyResult& result_;
    Conclusions& to_;
    std::optional<adhesion::WorkPosterior> posterior_;  ///< of W_int, where it was fitted
};

/// Part of the surface that acts in each pair's contact: waves shorter than its diameter, unless the study states the
/// longest, in a soft body as high as the lens.
void Concluding::find_shares() {
    for (auto& pair : to_.pairs) {
        const auto& surface = result_.surface(pair.surface);
        if (surface.failed()) continue;
        const auto& soft = result_.elastomer(pair.elastomer).input;
        adhesion::ContactScales scales{.poisson_ratio = soft.poisson_ratio.value};
        if (soft.sphere_height) scales.thickness = soft.sphere_height->value;
        if (pair.contact_area && !result_.study.analysis.longest_wavelength)
            scales.contact_diameter = 2.0 * std::sqrt(*pair.contact_area / pi);
        if (scales.contact_diameter || scales.thickness)
            pair.seen = adhesion::contact_shares(to_.spectrum_of(surface).curve, scales);
    }
}

RoughnessInContact Concluding::in_contact(const PairResult& pair, const SpectralParameters& parameters) const {
    return adhesion::roughness_in_contact(parameters, to_.spectrum_of(result_.surface(pair.surface)).spread, pair.seen);
}

/// Points of all pairs with a measured approach, for one balance.
std::vector<PairPoint> Concluding::points(Balance balance, const ParametersOf& parameters_of) const {
    std::vector<PairPoint> found;
    for (const auto& pair : to_.pairs) {
        if (!pair.approach) continue;
        const auto& surface = result_.surface(pair.surface);
        const auto& elastomer = result_.elastomer(pair.elastomer);
        if (!predictable(surface, elastomer)) continue;
        const auto index = static_cast<std::size_t>(&surface - result_.surfaces.data());
        isolated(to_.failed_parts, pair_name(pair), [&] {
            const auto rough = in_contact(pair, parameters_of(index));
            auto point = balance({surface.name, rough.parameters, rough.spread}, elastomer.soft_side());
            if (!std::isfinite(point.slope) || !std::isfinite(point.offset))
                throw UndefinedDataError(
                    fmt::format("the balance is not a finite number: slope {}, offset {} J/m2; check the spectrum, the "
                                "modulus and the surface energy",
                                point.slope, point.offset));
            point.measured = *pair.approach;
            point.measured.value = std::max(0.0, point.measured.value);
            point.in_unitputs = pair.approach_inputs;
            point.measured_noise = pair.approach_fits;
            found.push_back(std::move(point));
        });
    }
    return found;
}

Outcome<adhesion::WorkFit> Concluding::fit_approach(Balance balance) const {
    const auto found = points(balance, whole_spectra());
    if (found.size() < 2)
        return Outcome<adhesion::WorkFit>::missing(
            fmt::format("{} with a measured work of adhesion, a spectrum and a modulus; a fit needs at least 2",
                        counted(found.size(), "pair", "pairs")));
    auto fit = adhesion::fit_work_of_adhesion(found);
    fit.posterior = adhesion::WorkPosterior(found).work_of_adhesion();
    return fit;
}

Outcome<adhesion::LossFits> Concluding::fit_losses() const {
    std::vector<PairPoint> whole, reduced;
    for (const auto& pair : to_.pairs) {
        const auto& surface = result_.surface(pair.surface);
        if (!pair.loss || !pair.contact_area || surface.failed()) continue;
        const auto rough = in_contact(pair, to_.spectrum_of(surface).parameters);
        PairPoint point;
        point.surface = pair.surface;
        point.elastomer = pair.elastomer;
        point.quantity = "E_loss";
        point.measured = *pair.loss;
        point.in_unitputs = pair.loss_inputs;
        point.slope = rough.parameters.area_ratio() * *pair.contact_area;
        const RoughSide side{pair.surface, rough.parameters, rough.spread};
        const auto ratio = side.traced([](const SpectralParameters& p) { return p.area_ratio(); });
        point.slope_inputs =
            combined({{*pair.contact_area, ratio.components}, {ratio.value, pair.contact_area_inputs}});
        point.floored = false;
        whole.push_back(point);
        if (!pair.ideal_loss) continue;
        point.measured.value -= *pair.ideal_loss;
        reduced.push_back(point);
    }
    if (whole.size() < 2)
        return Outcome<adhesion::LossFits>::missing(
            fmt::format("{} with a loop energy and a contact radius; a fit needs at least 2",
                        counted(whole.size(), "pair", "pairs")));
    auto fits = adhesion::fit_losses(whole, reduced);
    fits.through_origin.posterior = adhesion::WorkPosterior(whole).work_of_adhesion();
    return fits;
}

/// Eq. 7 of all pairs with free stored energies; factor: on γ1.
std::vector<adhesion::FreeEnergyPoint> Concluding::free_points(const ParametersOf& parameters_of, double factor) const {
    std::vector<adhesion::FreeEnergyPoint> found;
    for (auto& point : points(adhesion::point_without_stored_energy, parameters_of)) {
        point.offset *= factor;
        const auto& modulus = result_.elastomer(point.elastomer).traced_contact_modulus;
        found.push_back({std::move(point), modulus});
    }
    return found;
}

/// Energies gained and stored in full contact of all pairs; factor: on γ1.
std::vector<adhesion::PartialContactPoint> Concluding::partial_points(const ParametersOf& parameters_of,
                                                                      double factor) const {
    const auto whole = points(adhesion::modified_point, parameters_of);
    auto gained = points(adhesion::point_without_stored_energy, parameters_of);
    std::vector<adhesion::PartialContactPoint> found;
    for (std::size_t i = 0; i < whole.size(); ++i) {
        const double stored = whole[i].offset - gained[i].offset;
        gained[i].offset *= factor;
        found.push_back({std::move(gained[i]), stored});
    }
    return found;
}

Outcome<adhesion::FreeEnergyFit> Concluding::fit_free() const {
    const auto found = free_points(whole_spectra(), 1.0);
    if (found.size() < 2)
        return Outcome<adhesion::FreeEnergyFit>::missing("fewer than 2 pairs have a measured work of adhesion");
    auto fit = adhesion::fit_with_free_energies(found);
    fit.generalised = adhesion::fit_free_energies_generalised(found, fit);
    return fit;
}

Outcome<adhesion::StrainedInterfaceFit> Concluding::fit_interface() const {
    try {
        return adhesion::fit_strained_interface(points(adhesion::modified_point, whole_spectra()));
    } catch (const InvalidArgument& error) {
        return Outcome<adhesion::StrainedInterfaceFit>::missing(error.what());
    }
}

/// Eq. 7 with W_int in proportion to the reference of each elastomer, or the elastomer without one.
Outcome<std::vector<PairPoint>> Concluding::reference_scaled(std::vector<PairPoint> modified) const {
    for (auto& point : modified) {
        const auto reference = reference_work(result_, point.elastomer);
        if (!reference)
            return Outcome<std::vector<PairPoint>>::missing("no smooth reference is given on " + point.elastomer);
        point = adhesion::reference_scaled_point(std::move(point), *reference);
    }
    return modified;
}

Outcome<adhesion::WorkFit> Concluding::fit_reference_scaled() const {
    const auto scaled = reference_scaled(points(adhesion::modified_point, whole_spectra()));
    if (!scaled) return Outcome<adhesion::WorkFit>::missing(scaled.reason);
    if (scaled->size() < 2)
        return Outcome<adhesion::WorkFit>::missing("fewer than 2 pairs have a measured work of adhesion");
    auto fit = adhesion::fit_work_of_adhesion(*scaled);
    fit.posterior = adhesion::WorkPosterior(*scaled).work_of_adhesion();
    return fit;
}

/// Parameters of every surface with its spectrum cut; of failed ones none.
std::vector<SpectralParameters> Concluding::cut_at(double shortest) const {
    std::vector<SpectralParameters> surfaces;
    for (const auto& surface : result_.surfaces)
        surfaces.push_back(surface.failed() ? SpectralParameters{}
                                            : parameters_within(to_.spectrum_of(surface), {.shortest = shortest},
                                                                result_.study.analysis.conversion));
    return surfaces;
}

/// Short cuts that leave a part of every spectrum, two per decade.
std::vector<double> Concluding::compared_cuts() const {
    double finest = 0.0, coarsest = std::numeric_limits<double>::infinity();
    for (const auto& surface : result_.surfaces) {
        if (surface.failed()) continue;
        const auto& band = to_.spectrum_of(surface).curve.band;
        finest = std::max(finest, 2.0 * pi / band.upper);
        coarsest = std::min(coarsest, 2.0 * pi / band.lower);
    }
    std::vector<double> cuts;
    for (const double cut : {3e-10, 1e-9, 3e-9, 1e-8, 3e-8, 1e-7, 3e-7, 1e-6})
        if (cut > finest && cut < coarsest / 10.0) cuts.push_back(cut);
    return cuts;
}

void Concluding::compare(std::vector<ComparedBalance>& balances, const std::vector<SpectralParameters>& surfaces,
                         double shortest, double factor) const {
    const auto of = [&](std::size_t i) -> const SpectralParameters& { return surfaces[i]; };
    const auto add = [&](const char* name, const adhesion::BalanceScore& score) {
        balances.push_back({name, shortest, factor, score});
    };
    const auto scaled = [&] {
        auto found = points(adhesion::modified_point, of);
        for (auto& point : found)
            point.offset +=
                (factor - 1.0) * result_.elastomer(point.elastomer).input.surface_energy.value * (point.slope - 1.0);
        return found;
    }();
    add("modified", adhesion::score_balance(scaled));
    if (const auto by_reference = reference_scaled(scaled)) {
        auto score = adhesion::score_balance(*by_reference);
        double mean = 0.0;  // mean of the references, so that W_int is comparable with the others
        for (std::size_t i = 0; i < scaled.size(); ++i)
            mean += (*by_reference)[i].slope / scaled[i].slope / static_cast<double>(scaled.size());
        score.work_of_adhesion *= mean;
        add("reference_scaled", score);
    }
    if (factor == 1.0) {
        const auto gained = points(adhesion::point_without_stored_energy, of);
        for (const auto& [name, k] : {std::pair{"pinned_1", 1.0}, {"pinned_2", 2.0}}) {
            auto pinned = scaled;
            for (std::size_t i = 0; i < pinned.size(); ++i)
                pinned[i] = adhesion::pinned_point(std::move(pinned[i]), gained[i], k);
            add(name, adhesion::score_balance(pinned));
        }
    }
    add("partial_contact", adhesion::score_partial_contact(partial_points(of, factor)));
    if (factor == 1.0) {  // γ1 does not enter the next two
        add("without_area_change", adhesion::score_balance(points(adhesion::point_without_area_change, of)));
        add("persson_tosatti", adhesion::score_balance(points(adhesion::persson_tosatti_point, of)));
    }
    if (to_.strained_interface) try {
            add("strained_interface", adhesion::score_strained_interface(scaled));
        } catch (const InvalidArgument&) {
            // spectra cut at long waves leave all surfaces flat: true areas do not differ
        }
    if (to_.free_energies) add("free_energies", adhesion::score_free_energies(free_points(of, factor)));
}

std::vector<ComparedBalance> Concluding::compare_balances() const {
    std::vector<ComparedBalance> balances;
    std::vector<SpectralParameters> whole;
    for (std::size_t i = 0; i < result_.surfaces.size(); ++i)
        whole.push_back(result_.surfaces[i].failed() ? SpectralParameters{} : whole_spectra()(i));
    compare(balances, whole, 0.0, 1.0);
    for (const double cut : compared_cuts()) compare(balances, cut_at(cut), cut, 1.0);
    for (const double factor : {0.0, 0.5, 0.8, 1.2, 1.5}) compare(balances, whole, 0.0, factor);
    return balances;
}

/// For inputs of elastomers, loops and instruments: inputs of a surface's spectrum change its parameters too much for a
/// linear relation over two standard errors.
std::vector<std::string> Concluding::profiled_inputs() const {
    auto names = stated_inputs(result_, to_);
    std::erase_if(names, [](const std::string& name) { return name.starts_with("surfaces."); });
    return names;
}

std::vector<CutoffPoint> Concluding::scan_cutoffs() const {
    std::vector<CutoffPoint> scan;
    for (const double shortest : result_.study.analysis.cutoff_scan) {
        CutoffPoint point;
        point.shortest_wavelength = shortest;
        point.surfaces = cut_at(shortest);
        const auto of_cut = [&](std::size_t i) -> const SpectralParameters& { return point.surfaces[i]; };
        point.modified = adhesion::fit_work_of_adhesion(points(adhesion::modified_point, of_cut));
        point.persson_tosatti = adhesion::fit_work_of_adhesion(points(adhesion::persson_tosatti_point, of_cut));
        scan.push_back(std::move(point));
    }
    return scan;
}

void Concluding::fit() {
    find_shares();
    to_.modified =
        attempted("fit of the full-contact balance (Eq. 7)", [&] { return fit_approach(adhesion::modified_point); });
    to_.persson_tosatti = attempted("fit of the Persson–Tosatti balance (Eq. S13)",
                                    [&] { return fit_approach(adhesion::persson_tosatti_point); });
    to_.without_area_change = attempted("fit of the small-slope balance (Eq. 2)",
                                        [&] { return fit_approach(adhesion::point_without_area_change); });
    to_.loop = attempted("fit of the true-area loss (Eq. 10)", [&] { return fit_losses(); });
    to_.free_energies = attempted("fit of Eq. 7 with free stored energies", [&] { return fit_free(); });
    to_.strained_interface = attempted("fit of Eq. 7 with a strained interface", [&] { return fit_interface(); });
    to_.reference_scaled =
        attempted("fit of Eq. 7 with W_int in proportion to references", [&] { return fit_reference_scaled(); });
    if (to_.modified) {
        const auto& pairs = to_.modified->pairs;
        const auto part = [&](const char* name, const auto& computation) {
            isolated(to_.failed_parts, name, computation);
        };
        part("leave-one-out predictions", [&] { to_.left_out = adhesion::predict_left_out(pairs); });
        part("profiles over inputs",
             [&] { to_.profiles = adhesion::profile_inputs(pairs, to_.modified->generalised, profiled_inputs()); });
        part("scan of short cutoffs", [&] { to_.cutoff_scan = scan_cutoffs(); });
        part("comparison of balances", [&] { to_.balances = compare_balances(); });
    }
    if (const auto& given = result_.study.work_of_adhesion) {
        to_.work_of_adhesion = *given;
        to_.work_of_adhesion_source = "given in the study";
        to_.traced_work_of_adhesion = {*given, given->input.empty() ? "work_of_adhesion" : given->input};
    } else if (to_.modified) {
        posterior_.emplace(to_.modified->pairs);
        to_.traced_work_of_adhesion = adhesion::traced_work(*posterior_, to_.modified->pairs);
        to_.work_of_adhesion = to_.modified->stated();
        to_.work_of_adhesion_source = "fit of the full-contact balance (Eq. 7) to the measured pairs";
    } else {
        to_.work_of_adhesion = Outcome<Estimate>::missing(
            "the study gives no work_of_adhesion, and W_int is not fitted: " + to_.modified.reason);
    }
}

/// For a soft side with a strain-dependent surface or interfacial energy.
std::optional<adhesion::ApparentWork> general_balance(const ElastomerInput& soft, double work,
                                                      const adhesion::ConformalState& state) {
    const auto& law = soft.surface_energy_law;
    if (law && law->form == StretchedSurfaceEnergy::Form::printed)
        return adhesion::printed_balance(work, law->law, state);
    if (!law && !soft.interface_change) return std::nullopt;
    const double unstretched = law ? law->law.at(1.0) : soft.surface_energy.value;
    return adhesion::end_state_balance(work, unstretched,
                                       soft.interface_change.value_or(0.0) * (state.area_ratio - 1.0), state);
}

void add_alerts(PairResult& pair) {
    const auto subject = pair.surface + " × " + pair.elastomer;
    if (!pair.modified->work.conforms)
        pair.alerts.push_back(
            {"WILL_NOT_CONFORM", subject,
             fmt::format("the full-contact balance (Eq. 7) gives {:.3g} mJ/m2; contact on {:.0f} % of the area gains "
                         "{:.2g}",
                         1e3 * pair.modified->work.raw, 100.0 * pair.contact.area_fraction,
                         1e3 * pair.partial_contact->value),
             "use the values of partial contact: area and energy of full contact do not apply, since the "
             "balance is negative and floored at 0; see docs/concepts/conformity.md"});
    if (pair.closing() == adhesion::Closing::under_pressure) {
        const auto& band = *pair.scales->pressed;
        pair.alerts.push_back(
            {"NEEDS_PRESSURE", subject,
             fmt::format("the roughness above q comes into full contact only under pressure, for q between {:.3g} and "
                         "{:.3g} 1/m: it stores more than {:.2f} of the energy that contact gains; 99 % contact needs "
                         "{:.3g} kPa",
                         band.lower, band.upper, adhesion::closing_energy_share,
                         1e-3 * pair.scales->closing_pressure.maxCoeff()),
             "press harder, or compare with loops at other loads: contact measured on approach may be "
             "partial"});
    }
    if (const auto& band = pair.scales->bridging)
        pair.alerts.push_back(
            {"CONFORMAL_INVALID", subject,
             fmt::format("the roughness above q stores more energy than contact gains, for q between {:.3g} and {:.3g} "
                         "1/m (wavelengths {:.3g} to {:.3g} m)",
                         band->lower, band->upper, 2.0 * pi / band->upper, 2.0 * pi / band->lower),
             "do not use area and energy of full contact at these wavelengths, where the solid rather forms "
             "bridges"});
}

/// Measured values of other pairs scatter about Eq. 7, and so will this one.
void Concluding::add_departure(PairResult& pair) const {
    pair.line->departure = adhesion::departure_from(to_.modified->generalised, *pair.line, 1.0);
    pair.modified->traced = adhesion::raw_prediction(*pair.line, to_.traced_work_of_adhesion);
    pair.modified->estimate = rectified(pair.modified->traced.estimate());
    pair.partial_contact->components = combined({{1.0, pair.partial_contact->components}, {1.0, pair.line->departure}});
}

void Concluding::predict(PairResult& pair, const SurfaceResult& surface, const ElastomerResult& elastomer) const {
    const auto& work = to_.traced_work_of_adhesion;
    const auto seen = in_contact(pair, to_.spectrum_of(surface).parameters);
    const adhesion::RoughSide rough{surface.name, seen.parameters, seen.spread};
    const auto soft = elastomer.soft_side();
    const auto prediction = adhesion::predict(rough, soft, work);
    pair.area_ratio = prediction.area_ratio;
    pair.stored_energy = prediction.stored_energy;
    pair.modified = prediction.modified;
    pair.line = adhesion::modified_point(rough, soft);
    pair.partial_contact = adhesion::partial_prediction(rough, soft, work);
    if (!pair.approach && !result_.study.work_of_adhesion) add_departure(pair);
    const auto gained = adhesion::point_without_stored_energy(rough, soft);
    const double gain = gained.raw_prediction(work.value);
    pair.contact = adhesion::unloaded_contact(gain > 0.0 ? pair.stored_energy.value / gain
                                                         : std::numeric_limits<double>::infinity());
    pair.persson_tosatti = prediction.persson_tosatti;
    pair.without_area_change = prediction.without_area_change;
    pair.budget = prediction.budget;
    pair.general = general_balance(elastomer.input, work.value, {pair.area_ratio, prediction.stored_energy.value});
    const auto& input = elastomer.input;
    if (input.sphere_radius && input.preload)
        pair.loop = adhesion::predict_loop(rough, soft, work, {elastomer.traced_radius(), *input.preload});
    if (pair.contact_area)
        pair.predicted_loss = adhesion::predicted_loss(rough, work, {*pair.contact_area, pair.contact_area_inputs});
    else if (pair.loop) pair.predicted_loss = pair.loop->conformal_loss.energy_loss;
    pair.scales = adhesion::scale_balance(roughness::cumulative_parameters(to_.spectrum_of(surface).curve),
                                          soft.contact_modulus.value, work.value, soft.surface_energy.value,
                                          rough.parameters.area_shape);
    add_alerts(pair);
    if (to_.of_averages) return;  // waves beyond the data are known only for the spectrum used
    // waves longer than the contact do not matter
    const auto& longer = pair.contact_area ? std::optional<roughness::BeyondData>{} : surface.longer_waves;
    pair.with_unmeasured_waves = adhesion::work_with_unmeasured_waves(
        rough, soft, work.value, {surface.used().parameters, surface.beyond_data, longer});
}

void Concluding::predict() {
    if (!to_.work_of_adhesion) return;
    for (auto& pair : to_.pairs) {
        const auto& surface = result_.surface(pair.surface);
        const auto& elastomer = result_.elastomer(pair.elastomer);
        if (!predictable(surface, elastomer)) continue;
        auto predicted = pair;
        if (isolated(pair.alerts, pair_name(pair), [&] { predict(predicted, surface, elastomer); }))
            pair = std::move(predicted);
    }
}

void Concluding::test() {
    using Missing = Outcome<adhesion::PredictionTest>;
    if (!to_.work_of_adhesion) {
        to_.prediction_test = Missing::missing(to_.work_of_adhesion.reason);
        return;
    }
    std::vector<PairPoint> tested;
    std::vector<std::string> left_out;
    for (auto& point : points(adhesion::modified_point, whole_spectra())) {
        if (point.measured.uncertain()) tested.push_back(std::move(point));
        else
            left_out.push_back(
                fmt::format("{} × {}: the measured value has no standard error", point.surface, point.elastomer));
    }
    try {
        auto test = adhesion::test_predictions(tested, to_.traced_work_of_adhesion, !result_.study.work_of_adhesion);
        test.left_out = std::move(left_out);
        to_.prediction_test = std::move(test);
    } catch (const std::exception& error) {
        to_.prediction_test = Missing::missing(reason_of(error));
    }
}

/// Draws of all inputs of W_int and of the predictions, from the posterior of the measured pairs.
void Concluding::draw() {
    constexpr int draws = 1000;
    if (!to_.work_of_adhesion) return;
    std::vector<PairPoint> lines;
    std::vector<PairResult*> predicted;
    for (auto& pair : to_.pairs) {
        if (!pair.line) continue;
        lines.push_back(*pair.line);
        predicted.push_back(&pair);
    }
    const auto seed = result_.study.analysis.seed;
    to_.draws = posterior_ ? posterior_->draw(lines, draws, seed)
                           : adhesion::draw_balances(to_.traced_work_of_adhesion, {}, lines, draws, seed);
    for (std::size_t i = 0; i < predicted.size(); ++i) predicted[i]->drawn = to_.draws.predictions[i];
    to_.draws.predictions.clear();
}

}  // namespace

void conclude(const StudyResult& result, Conclusions& conclusions) {
    Concluding concluding(result, conclusions);
    concluding.fit();
    concluding.predict();
    concluding.test();
    isolated(conclusions.failed_parts, "draws of W_int and of the predictions", [&] { concluding.draw(); });
}

}  // namespace setae::study
