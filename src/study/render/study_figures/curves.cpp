// SPDX-License-Identifier: GPL-3.0-or-later
#include "curves.hpp"

#include <cmath>
#include <vector>

#include "drawing.hpp"
#include "setae/core/statistics.hpp"
#include "setae/spectra/abel.hpp"

namespace setae::study_figures {
namespace {

constexpr double normal_95 = 1.959963984540054;

/// Share of the end of C_iso up to which C1D is drawn. C1D at q includes the waves beyond q: a missing continuation of
/// C_iso reduces it by a fifth there (C_iso ∝ q^−3.6), and completely at the end itself, where C1D decreases to 0.
constexpr double drawn_share = 0.7;

/// Nodes of a curve in its band with defined values.
DrawnCurve usable(const spectra::Spectrum& curve) {
    std::vector<double> q, values;
    for (Index i = 0; i < curve.wavevector.size(); ++i) {
        if (!(curve.density[i] > 0.0) || curve.wavevector[i] < curve.band.lower ||
            curve.wavevector[i] > curve.band.upper)
            continue;
        q.push_back(curve.wavevector[i]);
        values.push_back(curve.density[i]);
    }
    return {array_of(q), array_of(values)};
}

/// Half the 95 % interval of the average at each node of a curve, t of as many measurements as the bin has; NaN where
/// it has one.
Array1D half_widths(const spectra::CombinedSpectrum& combined, const Array1D& wavevector) {
    Array1D widths = Array1D::Constant(wavevector.size(), undefined);
    Index k = 0;
    for (Index i = 0; i < wavevector.size(); ++i) {
        while (k < combined.wavevector.size() && combined.wavevector[k] < wavevector[i]) ++k;
        if (k < combined.wavevector.size() && combined.wavevector[k] == wavevector[i] && combined.count[k] > 1.0)
            widths[i] = student_t_quantile(0.975, combined.count[k] - 1.0) * combined.standard_error[k];
    }
    return widths;
}

/// The part of a C1D made of a C_iso that the end of C_iso leaves as it is.
SurfaceCurve before_end(const SurfaceCurve& curve, double end) {
    std::vector<Index> kept;
    for (Index i = 0; i < curve.wavevector.size(); ++i)
        if (curve.wavevector[i] <= drawn_share * end) kept.push_back(i);
    const auto part = [&](const Array1D& values) { return values.size() > 0 ? taken(values, kept) : values; };
    return {part(curve.wavevector), part(curve.values), part(curve.lower), part(curve.upper), curve.method};
}

SurfaceCurve fitted_curve(const study::FittedSpectrum& fitted, const Array1D& values, const Array1D& log_error) {
    return {fitted.wavevector, values, values * (-normal_95 * log_error).exp(), values * (normal_95 * log_error).exp(),
            "likelihood"};
}

}  // namespace

std::optional<SurfaceCurve> C1D_of(const study::SurfaceResult& surface) {
    if (surface.failed()) return std::nullopt;
    if (surface.method == study::SpectrumMethod::likelihood && surface.fitted)
        return before_end(fitted_curve(*surface.fitted, surface.fitted->C1D, surface.fitted->log_C1D_standard_error),
                          surface.used().curve.band.upper);
    const auto& whole = surface.average.curve;
    const auto nodes = usable(whole);
    if (nodes.x.size() < 2) return std::nullopt;
    SurfaceCurve curve{.method = study::method_name(surface, study::SpectrumMethod::average)};
    if (whole.kind == spectra::Density::C_iso) {
        // the last node is the end of the spectrum, where the integral is 0
        curve.wavevector = nodes.x.head(nodes.x.size() - 1);
        curve.values = spectra::profile_from_isotropic(nodes.x, nodes.y, curve.wavevector);
        return before_end(curve, whole.band.upper);
    }
    const bool bins = surface.combined && whole.nodes == spectra::Nodes::power_law;
    if (!bins) {
        const auto thin = log_means(nodes, 400);
        curve.wavevector = thin.x;
        curve.values = thin.y;
        return curve;
    }
    curve.wavevector = nodes.x;
    curve.values = nodes.y;
    const Array1D widths = half_widths(*surface.combined, nodes.x);
    if (widths.isNaN().all()) return curve;
    curve.lower = nodes.y - widths;
    curve.upper = nodes.y + widths;
    return curve;
}

std::optional<SurfaceCurve> C_iso_of(const study::SurfaceResult& surface, roughness::Conversion conversion) {
    if (surface.failed()) return std::nullopt;
    if (surface.method == study::SpectrumMethod::likelihood && surface.fitted)
        return fitted_curve(*surface.fitted, surface.fitted->C_iso, surface.fitted->log_C_iso_standard_error);
    const auto& whole = surface.average.curve;
    if (whole.kind == spectra::Density::C_iso) {
        const auto nodes = usable(whole);
        return SurfaceCurve{.wavevector = nodes.x,
                            .values = nodes.y,
                            .method = study::method_name(surface, study::SpectrumMethod::average)};
    }
    auto curve = C1D_of(surface);
    if (!curve) return std::nullopt;
    std::vector<Index> below;
    for (Index i = 0; i < curve->wavevector.size(); ++i)
        if (curve->wavevector[i] < whole.band.upper) below.push_back(i);
    if (below.size() < 2) return std::nullopt;
    const Array1D q = taken(curve->wavevector, below), C1D = taken(curve->values, below);
    curve->wavevector = q;
    curve->values = conversion == roughness::Conversion::exact
                        ? spectra::isotropic_from_profile(q, C1D, whole.band.upper)
                        : spectra::isotropic_from_profile_eq11(q, C1D, whole.band.upper);
    curve->lower.resize(0);
    curve->upper.resize(0);
    return curve;
}

std::string method_in_words(const std::string& method) {
    if (method == "likelihood") return "fitted to all measurements together";
    if (method == "average") return "averaged over the measurements";
    return method == "moments" ? "reconstructed from published moments" : "given as a table";
}

}  // namespace setae::study_figures
