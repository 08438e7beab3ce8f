// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study/study_result.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "failed_part.hpp"
#include "setae/core/errors.hpp"

namespace setae::study {
namespace {

/// A measured value of a pair; `fits`: the part of its own noise that other values share.
std::optional<TracedValue> traced(const PairResult& pair, const char* symbol, const std::optional<Estimate>& measured,
                                  const Components& inputs, const Components& fits) {
    if (!measured) return std::nullopt;
    TracedValue value(measured->value, combined({{1.0, inputs}, {1.0, fits}}));
    if (auto own = beyond_fits(*measured, fits); own.directions.size() > 0)
        value.components[input_name(*measured, adhesion::own_noise_name(symbol, pair.surface, pair.elastomer))] =
            std::move(own);
    return value;
}

}  // namespace

std::optional<TracedValue> PairResult::traced_approach() const {
    return traced(*this, "W_app", approach, approach_inputs, approach_fits);
}
std::optional<TracedValue> PairResult::traced_pull_off() const {
    return traced(*this, "W_po", pull_off, pull_off_inputs, {});
}
std::optional<TracedValue> PairResult::traced_retraction() const {
    return traced(*this, "W_ret", retraction, retraction_inputs, {});
}
std::optional<TracedValue> PairResult::traced_loss() const { return traced(*this, "E_loss", loss, loss_inputs, {}); }

adhesion::SoftSide ElastomerResult::soft_side() const {
    return {input.name,
            traced_contact_modulus,
            {input.surface_energy, input_name(input.surface_energy, fmt::format("surface energy of {}", input.name))}};
}

TracedValue ElastomerResult::traced_radius() const {
    if (!input.sphere_radius) throw InternalError(fmt::format("elastomer '{}' has no sphere", input.name));
    return {*input.sphere_radius,
            input_name(*input.sphere_radius, fmt::format("elastomers.{}.sphere_radius", input.name))};
}

int StudyResult::failures() const {
    int count = 0;
    for (const auto& s : surfaces) {
        count += s.failed() || !s.likelihood_error.empty() ? 1 : 0;
        for (const auto& m : s.measurements) count += m.failed() ? 1 : 0;
    }
    for (const auto& e : experiments) count += e.failed() ? 1 : 0;
    return count + static_cast<int>(alerts_of_failed_parts().size());
}

std::vector<Alert> StudyResult::alerts_of_failed_parts() const {
    std::vector<Alert> found;
    const auto add = [&](const std::vector<Alert>& from) {
        std::copy_if(from.begin(), from.end(), std::back_inserter(found),
                     [](const Alert& alert) { return alert.code == part_failed; });
    };
    for (const auto& elastomer : elastomers) add(elastomer.alerts);
    for (const auto& pair : pairs) add(pair.alerts);
    add(alerts);
    return found;
}

int StudyResult::successes() const {
    const auto fine = [](const auto& item) { return !item.failed(); };
    return static_cast<int>(std::count_if(surfaces.begin(), surfaces.end(), fine) +
                            std::count_if(experiments.begin(), experiments.end(), fine));
}

const SurfaceResult& StudyResult::surface(const std::string& name) const {
    for (const auto& surface : surfaces)
        if (surface.name == name) return surface;
    throw InternalError(fmt::format("surface '{}' is not in the study", name));
}

const ElastomerResult& StudyResult::elastomer(const std::string& name) const {
    for (const auto& elastomer : elastomers)
        if (elastomer.input.name == name) return elastomer;
    throw InternalError(fmt::format("elastomer '{}' is not in the study", name));
}

}  // namespace setae::study
