// SPDX-License-Identifier: GPL-3.0-or-later
#include "bearings.hpp"

#include <set>
#include <utility>

namespace setae::output {
namespace {

/// Names, each once, in the order they came.
class Names {
public:
    void add(const std::string& name) {
        if (known_.insert(name).second) names_.push_back(name);
    }
    [[nodiscard]] std::vector<std::string> take() { return std::move(names_); }
    [[nodiscard]] std::size_t size() const { return names_.size(); }

private:
    std::vector<std::string> names_;
    std::set<std::string> known_;
};

}  // namespace

const std::vector<Bearing>& bearings() {
    static const std::vector<Bearing> list{
        {{"NOT_CONVERGED", "TIP_NOT_CONVERGED", "CONTACT_NOT_CONVERGED"},
         "An iteration for {} stopped before it converged: the result may change with more iterations."},
        {{"MAP_NOT_PERIODIC"},
         "The map of {} is repeated periodically, but its opposite edges do not match: the contact near the edges is an "
         "artefact."},
        {{"ADHESION_GRID"}, "The pixels of {} pin the edge of an adhesive contact: the work of opening is too large."},
        {{"FRONT_THEORY"},
         "The contact edge of {} is outside the range of the front theory: the works are first-order estimates at best."},
        {{"PINNING_EXTRAPOLATED"}, "The pinning models of {} are extrapolated beyond the simulated fronts."},
        {{"NO_DATA_SUSPECTED"},
         "The heights of {} may contain values that mark missing data: every number from these heights may be wrong."},
        {{"NO_DATA"}, "Heights of {} that equal the value for missing data are excluded from every number."},
        {{"UNREADABLE_MEMBER", "UNREADABLE_ARRAY"}, "Unreadable parts of {} do not contribute to any number."},
        {{"CHECKSUM"}, "A checksum of {} is wrong: the data may be damaged."},
        {{"UNIT_ASSUMED", "UNIT_GUESSED", "UNIT_MISMATCH", "UNITS_IMPLAUSIBLE"},
         "The units of {} are not certain: the numbers scale with the units."},
        {{"FEW_POINTS"}, "The fitted spectrum does not include {}: too few points per line."},
        {{"PART_FAILED"}, "The computation of some numbers of {} failed: these numbers are missing."},
        {{"SPECTRUM_CONVENTION"},
         "The normalisation of the spectrum of {} is not certain: heights and slopes scale with the normalisation."},
        {{"SIZE_MISMATCH", "SIZE_FROM_NAME"},
         "The size of {} is not certain: wavelengths and slopes scale with the size."},
        {{"SCALE_NOT_APPLIED", "SCALE_TWICE", "NO_HEIGHT_SCALE", "SENSITIVITY_MISSING"},
         "The height scale of {} is not certain: heights, slopes and stored energy change with the height scale."},
        {{"BAD_CALIBRATION", "DEFAULT_CALIBRATION", "UNKNOWN_UNIT", "RECIPROCAL_UNITS", "PIXEL_SIZE_DISAGREES",
          "SCALE_BAR_UNCONFIRMED", "SCALE_BAR_AMBIGUOUS", "SCALE_BAR_DISAGREES"},
         "The pixel size of {} is not certain: heights and wavelengths scale with the pixel size."},
        {{"LABELS_NOT_HEIGHTS"}, "The first row or column of {} is read as positions, not as heights."},
        {{"POSITIONS_REPEATED", "PASSES_SPLIT"},
         "Points of {} share positions or were measured back and forth: the selection of points is a choice."},
        {{"GAP_BRIDGED"}, "Straight lines replace missing points of {}: slopes and curvatures are underestimated."},
        {{"HEIGHTS_IMPLAUSIBLE"},
         "Some values of {} are implausible as heights, or their unit is wrong: every number from them is doubtful."},
        {{"INPUT_CHANGED"},
         "The content of {} changed during the run: the numbers may belong to the old or to the new content."},
        {{"ROWS_MISSING"}, "Rows of {} are missing: the missing areas do not contribute to any number."},
        {{"AMBIGUOUS_COLUMNS", "COLUMN_GUESSED"}, "The meaning of the columns of {} is a guess."},
        {{"UNTESTED_FORMAT"},
         "The reader for the format of {} follows the specification and was not tested on a real file."},
        {{"ORIGINAL_MISSING", "COPY_DIFFERS", "NO_PROCESSED_COPY"},
         "The original and the processed copy of {} differ, or one is missing: results of other software may use other data."},
        {{"HIDDEN_MEASUREMENT"}, "The file marks {} as hidden; the measurement is included nevertheless."},
        {{"CHANNEL_CHOSEN"}, "The study names no height channel of {}: the first of several channels is used."},
        {{"MASK_NOT_APPLIED"}, "The mask of {} is not applied: masked points count like all others."},
        {{"INSTRUMENTS_DISAGREE", "DISAGREE"},
         "Instruments disagree on {} beyond chance: the spectrum is a compromise between the instruments."},
        {{"NO_INSTRUMENT"},
         "The instrument of {} is not stated: short waves count as measured, although the instrument may have blurred them."},
        {{"NO_TIP_RADIUS"},
         "The tip radius of {} is not stated: short waves count as measured, although the tip may not resolve them."},
        {{"SAME_MEASUREMENT"}, "The study contains data of {} more than once: intervals are too narrow."},
        {{"CONSTANT"}, "All heights of {} are equal: the roughness is below the resolution of the record."},
        {{"WAVES_BEYOND_DATA"},
         "Waves of {} shorter than the finest data are missing: slope, true area and stored energy are lower bounds."},
        {{"BAND_LIMITED"},
         "Waves of {} longer than the longest measured wave are missing: h_rms and stored energy are lower bounds."},
        {{"LOW_Q_GAP", "ROLLOFF_NOT_SEEN"},
         "The spectrum of {} shows no roll-off at long waves: h_rms of a larger piece is larger."},
        {{"COVERAGE_GAP"}, "No measurement of {} covers the waves between the bands of its instruments."},
        {{"CUTOFF_NOT_SEEN"},
         "The data of {} do not reach the short cutoff: slope, curvature and true area depend on an assumed cutoff."},
        {{"TIP_BELOW_PIXEL"},
         "The tip radius estimated from {} is smaller than a pixel: the estimate is an upper limit at best."},
        {{"STEEP_SLOPES"},
         "The rms slope of {} is above 0.5: the stored energy U_el assumes small slopes and is approximate."},
        {{"MODEL_MISSES", "MODEL_MISSES_BEYOND", "FIT_AT_BOUND"},
         "A self-affine spectrum does not fit {}: results that depend on this form are approximate."},
        {{"SPECTRUM_WITHOUT_ERROR"}, "The spectrum of {} has no errors: results from this spectrum have no ±."},
        {{"SPREAD_INCOMPLETE", "INPUT_LOST"},
         "The ± of {} does not include every source of error: intervals are too narrow."},
        {{"ONE_PLACE"}, "Only one place of {} was measured: the variation between places is not known."},
        {{"FEW_PATCHES"}, "Maps of {} contain few independent patches: their ± are themselves uncertain."},
        {{"MEASUREMENTS_SCATTER"},
         "Places of {} differ by more than their waves explain: a few places may not represent the whole surface."},
        {{"SPIKES", "SCARS", "SCAN_DIRECTION", "CLIPPED", "QUANTISED"},
         "Heights of {} contain artefacts of the instrument (spikes, scars, jumping lines, clipping or digitiser steps): "
         "part of the measured roughness may be due to them."},
        {{"TILT_LARGE", "CURVATURE_LEFT"},
         "Tilt or bow of {} exceeds the roughness: the longest waves depend on the removed trend."},
        {{"UNDEF", "UNDEFINED"}, "Some points of {} are undefined and do not contribute to any number."},
        {{"PIXEL_NOISE", "TRACE_NOISE"}, "Noise hides the shortest waves of {}."},
        {{"VACUUM_ASSUMED", "TWO_EDGES", "LOW_CONTRAST"}, "The choice of the surface edge in {} is not certain."},
        {{"REENTRANT"}, "Contours of {} turn back: overhangs do not contribute to any number."},
        {{"FOIL_THICKNESS", "FOIL_PROJECTION"},
         "Contours of {} are projections of a foil: waves shorter than a few foil thicknesses are underestimated."},
        {{"SLOPES_INTEGRATED"}, "Heights of {} were integrated from slopes: the longest waves are the least certain."},
        {{"SINGLE_INSTRUMENT_DECADE"},
         "Only one instrument covers some decades of {}: no other instrument checks these decades."},
        {{"SINGLE_MEASUREMENT_DECADE"},
         "Only one measurement covers some decades of {}: the variation between places is not known there."},
        {{"ONE_DIRECTION"}, "Lines on {} run in one direction: isotropy is assumed where no map tests it."},
        {{"ANISOTROPIC", "STRETCHED"},
         "The roughness of {} depends on direction: the isotropic spectrum is the mean over all directions."},
        {{"NON_GAUSSIAN"},
         "The slopes of {} are not Gaussian, as Eq. 9 assumes: true areas from Eq. 9 are approximate."},
        {{"MEASURED_SLOPES"}, "The slopes of {} are not Gaussian: true areas use the measured slopes."},
        {{"HEIGHT_UNKNOWN"},
         "The height of the soft body of {} is not given: its modulus is that of a half-space, which is too high for a "
         "lens."},
        {{"MODULUS_IMPLAUSIBLE"},
         "The modulus of {} does not agree with the molar mass of its network: one of the two is wrong."},
        {{"NOISY_RECORD"}, "The record of {} is noisy: intervals of E* and W are slightly too short."},
        {{"STEP_IN_CONTACT"}, "The force of {} jumps during contact: E*, W and the energy may be wrong."},
        {{"FORCE_DRIFT", "DRIFT_NOT_LINEAR", "STEP_IN_FREE_FLIGHT"},
         "The zero of the force of {} drifts or jumps: the drift was removed, and the ± include its uncertainty."},
        {{"POOR_FIT", "BEYOND_NOISE", "RANGE_SENSITIVE", "WORK_NEGATIVE"},
         "The JKR fit of {} leaves residuals or depends on the fitted range: E* and W depend on the model or on this range."},
        {{"LARGE_STRAIN", "TABOR_RANGE"}, "The contact of {} is outside the range of the JKR theory."},
        {{"CONTACT_POINT_UNKNOWN", "CONTACT_POINT_SPREAD"},
         "The point of first contact of {} is not certain: E* from displacement depends on this point."},
        {{"STIFFNESS_UNRESOLVED"},
         "The testing machine is compliant compared with the contact of {}: the displacement does not determine E*."},
        {{"NO_BASELINE", "DRIFT_UNKNOWN", "ONE_BASELINE", "DRIFT_IRREGULAR", "FORCE_SATURATED"},
         "The zero, the drift or the range of the force of {} is not known: forces may be shifted or cut off."},
        {{"NO_RETRACTION"}, "The record of {} ends before pull-off: the energy loss is not known."},
        {{"LOOP_UNDERSAMPLED"}, "The loop of {} has few samples: its energy is a coarse estimate."},
        {{"FRAME_MISSING", "FRAMES_BAD", "FRAMES_OUTSIDE", "CLOCK_DOUBTFUL"},
         "Some contact radii of {} are missing, or their clock is doubtful."},
        {{"TIME_BACKWARDS"}, "The time of {} runs backwards: the assignment of branches is not certain."},
        {{"TWO_CONTACTS"}, "The record of {} contains several contacts; only one of them is analysed."},
        {{"CONFORMAL_INVALID"},
         "At some wavelengths, the roughness of {} stores more energy than full contact gains: the full-contact balance "
         "(Eq. 7) does not apply there."},
        {{"NEEDS_PRESSURE"},
         "The contact of {} is full only under pressure: the measured W_app of approach may be that of a partial contact."},
        {{"REFERENCE_INCOMPLETE"},
         "The smooth reference {} is incomplete: it cannot separate the loss of roughness from that of the material."},
        {{"REFERENCE_HYSTERESIS"},
         "The hysteresis of the smooth reference on {} is not shown to be below the margin: part of the hysteresis on "
         "rough surfaces may not be due to roughness."},
        {{"LOSS_CONTRADICTS_WORKS"},
         "The energy loss of {} does not agree with its W_app and W_ret: W_ret at pull-off is not the work of the whole "
         "retraction."},
        {{"SPEED_BEYOND_BULK"},
         "The rate dependence of the edge of {} is stronger than the stated bulk relaxation allows: one of the two is "
         "incomplete."},
        {{"REFERENCE_LOSS"},
         "The smooth reference on {} is not shown to lose no more than an ideal sphere: part of the loss on rough surfaces "
         "may not be due to roughness."}};
    return list;
}

namespace {

std::string last_part(const std::string& path) { return path.substr(path.find_last_of('/') + 1); }

}  // namespace

Subjects::Subjects(const study::StudyResult& result) {
    for (const auto& surface : result.surfaces) {
        for (const auto& alert : surface.alerts) subjects_.emplace(key_of(alert), Subject{surface.name, ""});
        for (const auto& m : surface.measurements) {
            const auto name = m.file.empty() ? m.name : last_part(m.file);
            for (const auto& alert : m.alerts)
                subjects_.emplace(key_of(alert), Subject{name.empty() ? surface.name : name, surface.name});
        }
    }
}

Subject Subjects::of(const Alert& alert) const {
    const auto found = subjects_.find(key_of(alert));
    return found == subjects_.end() ? Subject{last_part(alert.subject), ""} : found->second;
}

std::vector<std::string> names_of(const std::vector<Subject>& subjects) {
    constexpr std::size_t few = 3;
    Names own, of_surfaces;
    for (const auto& subject : subjects) {
        own.add(subject.name);
        of_surfaces.add(subject.surface.empty() ? subject.name : subject.surface);
    }
    return own.size() > few ? of_surfaces.take() : own.take();
}

}  // namespace setae::output
