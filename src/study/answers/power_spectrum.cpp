// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/power_spectrum.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "setae/core/errors.hpp"
#include "setae/spectra/abel.hpp"
#include "setae/spectra/inverse_abel.hpp"
#include "setae/spectra/spectrum_interval.hpp"
#include "setae/tables/power_spectrum_table.hpp"

namespace setae::answers {
namespace {

/// A given spectrum in SI, with both densities.
Table given(const PowerSpectrumRequest& request) {
    const auto& input = request.surface;
    if (request.abel || request.fit.wanted)
        throw InvalidArgument(fmt::format("{}: `abel` and `fit` are for measurements, this is a table of a spectrum",
                                          *input.power_spectrum));
    auto table = tables::read_power_spectrum_table(*input.power_spectrum, input.spectrum_units);
    if (const auto* C_iso = table.find("C_iso")) {
        const auto& q = table.at("wavevector");
        table.columns.push_back({"C1D", "m3", spectra::profile_from_isotropic(q, C_iso->values, q)});
    }
    return table;
}

/// One line has no scatter of its own: its interval is that of Gaussian heights.
void add_interval(Table& table, const spectra::MeasuredSpectrum& spectrum) {
    auto interval = spectra::interval_of(spectrum);
    table.columns.push_back({"interval_low", "m3", std::move(interval.lower)});
    table.columns.push_back({"interval_high", "m3", std::move(interval.upper)});
    table.metadata["interval"] =
        "95 %, of Gaussian heights: 2 n C1D/chi2 with 2 n degrees of freedom, n independent lines";
}

/// Columns of the spectrum, in the order of printing.
Table columns_of(const study::SurfaceResult& surface, const PowerSpectrumRequest& request) {
    const auto& only = surface.measurements.front();
    Table table;
    table.metadata["normalisation"] = "two-sided, averaged over +-q: h_rms^2 = (1/pi) int C1D dq";
    table.metadata["window"] = surface.measurements.size() == 1 ? only.spectrum.window : "of each measurement";
    if (surface.measurements.size() == 1 && !request.binned && !request.isotropic && !request.abel) {
        const auto own = spectra::within_band(only.spectrum);
        table.columns = {{"wavevector", "1/m", own.wavevector},
                         {"C1D", "m3", own.density},
                         {"standard_error", "m3", own.standard_error},
                         {"count", "1", own.count},
                         {"independent_lines", "1", own.independent_lines}};
        add_interval(table, own);
        return table;
    }
    const auto& c = *surface.combined;
    table.columns = {{"wavevector", "1/m", c.wavevector},
                     {"C1D", "m3", c.density},
                     {"standard_error", "m3", c.standard_error},
                     {"count", "1", c.count},
                     {"instrument_count", "1", c.instrument_count}};
    return table;
}

void add_isotropic(Table& table, const std::optional<topography::HeightMap>& map,
                   const study::SurfaceAnalysisOptions& options, parallel::Threads threads) {
    const auto& q = table.at("wavevector");
    if (map) {
        // its values belong to the mean |q| of each bin; the table has the bins' centres
        const auto curve = study::isotropic_spectrum(*map, options, threads);
        table.columns.push_back({"C_iso", "m4", roughness::values_at(curve, q)});
        table.metadata["C_iso"] = "radial mean of the two-dimensional transform";
        return;
    }
    const double end = q[q.size() - 1] * std::pow(10.0, 0.05);
    table.columns.push_back({"C_iso", "m4", spectra::isotropic_from_profile_eq11(q, table.at("C1D"), end)});
    table.metadata["C_iso"] = "from C1D by [D19], Eq. 11";
}

void add_inverse_abel(Table& table, const study::SurfaceResult& surface) {
    const auto isotropic = spectra::isotropic_from_lines(*surface.combined);
    table.columns.push_back({"C_iso_abel", "m4", isotropic.density});
    table.columns.push_back({"C_iso_abel_standard_error", "m4", isotropic.standard_error});
    table.columns.push_back({"C_iso_abel_over_pi_C1D_by_q", "1", isotropic.ratio});
    table.metadata["C_iso_abel"] = "inverse Abel transform of C1D, local parabolas over 0.6 decades";
}

}  // namespace

PowerSpectrum power_spectrum(const PowerSpectrumRequest& request, parallel::Threads threads) {
    auto options = request.analysis;
    options.bootstrap_resamples = 0;
    const study::Wanted wanted{.previews = false,
                               .parameters = false,
                               .map = request.isotropic,
                               .every_measurement = request.every_measurement};
    auto [surface, map] = study::analyse_surface(request.surface, options, wanted, threads);
    PowerSpectrum result{.surface = std::move(surface), .table = {}, .fit = {}};
    if (result.surface.failed()) return result;
    result.table = request.surface.power_spectrum ? given(request) : columns_of(result.surface, request);
    if (request.isotropic && result.table.find("C_iso") == nullptr)
        add_isotropic(result.table, map, request.analysis, threads);
    if (request.abel) add_inverse_abel(result.table, result.surface);
    if (request.fit.wanted) {
        result.fit = fitted(result.surface, request.fit);
        add_model(result.table, *result.fit);
    }
    return result;
}

}  // namespace setae::answers
