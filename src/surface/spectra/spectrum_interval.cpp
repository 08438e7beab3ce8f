// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectra/spectrum_interval.hpp"

#include <fmt/format.h>
#include <boost/math/distributions/chi_squared.hpp>

#include "setae/core/errors.hpp"

namespace setae::spectra {

SpectrumInterval interval_of(const MeasuredSpectrum& spectrum, double level) {
    if (!(level > 0.0 && level < 1.0))
        throw InvalidArgument(fmt::format("level {}; expected above 0 and below 1", level));
    const auto& n = spectrum.independent_lines;
    if (n.size() != spectrum.density.size() || !(n > 0.0).all())
        throw InvalidArgument(
            fmt::format("{} values of C1D with {} numbers of independent lines; expected as many of both, all positive",
                        spectrum.density.size(), n.size()));
    const auto end = [&](double probability) {
        const Array1D factor = n.unaryExpr([=](double lines) {
            return 2.0 * lines / boost::math::quantile(boost::math::chi_squared(2.0 * lines), probability);
        });
        return Array1D((spectrum.density > 0.0).select(spectrum.density * factor, undefined));
    };
    return {end(0.5 + 0.5 * level), end(0.5 - 0.5 * level)};
}

}  // namespace setae::spectra
