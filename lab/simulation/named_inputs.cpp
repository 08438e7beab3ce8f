// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "setae/simulation/recipe.hpp"

namespace setae::simulation {
namespace {

/// Collects named inputs.
class Inputs {
public:
    void add(const std::optional<StatedQuantity>& quantity) {
        if (!quantity || quantity->input.empty()) return;
        if (std::none_of(found_.begin(), found_.end(),
                         [&](const StatedQuantity& known) { return known.input == quantity->input; }))
            found_.push_back(*quantity);
    }
    void add(const InstrumentCalibration& calibration) {
        add(calibration.height);
        add(calibration.lateral);
    }
    [[nodiscard]] std::vector<StatedQuantity> take() { return std::move(found_); }

private:
    std::vector<StatedQuantity> found_;
};

}  // namespace

std::vector<StatedQuantity> named_inputs(const Recipe& recipe) {
    const auto in_use = [&](auto instrument) {
        return std::any_of(recipe.surfaces.begin(), recipe.surfaces.end(),
                           [&](const SurfaceRecipe& rough) { return (rough.*instrument).has_value(); });
    };
    const auto& calibrations = recipe.calibrations;
    Inputs inputs;
    if (in_use(&SurfaceRecipe::stylus)) inputs.add(calibrations.stylus);
    if (in_use(&SurfaceRecipe::afm)) inputs.add(calibrations.afm);
    if (in_use(&SurfaceRecipe::tem)) inputs.add(calibrations.tem);
    inputs.add(recipe.stylus_tip);
    inputs.add(recipe.afm_tip);
    if (recipe.loops)
        for (const auto* factor : {&calibrations.force, &calibrations.displacement, &calibrations.contact_radius})
            inputs.add(*factor);
    for (const auto& elastomer : recipe.elastomers) {
        inputs.add(elastomer.sphere_radius);
        inputs.add(elastomer.surface_energy);
    }
    return inputs.take();
}

}  // namespace setae::simulation
