// SPDX-License-Identifier: GPL-3.0-or-later
#include "data_files.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "setae/bytes/toml_text.hpp"

namespace setae::simulation {
namespace {

using Json = nlohmann::ordered_json;

constexpr double nano = 1e9, micro = 1e6;

/// Decimals that leave a quarter of a thousandth of the step, and no rounding noise in equal steps.
int decimals(double step) { return std::max(0, 4 - static_cast<int>(std::floor(std::log10(step)))); }

Json to_json(const LoopSpecimen& specimen, const LoopTruth& truth) {
    return {{"sphere_radius", specimen.radius},
            {"contact_modulus", specimen.contact_modulus},
            {"work_approach", specimen.work_approach},
            {"work_retraction", specimen.work_retraction},
            {"largest_contact_radius", truth.turning_point.contact_radius},
            {"largest_contact_area", truth.largest_contact_area()},
            {"smallest_force", truth.smallest_force},
            {"energy_loss", truth.energy_loss()},
            {"jump_in_loss", truth.jump_in_loss},
            {"pinning_loss", truth.pinning_loss},
            {"jump_out_loss", truth.jump_out_loss}};
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

std::string truth_text(const Recipe& recipe, const std::vector<SurfaceTruth>& surfaces,
                       const std::vector<PlantedLoop>& loops) {
    Json truth{{"seed", recipe.seed},        {"work_of_adhesion", recipe.work_of_adhesion},
               {"surfaces", Json::object()}, {"elastomers", Json::object()},
               {"pairs", Json::array()},     {"references", Json::array()}};
    if (recipe.loops && recipe.loops->law == RetractionLaw::loss) truth["loss_factor"] = recipe.loops->loss_factor;
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
        truth["elastomers"][elastomer.name] = {{"youngs_modulus", elastomer.youngs_modulus},
                                               {"surface_energy", elastomer.surface_energy.value},
                                               {"sphere_radius", elastomer.sphere_radius}};
    for (const auto& loop : loops) {
        Json entry{{"file", loop.file}};
        if (!loop.surface.empty()) entry["surface"] = loop.surface;
        entry["elastomer"] = loop.elastomer;
        if (!loop.stage.empty()) entry["stage"] = loop.stage;
        entry.update(to_json(loop.specimen, loop.truth));
        truth[loop.surface.empty() ? "references" : "pairs"].push_back(std::move(entry));
    }
    return truth.dump(2, ' ', false, decltype(truth)::error_handler_t::replace) + "\n";
}

std::string study_text(const Recipe& recipe, const std::vector<std::vector<MeasurementFile>>& measurements,
                       const std::vector<PlantedLoop>& loops) {
    std::string text = "# Written by `setae lab make`; truth.json says what it should find.\n";
    const auto line = [&]<class... Parts>(fmt::format_string<Parts...> form, Parts&&... parts) {
        fmt::format_to(std::back_inserter(text), form, std::forward<Parts>(parts)...);
        text += '\n';
    };
    line("title = {}", bytes::toml_quoted(recipe.title));
    if (!recipe.description.empty()) line("description = {}", bytes::toml_quoted(recipe.description));
    double shortest = recipe.surfaces.front().surface.short_wavelength;
    for (const auto& rough : recipe.surfaces) shortest = std::min(shortest, rough.surface.short_wavelength);
    line("\n[analysis]\nshortest_wavelength = \"{} m\"", shortest);
    line("\n[rough_solid]\nyoungs_modulus = \"{} Pa\"\npoisson_ratio = {}", recipe.counter_youngs_modulus,
         recipe.counter_poisson_ratio);
    for (std::size_t i = 0; i < recipe.surfaces.size(); ++i) {
        const auto& surface = recipe.surfaces[i].surface;
        line("\n[surfaces.{}]", bytes::toml_quoted(surface.name));
        if (!surface.description.empty()) line("description = {}", bytes::toml_quoted(surface.description));
        line("measurements = [");
        for (const auto& m : measurements[i]) {
            const std::string tip = m.tip_radius.empty() ? "" : fmt::format(", tip_radius = \"{}\"", m.tip_radius);
            const std::string foil =
                m.foil_thickness > 0.0 ? fmt::format(", foil_thickness = \"{:.6g} nm\"", nano * m.foil_thickness) : "";
            std::string references;
            for (const auto& file : m.references)
                references += (references.empty() ? ", references = [" : ", ") + bytes::toml_quoted(file);
            if (!references.empty()) references += "]";
            line("  {{ file = {}, instrument = \"{}\"{}{}{} }},", bytes::toml_quoted(m.file), m.instrument, tip, foil,
                 references);
        }
        line("]");
    }
    for (const auto& elastomer : recipe.elastomers) {
        line("\n[elastomers.{}]", bytes::toml_quoted(elastomer.name));
        if (loops.empty()) line("youngs_modulus = \"{} Pa\"", elastomer.youngs_modulus);
        line("poisson_ratio = {}", elastomer.poisson_ratio);
        line("surface_energy = \"{} ± {} J/m2\"", elastomer.surface_energy.value,
             elastomer.surface_energy.standard_error);
        line("sphere_radius = \"{} m\"", elastomer.sphere_radius);
    }
    for (const auto& loop : loops) {
        line("\n[[experiments]]\nfile = {}\nelastomer = {}", bytes::toml_quoted(loop.file),
             bytes::toml_quoted(loop.elastomer));
        if (loop.surface.empty()) line("role = \"reference\"\nstage = \"{}\"", loop.stage);
        else line("surface = {}", bytes::toml_quoted(loop.surface));
    }
    return text;
}

}  // namespace setae::simulation
