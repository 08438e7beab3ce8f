// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "pairs.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/statistics.hpp"
#include "setae/core/units.hpp"
#include "statistics.hpp"

namespace setae::study {
namespace {

/// A loop on a smooth reference, with the measured data.
struct MeasuredReference {
    std::string elastomer, stage;
    loops::ReferenceLoop loop;
};

std::vector<MeasuredReference> measured_references(StudyResult& result) {
    std::vector<MeasuredReference> found;
    for (auto& e : result.experiments) {
        if (!e.analysis || !e.input.reference || e.input.excluded()) continue;
        try {
            found.push_back({e.input.elastomer, e.input.stage, loops::evaluate_reference(*e.analysis)});
        } catch (const std::exception& error) {
            e.alerts.push_back({"REFERENCE_INCOMPLETE", e.input.file, reason_of(error),
                                "record the whole loop of a reference, retraction included"});
        }
    }
    return found;
}

std::optional<double> mean_rough_loss(const StudyResult& result, const std::string& elastomer) {
    std::vector<double> losses;
    for (const auto& pair : result.pairs)
        if (pair.elastomer == elastomer && pair.loss) losses.push_back(pair.loss->value);
    return losses.empty() ? std::nullopt : std::optional(mean_of(losses));
}

ReferenceResult published_reference(const PublishedPair& published, const StudyResult& result) {
    ReferenceResult reference;
    reference.elastomer = published.elastomer;
    reference.approach = published.approach.value_or(Estimate{.value = undefined});
    reference.retraction = published.retraction.value_or(Estimate{.value = undefined});
    reference.excess_energy = published.loss;
    reference.ideal_loss = ideal_loss(result.elastomer(published.elastomer), reference.approach.value);
    if (published.contact_radius) reference.contact_area = pi * *published.contact_radius * *published.contact_radius;
    return reference;
}

void add_loss_ratio(ReferenceResult& reference, const StudyResult& result) {
    const auto rough = mean_rough_loss(result, reference.elastomer);
    if (!rough || !reference.excess_energy || !(reference.excess_energy->value > 0.0)) return;
    reference.loss_ratio =
        loops::loss_ratios(Array1D::Constant(1, *rough), {{.excess_energy = *reference.excess_energy}})[0];
}

Estimate hysteresis_of(const PairResult& pair) {
    const auto& apart = pair.retraction ? pair.retraction : pair.pull_off;
    return apart && pair.approach ? difference(*apart, *pair.approach) : Estimate{.value = undefined};
}

void compare_with_margin(ReferenceResult& reference, double margin) {
    reference.hysteresis = statistics::test_equivalence(difference(reference.retraction, reference.approach), margin);
    if (!reference.excess_energy || !reference.ideal_loss || !reference.contact_area) return;
    Estimate beyond = *reference.excess_energy;
    beyond.interval.reset();
    beyond.value -= *reference.ideal_loss;
    reference.loss_per_area = statistics::test_equivalence(scaled(beyond, 1.0 / *reference.contact_area), margin);
}

/// Share of each pair's hysteresis that the smooth references have.
void add_shares(StudyResult& result) {
    for (auto& pair : result.pairs) {
        std::vector<Estimate> smooth;
        for (const auto& reference : result.references)
            if (reference.elastomer == pair.elastomer && std::isfinite(reference.hysteresis.difference.value))
                smooth.push_back(reference.hysteresis.difference);
        const Estimate rough = hysteresis_of(pair);
        if (smooth.empty() || !(rough.value > 0.0)) continue;
        const std::vector<Estimate> both{mean_of(smooth), rough};
        pair.reference_share = propagated([](const Array1D& x) { return x[0] / x[1]; }, both);
    }
}

std::string shares_of(const StudyResult& result, const std::string& elastomer) {
    std::vector<std::string> shares;
    for (const auto& pair : result.pairs)
        if (pair.elastomer == elastomer && pair.reference_share)
            shares.push_back(fmt::format("{:.0f} % of {}", 100.0 * pair.reference_share->value, pair.surface));
    return shares.empty()
               ? ""
               : fmt::format("; as a share of the hysteresis on rough surfaces, this is {}", fmt::join(shares, ", "));
}

/// A warning unless the test shows that the value is below the margin.
void require_equivalence(StudyResult& result, const char* code, const ReferenceResult& reference,
                         const statistics::Equivalence& test, const char* what, const std::string& besides,
                         const char* advice) {
    if (test.verdict == statistics::Verdict::equivalent || !std::isfinite(test.difference.value)) return;
    const auto shown = fmt::format("{} ± {}", format_value(test.difference.value, "J/m2"),
                                   format_value(test.difference.standard_error, "J/m2", 2)),
               margin = format_value(test.margin, "J/m2");
    result.alerts.push_back(
        {code, reference.elastomer,
         test.verdict == statistics::Verdict::different
             ? fmt::format("{} of the smooth reference is {}, more than the margin of {} (two one-sided tests){}", what,
                           shown, margin, besides)
             : fmt::format(
                   "{} of the smooth reference is {}; the data do not show that it is below the margin of {} (p = "
                   "{:.2g} of two one-sided tests){}",
                   what, shown, margin, test.probability, besides),
         advice});
}

}  // namespace

std::optional<ReferenceWorks> reference_works(const StudyResult& result, const std::string& elastomer) {
    std::vector<Estimate> approach, retraction;
    ReferenceWorks works;
    for (const auto& reference : result.references) {
        if (reference.elastomer != elastomer || !(reference.approach.value > 0.0) ||
            !(reference.retraction.value > 0.0))
            continue;
        approach.push_back(reference.approach);
        retraction.push_back(reference.retraction);
        if (reference.ideal_loss && reference.contact_area && *reference.contact_area > 0.0)
            works.jumps_per_area = *reference.ideal_loss / *reference.contact_area;
    }
    if (approach.empty()) return std::nullopt;
    works.approach = mean_of(approach);
    works.retraction = mean_of(retraction);
    return works;
}

std::optional<TracedValue> reference_work(const StudyResult& result, const std::string& elastomer) {
    std::vector<Estimate> works;
    for (const auto& reference : result.references)
        if (reference.elastomer == elastomer && reference.approach.value > 0.0) works.push_back(reference.approach);
    if (works.empty()) return std::nullopt;
    return TracedValue(mean_of(works), "W_app of the reference on " + elastomer);
}

void evaluate_references(StudyResult& result) {
    const auto measured = measured_references(result);
    for (const auto& [elastomer, stage, loop] : measured) {
        ReferenceResult reference;
        reference.elastomer = elastomer;
        reference.stage = stage;
        reference.approach = loop.work_of_adhesion_loading;
        reference.retraction = loop.work_of_adhesion_retraction;
        reference.excess_energy = loop.excess_energy;
        reference.ideal_loss = loop.ideal_loss;
        reference.contact_area = loop.contact_area;
        result.references.push_back(std::move(reference));
    }
    for (const auto& published : result.study.published)
        if (published.surface.empty()) result.references.push_back(published_reference(published, result));
    for (auto& reference : result.references) {
        add_loss_ratio(reference, result);
        compare_with_margin(reference, result.study.comparison.margin);
    }
    add_shares(result);
    for (const auto& reference : result.references) {
        require_equivalence(
            result, "REFERENCE_HYSTERESIS", reference, reference.hysteresis, "W_ret at pull-off less W_app",
            shares_of(result, reference.elastomer),
            "part of the hysteresis of the rough loops is not due to roughness: compare speeds and holds, "
            "and subtract this part before drawing conclusions");
        if (reference.loss_per_area)
            require_equivalence(
                result, "REFERENCE_LOSS", reference, *reference.loss_per_area,
                "the energy lost per unit contact area, beyond the jumps of a smooth sphere,", "",
                "part of the loss of the rough loops is not due to roughness: check speed, drift and the sphere");
    }
    for (const auto& before : measured) {
        if (before.stage != "before") continue;
        for (const auto& after : measured)
            if (after.stage == "after" && after.elastomer == before.elastomer)
                result.reference_drifts.push_back({before.elastomer, loops::change(before.loop, after.loop)});
    }
}

}  // namespace setae::study
