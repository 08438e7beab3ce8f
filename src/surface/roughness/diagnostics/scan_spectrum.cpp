// SPDX-License-Identifier: GPL-3.0-or-later
#include "scan_spectrum.hpp"

#include <cmath>

namespace setae::diagnostics {

spectra::MeasuredSpectrum scan_spectrum(const topography::HeightMap& map, parallel::Threads threads) {
    spectra::SpectrumOptions options;
    options.threads = threads;
    if (map.heights.cols() > 1) return spectra::power_spectrum(map, options);
    return spectra::power_spectrum(topography::LineScan{map.heights.col(0), map.size[0], map.periodic, map.metadata},
                                   options);
}

double window_gain(double mode, double exponent, bool hann) {
    if (!hann || mode < 2.0) return 1.0;
    // |1 at k, −½ next to it|², scaled to keep the mean square
    return (2.0 / 3.0) *
           (1.0 + 0.25 * (std::pow((mode - 1.0) / mode, -exponent) + std::pow((mode + 1.0) / mode, -exponent)));
}

}  // namespace setae::diagnostics
