// SPDX-License-Identifier: GPL-3.0-or-later
#include "data_files.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <tuple>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "setae/bytes/toml_text.hpp"
#include "stated_draws.hpp"

namespace setae::simulation {
namespace {

using Json = nlohmann::ordered_json;

constexpr double nano = 1e9, micro = 1e6;

/// Decimals that leave a quarter of a thousandth of the step, and no rounding noise in equal steps.
int decimals(double step) { return std::max(0, 4 - static_cast<int>(std::floor(std::log10(step)))); }

Json to_json(const hysteresis::HystereticSphere& specimen, const hysteresis::SphereLoop& truth) {
    return {{"sphere_radius", specimen.radius},
            {"contact_modulus", specimen.contact_modulus},
            {"work_approach", specimen.work_approach},
            {"work_retraction", specimen.work_retraction},
            {"largest_contact_radius", truth.turning_point.contact_radius},
            {"largest_contact_area", truth.largest_contact_area()},
            {"smallest_force", truth.smallest_force},
            {"energy_loss", truth.energy_loss()},
            {"jump_in_loss", truth.jump_in_loss},
            {"pinning_loss", truth.edge_loss},
            {"jump_out_loss", truth.jump_out_loss},
            {"speed_loss", truth.speed_loss},
            {"bulk_loss", truth.bulk_loss}};
}

struct StudyLines {
    std::string text;

    template <class... Parts>
    void add(fmt::format_string<Parts...> form, Parts&&... parts) {
        fmt::format_to(std::back_inserter(text), form, std::forward<Parts>(parts)...);
        text += '\n';
    }
};

void add_inputs(StudyLines& lines, const Recipe& recipe) {
    const auto inputs = named_inputs(recipe);
    if (inputs.empty()) return;
    lines.add("\n[inputs]");
    for (const auto& input : inputs) lines.add("{} = \"{}\"", bytes::toml_quoted(input.input), stated_text(input));
}

/// A measurement as an entry of its surface's list.
std::string measurement_text(const MeasurementFile& m) {
    std::string text = fmt::format("{{ file = {}, instrument = \"{}\"", bytes::toml_quoted(m.file), m.instrument);
    const auto add = [&](const char* key, const std::string& value) {
        if (!value.empty()) text += fmt::format(", {} = {}", key, bytes::toml_quoted(value));
    };
    add("tip_radius", m.tip_radius);
    add("height_calibration", m.height_calibration);
    add("lateral_calibration", m.lateral_calibration);
    if (m.foil_thickness > 0.0) add("foil_thickness", fmt::format("{:.6g} nm", nano * m.foil_thickness));
    std::string references;
    for (const auto& file : m.references)
        references += (references.empty() ? ", references = [" : ", ") + bytes::toml_quoted(file);
    if (!references.empty()) references += "]";
    return text + references + " }";
}

/// Whether the study has no loop to determine the modulus, or states it nevertheless.
bool modulus_is_stated(const ElastomerRecipe& elastomer, const std::vector<KnownLoop>& loops) {
    return elastomer.tell_modulus ||
           std::none_of(loops.begin(), loops.end(), [](const KnownLoop& loop) { return loop.measured; });
}

void add_elastomer(StudyLines& lines, const Recipe& recipe, const ElastomerRecipe& elastomer,
                   const std::vector<KnownLoop>& loops) {
    const auto& [modulus, energy, radius] =
        std::tie(elastomer.youngs_modulus, elastomer.surface_energy, elastomer.sphere_radius);
    lines.add("\n[elastomers.{}]", bytes::toml_quoted(elastomer.name));
    if (modulus_is_stated(elastomer, loops)) {
        if (modulus.stated_value.uncertain()) lines.add("youngs_modulus = \"{}\"", stated_text(modulus));
        else lines.add("youngs_modulus = \"{} Pa\"", modulus.value);
    }
    lines.add("poisson_ratio = {}", elastomer.poisson_ratio);
    if (energy.input.empty())
        lines.add("surface_energy = \"{} ± {} J/m2\"", energy.stated_value.value, energy.stated_value.standard_error);
    else lines.add("surface_energy = {}", bytes::toml_quoted(energy.input));
    if (!radius.input.empty()) lines.add("sphere_radius = {}", bytes::toml_quoted(radius.input));
    else if (radius.stated_value.uncertain()) lines.add("sphere_radius = \"{}\"", stated_text(radius));
    else lines.add("sphere_radius = \"{} m\"", radius.value);
    if (!elastomer.body.relaxation.empty()) {
        std::vector<std::string> terms;
        for (const auto& term : elastomer.body.relaxation)
            terms.push_back(fmt::format("{{ share = {}, time = \"{} s\" }}", term.share, term.time));
        lines.add("relaxation = [{}]", fmt::join(terms, ", "));
    }
    if (std::any_of(loops.begin(), loops.end(),
                    [&](const KnownLoop& loop) { return !loop.measured && loop.elastomer == elastomer.name; }))
        lines.add("preload = \"{} N\"", recipe.loops->protocol.maximum_force);
}

/// Factors of the testing machine of all loops, those with a name or those without; empty where there are none.
std::string machine_text(const Calibrations& factors, bool named) {
    StudyLines lines;
    const auto add = [&](const char* key, const std::optional<StatedQuantity>& factor) {
        if (factor && factor->input.empty() != named) lines.add("{} = {}", key, bytes::toml_quoted(mention(*factor)));
    };
    add("force_calibration", factors.force);
    add("displacement_calibration", factors.displacement);
    add("contact_radius_calibration", factors.contact_radius);
    return lines.text;
}

}  // namespace

std::string file_stem(const std::string& name) {
    std::string stem = name;
    for (char& c : stem)
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-' && c != '.') c = '_';
    return stem;
}

std::string scan_text(const topography::LineScan& scan) {
    const double step = micro * scan.pixel_size();
    const int digits = decimals(step);
    std::string text = "x [um],h [nm]\n";
    for (Index i = 0; i < scan.heights.size(); ++i)
        fmt::format_to(std::back_inserter(text), "{:.{}f},{:.4f}\n", step * static_cast<double>(i), digits,
                       nano * scan.heights[i]);
    return text;
}

std::string map_text(const topography::HeightMap& map) {
    std::string text = fmt::format("# Channel: Height\n# Width: {:.9g} um\n# Height: {:.9g} um\n# Value units: nm\n",
                                   micro * map.size[0], micro * map.size[1]);
    for (Index j = 0; j < map.heights.cols(); ++j)
        for (Index i = 0; i < map.heights.rows(); ++i)
            fmt::format_to(std::back_inserter(text), "{:.4f}{}", nano * map.heights(i, j),
                           i + 1 < map.heights.rows() ? '\t' : '\n');
    return text;
}

std::string contour_text(const topography::Profile& contour) {
    std::string text = "x [nm],h [nm]\n";
    for (Index i = 0; i < contour.positions.size(); ++i)
        fmt::format_to(std::back_inserter(text), "{:.5f},{:.5f}\n", nano * contour.positions[i],
                       nano * contour.heights[i]);
    return text;
}

std::string loop_text(const loops::Loop& loop) {
    std::string text = "time [s],force [uN],displacement [nm],contact_radius [um]\n";
    for (Index i = 0; i < loop.force.size(); ++i) {
        fmt::format_to(std::back_inserter(text), "{:.6g},{:.5f},{:.4f},", loop.time[i], micro * loop.force[i],
                       nano * loop.displacement[i]);
        if (!std::isnan(loop.contact_radius[i]))
            fmt::format_to(std::back_inserter(text), "{:.5f}", micro * loop.contact_radius[i]);
        text += '\n';
    }
    return text;
}

std::string true_values_text(const Recipe& recipe, const std::vector<TrueSurfaceValues>& surfaces,
                             const std::vector<KnownLoop>& loops) {
    Json truth{{"seed", recipe.seed},        {"work_of_adhesion", recipe.work_of_adhesion},
               {"surfaces", Json::object()}, {"elastomers", Json::object()},
               {"pairs", Json::array()},     {"references", Json::array()}};
    if (recipe.loops && recipe.loops->law == RetractionChoice::loss) truth["loss_factor"] = recipe.loops->loss_factor;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        const auto& parameters = surfaces[i].parameters;
        truth["surfaces"][recipe.surfaces[i].surface.name] = {
            {"rms_height", parameters.rms_height},
            {"rms_slope", parameters.rms_slope},
            {"rms_curvature", parameters.rms_curvature},
            {"elastic_energy_per_modulus", parameters.elastic_energy_per_modulus},
            {"area_ratio", surfaces[i].area_ratio},
            {"skewness", recipe.surfaces[i].surface.skewness},
            {"source", surfaces[i].source}};
        Json numbers = Json::object();
        for (const auto& parameter : recipe.surfaces[i].parameters) numbers[parameter.key] = parameter.value;
        truth["surfaces"][recipe.surfaces[i].surface.name]["spectrum"] = std::move(numbers);
    }
    for (const auto& elastomer : recipe.elastomers)
        truth["elastomers"][elastomer.name] = {{"youngs_modulus", elastomer.youngs_modulus.value},
                                               {"surface_energy", elastomer.surface_energy.value},
                                               {"sphere_radius", elastomer.sphere_radius.value}};
    for (const auto& input : named_inputs(recipe)) truth["inputs"][input.input] = input.value;
    for (const auto& loop : loops) {
        Json entry = loop.measured ? Json{{"file", loop.file}} : Json{{"measured", false}};
        if (!loop.surface.empty()) entry["surface"] = loop.surface;
        entry["elastomer"] = loop.elastomer;
        if (!loop.stage.empty()) entry["stage"] = loop.stage;
        entry.update(to_json(loop.specimen, loop.truth));
        truth[loop.surface.empty() ? "references" : "pairs"].push_back(std::move(entry));
    }
    return truth.dump(2, ' ', false, decltype(truth)::error_handler_t::replace) + "\n";
}

std::string study_text(const Recipe& recipe, const std::vector<std::vector<MeasurementFile>>& measurements,
                       const std::vector<KnownLoop>& loops) {
    StudyLines lines;
    lines.add("# Written by `setae lab make`; truth.json contains the true values.");
    lines.add("title = {}", bytes::toml_quoted(recipe.title));
    if (!recipe.description.empty()) lines.add("description = {}", bytes::toml_quoted(recipe.description));
    add_inputs(lines, recipe);
    double shortest = recipe.surfaces.front().surface.short_wavelength;
    for (const auto& rough : recipe.surfaces) shortest = std::min(shortest, rough.surface.short_wavelength);
    lines.add("\n[analysis]\nshortest_wavelength = \"{} m\"", shortest);
    lines.add("\n[rough_solid]\nyoungs_modulus = \"{} Pa\"\npoisson_ratio = {}", recipe.counter_youngs_modulus,
              recipe.counter_poisson_ratio);
    for (std::size_t i = 0; i < recipe.surfaces.size(); ++i) {
        const auto& surface = recipe.surfaces[i].surface;
        lines.add("\n[surfaces.{}]", bytes::toml_quoted(surface.name));
        if (!surface.description.empty()) lines.add("description = {}", bytes::toml_quoted(surface.description));
        lines.add("measurements = [");
        for (const auto& measurement : measurements[i]) lines.add("  {},", measurement_text(measurement));
        lines.add("]");
    }
    for (const auto& elastomer : recipe.elastomers) add_elastomer(lines, recipe, elastomer, loops);
    const auto machine = machine_text(recipe.calibrations, true);
    if (recipe.loops && !machine.empty()) lines.text += "\n[loops]\n" + machine;
    for (const auto& loop : loops) {
        if (!loop.measured) continue;
        lines.add("\n[[experiments]]\nfile = {}\nelastomer = {}", bytes::toml_quoted(loop.file),
                  bytes::toml_quoted(loop.elastomer));
        if (loop.surface.empty()) lines.add("role = \"reference\"\nstage = \"{}\"", loop.stage);
        else lines.add("surface = {}", bytes::toml_quoted(loop.surface));
        lines.text += machine_text(recipe.calibrations, false);
    }
    return lines.text;
}

}  // namespace setae::simulation
