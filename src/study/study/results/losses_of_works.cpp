// SPDX-License-Identifier: GPL-3.0-or-later
#include "losses_of_works.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/core/uncertain_text.hpp"
#include "setae/hysteresis/sphere_loop.hpp"

namespace setae::study {
namespace {

/// Message on the difference from the measured value; empty where the two agree.
std::optional<Alert> contradiction(const std::string& subject, const LossOfWorks& by_works, const Estimate& measured) {
    constexpr double standard_errors = 3.0, share = 0.2;
    const double apart = measured.value - by_works.energy.value,
                 error = std::sqrt(measured.variance() + by_works.energy.variance());
    if (std::abs(apart) < standard_errors * error || std::abs(apart) < share * by_works.energy.value)
        return std::nullopt;
    return Alert{
        "LOSS_CONTRADICTS_WORKS", subject,
        fmt::format("the loop lost {}; with W_app during the whole approach and W_ret during the whole retraction "
                    "it would lose {}",
                    format_uncertain(measured, "J"), format_uncertain(by_works.energy.estimate(), "J")),
        "look at G(a) along the retraction, and use energies from the loops instead of the works: W_ret "
        "is measured at pull-off and may differ from the work of the whole retraction"};
}

}  // namespace

std::optional<LossOfWorks> loss_of_works(const ElastomerResult& elastomer, const TracedValue& approach,
                                         const TracedValue& retraction) {
    const auto& input = elastomer.input;
    if (!input.sphere_radius || !input.preload || !(approach.value > 0.0) || !(retraction.value > 0.0) ||
        !(elastomer.contact_modulus.value > 0.0))
        return std::nullopt;
    enum Input : std::size_t { radius, modulus, work_approach, work_retraction };
    const auto loop_of = [&](const std::vector<double>& in) {
        const hysteresis::HystereticSphere sphere{.radius = in[radius],
                                                  .contact_modulus = in[modulus],
                                                  .work_approach = in[work_approach],
                                                  .work_retraction = std::max(in[work_approach], in[work_retraction])};
        return hysteresis::sphere_loop(sphere, {.maximum_force = *input.preload});
    };
    const std::vector<TracedValue> inputs{elastomer.traced_radius(), elastomer.soft_side().contact_modulus, approach,
                                          retraction};
    std::vector<double> values;
    for (const auto& value : inputs) values.push_back(value.value);
    try {
        return LossOfWorks{
            setae::propagated([&](const std::vector<double>& in) { return loop_of(in).energy_loss(); }, inputs),
            loop_of(values).largest_contact_area()};
    } catch (const InvalidArgument&) {
        return std::nullopt;  // a preload that does not come to this contact
    }
}

void compare_losses_with_works(StudyResult& result) {
    for (const auto& reference : result.references) {
        if (!reference.excess_energy) continue;
        const auto works = loss_of_works(result.elastomer(reference.elastomer), {reference.approach, "W_app"},
                                         {reference.retraction, "W_ret"});
        if (!works) continue;
        if (auto alert =
                contradiction("the smooth reference on " + reference.elastomer, *works, *reference.excess_energy))
            result.alerts.push_back(std::move(*alert));
    }
    for (auto& pair : result.pairs) {
        const auto approach = pair.traced_approach(), retraction = pair.traced_retraction();
        if (!pair.loss || !approach || !retraction) continue;
        const auto works = loss_of_works(result.elastomer(pair.elastomer), *approach, *retraction);
        if (!works) continue;
        if (auto alert = contradiction(pair.surface + " × " + pair.elastomer, *works, *pair.loss))
            pair.alerts.push_back(std::move(*alert));
    }
}

std::optional<LossSlope> loss_slope_of_works(const StudyResult& result) {
    double products = 0.0, squares = 0.0, energies = 0.0;
    int count = 0;
    std::vector<std::pair<double, double>> points;
    for (const auto& pair : result.pairs) {
        const auto approach = pair.traced_approach(),
                   retraction = pair.retraction ? pair.traced_retraction() : pair.traced_pull_off();
        if (!pair.modified || !approach || !retraction) continue;
        const auto works = loss_of_works(result.elastomer(pair.elastomer), *approach, *retraction);
        if (!works) continue;
        const double area = pair.contact.area_fraction * pair.area_ratio * works->contact_area;
        points.emplace_back(area, works->energy.value);
        products += area * works->energy.value;
        squares += area * area;
        ++count;
    }
    if (count < 2 || !(squares > 0.0)) return std::nullopt;
    const double slope = products / squares;
    for (const auto& [area, energy] : points) energies += std::pow(energy - slope * area, 2);
    const double freedom = count - 1.0;
    return LossSlope{{.value = slope,
                      .standard_error = std::sqrt(energies / freedom / squares),
                      .method = "least squares",
                      .degrees_of_freedom = freedom},
                     count};
}

}  // namespace setae::study
