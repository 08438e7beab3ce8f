// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nanobind/stl/shared_ptr.h>
#include <nlohmann/json.hpp>

#include "heights.hpp"
#include "request.hpp"
#include "setae/answers/adhesion_fields.hpp"
#include "setae/answers/diagnosis.hpp"
#include "setae/answers/parameters.hpp"
#include "setae/answers/power_spectrum_fields.hpp"
#include "setae/answers/scale_fields.hpp"
#include "setae/answers/texture.hpp"
#include "setae/core/errors.hpp"
#include "setae/output/field_json.hpp"
#include "setae/output/study_tables.hpp"

namespace setae::python {
namespace {

using Items = std::vector<std::shared_ptr<Item>>;

/// An analysed surface, and the options of the analysis.
struct Surface {
    study::SurfaceWithMap result;
    study::SurfaceAnalysisOptions analysis;
    Table spectrum;  ///< spectrum from which the results are computed
};

/// The spectrum from which the results of a surface are computed.
Table spectrum_of(const study::SurfaceResult& surface) {
    if (surface.method == study::SpectrumMethod::likelihood) return output::fitted_spectrum_table(*surface.fitted);
    const auto& curve = surface.used().curve;
    const bool is_profile = curve.kind == spectra::Density::C1D;
    const auto* unit = is_profile ? "m3" : "m4";
    Table table;
    table.columns = {{"wavevector", "1/m", curve.wavevector}, {is_profile ? "C1D" : "C_iso", unit, curve.density}};
    if (curve.standard_error.size() > 0) table.columns.push_back({"standard_error", unit, curve.standard_error});
    return table;
}

Surface surface(const Items& items, const answers::AnalysisRequest& request, const std::string& spectrum,
                bool every_measurement) {
    Surface surface{.result = {}, .analysis = request.analysis(), .spectrum = {}};
    auto& method = surface.analysis.spectrum;
    if (spectrum.empty()) method.reset();
    else if (spectrum == "likelihood") method = study::SpectrumMethod::likelihood;
    else if (spectrum != "average")
        throw InvalidArgument(fmt::format("spectrum '{}'; expected \"average\" or \"likelihood\"", spectrum));
    surface.result =
        study::analyse_surface(surface_of(items), surface.analysis,
                               {.previews = false, .map = true, .every_measurement = every_measurement}, {});
    surface.spectrum = spectrum_of(analysed(surface.result.surface));
    return surface;
}

answers::ScaleFunction scale_function(const std::string& command) {
    if (command == "sdrp") return answers::ScaleFunction::differences;
    if (command == "acf") return answers::ScaleFunction::autocorrelation;
    return answers::ScaleFunction::variable_bandwidth;
}

void bind_analysis(nb::module_& module) {
    nb::class_<answers::AnalysisRequest> request(module, "Analysis");
    request.def(nb::init<>());
    bind_asked(request);
    bind_options(request, fields::Asked<answers::AnalysisRequest>::memory);
    request.def(
        "require_valid", [](const answers::AnalysisRequest& asked) { (void)asked.analysis(); },
        "raises InvalidArgument for malformed values");
}

void bind_texture(nb::module_& module) {
    using Request = answers::TextureRequest;
    nb::class_<Request> request(module, "TextureRequest");
    request.def(nb::init<>());
    bind_asked(request);
    module.def(
        "texture",
        [](const Items& items, const Request& request, bool every_measurement) {
            return unlocked([&](const auto&) {
                const auto answer = answers::texture_of(surface_of(items), request, {}, every_measurement);
                if (answer.list.empty()) throw InvalidArgument(fmt::format("{}", fmt::join(answer.failures, "; ")));
                return output::as_text(output::described(answers::texture_entries(answer)));
            });
        },
        nb::arg("items"), nb::arg("request"), nb::arg("every_measurement"),
        "as printed by `setae params --standard --json`");
}

void bind_adhesion(nb::module_& module) {
    nb::class_<answers::AdhesionRequest> solids(module, "Solids");
    solids.def(nb::init<>());
    bind_asked(solids);
    solids.def(
        "require_valid", [](const answers::AdhesionRequest& request) { (void)request.study({}); },
        "raises InvalidArgument for missing or malformed values");
    module.def(
        "adhesion_of_files",
        [](const Items& items, const answers::AnalysisRequest& request, const answers::AdhesionRequest& solids,
           bool every_measurement) {
            return unlocked([&](const auto&) {
                const auto analysis = request.analysis();
                auto surface = study::analyse_surface(
                    surface_of(items), analysis,
                    {.previews = false, .parameters = false, .map = true, .every_measurement = every_measurement}, {});
                (void)analysed(surface.surface);
                return output::as_text(output::described(answers::adhesion(std::move(surface), analysis, solids)));
            });
        },
        nb::arg("items"), nb::arg("analysis"), nb::arg("solids"), nb::arg("every_measurement"),
        "as printed by `setae adhesion --json`");
    module.def(
        "adhesion_of_surface",
        [](const Surface& surface, const answers::AdhesionRequest& solids) {
            return unlocked([&](const auto&) {
                return output::as_text(output::described(answers::adhesion(surface.result, surface.analysis, solids)));
            });
        },
        nb::arg("surface"), nb::arg("solids"));
}

/// Values of the self-affine fit and the model at their wavevectors, by name; empty without a fit.
nb::typed<nb::dict, nb::str, ReadOnly1D> fitted_values(nb::handle self) {
    nb::typed<nb::dict, nb::str, ReadOnly1D> named;
    const auto& fit = nb::cast<const answers::PowerSpectrum&>(self).fit;
    if (!fit) return named;
    named["wavevector"] = view(fit->wavevector, self);
    named["C1D"] = view(fit->values, self);
    named["best_fit"] = view(fit->expected, self);
    named["residuals"] = view(fit->residual, self);
    return named;
}

}  // namespace

const study::SurfaceResult& analysed(const study::SurfaceResult& surface) {
    if (!surface.failed()) return surface;
    std::string reasons;
    for (const auto& m : surface.measurements)
        if (m.failed()) reasons += "; " + m.error;
    throw InvalidArgument(surface.error + reasons);
}

void bind_surfaces(nb::module_& module) {
    bind_analysis(module);
    using Spectrum = answers::PowerSpectrum;
    nb::class_<Spectrum>(module, "Spectrum")
        .def_prop_ro("columns", [](nb::handle self) { return columns(nb::cast<const Spectrum&>(self).table, self); })
        .def_prop_ro("units", [](const Spectrum& spectrum) { return units(spectrum.table); })
        .def_prop_ro("fitted", &fitted_values)
        .def("json", [](const Spectrum& spectrum) { return output::as_text(output::described(spectrum)); });
    module.def(
        "power_spectrum",
        [](const Items& items, const answers::AnalysisRequest& analysis, bool isotropic, bool abel, bool binned,
           bool fit, const std::string& fit_range, bool no_rolloff, bool short_cutoff, bool every_measurement) {
            const auto compute = [&](const auto&) {
                auto spectrum = answers::power_spectrum({.surface = surface_of(items),
                                                         .analysis = analysis.analysis(),
                                                         .isotropic = isotropic,
                                                         .abel = abel,
                                                         .binned = binned,
                                                         .fit = {fit, fit_range, no_rolloff, short_cutoff},
                                                         .every_measurement = every_measurement});
                (void)analysed(spectrum.surface);
                return spectrum;
            };
            return are_few_heights(items) ? unlocked_here(compute) : unlocked(compute);
        },
        nb::arg("items"), nb::arg("analysis"), nb::arg("isotropic"), nb::arg("abel"), nb::arg("binned"), nb::arg("fit"),
        nb::arg("fit_range"), nb::arg("no_rolloff"), nb::arg("short_cutoff"), nb::arg("every_measurement"));
    module.def(
        "parameters",
        [](const Items& items, const answers::AnalysisRequest& analysis, bool every_measurement,
           const std::vector<std::string>& only) {
            return unlocked([&](const auto&) {
                const auto parameters =
                    answers::parameters({surface_of(items), analysis.analysis(), every_measurement, only});
                (void)analysed(parameters.surface);
                return output::as_text(output::described(answers::parameter_entries(parameters)));
            });
        },
        nb::arg("items"), nb::arg("analysis"), nb::arg("every_measurement"),
        nb::arg("only") = std::vector<std::string>(), "as printed by `setae params --json`");
    bind_texture(module);
    using Scales = answers::FunctionsOfScale;
    nb::class_<Scales>(module, "FunctionsOfScale")
        .def_prop_ro("columns", [](nb::handle self) { return columns(nb::cast<const Scales&>(self).table, self); })
        .def_prop_ro("units", [](const Scales& found) { return units(found.table); })
        .def("json", [](const Scales& found) {
            return output::as_text(output::described(&found, answers::description_of(found.function)));
        });
    using ScaleRequest = answers::ScaleRequest;
    nb::class_<ScaleRequest> scales(module, "ScaleRequest");
    scales.def(nb::init<>()).def_rw("every_measurement", &ScaleRequest::every_measurement);
    bind_asked(scales);
    bind_options(scales, fields::Asked<ScaleRequest>::differences);
    bind_options(scales, fields::Asked<ScaleRequest>::of_area);
    bind_options(scales, fields::Asked<ScaleRequest>::autocorrelation);
    module.def(
        "functions_of_scale",
        [](const std::string& function, const Items& items, const answers::AnalysisRequest& analysis,
           const answers::ScaleRequest& asked) {
            return unlocked([&](const auto&) {
                auto request = asked;
                request.surface = surface_of(items);
                request.largest_map = analysis.analysis().largest_map;
                auto found = answers::functions_of_scale(scale_function(function), request);
                if (found.functions.empty()) throw InvalidArgument(fmt::format("{}", fmt::join(found.failures, "; ")));
                return found;
            });
        },
        nb::arg("function"), nb::arg("items"), nb::arg("analysis"), nb::arg("request"));
    module.def(
        "diagnosis",
        [](const Items& items, const std::string& tip_radius, bool every_measurement) {
            return unlocked([&](const auto&) {
                std::vector<answers::Suspect> suspects;
                for (const auto& item : items)
                    suspects.push_back({item->path, [item] { return measurements_of(*item); }});
                const auto found = answers::diagnosis(suspects, {tip_radius}, {}, every_measurement);
                if (found.failures.size() == items.size())
                    throw InvalidArgument(fmt::format("{}", fmt::join(found.failures, "; ")));
                return output::as_text(output::described(found.findings));
            });
        },
        nb::arg("items"), nb::arg("tip_radius"), nb::arg("every_measurement"), "as printed by `setae check --json`");
    nb::class_<Surface>(module, "Surface")
        .def("json",
             [](const Surface& surface) {
                 return output::as_text(output::to_json(surface.result.surface, surface.analysis));
             })
        .def("quantities",
             [](const Surface& surface) {
                 const auto& result = surface.result.surface;
                 output::Json json = output::Json::array();
                 for (const auto& q : output::surface_quantities(result, result.used(), surface.analysis.conversion))
                     json.push_back(output::to_json(q));
                 return output::as_text(json);
             })
        .def_prop_ro("columns", [](nb::handle self) { return columns(nb::cast<const Surface&>(self).spectrum, self); })
        .def_prop_ro("units", [](const Surface& surface) { return units(surface.spectrum); });
    module.def(
        "surface",
        [](const Items& items, const answers::AnalysisRequest& analysis, const std::string& spectrum,
           bool every_measurement) {
            return unlocked([&](const auto&) { return surface(items, analysis, spectrum, every_measurement); });
        },
        nb::arg("items"), nb::arg("analysis"), nb::arg("spectrum"), nb::arg("every_measurement"));
    bind_adhesion(module);
}

}  // namespace setae::python
