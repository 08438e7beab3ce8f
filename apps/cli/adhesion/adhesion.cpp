// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "program/command.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "program/terminal.hpp"
#include "psd/surface_options.hpp"
#include "setae/adhesion/stored_energy.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"
#include "setae/output/predicted_quantities.hpp"
#include "setae/output/quantity_table.hpp"
#include "setae/study/study_result.hpp"

namespace setae::cli::adhesion_command {
namespace {

constexpr const char* explanation =
    "E*       1/E* = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2\n"
    "r        = A_true/A_app = 1 + sqrt(pi)/2 h' exp(1/h'^2) erfc(1/h')                        [D19] (9)\n"
    "U_el     U_el/A_app = (E*/8) int q C1D dq                                                [D19] (8)\n"
    "         one map: (E*/8 pi) int q^2 C_iso dq, and (E*/4) sum |q| |h_q|^2 of its own modes   [D19] (8)\n"
    "modified W_app = W_int r - gamma_1 (r - 1) - U_el/A_app                                  [D19] (7)\n"
    "Persson-Tosatti W_app = W_int (1 + h'^2/2) - U_el/A_app                                  [D19] (S13)\n"
    "without area change of the soft side W_app = W_int r - U_el/A_app                        [D19] (2)\n"
    "loop     a_max by (1) with W_app; E_loss = W_int r pi a_max^2                             [D19] (1), (10)\n"
    "         W_ret from E_loss = (W_ret - W_app) pi a_max^2 + jump in (W_app) + jump out (W_ret); F = 3/2 pi R W  (S1)\n"
    "bridging wavevectors q above which the roughness stores more than it gains                THEORY 8\n"
    "pressed  q above which it stores more than 0.49 of that: closes under pressure alone      Johnson (1995)\n";

struct Arguments {
    Common common;
    SurfaceOptions surface;
    std::string youngs_modulus, work, surface_energy;
    double poisson_ratio = 0.5;
    std::string rough_modulus;
    double rough_poisson_ratio = 0.0;
    std::string radius, preload;
};

study::Study study_of(const Arguments& arguments) {
    study::Study study;
    study.analysis = arguments.surface.analysis();
    study.counter_youngs_modulus = arguments.rough_modulus.empty()
                                       ? std::numeric_limits<double>::infinity()
                                       : parse_quantity(arguments.rough_modulus, positive(dimension::pressure));
    study.counter_poisson_ratio = arguments.rough_poisson_ratio;
    study.work_of_adhesion = parse_uncertain_quantity(arguments.work, positive(dimension::surface_energy));
    study::ElastomerInput elastomer;
    elastomer.name = "soft solid";
    elastomer.youngs_modulus = parse_uncertain_quantity(arguments.youngs_modulus, positive(dimension::pressure));
    elastomer.poisson_ratio.value = arguments.poisson_ratio;
    if (!arguments.radius.empty()) {
        elastomer.sphere_radius = parse_uncertain_quantity(arguments.radius, positive(dimension::length));
        elastomer.preload = parse_quantity(arguments.preload, non_negative(dimension::force));
    }
    elastomer.surface_energy =
        parse_uncertain_quantity(arguments.surface_energy, non_negative(dimension::surface_energy));
    study.elastomers = {elastomer};
    return study;
}

/// Stored energy by the routes the prediction does not use: Eq. (11), and for one map its own transform.
void add_other_routes(std::vector<Quantity>& list, const study::StudyResult& result,
                      const std::optional<topography::HeightMap>& map, parallel::Threads threads) {
    const double modulus = result.elastomers.front().contact_modulus.value;
    const auto& options = result.study.analysis;
    const auto add = [&](const char* name, double energy, const char* source) {
        auto q = output::quantity(name, "U_el/A_app", energy, "J/m2");
        q.source = source;
        list.push_back(std::move(q));
    };
    const bool exact = options.conversion == roughness::Conversion::exact;
    if (const auto& other = result.surfaces.front().used().other_conversion)
        add(exact ? "stored_energy_eq11" : "stored_energy_exact", modulus * other->elastic_energy_per_modulus,
            exact ? "C1D by [D19] (11)" : "(E*/8) int q C1D dq");
    const auto& p = result.surfaces.front().used().parameters;
    add("stored_energy_bound", adhesion::stored_energy_bound(modulus, p.rms_height, p.rms_slope),
        "E* h_rms h'_rms/4, no spectrum with these two stores more");
    if (!map) return;
    const auto curve = roughness::limited(study::isotropic_spectrum(*map, options, threads), options.limits);
    add("stored_energy_from_C_iso", adhesion::stored_energy(modulus, curve), "(E*/8 pi) int q^2 C_iso dq; [D19] (8)");
    add("stored_energy_from_map", adhesion::stored_energy(modulus, *map, threads),
        "(E*/4) sum |q| |h_q|^2, no isotropy assumed; all wavevectors of the map");
}

std::vector<Quantity> quantities(const study::StudyResult& result, const std::optional<topography::HeightMap>& map,
                                 parallel::Threads threads) {
    using output::quantity;
    const auto& pair = result.pairs.front();
    const auto& surface = result.surfaces.front();
    auto list = output::surface_quantities(surface, surface.used(), result.study.analysis.conversion);
    list.push_back(quantity("contact_modulus", "E*", result.elastomers.front().contact_modulus, "Pa"));
    list.push_back(quantity("stored_energy", "U_el/A_app", pair.stored_energy, "J/m2"));
    add_other_routes(list, result, map, threads);
    const auto predicted = [&](const char* name, const std::optional<adhesion::PredictedWork>& work,
                               const char* source) {
        auto raw = quantity(std::string("work_of_adhesion_") + name, "W_app", work->estimate, "J/m2");
        raw.source = source;
        list.push_back(raw);
        list.push_back(quantity(std::string("work_of_adhesion_") + name + "_floored", "max(0, W_app)",
                                work->work.floored, "J/m2"));
    };
    predicted("modified", pair.modified, "[D19] (7)");
    predicted("persson_tosatti", pair.persson_tosatti, "[D19] (S13)");
    predicted("without_area_change", pair.without_area_change, "[D19] (2)");
    return list;
}

ExitCode run(const Arguments& arguments) {
    if (arguments.radius.empty() != arguments.preload.empty())
        throw InvalidArgument(
            "--radius and --preload are given together or not at all, such as --radius 1.25mm --preload 1mN");
    if (arguments.youngs_modulus.empty() || arguments.work.empty() || arguments.surface_energy.empty())
        throw InvalidArgument("expected --E, --w and --gamma, such as --E 1.1MPa --w 37mJ/m2 --gamma 25mJ/m2");
    const auto study = study_of(arguments);
    const auto threads = arguments.common.workers();
    auto [surface, map] = study::analyse_surface(arguments.surface.surface(), study.analysis,
                                                 {.previews = false, .parameters = false, .map = true}, threads);
    const auto code = report_failures(surface);
    if (code == ExitCode::nothing_done) return code;
    const auto result = study::predicted_study(study, std::move(surface));
    auto list = quantities(result, map, threads);
    const auto& pair = result.pairs.front();
    if (pair.with_unmeasured_waves) list.push_back(output::unmeasured_quantity(*pair.with_unmeasured_waves));
    if (pair.loop)
        for (auto& quantity : output::loop_quantities(*pair.loop)) list.push_back(std::move(quantity));
    auto alerts = alerts_of(result.surfaces.front());
    alerts.insert(alerts.end(), pair.alerts.begin(), pair.alerts.end());
    if (!arguments.common.json) {
        print(output::adhesion_answer(result));
        // the answer says where a work of adhesion is floored
        std::erase_if(list, [](const auto& q) { return q.quantity.ends_with("_floored"); });
        print("\n" + output::quantity_table("", list, output_size().width));
        show(alerts);
        return code;
    }
    output::Json json;
    for (const auto& q : list) json[q.quantity] = output::to_json(q);
    json["conforms"] = pair.modified->work.conforms;
    const auto& scales = *pair.scales;
    json["scales"] = {
        {"wavevector", output::numbers(scales.wavevector)},
        {"gained", output::numbers(scales.gained)},
        {"stored", output::numbers(scales.stored)},
        {"stored_share", output::numbers(scales.stored_share)},
        {"area_share", output::numbers(scales.area_share)},
        {"units",
         {{"wavevector", "1/m"}, {"gained", "J/m2"}, {"stored", "J/m2"}, {"stored_share", "1"}, {"area_share", "1"}}}};
    if (const auto& measurements = result.surfaces.front().measurements; measurements.size() == 1)
        if (const auto channel = measurements.front().channel) json["channel"] = *channel;
    json["alerts"] = output::to_json(alerts);
    print_json(json);
    return code;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    arguments->surface.add_to(options);
    options
        .add("--E,--youngs-modulus", arguments->youngs_modulus,
             "Young's modulus of the soft solid, such as \"0.7 ± 0.02 MPa\"")
        .quantity(positive(dimension::pressure));
    options.add("--nu,--poisson-ratio", arguments->poisson_ratio, "its Poisson ratio").within(domain::poisson_ratio);
    options.add("--w,--work-of-adhesion", arguments->work, "intrinsic work of adhesion, such as \"37 ± 3.7 mJ/m2\"")
        .quantity(positive(dimension::surface_energy));
    options.add("--gamma,--surface-energy", arguments->surface_energy, "surface energy of the soft solid")
        .quantity(non_negative(dimension::surface_energy));
    options.add("--rough-E", arguments->rough_modulus, "Young's modulus of the rough solid; default rigid")
        .quantity(positive(dimension::pressure));
    options.add("--radius", arguments->radius, "of a soft sphere that is pressed on and pulled off; with --preload")
        .quantity(positive(dimension::length));
    options.add("--preload", arguments->preload, "its largest force, such as 1mN")
        .quantity(non_negative(dimension::force));
    options.add("--rough-nu", arguments->rough_poisson_ratio, "its Poisson ratio").within(domain::poisson_ratio);
    options.example("setae adhesion stylus.csv afm.ibw --E \"0.7 ± 0.02 MPa\" --w \"37 ± 3.7 mJ/m2\" --gamma 25mJ/m2",
                    "work of adhesion of a soft solid on the measured surface");
    options.example("setae adhesion spectrum.csv --E 0.7MPa --w 37mJ/m2 --gamma 25mJ/m2 --radius 1.25mm --preload 1mN",
                    "from a table of a spectrum, with what a sphere should do");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::adhesion_command
