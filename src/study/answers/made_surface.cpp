// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/answers/made_surface.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "setae/answers/persson_contact.hpp"
#include "setae/answers/synthesis.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/units.hpp"
#include "setae/output/json.hpp"
#include "setae/roughness/spectral_moments.hpp"
#include "setae/spectra/abel.hpp"
#include "setae/study/pipeline_file.hpp"
#include "setae/study/study.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace setae::answers {
namespace {

/// C_iso as power laws between nodes; for one measurement, whose modes have a relative scatter of 1, from their means
/// over bins, from its longest wave to its shortest.
spectra::Spectrum isotropic(const study::SurfaceResult& surface) {
    const auto& used = surface.used().curve;
    const bool modes = used.nodes == spectra::Nodes::modes;
    const spectra::Spectrum& curve = modes ? *surface.combined : used;
    std::vector<Index> known;
    for (Index i = 0; i < curve.wavevector.size(); ++i)
        if (curve.density[i] > 0.0) known.push_back(i);
    Array1D q = curve.wavevector(known), density = curve.density(known);
    const Index n = q.size();
    if (n < 2) throw UndefinedDataError("fewer than two values of the spectrum inside its band");
    auto band = used.band;
    if (modes) {
        band.lower = std::max(band.lower, used.wavevector[0]);
        band.upper = std::min(band.upper, used.wavevector[used.wavevector.size() - 1]);
    }
    if (curve.kind == spectra::Density::C1D)
        density = spectra::isotropic_from_profile(q, density, std::max(band.upper, q[n - 1] * q[n - 1] / q[n - 2]));
    return {.wavevector = std::move(q), .density = std::move(density), .band = band, .kind = spectra::Density::C_iso};
}

/// The curve with a node on each end of its band, and none beyond.
spectra::Spectrum within_its_band(const spectra::Spectrum& curve) {
    std::vector<double> nodes{curve.band.lower};
    for (const double q : curve.wavevector)
        if (q > curve.band.lower * (1.0 + 1e-9) && q < curve.band.upper * (1.0 - 1e-9)) nodes.push_back(q);
    nodes.push_back(curve.band.upper);
    auto within = curve;
    within.wavevector = Eigen::Map<const Array1D>(nodes.data(), static_cast<Index>(nodes.size()));
    within.density = roughness::values_at(curve, within.wavevector);
    return within;
}

bool is_study(const std::string& path) { return path.ends_with(".toml"); }

/// The surface of a study that is named, or its only one.
const study::SurfaceInput& chosen(const study::Study& study, const std::string& path, const std::string& name) {
    std::vector<std::string> names;
    for (const auto& surface : study.surfaces) {
        if (surface.name == name || (name.empty() && study.surfaces.size() == 1)) return surface;
        names.push_back(surface.name);
    }
    throw InvalidArgument(fmt::format("{}: {}; expected `surface` with one of {}", path,
                                      name.empty() ? "more than one surface" : "no surface '" + name + "'",
                                      fmt::join(names, ", ")));
}

study::SurfaceResult analysed(const std::string& path, const FileRequest& file, const std::string& name,
                              parallel::Threads threads) {
    study::SurfaceResult surface;
    if (is_study(path)) {
        const auto study = study::read_study(path);
        surface = surface_for_theory(chosen(study, path, name), study.analysis, threads);
    } else {
        SurfaceRequest request;
        request.file = file;
        request.files = {path};
        surface = surface_for_theory(request.surface(), request.analysis(), threads);
    }
    if (surface.failed()) throw UndefinedDataError(fmt::format("{}: {}", path, surface.error));
    return surface;
}

synthesis::SurfaceGrid grid_of(const MadeSurfaceRequest& request, const Band& band) {
    if (request.pixels.empty())
        throw InvalidArgument(
            "a spectrum is no map; expected `pixels = 512` and `cell = 2 um` of the surface to be made");
    return surface_grid(request.pixels, request.cell, band);
}

/// The waves of a band that a grid holds. @throws InvalidArgument where there are none.
Band held(const Band& band, const synthesis::SurfaceGrid& grid) {
    const double pixel = longest_pixel(grid);
    const Band waves{std::max(band.lower, 2.0 * pi / std::min(grid.size_x, grid.size_y)),
                     std::min(band.upper, 2.0 * pi / (pixels_per_wave * pixel))};
    if (waves.lower < waves.upper) return waves;
    throw InvalidArgument(fmt::format(
        "the grid holds no wave of the spectrum, which has {} to {}, while four pixels are {} and the cell is {}; "
        "expected another `cell` or more `pixels`",
        format_value(2.0 * pi / band.upper, "m"), format_value(2.0 * pi / band.lower, "m"),
        format_value(pixels_per_wave * pixel, "m"), format_value(std::min(grid.size_x, grid.size_y), "m")));
}

processing::StepRecord record_of(const spectra::Spectrum& whole, const spectra::Spectrum& made, std::uint64_t seed) {
    const auto all = roughness::spectral_parameters(whole), some = roughness::spectral_parameters(made);
    using output::quantity;
    return {
        making_step,
        {quantity("longest_wavelength", "lambda_max", 2.0 * pi / made.band.lower, "m"),
         quantity("shortest_wavelength", "lambda_min", 2.0 * pi / made.band.upper, "m"),
         quantity("rms_height", "h_rms", some.rms_height, "m"), quantity("rms_slope", "h'_rms", some.rms_slope, "1"),
         quantity("stored_energy_share", "U_el/U_el,all",
                  some.elastic_energy_per_modulus / all.elastic_energy_per_modulus, "1"),
         quantity("seed", "seed", static_cast<double>(seed), "1")},
        {}};
}

}  // namespace

spectra::Spectrum isotropic_spectrum(const study::SurfaceResult& surface) {
    return within_its_band(isotropic(surface));
}

spectra::SpectralDensity density_of(const spectra::Spectrum& curve) {
    return [table = spectra::tabulated_density(curve.wavevector, curve.density), band = curve.band](double q) {
        constexpr double rounding = 1e-9;
        if (q < band.lower * (1.0 - rounding) || q > band.upper * (1.0 + rounding)) return 0.0;
        return table(std::min(q, band.upper));
    };
}

synthesis::SurfaceGrid surface_grid(const std::string& pixels, const std::string& cell, const Band& band) {
    constexpr Index max_points = Index{1} << 28;  // a contact of them takes some 40 GB
    const auto points = point_counts(pixels);
    if (points[0] < 2 || points[1] < 2 || points[0] > max_points / points[1])
        throw InvalidArgument(
            fmt::format("surfaces of {} x {} points; expected at least 2 x 2 and no more than {} in all", points[0],
                        points[1], max_points));
    const double longest = 2.0 * pi / band.lower;
    const auto size = cell.empty() ? std::array{2.0 * longest, 2.0 * longest} : extents(cell);
    return {points[0], points[1], size[0], size[1]};
}

double longest_pixel(const synthesis::SurfaceGrid& grid) {
    return std::max(grid.size_x / static_cast<double>(grid.nx), grid.size_y / static_cast<double>(grid.ny));
}

bool is_of_spectrum(const std::string& path, const FileRequest& file) {
    SurfaceRequest request;
    request.file = file;
    request.files = {path};
    return is_study(path) || request.is_spectrum();
}

processing::PipelineResult made_surface(const std::string& path, const FileRequest& file,
                                        const MadeSurfaceRequest& request, parallel::Threads threads) {
    const auto whole = isotropic_spectrum(analysed(path, file, request.surface, threads));
    const auto grid = grid_of(request, whole.band);
    auto part = whole;
    part.band = held(whole.band, grid);
    part = within_its_band(part);
    auto map = synthesis::random_surface(
        density_of(part), grid,
        {.key = {request.seed}, .amplitudes = synthesis::Amplitudes::exact, .threads = threads});
    return {std::move(map), {record_of(whole, part, request.seed)}};
}

}  // namespace setae::answers
