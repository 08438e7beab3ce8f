// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/texture/areal_parameters.hpp"

namespace setae::texture {

/// Which profile parameters are of.
enum class ProfileKind {
    primary,    ///< P: after the S-filter
    waviness,   ///< W: what the L-filter takes out of it
    roughness,  ///< R: what it leaves
};

struct ProfileOptions {
    ProfileKind kind = ProfileKind::roughness;
    Filters filters;
    std::optional<double> section_length;     ///< l_sc [m]; absent: the L-filter's nesting index, or all of the profile without it
    double height_discrimination = 0.10;      ///< of RSm and Rc, as share of Rz
    double length_discrimination = 0.01;      ///< of RSm and Rc, as share of the section length
    MaterialRatios ratios;
};

/// Elements of a profile, each a hill and the dale behind it, found by crossing the mean line.
///
/// A hill (dale) counts where it is higher (deeper) than the height discrimination and longer than the length discrimination; what
/// does not count is joined to its neighbours.
/// Source: ISO 21920-2:2021, 3.1.15 and annex C.
struct ProfileElements {
    double RSm = 0.0;   ///< mean spacing [m]; NaN where fewer than one whole element lies inside
    double RSmq = 0.0;  ///< its rms deviation [m]
    double Rc = 0.0;    ///< mean height [m]
    double Rcq = 0.0;   ///< its rms deviation [m]
    Index elements = 0;
};

/// Uniform lines: straight between the points; polylines exact.
[[nodiscard]] ProfileElements profile_elements(const MeasurementView& line, double height_discrimination, double length_discrimination);

/// Heights of sections of equal length, the largest of each and their mean.
struct SectionHeights {
    double Rp = 0.0;  ///< mean over sections of the highest point over the mean line [m]
    double Rv = 0.0;  ///< mean of the deepest [m]
    double Rz = 0.0;  ///< mean of Rp + Rv of each section [m]
    double Rzx = 0.0; ///< the largest of them [m]
    double Rt = 0.0;  ///< highest to deepest of all [m]
    Index sections = 0;
};

/// As many whole sections as fit. @throws InvalidArgument where none fits.
[[nodiscard]] SectionHeights section_heights(const MeasurementView& line, double section_length);

/// Slopes of a line: uniform ones by the seven-point formula of the standard and by forward differences, polylines by segments.
struct ProfileSlopes {
    double Rdq = 0.0;          ///< rms [1]
    double Rda = 0.0;          ///< mean of the absolute value [1]
    double Rdq_forward = 0.0;  ///< by differences of neighbours, as spectra have it [1]
};
[[nodiscard]] ProfileSlopes profile_slopes(const MeasurementView& line);

/// All parameters of ISO 21920-2:2021 of a line, its symbols with P, W or R. Filters need equal steps.
/// @throws InvalidArgument for a map (take line_scans) or a filter on a polyline.
[[nodiscard]] std::vector<TextureParameter> profile_parameters(const MeasurementView& line, const ProfileOptions& options = {},
                                                               parallel::Threads threads = {});

}  // namespace setae::texture
