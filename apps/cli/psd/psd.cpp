// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "plot/figure_output.hpp"
#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "program/terminal.hpp"
#include "psd/psd_fit.hpp"
#include "psd/surface_options.hpp"
#include "setae/core/errors.hpp"
#include "setae/file_figures/spectrum_figure.hpp"
#include "setae/output/quantity_table.hpp"
#include "setae/spectra/abel.hpp"
#include "setae/spectra/inverse_abel.hpp"
#include "setae/tables/power_spectrum_table.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::cli::psd_command {
namespace {

constexpr const char* explanation =
    "C1D(q) = |h(q)|^2/L [m3], h(q) = int h exp(-iqx) dx; two-sided, averaged over +-q; h_rms^2 = (1/pi) int_0^inf C1D dq   [J17]\n"
    "C2D(q) = |h(q)|^2/A [m4]; C_iso its mean over the circle |q|; h_rms^2 = (1/2 pi) int q C_iso dq                        [J17]\n"
    "one map: C_iso by transform; else C_iso = pi C1D/(q sqrt(1 - (q/q_s)^2)), q_s the end of the band                      [D19] (11)\n"
    "--abel: C_iso = -2 int_q^inf C1D'(p) dp/sqrt(p^2 - q^2), exact for isotropic surfaces; its ratio to pi C1D/q                Bracewell\n"
    "--fit: C_iso = C_0 max(1, q/q_r)^(-2-2H) by the likelihood of the spectra, C1D by the exact Abel integral             docs/theory/self-affine-fit.md\n"
    "one measurement: its own modes; several: arithmetic mean in bins of 0.1 decade, each in its reliable band              [D19]\n";

struct Arguments {
    Common common;
    SurfaceOptions surface;
    bool isotropic = false;
    bool abel = false;
    FitOptions fit;
    bool binned = false;
    std::string output;
    FigureOption figure;
};

/// A given spectrum in SI, with both densities.
Table given(const study::SurfaceInput& input, const Arguments& arguments) {
    if (arguments.abel || arguments.fit.wanted)
        throw InvalidArgument(fmt::format("{}: --abel and --fit are for measurements, this is a table of a spectrum",
                                          *input.power_spectrum));
    auto table = tables::read_power_spectrum_table(*input.power_spectrum, input.spectrum_units);
    if (const auto* C_iso = table.find("C_iso")) {
        const auto& q = table.at("wavevector");
        table.columns.push_back({"C1D", "m3", spectra::profile_from_isotropic(q, C_iso->values, q)});
    }
    return table;
}

/// Columns of the spectrum, in the order of printing.
Table spectrum(const study::SurfaceResult& surface, const Arguments& arguments) {
    const auto& only = surface.measurements.front();
    Table table;
    table.metadata["normalisation"] = "two-sided, averaged over +-q: h_rms^2 = (1/pi) int C1D dq";
    table.metadata["window"] = surface.measurements.size() == 1 ? only.spectrum.window : "of each measurement";
    if (surface.measurements.size() == 1 && !arguments.binned && !arguments.isotropic && !arguments.abel) {
        const auto own = spectra::within_band(only.spectrum);
        table.columns = {{"wavevector", "1/m", own.wavevector},
                         {"C1D", "m3", own.density},
                         {"standard_error", "m3", own.standard_error},
                         {"count", "1", own.count}};
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

void add_isotropic(Table& table, const std::optional<topography::HeightMap>& map, const Arguments& arguments) {
    const auto& q = table.at("wavevector");
    if (map) {
        // its values belong to the mean |q| of each bin; the table has the bins' centres
        const auto curve = study::isotropic_spectrum(*map, arguments.surface.analysis(), arguments.common.workers());
        table.columns.push_back({"C_iso", "m4", roughness::values_at(curve, q)});
        table.metadata["C_iso"] = "radial mean of the two-dimensional transform";
        return;
    }
    const double end = q[q.size() - 1] * std::pow(10.0, 0.05);
    table.columns.push_back({"C_iso", "m4", spectra::isotropic_from_profile_eq11(q, table.at("C1D"), end)});
    table.metadata["C_iso"] = "[D19] (11) from C1D";
}

void add_inverse_abel(Table& table, const study::SurfaceResult& surface) {
    const auto isotropic = spectra::isotropic_from_lines(*surface.combined);
    table.columns.push_back({"C_iso_abel", "m4", isotropic.density});
    table.columns.push_back({"C_iso_abel_standard_error", "m4", isotropic.standard_error});
    table.columns.push_back({"C_iso_abel_over_pi_C1D_by_q", "1", isotropic.ratio});
    table.metadata["C_iso_abel"] = "inverse Abel transform of C1D, local parabolas over 0.6 decades";
}

output::Json as_json(const Table& table, const study::SurfaceResult& surface) {
    output::Json json, units;
    for (const auto& column : table.columns) {
        json[column.name] = output::numbers(column.values);
        units[column.name] = column.unit;
    }
    json["units"] = units;
    for (const auto& [key, text] : table.metadata) json["conventions"][key] = text;
    json["band"] = {
        {"lower", surface.average.curve.band.lower}, {"upper", surface.average.curve.band.upper}, {"unit", "1/m"}};
    json["measurements"] = output::Json::array();
    for (const auto& m : surface.measurements) {
        if (m.failed()) continue;
        json["measurements"].push_back({{"file", m.file},
                                        {"name", m.name},
                                        {"q_min", m.spectrum.band.lower},
                                        {"q_max", m.spectrum.band.upper},
                                        {"window", m.spectrum.window},
                                        {"processing", output::to_json(m.processing)}});
        if (m.channel) json["measurements"].back()["channel"] = *m.channel;
    }
    json["alerts"] = output::to_json(alerts_of(surface));
    return json;
}

ExitCode run(const Arguments& arguments) {
    require_table_or_figure(arguments.output);
    auto options = arguments.surface.analysis();
    options.bootstrap_resamples = 0;
    const study::Wanted wanted{.previews = false, .parameters = false, .map = arguments.isotropic};
    const auto input = arguments.surface.surface();
    const auto [surface, map] = study::analyse_surface(input, options, wanted, arguments.common.workers());
    const auto code = report_failures(surface);
    if (code == ExitCode::nothing_done) return code;
    auto table = input.power_spectrum ? given(input, arguments) : spectrum(surface, arguments);
    if (arguments.isotropic && table.find("C_iso") == nullptr) add_isotropic(table, map, arguments);
    if (arguments.abel) add_inverse_abel(table, surface);
    std::optional<spectra::SelfAffineFit> fit;
    if (arguments.fit.wanted) {
        fit = fitted(surface, arguments.fit);
        add_model(table, *fit);
    }
    write_table_or_figure(
        arguments.output, table,
        [&, &result = surface] { return file_figures::spectrum_figure(result, table, arguments.figure.look()); },
        arguments.common.json);
    if (arguments.common.json) {
        auto json = as_json(table, surface);
        if (fit) json["fit"] = fit_json(*fit);
        print_json(json);
        return code;
    }
    if (arguments.output.empty()) print(tables::as_csv(table));
    else if (fit) print(output::quantity_table("", parameters_of(*fit), output_size().width));
    show(alerts_of(surface));
    if (fit) show(fit->alerts);
    return code;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    arguments->surface.add_to(options);
    options.flag("--iso", arguments->isotropic, "also C_iso, on the combined grid");
    options.flag("--abel", arguments->abel, "also C_iso by the inverse Abel transform, on the combined grid");
    arguments->fit.add_to(options);
    options.flag("--binned", arguments->binned, "one measurement on the combined grid too");
    options.add("-o,--output", arguments->output, "table OUT.csv or OUT.nc; figure OUT.svg, .pdf or .png");
    arguments->figure.add_to(options);
    options.example("setae psd afm.ibw --tip-radius \"10 nm\" -o psd.svg",
                    "its spectrum as a figure, with what the tip cannot show");
    options.example("setae psd stylus.csv afm.ibw tem.csv -o psd.csv", "three measurements combined, as a table");
    options.example("setae psd afm.ibw stylus.csv --fit --json", "with a self-affine fit, for a script");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::psd_command
