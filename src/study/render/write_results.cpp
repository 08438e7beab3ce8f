// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "setae/bytes/whole_file.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/formats/netcdf.hpp"
#include "setae/output/file_names.hpp"
#include "setae/output/hysteresis_output.hpp"
#include "setae/output/json.hpp"
#include "setae/output/study_tables.hpp"
#include "setae/spectra/abel.hpp"
#include "setae/tables/table_file.hpp"
#include "tables/table_support.hpp"

namespace setae::output {
namespace {

/// The curve as used by the study, with the data of each bin of the combination; C_iso by Eq. 11 with the surface's
/// q_s.
Table spectrum_table(const study::SurfaceResult& surface, double shortest_wavelength) {
    Table table;
    table.metadata["surface"] = surface.name;
    table.metadata["source"] = surface.reconstructed ? "self-affine reconstruction from published moments"
                               : surface.combined    ? "combined measurements"
                                                     : "given power spectrum";
    table.metadata["normalisation"] =
        "C1D = |h(q)|^2/L two-sided, averaged over +-q: h_rms^2 = (1/pi) int C1D dq; C_iso: h_rms^2 = (1/2 pi) int q C_iso dq";
    if (surface.combined) {
        const auto& c = *surface.combined;
        table.columns = {
            {"wavevector", "1/m", c.wavevector},
            {"C1D", "m3", c.density},
            {"standard_error", "m3", c.standard_error},
            {"count", "1", c.count},
            {"instrument_count", "1", c.instrument_count},
            {"C_iso", "m4",
             spectra::isotropic_from_profile_eq11(c.wavevector, c.density, 2.0 * pi / shortest_wavelength)}};
    } else if (surface.average.curve.kind == spectra::Density::C_iso) {
        // few nodes represent the model; the output has ten per decade, up to where C1D decreases to zero
        const auto& curve = surface.average.curve;
        const auto n = static_cast<Index>(std::ceil(10.0 * std::log10(curve.band.upper / curve.band.lower)));
        const Array1D q =
            curve.band.lower * (Array1D::LinSpaced(n, 0.0, static_cast<double>(n - 1)) * (std::log(10.0) / 10.0)).exp();
        table.columns = {{"wavevector", "1/m", q},
                         {"C_iso", "m4", roughness::values_at(curve, q)},
                         {"C1D", "m3", spectra::profile_from_isotropic(curve.wavevector, curve.density, q)}};
    } else {
        table.columns = {{"wavevector", "1/m", surface.average.curve.wavevector},
                         {"C1D", "m3", surface.average.curve.density}};
    }
    return table;
}

}  // namespace

std::vector<std::string> spectrum_stems(const study::StudyResult& result) {
    std::vector<std::string> names;
    for (const auto& surface : result.surfaces) names.push_back(surface.name);
    return file_names(names);
}

std::vector<std::string> write_results(const study::StudyResult& result, ResultFolder& folder) {
    std::vector<std::string> files;
    const auto path_of = [&](const std::string& name) {
        files.push_back(name);
        return folder.claim(name);
    };
    const auto write_table = [&](const std::string& name, const tables::TidyTable& table) {
        if (!table.rows.empty()) bytes::write_whole_file(path_of(name), tables::as_csv(table));
    };
    write_table("surfaces.csv", surface_table(result));
    write_table("pairs.csv", pair_table(result));
    write_table("fits.csv", fit_table(result));
    write_table("work_estimates.csv", work_estimate_table(result));
    write_table("replicates.csv", replicate_table(result));
    write_table("replicate_means.csv", replicate_mean_table(result));
    write_table("prediction_test.csv", prediction_test_table(result));
    write_table("budget.csv", budget_table(result));
    write_table("left_out.csv", left_out_table(result));
    write_table("profiles.csv", profile_table(result));
    write_table("measurements.csv", measurement_table(result));
    write_table("decades.csv", decade_table(result));
    write_table("agreement.csv", agreement_table(result));
    write_table("tip_factors.csv", tip_factor_table(result));
    write_table("stretch.csv", stretch_table(result));
    write_table("cumulative.csv", cumulative_table(result));
    write_table("cutoff_scan.csv", cutoff_table(result));
    write_table("balances.csv", balance_table(result));
    write_table("conforming.csv", full_contact_table(result));
    write_table("loop_fits.csv", loop_fit_table(result));
    write_table("loop_energies.csv", loop_energy_table(result));
    if (result.hysteresis)
        for (const auto& [name, table] : hysteresis_tables(*result.hysteresis)) write_table(name, table);
    write_table("alerts.csv", alert_table(result));
    const auto stems = spectrum_stems(result);
    const auto write_spectrum = [&](const std::string& stem, const Table& table) {
        formats::write_netcdf(path_of(stem + ".nc"), table);
        tables::write_csv(path_of(stem + ".csv"), table);
    };
    for (std::size_t i = 0; i < stems.size(); ++i) {
        const auto& surface = result.surfaces[i];
        if (surface.failed()) continue;
        const auto table = spectrum_table(surface, result.study.analysis.likelihood.shortest_wavelength);
        write_spectrum("psd_" + stems[i], table);
        if (!surface.fitted) continue;
        auto fitted = fitted_spectrum_table(*surface.fitted);
        fitted.metadata = {{"surface", surface.name},
                           {"source", "C_iso fitted to all measurements"},
                           {"normalisation", table.metadata.at("normalisation")},
                           {"band", "_low and _high: 95 %"}};
        write_spectrum("likelihood_" + stems[i], fitted);
    }
    bytes::write_whole_file(path_of("study.json"), [&](const bytes::Write& write) { write_json(result, write); });
    return files;
}

std::vector<std::string> write_results(const study::StudyResult& result) {
    ResultFolder folder(result.study);
    folder.begin();
    auto files = write_results(result, folder);
    folder.finish();
    return files;
}

}  // namespace setae::output
