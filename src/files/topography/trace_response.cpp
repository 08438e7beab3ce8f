// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/topography/trace_response.hpp"

#include <cmath>

#include "setae/core/constants.hpp"
#include "setae/numerics/bracketing.hpp"

namespace setae::topography {
namespace {

Array1D kept(const TraceResponse& response, const ArrayView1D& wavevectors) {
    return smoothing_transfer(response, wavevectors) * (-0.5 * (response.blur * wavevectors).square()).exp();
}

}  // namespace

Array1D smoothing_transfer(const TraceResponse& response, const ArrayView1D& wavevectors) {
    const double strength = std::pow(response.smoothing_length / response.step, 4);
    // 2 − 2 cos x = 4 sin²(x/2), which keeps its digits for long waves
    return 1.0 / (1.0 + strength * (4.0 * (0.5 * response.step * wavevectors).sin().square()).square());
}

Array1D trace_transfer(const TraceResponse& response, const ArrayView1D& wavevectors) {
    return response.jumps ? Array1D(Array1D::Ones(wavevectors.size())) : kept(response, wavevectors);
}

double trace_band_end(const TraceResponse& response) {
    const double nyquist = pi / response.step;
    const double least = response.jumps ? min_trace_power_with_jumps : min_trace_power;
    const auto inside = [&](double q) { return std::pow(kept(response, Array1D::Constant(1, q))[0], 2) >= least; };
    if (inside(nyquist)) return nyquist;
    return numerics::bisected(inside, 0.0, nyquist, 60).first;  // T decreases monotonically up to π/step
}

}  // namespace setae::topography
