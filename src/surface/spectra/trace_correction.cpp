// SPDX-License-Identifier: GPL-3.0-or-later
#include "trace_correction.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "setae/core/constants.hpp"
#include "setae/core/units.hpp"
#include "setae/topography/trace_response.hpp"

namespace setae::spectra {
namespace {

/// C1D must exceed the subtracted noise by this factor: N has an error of about 20 %, which then changes C1D by 10 %.
constexpr double min_signal = 2.0;

/// Mean over neighbouring modes, within a fifth of the wavevector and at least eight on either side.
Array1D smoothed(const Array1D& wavevector, const Array1D& values) {
    constexpr double reach = 1.2;
    constexpr Index at_least = 8;
    const Index n = values.size();
    Array1D sums = Array1D::Zero(n + 1);
    for (Index k = 0; k < n; ++k) sums[k + 1] = sums[k] + values[k];
    Array1D result(n);
    Index first = 0, after = 0;
    for (Index k = 0; k < n; ++k) {
        while (wavevector[first] * reach < wavevector[k]) ++first;
        while (after < n && wavevector[after] <= wavevector[k] * reach) ++after;
        const Index from = std::max<Index>(0, std::min(first, k - at_least)),
                    to = std::min(n, std::max(after, k + at_least + 1));
        result[k] = (sums[to] - sums[from]) / static_cast<double>(to - from);
    }
    return result;
}

}  // namespace

void correct_for_trace(MeasuredSpectrum& spectrum, const topography::TraceResponse& response,
                       const ArrayView1D& kept_by_segments) {
    const auto& q = spectrum.wavevector;
    const Array1D noise =
        kept_by_segments * topography::smoothing_transfer(response, q).square() * response.noise_density;
    const Array1D kept = topography::trace_transfer(response, q).square().max(topography::min_trace_power);
    spectrum.density = (spectrum.density - noise) / kept;

    const Array1D signal = smoothed(q, spectrum.density), floor = noise / kept;
    const double widest = topography::trace_band_end(response);
    Index end = 0;
    while (end < q.size() && q[end] <= widest && signal[end] > min_signal * floor[end]) ++end;
    const double nyquist = spectrum.band.upper;
    spectrum.band.upper = end == 0 ? 0.0 : end == q.size() ? nyquist : std::min(nyquist, q[end - 1]);
    const std::string action = "to use shorter waves, take pictures with a higher magnification or less noise";
    if (end == 0) {
        spectrum.alerts.push_back(
            {"TRACE_NOISE", topography::label(spectrum.metadata),
             fmt::format("the noise of the trace, C1D {}, exceeds all waves, so that no wavelength is reliable",
                         format_value(response.noise_density, "m³", 3)),
             action});
        return;
    }
    const Index last = end - 1;
    if (response.jumps) {
        spectrum.alerts.push_back(
            {"TRACE_NOISE", topography::label(spectrum.metadata),
             fmt::format("the noise of the trace, C1D {}, was subtracted; its blur and smoothing remain, because "
                         "overhangs were replaced by jumps, which neither affects: the band ends at the wavelength {}, "
                         "where blur and smoothing remove up to {:.0f} % of C1D",
                         format_value(response.noise_density, "m³", 3),
                         format_value(2.0 * pi / std::min(q[last], nyquist), "m"),
                         100.0 * (1.0 - topography::min_trace_power_with_jumps)),
             action});
        return;
    }
    spectrum.alerts.push_back(
        {"TRACE_NOISE", topography::label(spectrum.metadata),
         fmt::format("the noise of the trace, C1D {}, was subtracted, and its blur and smoothing were corrected down "
                     "to the wavelength {}, where the band ends: there the noise was {:.0f} % of the traced C1D, and "
                     "{:.0f} % of the C1D of the curve had remained",
                     format_value(response.noise_density, "m³", 3),
                     format_value(2.0 * pi / std::min(q[last], nyquist), "m"),
                     100.0 * floor[last] / (signal[last] + floor[last]), 100.0 * kept[last]),
         action});
}

}  // namespace setae::spectra
