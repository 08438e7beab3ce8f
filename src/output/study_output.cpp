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
#include "setae/output/json.hpp"
#include "setae/output/study_tables.hpp"
#include "setae/spectra/abel.hpp"
#include "setae/tables/table_file.hpp"
#include "tables/table_support.hpp"

namespace setae::output {
namespace {

std::string with_error(double value, double error, int decimals) {
    if (std::isnan(value)) return "–";
    if (!(error > 0.0)) return fmt::format("{:.{}f}", value, decimals);
    return fmt::format("{:.{}f} ± {:.{}f}", value, decimals, error, decimals);
}

/// "4.60 ± 0.80" in another unit.
std::string with_error(const Estimate& estimate, double factor, int decimals) {
    return with_error(factor * estimate.value, factor * estimate.standard_error, decimals);
}

/// "4.60 ± 0.80 [3.02, 6.18]".
std::string with_interval(const Estimate& estimate, double factor, int decimals) {
    const auto interval = interval_of(estimate);
    const auto text = with_error(estimate, factor, decimals);
    return interval ? fmt::format("{} [{:.{}f}, {:.{}f}]", text, factor * interval->lower, decimals,
                                  factor * interval->upper, decimals)
                    : text;
}

tables::TidyTable surfaces_for_reading(const study::StudyResult& result) {
    tables::TidyTable table{"Surfaces",
                            {"surface", "method", "h_rms [nm]", "h'_rms", "h''_rms [1/nm]", "A_true/A_app",
                             "U_el/(A E*) [nm]", "n", "± and [ ] by"},
                            {}};
    for (const auto& surface : result.surfaces) {
        if (surface.failed()) {
            table.rows.push_back({surface.name, "failed: " + surface.error, "", "", "", "", "", "", ""});
            continue;
        }
        for (const auto& [method, spectrum] : study::spectra_of(surface)) {
            const auto q = surface_quantities(surface, *spectrum, result.study.analysis.conversion);
            const auto cell = [&](std::size_t i, double factor, int decimals) {
                return with_interval(q[i].estimate, factor, decimals);
            };
            table.rows.push_back({surface.name, method, cell(0, 1e9, 2), cell(1, 1.0, 3), cell(2, 1e-9, 3),
                                  cell(3, 1.0, 4), cell(5, 1e9, 3), q[0].n ? fmt::format("{}", *q[0].n) : "",
                                  interval_of(q[0].estimate) ? q[0].estimate.method : ""});
        }
    }
    return table;
}

/// One row a surface and instrument, with the decade in which it agrees least.
tables::TidyTable agreement_for_reading(const study::StudyResult& result) {
    tables::TidyTable table{
        "Measured periodograms against what the fitted spectra expect",
        {"surface", "instrument", "q [1/m]", "χ²", "groups of modes", "least p", "there q [1/m]", "measured/expected"},
        {}};
    const auto decades = [](int first, int last) { return fmt::format("1e{} … 1e{}", first, last + 1); };
    for (const auto& surface : result.surfaces) {
        if (surface.failed() || !surface.fitted) continue;
        const auto& rows = surface.fitted->agreement;  // by instrument, then by decade
        for (auto first = rows.begin(); first != rows.end();) {
            const auto end =
                std::find_if(first, rows.end(), [&](const auto& row) { return row.instrument != first->instrument; });
            const auto& worst = *std::min_element(
                first, end, [](const auto& a, const auto& b) { return a.probability < b.probability; });
            double chi_squared = 0.0;
            int groups = 0;
            for (auto row = first; row != end; ++row) {
                chi_squared += row->chi_squared;
                groups += row->groups;
            }
            table.rows.push_back({surface.name, first->instrument, decades(first->decade, std::prev(end)->decade),
                                  fmt::format("{:.0f}", chi_squared), fmt::format("{}", groups),
                                  fmt::format("{:.2g}", worst.probability), decades(worst.decade, worst.decade),
                                  fmt::format("{:.2f}", worst.ratio)});
            first = end;
        }
    }
    return table;
}

/// Whether instruments agree, in one line; nothing where no spectrum was fitted.
std::string agreement_line(const study::StudyResult& result) {
    std::string surfaces;
    bool fitted = false;
    for (const auto& surface : result.surfaces) {
        fitted = fitted || surface.fitted;
        const auto& alerts = surface.alerts;
        if (std::any_of(alerts.begin(), alerts.end(),
                        [](const Alert& alert) { return alert.code == "INSTRUMENTS_DISAGREE"; }))
            surfaces += (surfaces.empty() ? "" : ", ") + surface.name;
    }
    if (!fitted) return "";
    return surfaces.empty()
               ? "Instruments agree with the fitted spectra.\n\n"
               : fmt::format("Instruments disagree with the fitted spectra of: {} (agreement.csv has each decade).\n\n",
                             surfaces);
}

tables::TidyTable elastomers_for_reading(const study::StudyResult& result) {
    tables::TidyTable table{
        "Elastomers", {"elastomer", "E [MPa]", "E* [MPa]", "γ1 [mJ/m²]", "ρRT/M_c [MPa]", "E/(ρRT/M_c)"}, {}};
    for (const auto& e : result.elastomers) {
        const double network = e.network_modulus.value_or(undefined);
        table.rows.push_back({e.input.name, with_error(e.youngs_modulus, 1e-6, 3),
                              with_error(e.contact_modulus, 1e-6, 4), with_error(e.input.surface_energy, 1e3, 1),
                              with_error(1e-6 * network, 0.0, 3),
                              with_error(e.youngs_modulus.value / network, 0.0, 1)});
    }
    return table;
}

tables::TidyTable pairs_for_reading(const study::StudyResult& result) {
    tables::TidyTable table{
        "Work of adhesion on approach [mJ/m²]",
        {"surface", "elastomer", "method", "E* [MPa]", "measured", "predicted (7)", "raw (7)", "(S13)", "residual", ""},
        {}};
    for (const auto* conclusions : by_method(result))
        for (const auto& p : conclusions->pairs) {
            const auto& surface = result.surface(p.surface);
            if ((!p.modified && !p.approach) || (conclusions->of_averages && !surface.likelihood)) continue;
            const double measured = p.approach ? 1e3 * p.approach->value : undefined;
            const auto predicted = [&](const std::optional<adhesion::PredictedWork>& w) {
                return w ? 1e3 * w->work.floored : undefined;
            };
            const double raw = p.modified ? 1e3 * p.modified->work.raw : undefined;
            std::string note;
            if (p.modified && !p.modified->work.conforms) note = "will not conform";
            else if (p.scales) note = name(p.closing());
            table.rows.push_back(
                {p.surface, p.elastomer, method_name(surface, conclusions->method_of(surface)),
                 fmt::format("{:.4f}", 1e-6 * result.elastomer(p.elastomer).contact_modulus.value),
                 with_error(measured, p.approach ? 1e3 * p.approach->standard_error : 0.0, 2),
                 with_error(predicted(p.modified), p.modified ? 1e3 * p.modified->estimate.standard_error : 0.0, 2),
                 with_error(raw, 0.0, 2), with_error(predicted(p.persson_tosatti), 0.0, 2),
                 with_error(measured - predicted(p.modified), 0.0, 2), note});
        }
    return table;
}

tables::TidyTable fits_for_reading(const study::StudyResult& result) {
    tables::TidyTable table{
        "Intrinsic work of adhesion from all pairs",
        {"fit", "variant", "method", "W_int [mJ/m²]", "R²", "χ²", "n", "reported W_int", "reported R²"},
        {}};
    const auto rows = fit_table(result);
    const auto column = [&rows](const char* name) {
        return static_cast<std::size_t>(std::find(rows.columns.begin(), rows.columns.end(), name) -
                                        rows.columns.begin());
    };
    for (const auto& row : rows.rows) {
        const auto at = [&](const char* name) { return std::get<double>(row[column(name)]); };
        Estimate work{at("W_int [J/m2]"), at("standard_error [J/m2]")};
        if (const double lower = at("interval_low [J/m2]"); !std::isnan(lower))
            work.interval = Interval{lower, at("interval_high [J/m2]"), at("level")};
        table.rows.push_back(
            {row[0], row[1], row[2], with_interval(work, 1e3, 2), with_error(at("R2"), 0.0, 3),
             with_error(at("chi2"), 0.0, 1), fmt::format("{:.0f}", at("n")),
             with_error(1e3 * at("reported W_int [J/m2]"), 1e3 * at("reported standard_error [J/m2]"), 1),
             with_error(at("reported R2"), 0.0, 2)});
    }
    return table;
}

tables::TidyTable cutoffs_for_reading(const study::StudyResult& result) {
    tables::TidyTable table{"W_int against the short cutoff",
                            {"shortest wavelength", "method", "(7) [mJ/m²]", "R² (7)", "(S13) [mJ/m²]", "R² (S13)"},
                            {}};
    for (const auto* conclusions : by_method(result))
        for (const auto& p : conclusions->cutoff_scan)
            table.rows.push_back({format_value(p.shortest_wavelength, "m"), method_name(result, *conclusions),
                                  with_error(p.modified.work_of_adhesion, 1e3, 2),
                                  with_error(p.modified.r_squared, 0.0, 3),
                                  with_error(p.persson_tosatti.work_of_adhesion, 1e3, 2),
                                  with_error(p.persson_tosatti.r_squared, 0.0, 3)});
    return table;
}

tables::TidyTable references_for_reading(const study::StudyResult& result) {
    tables::TidyTable table{
        "Smooth references",
        {"elastomer", "stage", "W loading [mJ/m²]", "W retraction [mJ/m²]", "excess energy [nJ]", "ideal sphere [nJ]"},
        {}};
    for (const auto& r : result.references)
        table.rows.push_back({r.elastomer, r.stage, with_error(r.approach, 1e3, 1), with_error(r.retraction, 1e3, 1),
                              r.excess_energy ? with_error(*r.excess_energy, 1e9, 2) : "–",
                              with_error(1e9 * r.ideal_loss.value_or(undefined), 0.0, 2)});
    return table;
}

tables::TidyTable experiments_for_reading(const study::StudyResult& result) {
    tables::TidyTable table{"Loops",
                            {"file", "surface", "elastomer", "E* [MPa]", "W loading [mJ/m²]", "W pull-off [mJ/m²]",
                             "W retraction [mJ/m²]", "E_loss [nJ]", ""},
                            {}};
    for (const auto& e : result.experiments) {
        const auto file = std::filesystem::path(e.input.file).filename().string();
        if (e.failed()) {
            table.rows.push_back({file, e.input.surface, e.input.elastomer, "", "", "", "", "", "failed"});
            continue;
        }
        const auto& a = *e.analysis;
        const auto cell = [](const Estimate& v, double factor, int decimals) {
            return with_error(v, factor, decimals);
        };
        table.rows.push_back(
            {file, e.input.reference ? "(reference)" : e.input.surface, e.input.elastomer,
             cell(a.loading.primary().contact_modulus, 1e-6, 3), cell(a.loading.primary().work_of_adhesion, 1e3, 2),
             a.pull_off ? cell(a.pull_off->work_of_adhesion, 1e3, 2) : "–",
             a.retraction ? cell(a.retraction->work_of_adhesion, 1e3, 2) : "–",
             a.loop ? cell(a.loop->estimate(), 1e9, 4) : "–",
             (e.input.excluded() ? "excluded: " + e.input.exclusion : std::string()) +
                 (e.alerts.empty() ? ""
                                   : fmt::format("{}{} alerts", e.input.excluded() ? ", " : "", e.alerts.size()))});
    }
    return table;
}

/// χ² of (7) with both errors.
std::string prediction_line(const study::StudyResult& result) {
    if (!result.prediction_test) return "";
    const auto& test = *result.prediction_test;
    auto text = fmt::format(
        "Measured against predicted, both errors: χ² = {:.1f} with {} degrees of freedom (p = {:.2g}, {} pairs",
        test.chi_squared, test.degrees_of_freedom, test.probability, test.n);
    if (test.extra_scatter > 0.0)
        text += fmt::format("; with {} more scatter of the model χ² = {:.1f}",
                            format_value(test.extra_scatter, "J/m2", 3), test.chi_squared_with_scatter);
    return text + ").\n\n";
}

/// The curve as the study used it, with what the combination knows of each bin; C_iso by (11) with the surface's q_s.
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
        // few nodes hold the model; readers get ten a decade, up to where C1D falls to zero
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

std::string summary(const study::StudyResult& result) {
    std::string text =
        result.study.title + "\n" + (result.study.description.empty() ? "" : result.study.description + "\n") + "\n";
    const auto append = [&text](const tables::TidyTable& table) {
        if (!table.rows.empty()) text += tables::as_text(table) + "\n";
    };
    append(surfaces_for_reading(result));
    append(agreement_for_reading(result));
    text += agreement_line(result);
    append(elastomers_for_reading(result));
    append(experiments_for_reading(result));
    append(references_for_reading(result));
    append(pairs_for_reading(result));
    append(fits_for_reading(result));
    text += prediction_line(result);
    append(cutoffs_for_reading(result));
    text +=
        "± is one standard error, [ ] the 95 % interval, both by one method; it stands in the tables and in study.json.\n";
    if (!result.loop && !result.pairs.empty()) text += "No fit of loop energies: " + result.loop.reason + ".\n";
    if (!result.work_of_adhesion && !result.pairs.empty())
        text += "No prediction: " + result.work_of_adhesion.reason + ".\n";
    return text;
}

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
    write_table("replicates.csv", replicate_table(result));
    write_table("replicate_means.csv", replicate_mean_table(result));
    write_table("prediction_test.csv", prediction_test_table(result));
    write_table("measurements.csv", measurement_table(result));
    write_table("decades.csv", decade_table(result));
    write_table("agreement.csv", agreement_table(result));
    write_table("tip_factors.csv", tip_factor_table(result));
    write_table("stretch.csv", stretch_table(result));
    write_table("cumulative.csv", cumulative_table(result));
    write_table("cutoff_scan.csv", cutoff_table(result));
    write_table("balances.csv", balance_table(result));
    write_table("conforming.csv", conforming_table(result));
    write_table("loop_fits.csv", loop_fit_table(result));
    write_table("loop_energies.csv", loop_energy_table(result));
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
