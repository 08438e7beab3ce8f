// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "setae/answers/surface_request.hpp"
#include "setae/fields/option.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/processing/pipeline.hpp"
#include "setae/spectra/spectral_density.hpp"
#include "setae/study/surface_analysis.hpp"
#include "setae/synthesis/random_surface.hpp"

namespace setae::answers {

inline constexpr double pixels_per_wave = 4.0;  ///< pixels per shortest wavelength of a generated surface

/// Points "512" or "1024x512" and extent of a generated surface; empty extent: twice the band's longest wavelength.
/// @throws InvalidArgument for malformed texts, fewer than 2 x 2 points, and numbers of points that exceed the memory
/// of a contact.
[[nodiscard]] synthesis::SurfaceGrid surface_grid(const std::string& pixels, const std::string& cell, const Band& band);

/// The longer side of its pixels [m].
[[nodiscard]] double longest_pixel(const synthesis::SurfaceGrid& grid);

/// C_iso of a surface as power laws between nodes, with a node on each end of its band and none beyond. For one
/// measurement, whose modes have a relative scatter of 1, from their means over bins.
/// @throws UndefinedDataError for fewer than two values.
[[nodiscard]] spectra::Spectrum isotropic_spectrum(const study::SurfaceResult& surface);

/// C_iso of this curve inside its band, 0 outside.
[[nodiscard]] spectra::SpectralDensity density_of(const spectra::Spectrum& curve);

/// Request of a surface that is generated from a spectrum.
struct MadeSurfaceRequest {
    std::string pixels;
    std::string cell;     ///< empty: twice the longest wave
    std::string surface;  ///< for a study with several surfaces
    std::uint64_t seed = 1;

    /// Whether any value is given that a map already has.
    [[nodiscard]] bool given() const { return !pixels.empty() || !cell.empty() || !surface.empty(); }
};

/// Whether a file is a study or the table of a spectrum, from which a surface can be generated, and not a map.
[[nodiscard]] bool is_of_spectrum(const std::string& path, const FileRequest& file);

/// A periodic map with the spectrum of a table, or of a surface of a study by its analysis (likelihood or average).
///
/// Its waves are those of the spectrum within the grid, down to four pixels, each with the power of the spectrum; the
/// record states them, their shares of h_rms and h', and the share of U_el.
/// @throws InvalidArgument for a grid without such waves, as study::read_study() and study::analyse_surface().
[[nodiscard]] processing::PipelineResult made_surface(const std::string& path, const FileRequest& file,
                                                      const MadeSurfaceRequest& request,
                                                      parallel::Threads threads = {});

/// The name of the step in its record.
inline constexpr const char* making_step = "synthesize";

}  // namespace setae::answers

template <>
struct setae::fields::Asked<setae::answers::MadeSurfaceRequest> {
    using R = answers::MadeSurfaceRequest;
    static constexpr std::array options{
        option<&R::pixels>("pixels", "points of a surface made from a spectrum, 512 or 1024x512"),
        option<&R::cell>("cell", "extent of a surface made from a spectrum")
            .such_as("2 um")
            .or_else("twice the longest wavelength"),
        option<&R::surface>("surface", "name of the surface in a study from whose spectrum one is made"),
        option<&R::seed>("seed", "seed of the phases of a surface made from a spectrum").default_shown().advanced(),
    };
};
