// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/adhesion/work_of_adhesion.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "setae/core/errors.hpp"

namespace setae::adhesion {
namespace {

void require_not_negative(double value, const char* what) {
    if (!(value >= 0.0) || std::isinf(value))
        throw InvalidArgument(fmt::format("{} is {} J/m2; expected a number >= 0", what, value));
}

void require_state(const ConformalState& state) {
    require_not_negative(state.stored_energy, "stored energy");
    if (!(state.area_ratio >= 1.0))
        throw InvalidArgument(fmt::format("true over apparent area is {}; expected >= 1", state.area_ratio));
}

ApparentWork apparent(double raw) { return {raw, std::max(0.0, raw), raw > 0.0}; }

}  // namespace

ApparentWork modified_balance(double work_of_adhesion, double surface_energy, const ConformalState& state) {
    require_not_negative(work_of_adhesion, "work of adhesion");
    require_not_negative(surface_energy, "surface energy");
    require_state(state);
    return apparent(work_of_adhesion * state.area_ratio - surface_energy * (state.area_ratio - 1.0) -
                    state.stored_energy);
}

ApparentWork balance_without_area_change(double work_of_adhesion, const ConformalState& state) {
    return modified_balance(work_of_adhesion, 0.0, state);
}

ApparentWork persson_tosatti_balance(double work_of_adhesion, double rms_slope, double stored_energy) {
    return balance_without_area_change(work_of_adhesion, {1.0 + 0.5 * rms_slope * rms_slope, stored_energy});
}

void SurfaceEnergyLaw::validate() const {
    const auto n = area_ratio.size();
    if (n < 1 || n != surface_energy.size() || area_ratio[0] != 1.0)
        throw InvalidArgument(
            "a strain-dependent surface energy needs one energy per area ratio, and 1 as the first ratio");
    for (Index i = 1; i < n; ++i)
        if (!(area_ratio[i] > area_ratio[i - 1]))
            throw InvalidArgument(fmt::format(
                "area ratios of a strain-dependent surface energy must increase; entry {} does not", i + 1));
}

double SurfaceEnergyLaw::at(double x) const {
    const auto n = area_ratio.size();
    if (x >= area_ratio[n - 1]) return surface_energy[n - 1];
    const auto right = std::upper_bound(area_ratio.data(), area_ratio.data() + n, x) - area_ratio.data();
    if (right == 0) return surface_energy[0];
    const double t = (x - area_ratio[right - 1]) / (area_ratio[right] - area_ratio[right - 1]);
    return surface_energy[right - 1] + t * (surface_energy[right] - surface_energy[right - 1]);
}

double SurfaceEnergyLaw::integral(double x) const {
    double sum = 0.0, left = 1.0;
    for (Index i = 1; i < area_ratio.size() && left < x; ++i) {
        const double right = std::min(x, area_ratio[i]);
        sum += 0.5 * (at(left) + at(right)) * (right - left);
        left = right;
    }
    return x > left ? sum + surface_energy[surface_energy.size() - 1] * (x - left) : sum;
}

ApparentWork end_state_balance(double work_of_adhesion, double surface_energy, double interface_change,
                               const ConformalState& state) {
    require_not_negative(work_of_adhesion, "work of adhesion");
    require_not_negative(surface_energy, "surface energy");
    require_state(state);
    if (!std::isfinite(interface_change))
        throw InvalidArgument(
            fmt::format("change of the interface energy is {} J/m2; expected a finite number", interface_change));
    const double r = state.area_ratio;
    return apparent((work_of_adhesion - interface_change) * r - surface_energy * (r - 1.0) - state.stored_energy);
}

ApparentWork printed_balance(double work_of_adhesion, const SurfaceEnergyLaw& law, const ConformalState& state) {
    require_not_negative(work_of_adhesion, "work of adhesion");
    require_state(state);
    law.validate();
    const double r = state.area_ratio;
    const double strained_work = work_of_adhesion + law.at(r) - law.at(1.0);
    return apparent(strained_work * r - law.integral(r) - state.stored_energy);
}

}  // namespace setae::adhesion
