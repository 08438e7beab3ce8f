// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectra/polyline.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "samples.hpp"

namespace polyline_property_test {

using namespace setae;
using namespace setae::spectra;
using tests::log_spaced;
using tests::random_profile;
using topography::Profile;

/// The profile with further points on its segments, at the share t of each chosen one.
Profile with_collinear_points(const Profile& profile, const std::vector<int>& choices) {
    std::vector<double> x, h;
    for (Index k = 0; k < profile.positions.size(); ++k) {
        x.push_back(profile.positions[k]);
        h.push_back(profile.heights[k]);
        const int choice = choices[static_cast<std::size_t>(k)];
        if (choice == 0 || k + 1 == profile.positions.size()) continue;
        const double t = choice / 10.0;
        x.push_back(profile.positions[k] + t * (profile.positions[k + 1] - profile.positions[k]));
        h.push_back(profile.heights[k] + t * (profile.heights[k + 1] - profile.heights[k]));
    }
    const auto n = static_cast<Index>(x.size());
    return {Eigen::Map<Array1D>(x.data(), n), Eigen::Map<Array1D>(h.data(), n), {}};
}

/// Largest difference over the mean level of the ten nearest wavevectors.
double deviation(const Array1D& one, const Array1D& other) {
    double worst = 0.0;
    for (Index j = 0; j < one.size(); ++j) {
        const Index first = std::clamp<Index>(j - 5, 0, one.size() - 10);
        worst = std::max(worst, std::abs(one[j] - other[j]) / one.segment(first, 10).mean());
    }
    return worst;
}

Window any_window() { return *rc::gen::element(Window::none, Window::hann, Window::blackman_harris); }

RC_GTEST_PROP(PolylinePowerSpectrumProperty, IsInvariantUnderCollinearPoints, ()) {
    const auto n = *rc::gen::inRange(3, 200);
    const auto profile = random_profile(n, 1.0, 0.8, *rc::gen::arbitrary<unsigned>());
    const auto choices = *rc::gen::container<std::vector<int>>(static_cast<std::size_t>(n), rc::gen::inRange(0, 10));
    const auto window = any_window();
    const auto q = log_spaced(60, 1.0 / static_cast<double>(n), 30.0);
    RC_ASSERT(deviation(polyline_power_spectrum(profile, q, window),
                        polyline_power_spectrum(with_collinear_points(profile, choices), q, window)) < 1e-10);
}

RC_GTEST_PROP(PolylinePowerSpectrumProperty, IsInvariantUnderShifts, (std::uint16_t shift)) {
    const auto n = *rc::gen::inRange(3, 200);
    auto profile = random_profile(n, 1.0, 0.8, *rc::gen::arbitrary<unsigned>());
    // positions that are exact after a shift: multiples of 2^-20
    profile.positions = (profile.positions * 1048576.0).round() / 1048576.0;
    const auto window = any_window();
    const auto q = log_spaced(60, 1.0 / static_cast<double>(n), 30.0);
    const auto before = polyline_power_spectrum(profile, q, window);
    profile.positions += shift;
    RC_ASSERT(deviation(before, polyline_power_spectrum(profile, q, window)) < 1e-10);
}

RC_GTEST_PROP(PolylinePowerSpectrumProperty, ScalesWithTheUnitOfLength, ()) {
    const auto profile = random_profile(*rc::gen::inRange(3, 200), 1.0, 0.8, *rc::gen::arbitrary<unsigned>());
    const double unit = *rc::gen::element(1e-12, 1e-9, 1e-6, 1e3);
    const Profile scaled{profile.positions * unit, profile.heights * unit, {}};
    const auto q = log_spaced(60, 0.01, 30.0);
    const Array1D expected = polyline_power_spectrum(profile, q) * std::pow(unit, 3);
    RC_ASSERT(deviation(expected, polyline_power_spectrum(scaled, q / unit)) < 1e-10);
}

}  // namespace polyline_property_test
