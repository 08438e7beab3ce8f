// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "pairs.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"

namespace setae::study {
namespace {

using adhesion::PairPoint;
using adhesion::RoughSide;
using adhesion::SoftSide;
using roughness::SpectralParameters;

/// Whether (7) can be evaluated for a pair: a spectrum and a modulus.
bool predictable(const SurfaceResult& surface, const ElastomerResult& elastomer) {
    return !surface.failed() && elastomer.contact_modulus.value > 0.0;
}

SoftSide soft_side(const ElastomerResult& elastomer) {
    return {elastomer.input.name, elastomer.contact_modulus, elastomer.input.surface_energy};
}

/// Conclusions on their way: fits first, then predictions at the W_int they lead to.
class Concluding {
public:
    Concluding(const StudyResult& result, Conclusions& conclusions) : result_(result), to_(conclusions) {}

    void fit();
    void predict();
    void test();

private:
    using Balance = PairPoint (*)(const RoughSide&, const SoftSide&);
    using ParametersOf = std::function<const SpectralParameters&(std::size_t surface)>;

    [[nodiscard]] RoughSide rough_side(const SurfaceResult& surface) const {
        const auto& spectrum = to_.spectrum_of(surface);
        return {surface.name, spectrum.parameters, spectrum.spread};
    }
    [[nodiscard]] ParametersOf whole_spectra() const {
        return [this](std::size_t i) -> const SpectralParameters& {
            return to_.spectrum_of(result_.surfaces[i]).parameters;
        };
    }
    [[nodiscard]] std::vector<PairPoint> points(Balance balance, const ParametersOf& parameters_of) const;
    [[nodiscard]] Outcome<adhesion::WorkFit> fit_approach(Balance balance) const;
    [[nodiscard]] Outcome<adhesion::LossFits> fit_losses() const;
    [[nodiscard]] Outcome<adhesion::FreeEnergyFit> fit_free() const;
    [[nodiscard]] std::vector<CutoffPoint> scan_cutoffs() const;
    void predict(PairResult& pair, const SurfaceResult& surface, const ElastomerResult& elastomer) const;

    const StudyResult& result_;
    Conclusions& to_;
};

/// Points of all pairs with a measured approach, for one balance.
std::vector<PairPoint> Concluding::points(Balance balance, const ParametersOf& parameters_of) const {
    std::vector<PairPoint> found;
    for (const auto& pair : to_.pairs) {
        if (!pair.approach) continue;
        const auto& surface = result_.surface(pair.surface);
        const auto& elastomer = result_.elastomer(pair.elastomer);
        if (!predictable(surface, elastomer)) continue;
        const auto index = static_cast<std::size_t>(&surface - result_.surfaces.data());
        auto point =
            balance({surface.name, parameters_of(index), to_.spectrum_of(surface).spread}, soft_side(elastomer));
        point.measured = *pair.approach;
        point.measured.value = std::max(0.0, point.measured.value);
        found.push_back(std::move(point));
    }
    return found;
}

Outcome<adhesion::WorkFit> Concluding::fit_approach(Balance balance) const {
    const auto found = points(balance, whole_spectra());
    if (found.size() < 2)
        return Outcome<adhesion::WorkFit>::missing(fmt::format(
            "{} pairs have both a measured work of adhesion and a predictable surface, a fit needs at least 2",
            found.size()));
    return adhesion::fit_work_of_adhesion(found);
}

Outcome<adhesion::LossFits> Concluding::fit_losses() const {
    std::vector<PairPoint> whole, reduced;
    for (const auto& pair : to_.pairs) {
        const auto& surface = result_.surface(pair.surface);
        if (!pair.loss || !pair.contact_area || surface.failed()) continue;
        const auto& spectrum = to_.spectrum_of(surface);
        PairPoint point;
        point.surface = pair.surface;
        point.elastomer = pair.elastomer;
        point.measured = *pair.loss;
        point.slope = spectrum.area_ratio() * *pair.contact_area;
        point.slope_variance =
            std::pow(*pair.contact_area * spectrum.spread.standard_error([](const SpectralParameters& p) {
                return roughness::gaussian_area_ratio(p.rms_slope);
            }),
                     2);
        if (!std::isfinite(point.slope_variance)) point.slope_variance = 0.0;
        point.floored = false;
        whole.push_back(point);
        if (!pair.ideal_loss) continue;
        point.measured.value -= *pair.ideal_loss;
        reduced.push_back(point);
    }
    if (whole.size() < 2)
        return Outcome<adhesion::LossFits>::missing(
            fmt::format("{} pairs have a loop energy and a contact radius, a fit needs at least 2", whole.size()));
    return adhesion::fit_losses(whole, reduced);
}

Outcome<adhesion::FreeEnergyFit> Concluding::fit_free() const {
    std::vector<adhesion::FreeEnergyPoint> found;
    for (const auto& p : points(adhesion::modified_point, whole_spectra())) {
        const auto& elastomer = result_.elastomer(p.elastomer);
        found.push_back({p.surface, p.measured.value, p.slope, elastomer.input.surface_energy.value * (p.slope - 1.0),
                         elastomer.contact_modulus.value});
    }
    if (found.size() < 2)
        return Outcome<adhesion::FreeEnergyFit>::missing("fewer than 2 pairs with a measured work of adhesion");
    return adhesion::fit_with_free_energies(found);
}

std::vector<CutoffPoint> Concluding::scan_cutoffs() const {
    std::vector<CutoffPoint> scan;
    const auto& analysis = result_.study.analysis;
    for (const double shortest : analysis.cutoff_scan) {
        CutoffPoint point;
        point.shortest_wavelength = shortest;
        for (const auto& surface : result_.surfaces)
            point.surfaces.push_back(surface.failed() ? SpectralParameters{}
                                                      : parameters_within(to_.spectrum_of(surface),
                                                                          {.shortest = shortest}, analysis.conversion));
        const auto of_cut = [&](std::size_t i) -> const SpectralParameters& { return point.surfaces[i]; };
        point.modified = adhesion::fit_work_of_adhesion(points(adhesion::modified_point, of_cut));
        point.persson_tosatti = adhesion::fit_work_of_adhesion(points(adhesion::persson_tosatti_point, of_cut));
        scan.push_back(std::move(point));
    }
    return scan;
}

void Concluding::fit() {
    to_.modified = fit_approach(adhesion::modified_point);
    to_.persson_tosatti = fit_approach(adhesion::persson_tosatti_point);
    to_.without_area_change = fit_approach(adhesion::point_without_area_change);
    to_.loop = fit_losses();
    to_.free_energies = fit_free();
    if (to_.modified) to_.cutoff_scan = scan_cutoffs();
    if (result_.study.work_of_adhesion) {
        to_.work_of_adhesion = *result_.study.work_of_adhesion;
        to_.work_of_adhesion_source = "given in the study";
    } else if (to_.modified) {
        to_.work_of_adhesion = to_.modified->clustered;
        to_.work_of_adhesion_source = "fit of (7) to the measured pairs";
    } else {
        to_.work_of_adhesion =
            Outcome<Estimate>::missing("no work_of_adhesion in the study, and no fit: " + to_.modified.reason);
    }
}

void add_alerts(PairResult& pair) {
    const auto subject = pair.surface + " × " + pair.elastomer;
    if (!pair.modified->work.conforms)
        pair.alerts.push_back({"WILL_NOT_CONFORM", subject,
                               fmt::format("(7) gives {:.3g} mJ/m2, floored at 0", 1e3 * pair.modified->work.raw),
                               "conformal contact is not predicted; area and energy of full contact do not apply"});
    if (const auto& band = pair.scales->bridging)
        pair.alerts.push_back(
            {"CONFORMAL_INVALID", subject,
             fmt::format(
                 "the roughness above q stores more than it gains for q between {:.3g} and {:.3g} 1/m (wavelengths {:.3g} to {:.3g} m)",
                 band->lower, band->upper, 2.0 * pi / band->upper, 2.0 * pi / band->lower),
             "the solid would rather bridge these wavelengths than conform"});
}

void Concluding::predict(PairResult& pair, const SurfaceResult& surface, const ElastomerResult& elastomer) const {
    const auto& work = *to_.work_of_adhesion;
    const auto rough = rough_side(surface);
    const auto soft = soft_side(elastomer);
    const auto prediction = adhesion::predict(rough, soft, work);
    pair.area_ratio = prediction.area_ratio;
    pair.stored_energy = prediction.stored_energy;
    pair.modified = prediction.modified;
    pair.persson_tosatti = prediction.persson_tosatti;
    pair.without_area_change = prediction.without_area_change;
    pair.budget = prediction.budget;
    if (const auto& law = elastomer.input.surface_energy_law)
        pair.general = adhesion::general_balance(work.value, *law, {pair.area_ratio, prediction.stored_energy.value});
    if (pair.contact_area) pair.predicted_loss = adhesion::predicted_loss(rough, work, *pair.contact_area);
    pair.scales = adhesion::scale_balance(roughness::cumulative_parameters(to_.spectrum_of(surface).curve),
                                          soft.contact_modulus.value, work.value, soft.surface_energy.value);
    add_alerts(pair);
}

void Concluding::predict() {
    if (!to_.work_of_adhesion) return;
    for (auto& pair : to_.pairs) {
        const auto& surface = result_.surface(pair.surface);
        const auto& elastomer = result_.elastomer(pair.elastomer);
        if (predictable(surface, elastomer)) predict(pair, surface, elastomer);
    }
}

void Concluding::test() {
    using Missing = Outcome<adhesion::PredictionTest>;
    if (!to_.work_of_adhesion) {
        to_.prediction_test = Missing::missing(to_.work_of_adhesion.reason);
        return;
    }
    std::vector<adhesion::MeasuredPair> tested;
    std::vector<std::string> left_out;
    for (const auto& pair : to_.pairs) {
        if (!pair.modified || !pair.approach) continue;
        if (pair.approach->uncertain())
            tested.push_back({rough_side(result_.surface(pair.surface)), soft_side(result_.elastomer(pair.elastomer)),
                              *pair.approach, pair.modified->work});
        else
            left_out.push_back(
                fmt::format("{} × {}: no standard error of the measured value", pair.surface, pair.elastomer));
    }
    try {
        auto test = adhesion::test_predictions(tested, *to_.work_of_adhesion, !result_.study.work_of_adhesion);
        test.left_out = std::move(left_out);
        to_.prediction_test = std::move(test);
    } catch (const Error& error) {
        to_.prediction_test = Missing::missing(error.what());
    }
}

}  // namespace

void conclude(const StudyResult& result, Conclusions& conclusions) {
    Concluding concluding(result, conclusions);
    concluding.fit();
    concluding.predict();
    concluding.test();
}

}  // namespace setae::study
