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
    bool default_filters = false;  ///< those not given by default_setting() of the line
    std::optional<double>
        section_length;  ///< l_sc [m]; absent: the L-filter's nesting index, or all of the profile without it
    Averages averages = Averages::evaluation_length;
    MeanLine mean_line = MeanLine::mean;
    Discrimination discrimination;
    MaterialRatios ratios;
    Between between = Between::linear;
    double material_height = 0.0;  ///< c of Rmr(c), over the mean line [m]
    double material_ratio = 0.5;   ///< p of Rmc(p)
    std::vector<std::string>
        only;  ///< symbols of the table, with R; what no other parameter needs is not computed; empty: all
};

/// Sections of equal length from the start of a line, as many as fit to 1 % of their length; polylines are cut between
/// points.
/// @throws InvalidArgument for a map, or where not one section fits.
[[nodiscard]] std::vector<topography::Measurement> sections(const MeasurementView& line, double section_length);

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

/// Of the scan lines of a map: means over the lines where a parameter has a value, with the standard errors of these
/// means from the scatter of the lines.
/// @throws as profile_parameters; UndefinedDataError where no scan line has two defined heights.
[[nodiscard]] std::vector<TextureParameter> mean_profile_parameters(const topography::HeightMap& map,
                                                                    const ProfileOptions& options = {},
                                                                    parallel::Threads threads = {});

}  // namespace setae::texture
