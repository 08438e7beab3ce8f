// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/contact_comparison.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "setae/answers/contact_problem.hpp"
#include "setae/answers/made_surface.hpp"
#include "setae/answers/pressures.hpp"
#include "setae/answers/surface_request.hpp"
#include "setae/answers/synthesis.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"
#include "setae/half_space/hard_wall.hpp"
#include "setae/persson/cell_scales.hpp"
#include "setae/roughness/spectral_moments.hpp"

namespace setae::answers {
namespace {

/// Compared quantities, in the order of the table.
struct Compared {
    const char *name, *unit;
};
constexpr std::array<Compared, 4> compared{
    {{"area_fraction", "1"}, {"mean_gap", "m"}, {"contact_stiffness", "Pa/m"}, {"stored_energy", "J/m2"}}};

synthesis::SurfaceGrid grid_of(const ComparisonRequest& request, const Band& band) {
    const double longest = 2.0 * pi / band.lower, shortest = 2.0 * pi / band.upper;
    const auto grid = surface_grid(request.pixels, request.cell, band);
    const double smaller = std::min(grid.size_x, grid.size_y), larger = std::max(grid.size_x, grid.size_y);
    if (!(smaller >= longest * (1.0 - 1e-9)))
        throw InvalidArgument(fmt::format(
            "a cell of {} does not hold the longest wave, {}; expected a larger `cell`, or `longest_wavelength`",
            format_value(smaller, "m"), format_value(longest, "m")));
    const double pixel = longest_pixel(grid);
    if (!(pixels_per_wave * pixel <= shortest * (1.0 + 1e-9)))
        throw InvalidArgument(
            fmt::format("the shortest wave, {}, has {:.2g} pixels and needs {}; expected `pixels = {}` or more, or "
                        "`shortest_wavelength = {}`",
                        format_value(shortest, "m"), shortest / pixel, pixels_per_wave,
                        static_cast<Index>(std::ceil(pixels_per_wave * larger / shortest)),
                        format_value(pixels_per_wave * pixel, "m")));
    return grid;
}

/// Mean and its standard error down each column, one surface per row.
void add_statistics(Table& load, const Compared& what, const Array2D& values, const Array1D& theory) {
    const auto n = static_cast<double>(values.rows());
    const Array1D mean = values.colwise().mean().transpose();
    Array1D error = Array1D::Constant(mean.size(), undefined);
    if (values.rows() > 1)
        error = ((values.rowwise() - mean.transpose()).square().colwise().sum() / (n * (n - 1.0))).sqrt().transpose();
    const std::string name = what.name;
    load.columns.push_back({name, what.unit, mean});
    load.columns.push_back({name + "_standard_error", what.unit, error});
    load.columns.push_back({name + "_persson", what.unit, theory});
}

}  // namespace

void ComparisonRequest::require_complete() const {
    theory.require_complete();
    if ((pressures_of(theory.pressure) <= 0.0).any())
        throw InvalidArgument(fmt::format("'{}': expected pressures above 0", theory.pressure));
    if (surfaces < 1) throw InvalidArgument(fmt::format("{} surfaces, expected at least one", surfaces));
    (void)point_counts(pixels);
    if (!cell.empty()) (void)extents(cell);
}

ContactComparison compare_contact(const study::SurfaceResult& surface, const ComparisonRequest& request,
                                  parallel::Threads threads, const std::function<void(Index, Index)>& progress) {
    request.require_complete();
    const auto curve = isotropic_spectrum(surface);
    const auto C_iso = density_of(curve);
    const auto body = request.theory.body();
    const Array1D pressures = pressures_of(request.theory.pressure);
    const auto parameters = roughness::spectral_parameters(curve);
    synthesis::SurfaceOptions options{.amplitudes = synthesis::Amplitudes::exact, .threads = threads};
    const auto cell = grid_of(request, curve.band);
    half_space::HardWall problem{.grid = {cell.nx, cell.ny, cell.size_x, cell.size_y}, .body = body, .control = {}};
    ContactComparison comparison{.scales = persson::scales_of_cell(C_iso, problem.grid, body),
                                 .grid = problem.grid,
                                 .band = curve.band,
                                 .load = {},
                                 .body = body,
                                 .energy_factor = request.theory.energy_factor,
                                 .surfaces = request.surfaces,
                                 .seed = request.seed,
                                 .rms_height = parameters.rms_height,
                                 .rms_slope = parameters.rms_slope,
                                 .made = {},
                                 .alerts = alerts_of(surface)};
    comparison.made = synthesis::expected_roughness(C_iso, cell, options);
    const auto theory = persson::load_table(pressures, comparison.scales, request.theory.options());
    std::array<Array2D, compared.size()> found;
    found.fill(Array2D(request.surfaces, pressures.size()));
    for (Index s = 0; s < request.surfaces; ++s) {
        options.key = {request.seed + static_cast<std::uint64_t>(s)};
        problem.heights = synthesis::random_surface(C_iso, cell, options).heights;
        for (Index p = 0; p < pressures.size(); ++p) {
            problem.control = half_space::MeanPressure{pressures[p]};
            const auto contact = half_space::solve(problem, {.tolerance = request.tolerance, .threads = threads});
            comparison.largest_duality_gap = std::max(comparison.largest_duality_gap, contact.certificate.duality_gap);
            found[0](s, p) = contact.area.corrected_fraction;
            found[1](s, p) = contact.mean_gap;
            found[2](s, p) = half_space::contact_stiffness(problem, contact, threads);
            found[3](s, p) = contact.stored_energy / problem.grid.area();
            if (progress) progress(s * pressures.size() + p + 1, request.surfaces * pressures.size());
        }
    }
    comparison.load.columns.push_back({"pressure", "Pa", pressures});
    for (std::size_t i = 0; i < compared.size(); ++i)
        add_statistics(comparison.load, compared[i], found[i], theory.at(compared[i].name));
    if (comparison.largest_duality_gap > request.tolerance)
        comparison.alerts.push_back({"CONTACT_NOT_CONVERGED", "contact",
                                     fmt::format("pressures may be off: the duality gap is {:.1e}, wanted was {:.1e}",
                                                 comparison.largest_duality_gap, request.tolerance),
                                     "raise `tolerance`, or resolve the surface's shortest waves with more points"});
    return comparison;
}

}  // namespace setae::answers
