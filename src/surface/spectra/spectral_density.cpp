// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/spectra/spectral_density.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <boost/math/quadrature/gauss.hpp>

#include "abel_integral.hpp"
#include "refined_curve.hpp"
#include "self_affine_model.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/summation.hpp"
#include "setae/spectra/abel.hpp"

namespace setae::spectra {
namespace {

/// A curve of power laws between nodes.
class PowerLaws {
public:
    PowerLaws(const ArrayView1D& wavevector, const ArrayView1D& spectrum)
        : nodes_(wavevector.begin(), wavevector.end()), values_(spectrum.begin(), spectrum.end()) {
        for (std::size_t i = 0; i + 1 < nodes_.size(); ++i)
            exponents_.push_back(std::log(values_[i + 1] / values_[i]) / std::log(nodes_[i + 1] / nodes_[i]));
    }

    double operator()(double q) const {
        if (q <= nodes_.front()) return values_.front();
        if (q > nodes_.back()) return 0.0;
        const auto upper = std::lower_bound(nodes_.begin(), nodes_.end(), q);
        const auto i = static_cast<std::size_t>(upper - nodes_.begin()) - 1;
        if (values_[i] > 0.0 && values_[i + 1] > 0.0) return values_[i] * std::pow(q / nodes_[i], exponents_[i]);
        return values_[i] + (values_[i + 1] - values_[i]) * (q - nodes_[i]) / (nodes_[i + 1] - nodes_[i]);
    }

private:
    std::vector<double> nodes_, values_, exponents_;
};

void require(const Band& band) {
    if (!(band.lower > 0.0 && band.lower < band.upper && std::isfinite(band.upper)))
        throw InvalidArgument(
            fmt::format("a spectrum from {} to {} 1/m; expected 0 < lower < upper", band.lower, band.upper));
}

}  // namespace

SpectralDensity density(const SelfAffine& model) {
    if (!(model.hurst_exponent > 0.0 && model.hurst_exponent <= 1.0))
        throw InvalidArgument(fmt::format("Hurst exponent {}; expected 0 < H <= 1", model.hurst_exponent));
    if (!(model.short_wavevector > model.rolloff_wavevector))
        throw InvalidArgument(
            fmt::format("short cutoff at q_s = {} 1/m, roll-off at q_r = {} 1/m; expected q_s > q_r, that is a short "
                        "wavelength below the roll-off wavelength",
                        model.short_wavevector, model.rolloff_wavevector));
    if (!(model.rolloff_wavevector > 0.0 && model.plateau > 0.0 &&
          std::isfinite(model.plateau * model.short_wavevector)))
        throw InvalidArgument(fmt::format("plateau C_0 = {} m4 up to q_r = {} 1/m; expected both positive and finite",
                                          model.plateau, model.rolloff_wavevector));
    return [model](double q) { return isotropic_value(model, q); };
}

SpectralDensity tabulated_density(const ArrayView1D& wavevector, const ArrayView1D& spectrum) {
    if (wavevector.size() != spectrum.size() || wavevector.size() < 2)
        throw InvalidArgument(
            fmt::format("a spectrum of {} wavevectors and {} values; expected as many of both, at least 2",
                        wavevector.size(), spectrum.size()));
    for (Index i = 0; i < wavevector.size(); ++i) {
        if (!(wavevector[i] > (i == 0 ? 0.0 : wavevector[i - 1])) || !std::isfinite(wavevector[i]))
            throw InvalidArgument(
                fmt::format("row {} of a spectrum has q = {} 1/m after {}; expected positive wavevectors that increase",
                            i + 1, wavevector[i], i == 0 ? 0.0 : wavevector[i - 1]));
        if (!(spectrum[i] >= 0.0) || !std::isfinite(spectrum[i]))
            throw InvalidArgument(fmt::format(
                "row {} of a spectrum (q = {} 1/m) is {}; expected a number >= 0: a power spectrum is a mean "
                "square",
                i + 1, wavevector[i], spectrum[i]));
    }
    return PowerLaws(wavevector, spectrum);
}

SpectralDensity surface_density(const ArrayView1D& wavevector, const ArrayView1D& C1D) {
    const Index n = wavevector.size();
    if (n < 2) throw InvalidArgument(fmt::format("C1D at {} wavevectors; expected two or more", n));
    const double cutoff = wavevector[n - 1] * (wavevector[n - 1] / wavevector[n - 2]);
    Array1D nodes(n + 1), values(n + 1);
    nodes << wavevector, cutoff;
    const Array1D inverted = isotropic_from_profile(wavevector, C1D, cutoff);
    values << inverted,
        inverted[n - 1] * std::pow(cutoff / wavevector[n - 1], std::log(inverted[n - 1] / inverted[n - 2]) /
                                                                   std::log(wavevector[n - 1] / wavevector[n - 2]));
    return tabulated_density(nodes, values);
}

SpectralDensity profile_density(const SpectralDensity& C_iso, const Band& band) {
    require(band);
    const auto surface = refined_curve(C_iso, band.lower, band.upper, 2e-5);
    const Index n = surface.nodes.size();
    if (n < 2)
        throw InvalidArgument(fmt::format("C_iso = {} m4 at {} 1/m; expected power from the lowest wavevector on",
                                          C_iso(band.lower), band.lower));
    const AbelIntegral integral(surface.nodes, surface.values);
    const double cutoff = surface.nodes[n - 1], at_cutoff = surface.values[n - 1] * cutoff / pi;
    // tabulated is C1D without the root with which it goes to zero at the cutoff; below a thousandth of the begin of
    // the band it is constant to 1e-6
    const auto rootless = [&](double q) {
        const double share = std::sqrt((1.0 - q / cutoff) * (1.0 + q / cutoff));
        return share > 1e-4 ? integral(q) / share : at_cutoff;
    };
    const auto line = refined_curve(rootless, 1e-3 * band.lower, cutoff, 1e-5);
    return [smooth = PowerLaws(line.nodes, line.values), cutoff](double q) {
        return q < cutoff ? smooth(q) * std::sqrt((1.0 - q / cutoff) * (1.0 + q / cutoff)) : 0.0;
    };
}

double moment(const SpectralDensity& density, double order, const Band& band) {
    require(band);
    const double span = std::log(band.upper / band.lower);
    const auto pieces = static_cast<Index>(std::ceil(20.0 * span / std::log(10.0)));
    const double width = span / static_cast<double>(pieces);
    Array1D sums(pieces);
    for (Index i = 0; i < pieces; ++i) {
        const double from = std::log(band.lower) + static_cast<double>(i) * width;
        const auto integrand = [&](double log_q) { return std::exp((order + 2.0) * log_q) * density(std::exp(log_q)); };
        sums[i] = boost::math::quadrature::gauss<double, 20>::integrate(integrand, from, from + width);
    }
    return pairwise_sum(sums);
}

}  // namespace setae::spectra
