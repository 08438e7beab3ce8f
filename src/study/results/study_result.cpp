// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study/study_result.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "setae/core/errors.hpp"

namespace setae::study {

adhesion::SoftSide ElastomerResult::soft_side() const {
    const auto named = [this](const Estimate& value, const std::string& name, const char* what) {
        return TracedValue(value, name.empty() ? fmt::format("{} of {}", what, input.name) : name);
    };
    return {input.name, named(contact_modulus, youngs_modulus.input, "modulus"),
            named(input.surface_energy, input.surface_energy.input, "surface energy")};
}

int StudyResult::failures() const {
    int count = 0;
    for (const auto& s : surfaces) {
        count += s.failed() || !s.likelihood_error.empty() ? 1 : 0;
        for (const auto& m : s.measurements) count += m.failed() ? 1 : 0;
    }
    for (const auto& e : experiments) count += e.failed() ? 1 : 0;
    return count;
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
