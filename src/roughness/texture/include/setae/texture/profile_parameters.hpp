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

/// Over which length averages run.
enum class Averages {
    evaluation_length,  ///< ISO 21920-2:2021: Ra, Rq, Rsk, Rku, RSm, Rc … of the whole
    sections,           ///< ISO 4287:1997, as instruments have it: of each section, then their mean
};

/// What heights are counted from.
enum class MeanLine {
    mean,  ///< their mean over the evaluation length
    zero,  ///< 0, the mean line a filter has left: for profiles that an instrument filtered
};

/// Smallest hills, dales and their lengths that count as such.
struct Discrimination {
    double height = 0.10;  ///< share of Rz, or of the section's height
    double length = 0.01;  ///< share of the section length
};

struct ProfileOptions {
    ProfileKind kind = ProfileKind::roughness;
    Filters filters;
    std::optional<double>
        section_length;  ///< l_sc [m]; absent: the L-filter's nesting index, or all of the profile without it
    Averages averages = Averages::evaluation_length;
    MeanLine mean_line = MeanLine::mean;
    Discrimination discrimination;
    MaterialRatios ratios;
    Between between = Between::linear;
    double material_height = 0.0;  ///< c of Rmr(c), over the mean line [m]
    double material_ratio = 0.5;   ///< p of Rmc(p)
};

/// Elements of a profile, each a hill and the dale behind it, found by crossing the mean line.
///
/// A hill (dale) that is lower than the height threshold or shorter than the length threshold is joined to what lies
/// around it. Elements begin at the first crossing; what lies before it and behind the last is left out. Source: ISO
/// 21920-2:2021, 5; ISO 4287:1997, 3.2.7 and 4.3.
struct ProfileElements {
    double RSm = 0.0;   ///< mean length [m]; NaN without a whole element
    double RSmq = 0.0;  ///< its rms deviation [m]
    double Rc = 0.0;    ///< mean height, hill plus dale [m]
    double Rcq = 0.0;   ///< its rms deviation [m]
    Index elements = 0;
};

/// height, length: thresholds [m]; mean_line: [m]. Straight between the points.
/// @throws InvalidArgument for a map; UndefinedDataError for undefined heights.
[[nodiscard]] ProfileElements profile_elements(const MeasurementView& line, double height, double length,
                                               double mean_line);

/// Sections of equal length from the start of a line, as many as fit to 1 % of their length; polylines are cut between
/// points.
/// @throws InvalidArgument for a map, or where not one section fits.
[[nodiscard]] std::vector<topography::Measurement> sections(const MeasurementView& line, double section_length);

/// Slopes of a line: uniform ones by the seven-point formula of the standard, polylines by segments.
struct ProfileSlopes {
    double Rdq = 0.0;    ///< rms [1]; NaN for fewer than seven points
    double Rda = 0.0;    ///< mean of the absolute value [1]
    double Rdt = 0.0;    ///< largest absolute value [1]
    double Rdr = 0.0;    ///< length of the straight segments between points over their length along x, minus 1 [1]
    double Rdq_2 = 0.0;  ///< rms by differences of neighbours, as spectra have it [1]
};
/// @throws InvalidArgument for a map or a re-entrant profile.
/// Seven points: z' = (z₊₃ − 9 z₊₂ + 45 z₊₁ − 45 z₋₁ + 9 z₋₂ − z₋₃)/(60 Δx). Source: ISO 21920-2:2021, 4.4; ISO
/// 4287:1997, local slope.
[[nodiscard]] ProfileSlopes profile_slopes(const MeasurementView& line);

/// Filters and section length that a roughness asks for.
struct ProfileSetting {
    double section_length = 0.0;  ///< and L-filter [m]
    double s_filter = 0.0;        ///< [m]
    Index sections = 5;
};

/// Of a profile that is not periodic, by its Ra [m].
/// @throws InvalidArgument for Ra < 0.
/// Source: ISO 4288:1996, table 1; ISO 3274:1996, table 1.
[[nodiscard]] ProfileSetting default_setting(double Ra);

/// Of a line with equal steps: the smallest L-filter of the table that the Ra behind it asks for itself, with its
/// S-filter; the largest that leaves one section where none does.
/// @throws InvalidArgument for a map, a polyline, or a line shorter than the smallest section.
/// Source: ISO 4288:1996, 7.2.
[[nodiscard]] ProfileSetting default_setting(const MeasurementView& line, parallel::Threads threads = {});

/// All parameters of ISO 21920-2:2021 of a line, its symbols with P, W or R. Filters need equal steps.
/// @throws InvalidArgument for a map (take topography::line_scans), a filter on a polyline or a waviness without
/// L-filter.
[[nodiscard]] std::vector<TextureParameter> profile_parameters(const MeasurementView& line,
                                                               const ProfileOptions& options = {},
                                                               parallel::Threads threads = {});

}  // namespace setae::texture
