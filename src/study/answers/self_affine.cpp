// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/self_affine.hpp"

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/core/number_text.hpp"
#include "setae/core/text.hpp"

namespace setae::answers {

Band wavevector_range(const std::string& text) {
    const auto ends = spelled_list<double, 2>(text, ':');
    if (!ends) throw InvalidArgument(fmt::format("'{}'; expected two wavevectors in 1/m, such as 1e5:1e8", text));
    return {(*ends)[0], (*ends)[1]};
}

spectra::SelfAffineFit fitted(const study::SurfaceResult& surface, const SelfAffineRequest& request) {
    spectra::SelfAffineFitOptions fit;
    if (!request.range.empty()) fit.range = wavevector_range(request.range);
    fit.rolloff = !request.no_rolloff;
    fit.short_cutoff = request.short_cutoff;
    std::vector<spectra::MeasuredSpectrum> spectra;
    for (const auto& m : surface.measurements)
        if (!m.failed()) spectra.push_back(m.spectrum);
    if (spectra.empty()) throw InvalidArgument("a spectrum given as a table is not fitted: give the measurements");
    return spectra::fit_self_affine(spectra, fit);
}

std::vector<Quantity> parameters_of(const spectra::SelfAffineFit& fit) {
    std::vector<Quantity> list{fit.hurst_exponent, fit.amplitude};
    if (fit.rolloff != spectra::ScaleStatus::not_asked) {
        list.push_back(fit.plateau);
        list.push_back(fit.rolloff_wavelength);
    }
    if (fit.short_cutoff != spectra::ScaleStatus::not_asked) list.push_back(fit.shortest_wavelength);
    return list;
}

void add_model(Table& table, const spectra::SelfAffineFit& fit) {
    const auto model = spectra::model_spectrum(fit, table.at("wavevector"));
    const Array1D extrapolated = model.wavevector.unaryExpr([&](double q) {
        return q < model.band.lower * (1.0 - 1e-12) || q > model.band.upper * (1.0 + 1e-12) ? 1.0 : 0.0;
    });
    table.columns.push_back({"C1D_model", "m3", model.density});
    table.columns.push_back({"C1D_model_standard_error", "m3", model.standard_error});
    table.columns.push_back({"extrapolated", "1", extrapolated});
    for (const auto& q : parameters_of(fit))
        table.metadata["fit_" + q.quantity] =
            fmt::format("{:.6g} {} (standard error {:.2g})", q.estimate.value, q.unit, q.estimate.standard_error);
    table.metadata["fit_range"] = fmt::format("{:.6g} … {:.6g} 1/m", fit.range.lower, fit.range.upper);
    if (fit.parameters.size() > 1) {
        std::string correlations;
        for (Index i = 0; i < fit.correlation.rows(); ++i)
            for (Index j = 0; j < i; ++j)
                correlations += fmt::format("{}{}, {}: {:.2f}", correlations.empty() ? "" : "; ",
                                            fit.parameters[static_cast<std::size_t>(j)],
                                            fit.parameters[static_cast<std::size_t>(i)], fit.correlation(i, j));
        table.metadata["fit_correlation"] = correlations;
    }
}

}  // namespace setae::answers
