// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/contact_problem.hpp"

#include <array>
#include <filesystem>
#include <vector>

#include <fmt/format.h>

#include "convert/heights_output.hpp"
#include "convert/processing_text.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"
#include "setae/formats/netcdf.hpp"
#include "setae/output/quantity_table.hpp"

namespace setae::cli {

void ContactSurface::add_to(Options& options) {
    options
        .add("file", path,
             "map or line, or container with one; table of a spectrum, or study, from which a surface is made")
        .of_inputs();
    options.ask(file, OptionGroup::height_files);
    options.ask(processing);
    options.ask(measured);
    options.ask(made);
}

processing::PipelineResult ContactSurface::processed(answers::BeyondMap beyond, parallel::Threads threads) const {
    if (path.empty()) throw InvalidArgument("no file; expected a map");
    return answers::contact_surface(path, file, processing.pipeline(), *this, beyond, threads);
}

std::vector<processing::PipelineResult> ContactSurface::realisations(int count, parallel::Threads threads) const {
    if (path.empty()) throw InvalidArgument("no file; expected a map, a table of a spectrum or a study");
    return answers::contact_surfaces(path, file, processing.pipeline(), *this, answers::BeyondMap::nothing, count,
                                     threads);
}

void ContactMaps::require_ending() const {
    const auto is_table = [this](const char* ending) { return output.ends_with(ending); };
    if (output.empty() || is_table(".npy") || is_table(".csv") || is_table(".nc") ||
        file_figures::is_figure_path(output))
        return;
    throw InvalidArgument(
        fmt::format("{}: maps of pressure are not heights; expected an ending .npy, .csv or .nc, or {}", output,
                    file_figures::figure_endings));
}

void ContactMaps::write(const half_space::Grid& grid, bool periodic, const std::string& file,
                        const std::vector<State>& states, bool quiet) const {
    if (output.empty()) return;
    const std::array size{grid.size_x, grid.size_y};
    if (file_figures::is_figure_path(output)) {
        std::vector<file_figures::ContactState> drawn;
        for (const auto& [name, state] : states) drawn.push_back(state);
        write_figure(file_figures::contact_map_figure(drawn, size, file, figure.look()), output, quiet);
        return;
    }
    if (output.ends_with(".nc")) {
        std::vector<formats::GridMap> maps;
        for (const auto& [name, state] : states) {
            const auto of = name.empty() ? name : name + "_";
            maps.push_back({of + "pressure", "Pa", state.pressures});
            maps.push_back({of + "gap", "m", state.gaps});
        }
        formats::write_netcdf(output, maps, size, periodic);
        return;
    }
    const std::filesystem::path path(output);
    const auto write_map = [&](const std::string& what, const Array2D& values) {
        const auto name = path.stem().string() + "_" + what + path.extension().string();
        write_heights((path.parent_path() / name).string(), topography::HeightMap{values, size, periodic, {}});
    };
    for (const auto& [name, state] : states) {
        const auto of = name.empty() ? name : name + "_";
        write_map(of + "pressure", state.pressures);
        write_map(of + "gap", state.gaps);
    }
}

std::string surface_text(const processing::PipelineResult& surface, std::size_t width) {
    if (surface.records.empty()) return "";
    if (surface.records.front().step == answers::making_step)
        return output::quantity_table("surface made from the spectrum", surface.records.front().numbers, width) + "\n";
    std::string lines = "heights before the contact\n";
    for (const auto& record : surface.records) lines += as_line(record);
    return lines + "\n";
}

}  // namespace setae::cli
