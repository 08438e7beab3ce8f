// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "setae/texture/areal_parameters.hpp"

namespace setae::texture {

/// Profile of the parameters.
enum class ProfileKind {
    primary,    ///< P: after the S-filter
    waviness,   ///< W: the part removed by the L-filter
    roughness,  ///< R: the part kept by the L-filter
};

/// Length of averages.
enum class Averages {
    evaluation_length,  ///< ISO 21920-2:2021: Ra, Rq, Rsk, Rku, RSm, Rc … over the whole length
    sections,           ///< ISO 4287:1997, as on instruments: for each section, then the mean
};

/// Reference of heights.
enum class MeanLine {
    mean,  ///< their mean over the evaluation length
    zero,  ///< 0, the mean line of a filter: for profiles filtered by an instrument
};

/// Minimum heights and lengths of hills and dales.
struct Discrimination {
    double height = 0.10;  ///< share of Rz, or of the height of the section
    double length = 0.01;  ///< share of the section length
};

struct ProfileOptions {
    ProfileKind kind = ProfileKind::roughness;
    Filters filters;
    bool default_filters = false;  ///< default_setting() of the line for filters not given
    std::optional<double>
        section_length;  ///< l_sc [m]; absent: the nesting index of the L-filter, or the whole profile without it
    Averages averages = Averages::evaluation_length;
    MeanLine mean_line = MeanLine::mean;
    Discrimination discrimination;
    MaterialRatios ratios;
    Between between = Between::linear;
    double material_height = 0.0;  ///< c of Rmr(c), above the mean line [m]
    double material_ratio = 0.5;   ///< p of Rmc(p)
    std::vector<std::string>
        only;  ///< symbols of the table, with R; only these parameters and those they need are computed; empty: all
};

/// Sections of equal length from the start of a line, as many as fit (tolerance 1 % of their length); polylines are
/// divided between points. @throws InvalidArgument for a map, or if no section fits.
[[nodiscard]] std::vector<topography::Measurement> sections(const MeasurementView& line, double section_length);

/// Filters and section length for a roughness.
struct ProfileSetting {
    double section_length = 0.0;  ///< and L-filter [m]
    double s_filter = 0.0;        ///< [m]
    Index sections = 5;
};

/// Setting for a profile that is not periodic, by its Ra [m].
/// @throws InvalidArgument for Ra < 0.
/// Source: ISO 4288:1996, table 1; ISO 3274:1996, table 1.
[[nodiscard]] ProfileSetting default_setting(double Ra);

/// Setting for a line with equal steps: the smallest L-filter of the table that is consistent with the Ra after
/// filtering, with its S-filter; otherwise the largest with one section.
/// @throws InvalidArgument for a map, a polyline, or a line shorter than the smallest section.
/// Source: ISO 4288:1996, 7.2.
[[nodiscard]] ProfileSetting default_setting(const MeasurementView& line, parallel::Threads threads = {});

/// All parameters of ISO 21920-2:2021 of a line, its symbols with P, W or R. Filters need equal steps.
/// @throws InvalidArgument for a map (use topography::line_scans), a filter on a polyline or a waviness without
/// L-filter.
[[nodiscard]] std::vector<TextureParameter> profile_parameters(const MeasurementView& line,
                                                               const ProfileOptions& options = {},
                                                               parallel::Threads threads = {});

/// Parameters of the scan lines of a map: means over the lines with a value, with standard errors from the scatter of
/// the lines.
/// @throws as profile_parameters; UndefinedDataError if no scan line has two defined heights.
[[nodiscard]] std::vector<TextureParameter> mean_profile_parameters(const topography::HeightMap& map,
                                                                    const ProfileOptions& options = {},
                                                                    parallel::Threads threads = {});

}  // namespace setae::texture
