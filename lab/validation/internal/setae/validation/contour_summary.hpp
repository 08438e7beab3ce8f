// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "setae/fields/describe.hpp"
#include "setae/validation/contour_trials.hpp"

namespace setae::validation {

/// A number over the runs of a kind; NaN where no run has it, the standard error also where only one run has it.
struct OverRuns {
    int count = 0;
    double mean = 0.0, standard_error = 0.0;
    double worst = 0.0;  ///< largest deviation from the expected value
    int worst_run = 0;
};

/// All trials of one kind of picture.
struct ContourRow {
    std::string kind;
    bool judged = true;
    int runs = 0, refused = 0, vacuum_mistaken = 0;
    OverRuns segments, completeness, rms_error, largest_error, offset, within_two_errors, rms_height_ratio, floor_ratio,
        overhang_depth_ratio;
    std::array<OverRuns, 5> spectrum_ratio;
    int overhangs = 0, overhangs_found = 0, overhangs_false = 0;
};

/// One row per kind, in the order of their first appearance.
[[nodiscard]] std::vector<ContourRow> contour_summary(const std::vector<ContourTrial>& trials);

/// A criterion for traces, and whether it is met.
struct ContourVerdict {
    std::string kind, criterion;  ///< "rms error below 0.5 px in every run"
    bool passed = false;
    std::string found;  ///< "0.41 px on average, 0.47 px in run 12"
};

/// For judged kinds: no picture refused; vacuum distinguished from the sample; rms error below 0.5 px in every run;
/// overhangs all found and none false; where the profile is judged, Rq within 2 % in every run and C1D within 10 % in
/// each half decade on average.
[[nodiscard]] std::vector<ContourVerdict> contour_verdicts(const std::vector<ContourRow>& rows);

/// Output of `setae lab contours`.
struct ContoursOutput {
    int runs = 0;
    std::uint64_t first_seed = 0;
    long size = 0;  ///< side of a picture [px]
    std::vector<ContourRow> rows;
    std::vector<ContourVerdict> verdicts;
};

/// Rows as aligned text, then their spectra, then verdicts: those that failed, and how many passed.
[[nodiscard]] std::string contour_table(const std::vector<ContourRow>& rows);

/// Every trial as CSV.
[[nodiscard]] std::string contour_trials_csv(const std::vector<ContourTrial>& trials);

/// The ratio of spectra in one half decade.
struct BandRatio {
    const OverRuns* ratio;
    double longest_wave = 0.0;  ///< [px]
};

[[nodiscard]] inline std::vector<BandRatio> band_ratios(const ContourRow& row) {
    std::vector<BandRatio> ratios;
    for (std::size_t band = 0; band < row.spectrum_ratio.size(); ++band)
        ratios.push_back({&row.spectrum_ratio[band], spectrum_band_ends[band]});
    return ratios;
}

}  // namespace setae::validation

namespace setae::fields {

template <>
struct Described<validation::OverRuns> {
    using T = validation::OverRuns;
    static constexpr std::array rows{
        field<&T::count>("count", "number of pictures that have the number"),
        field<&T::mean>("mean", "mean over these pictures"),
        field<&T::standard_error>("standard_error", "standard error of the mean; null for fewer than two pictures"),
        field<&T::worst>("worst", "number with the largest deviation from the expected value"),
        field<&T::worst_run>("worst_run", "run of that number"),
    };
    static constexpr Description description{"trial_mean", "mean over pictures", rows};
};
static_assert(complete<validation::OverRuns>);

template <>
struct Described<validation::BandRatio> {
    using T = validation::BandRatio;
    static constexpr std::array rows{
        fields_of<T>([](const T& of) -> const auto& { return *of.ratio; }),
        field<&T::longest_wave>("longest_wave_px", "longest wavelength of the half decade [px]"),
        inner<&T::ratio>(),
    };
    static constexpr Description description{"", "mean over pictures in one half decade of wavelengths", rows};
};
static_assert(complete<validation::BandRatio>);

template <>
struct Described<validation::ContourRow> {
    using T = validation::ContourRow;
    static constexpr std::array rows{
        field<&T::kind>("kind", "kind of picture"),
        field<&T::judged>("judged", "whether criteria apply to the row"),
        field<&T::runs>("runs", "number of pictures of this kind"),
        field<&T::refused>("refused", "number of pictures in which no edge was found"),
        field<&T::vacuum_mistaken>("vacuum_mistaken", "number of pictures in which vacuum and sample were exchanged"),
        field<&T::completeness>("completeness", "share of the true edge that was found"),
        field<&T::rms_error>("rms_error_px", "rms error of positions [px]"),
        field<&T::largest_error>("largest_error_px", "largest error of positions [px]"),
        field<&T::offset>("offset_px", "mean error of positions [px], positive in the vacuum"),
        field<&T::within_two_errors>("within_two_errors", "share of positions within two standard errors"),
        field<&T::rms_height_ratio>("rms_height_ratio", "found rms height divided by the true value"),
        field<&T::floor_ratio>("floor_ratio", "density of the errors divided by the stated noise density"),
        field<&T::overhangs>("overhangs", "number of overhangs"),
        field<&T::overhangs_found>("overhangs_found", "number of overhangs that were found"),
        field<&T::overhangs_false>("overhangs_false", "number of false overhangs"),
        field<&T::overhang_depth_ratio>("overhang_depth_ratio", "found depth of overhangs divided by the true depth"),
        made<T>("spectrum_ratio", "found C1D divided by the true C1D, per half decade",
                [](const T& of) { return validation::band_ratios(of); }),
        inner<&T::segments>(),
        inner<&T::spectrum_ratio>(),
    };
    static constexpr Description description{"", "all pictures of one kind", rows};
};
static_assert(complete<validation::ContourRow>);

template <>
struct Described<validation::ContourVerdict> {
    using T = validation::ContourVerdict;
    static constexpr std::array rows{
        field<&T::kind>("kind", "kind of picture"),
        field<&T::criterion>("criterion", "criterion in words"),
        field<&T::passed>("passed", "whether the criterion is met"),
        field<&T::found>("found", "found value, in words"),
    };
    static constexpr Description description{"", "a criterion for traces, and whether it is met", rows};
};
static_assert(complete<validation::ContourVerdict>);

template <>
struct Described<validation::ContoursOutput> {
    using T = validation::ContoursOutput;
    static constexpr std::array rows{
        field<&T::runs>("runs", "number of pictures of each kind"),
        field<&T::first_seed>("first_seed", "seed of the first run"),
        field<&T::size>("size", "number of pixels along each side of a picture"),
        field<&T::rows>("rows", "one entry per kind of picture"),
        field<&T::verdicts>("verdicts", "criteria of each kind"),
    };
    static constexpr Description description{"", "contours of curves with known shape", rows};
};
static_assert(complete<validation::ContoursOutput>);

}  // namespace setae::fields
