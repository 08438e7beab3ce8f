// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "plot/figure_output.hpp"
#include "program/options.hpp"
#include "setae/answers/contact_problem.hpp"
#include "setae/answers/contact_surface.hpp"
#include "setae/file_figures/contact_map_figure.hpp"
#include "setae/processing/pipeline.hpp"

namespace setae::cli {

/// A file with a surface, or with a spectrum from which a surface is made.
struct ContactSurface : answers::ContactSurfaceRequest {
    std::string path;
    answers::FileRequest file;
    answers::ProcessingRequest processing;

    void add_to(Options& options);
    /// answers::contact_surface(). @throws InvalidArgument without a file, and as contact_surface().
    [[nodiscard]] processing::PipelineResult processed(answers::BeyondMap beyond, parallel::Threads threads) const;
    /// answers::contact_surfaces() for contacts that end within a map. @throws InvalidArgument without a file, and as
    /// contact_surfaces().
    [[nodiscard]] std::vector<processing::PipelineResult> realisations(int count, parallel::Threads threads) const;
};

/// Output of the maps of a contact: OUT.npy means OUT_pressure.npy [Pa] and OUT_gap.npy [m], or
/// OUT_NAME_pressure.npy for several states; OUT.nc contains the maps of all states with coordinates, OUT.svg is one
/// figure of all states.
struct ContactMaps {
    std::string output;  ///< empty: no maps are written
    FigureOption figure;

    /// A state and its name; the name is empty if there is only one state.
    using State = std::pair<std::string, file_figures::ContactState>;

    /// @throws InvalidArgument for an ending other than .npy, .csv, .nc and those of figures.
    void require_ending() const;
    void write(const half_space::Grid& grid, bool periodic, const std::string& file, const std::vector<State>& states,
               bool quiet) const;
};

/// Parameters of a surface made from a spectrum, or processing of measured heights.
[[nodiscard]] std::string surface_text(const processing::PipelineResult& surface, std::size_t width);

}  // namespace setae::cli
