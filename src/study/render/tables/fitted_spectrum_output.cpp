// SPDX-License-Identifier: GPL-3.0-or-later
// What a spectrum fitted to all measurements knows beside its parameters: tables and columns of curves.
#include <algorithm>
#include <cmath>

#include "json/surface_fields.hpp"
#include "setae/core/constants.hpp"
#include "setae/output/json.hpp"
#include "setae/output/study_tables.hpp"
#include "setae/study/study_result.hpp"
#include "table_support.hpp"

namespace setae::output {
namespace {

/// Visits every surface whose spectrum was fitted.
template <class Visit>
void each_fitted(const study::StudyResult& result, Visit visit) {
    for (const auto& surface : result.surfaces)
        if (!surface.failed() && surface.fitted) visit(surface.name, *surface.fitted);
}

Band decade_of(const spectral_fit::Agreement& row) {
    return {std::pow(10.0, row.decade), std::pow(10.0, row.decade + 1)};
}

void add_curve(Table& table, const std::string& name, const std::string& unit, const Array1D& values,
               const Array1D& log_error) {
    const Array1D factor = FittedCurves::factor(log_error);
    table.columns.push_back({name, unit, values});
    table.columns.push_back({name + "_standard_error", unit, values * log_error});
    table.columns.push_back({name + "_low", unit, values / factor});
    table.columns.push_back({name + "_high", unit, values * factor});
}

Estimate in_degrees(const Estimate& angle) {
    constexpr double degree = pi / 180.0;
    return {angle.value / degree, angle.standard_error / degree};
}

}  // namespace

tables::TidyTable decade_table(const study::StudyResult& result) {
    tables::TidyTable table{"", {"surface", "method", "decade_low [1/m]", "decade_high [1/m]", "C1D [m3]"}, {}};
    append(table.columns, uncertainty_columns("", "m3"));
    for (const auto& surface : result.surfaces) {
        if (surface.failed()) continue;
        for (const auto& [method, spectrum] : study::spectra_of(surface))
            for (const auto& q : decade_quantities(surface, *spectrum)) {
                Cells row;
                add_cells(row, surface.name, method, q.band->lower, q.band->upper, q.estimate.value);
                append(row, uncertainty_cells(q.estimate));
                table.rows.push_back(std::move(row));
            }
    }
    return table;
}

tables::TidyTable agreement_table(const study::StudyResult& result) {
    tables::TidyTable table{"",
                            {"surface", "instrument", "decade_low [1/m]", "decade_high [1/m]", "measured/expected [1]",
                             "standard_error [1]", "chi2", "groups", "probability"},
                            {}};
    each_fitted(result, [&](const std::string& surface, const study::FittedSpectrum& fitted) {
        for (const auto& a : fitted.agreement) {
            const auto decade = decade_of(a);
            table.rows.push_back({surface, a.instrument, decade.lower, decade.upper, a.ratio, a.standard_error,
                                  a.chi_squared, static_cast<double>(a.groups), a.probability});
        }
    });
    return table;
}

tables::TidyTable tip_factor_table(const study::StudyResult& result) {
    tables::TidyTable table{
        "", {"surface", "instrument", "group", "probe", "size [m]", "wavevector [1/m]", "tip factor [1]"}, {}};
    each_fitted(result, [&](const std::string& surface, const study::FittedSpectrum& fitted) {
        double group = 0.0;
        for (const auto& tip : fitted.tips) {
            ++group;
            for (Index k = 0; k < tip.wavevector.size(); ++k)
                table.rows.push_back(
                    {surface, tip.instrument, group, tip.probe, tip.size, tip.wavevector[k], tip.transfer[k]});
        }
    });
    return table;
}

tables::TidyTable stretch_table(const study::StudyResult& result) {
    tables::TidyTable table{"", {"surface", "wavevector [1/m]", "stretch [1]"}, {}};
    append(table.columns, uncertainty_columns("stretch", "1"));
    table.columns.emplace_back("direction [deg]");
    append(table.columns, uncertainty_columns("direction", "deg"));
    each_fitted(result, [&](const std::string& surface, const study::FittedSpectrum& fitted) {
        for (const auto& s : fitted.stretch) {
            Cells row;
            const auto direction = in_degrees(s.direction);
            add_cells(row, surface, s.wavevector, s.ratio.value);
            append(row, uncertainty_cells(s.ratio));
            row.emplace_back(direction.value);
            append(row, uncertainty_cells(direction));
            table.rows.push_back(std::move(row));
        }
    });
    return table;
}

Table fitted_spectrum_table(const study::FittedSpectrum& fitted) {
    Table table;
    table.columns = {{"wavevector", "1/m", fitted.wavevector}};
    add_curve(table, "C_iso", "m4", fitted.C_iso, fitted.log_C_iso_standard_error);
    add_curve(table, "C1D", "m3", fitted.C1D, fitted.log_C1D_standard_error);
    if (fitted.C1D_along.size() == 0) return table;
    table.columns.push_back({"C1D_along", "m3", fitted.C1D_along});
    table.columns.push_back({"C1D_across", "m3", fitted.C1D_across});
    return table;
}

std::vector<Quantity> decade_quantities(const study::SurfaceResult& surface, const study::SpectrumResult& spectrum) {
    std::vector<Quantity> found;
    if (surface.measurements.empty()) return found;
    for (std::size_t d = 0; d < spectrum.parameters.decade_C1D.size(); ++d) {
        if (!std::isfinite(spectrum.parameters.decade_C1D[d])) continue;
        auto q =
            quantity("decade_mean_C1D", "C1D",
                     spectrum.estimate([d](const roughness::SpectralParameters& p) { return p.decade_C1D[d]; }), "m3");
        const int decade = roughness::first_decade + static_cast<int>(d);
        q.band = Band{std::pow(10.0, decade), std::pow(10.0, decade + 1)};
        q.source = "exp of the mean of ln C1D over ln q";
        found.push_back(std::move(q));
    }
    return found;
}

}  // namespace setae::output
