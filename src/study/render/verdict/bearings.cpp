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
         "An iteration for {} ended before its changes were small: its result may move."},
        {{"MAP_NOT_PERIODIC"},
         "The map of {} is repeated and does not fit itself: contact near its edges is not the surface's."},
        {{"ADHESION_GRID"}, "Pixels of {} catch the edge of an adhesive contact: opening it takes too much work."},
        {{"FRONT_THEORY"}, "The edge of {} is outside the theory of fronts: its works are of first order at best."},
        {{"PINNING_EXTRAPOLATED"}, "The pinning models of {} go beyond the simulated fronts."},
        {{"NO_DATA_SUSPECTED"},
         "Heights of {} may hold values that mark missing ones: every number of it may be wrong."},
        {{"NO_DATA"}, "Heights of {} that have a value that marks missing ones are in no number."},
        {{"UNREADABLE_MEMBER", "UNREADABLE_ARRAY"}, "What of {} cannot be read is in no number."},
        {{"CHECKSUM"}, "A checksum of {} is wrong: what was read may be damaged."},
        {{"UNIT_ASSUMED", "UNIT_GUESSED", "UNIT_MISMATCH", "UNITS_IMPLAUSIBLE"},
         "The units of {} are not certain: its numbers scale with them."},
        {{"FEW_POINTS"}, "The fitted spectrum does not rest on {}."},
        {{"PART_FAILED"}, "Of {} a number is missing that could not be computed."},
        {{"SPECTRUM_CONVENTION"},
         "The normalisation of the spectrum of {} is not certain: heights and slopes scale with it."},
        {{"SIZE_MISMATCH", "SIZE_FROM_NAME"}, "The size of {} is not certain: wavelengths and slopes scale with it."},
        {{"SCALE_NOT_APPLIED", "SCALE_TWICE", "NO_HEIGHT_SCALE", "SENSITIVITY_MISSING"},
         "The scale of heights of {} is not certain: heights, slopes and stored energy go with it."},
        {{"BAD_CALIBRATION", "DEFAULT_CALIBRATION", "UNKNOWN_UNIT", "RECIPROCAL_UNITS", "PIXEL_SIZE_DISAGREES",
          "SCALE_BAR_UNCONFIRMED", "SCALE_BAR_AMBIGUOUS", "SCALE_BAR_DISAGREES"},
         "The size of a pixel of {} is not certain: heights and wavelengths scale with it."},
        {{"LABELS_NOT_HEIGHTS"}, "The first row or column of {} is taken for positions, not for heights."},
        {{"POSITIONS_REPEATED", "PASSES_SPLIT"},
         "Points of {} share positions or were measured back and forth: which of them count is a choice."},
        {{"GAP_BRIDGED"}, "Straight lines stand for missing points of {}: its slopes and curvatures are too low."},
        {{"HEIGHTS_IMPLAUSIBLE"},
         "Some heights of {} are no heights, or are in a wrong unit: all its numbers are in doubt."},
        {{"INPUT_CHANGED"},
         "{} changed during the run: the numbers may be those of its old content or of the new one."},
        {{"ROWS_MISSING"}, "Of {} rows are missing: what stands there is in no number."},
        {{"AMBIGUOUS_COLUMNS", "COLUMN_GUESSED"}, "What the columns of {} hold is a guess."},
        {{"UNTESTED_FORMAT"}, "The format of {} is read by its description alone: no real file has tested that."},
        {{"ORIGINAL_MISSING", "COPY_DIFFERS", "NO_PROCESSED_COPY"},
         "Of {} original and processed copy are not both there and alike: what others computed from it may rest on other data."},
        {{"HIDDEN_MEASUREMENT"}, "Of {} the file says not to show it; it counts all the same."},
        {{"CHANNEL_CHOSEN"}, "Of several channels of heights of {} the first counts, as the study names none."},
        {{"MASK_NOT_APPLIED"}, "Points of {} that a mask selects count like all others."},
        {{"INSTRUMENTS_DISAGREE", "DISAGREE"},
         "Instruments disagree on {} beyond chance: its spectrum is a compromise between them."},
        {{"NO_INSTRUMENT"}, "Of {} no instrument is stated: waves that it may have blurred count as seen."},
        {{"NO_TIP_RADIUS"}, "Of {} no tip radius is stated: waves that a tip may have hidden count as seen."},
        {{"SAME_MEASUREMENT"}, "Data of {} stand in the study more than once: intervals are too narrow."},
        {{"CONSTANT"}, "All heights of {} are equal: its roughness is below what was recorded."},
        {{"WAVES_BEYOND_DATA"},
         "Of {} waves shorter than the finest data are in no number; slope, true area and stored energy are lower bounds."},
        {{"BAND_LIMITED"},
         "Of {} waves longer than the longest measured are in no number; h_rms and stored energy are lower bounds."},
        {{"LOW_Q_GAP", "ROLLOFF_NOT_SEEN"},
         "The spectrum of {} does not level off at its longest waves: a larger piece of it is rougher."},
        {{"COVERAGE_GAP"}, "No measurement of {} sees the waves between those of its instruments."},
        {{"CUTOFF_NOT_SEEN"},
         "Where the spectrum of {} ends is not seen: slope, curvature and true area rest on an end that was assumed."},
        {{"TIP_BELOW_PIXEL"}, "The tip radius estimated from {} is below the pixel: it is an upper limit at best."},
        {{"STEEP_SLOPES"},
         "The rms slope of {} is above 0.5: the stored energy U_el assumes small slopes and is approximate."},
        {{"MODEL_MISSES", "MODEL_MISSES_BEYOND", "FIT_AT_BOUND"},
         "A self-affine spectrum does not describe {}: what rests on its form is approximate."},
        {{"SPECTRUM_WITHOUT_ERROR"}, "The spectrum of {} comes without errors: no ± follows from it."},
        {{"SPREAD_INCOMPLETE", "INPUT_LOST"}, "The ± of {} leaves a part out: its intervals are too narrow."},
        {{"ONE_PLACE"}, "One place of {} was measured: whether others are like it is not known."},
        {{"FEW_PATCHES"}, "Maps of {} hold few independent patches: their ± is itself uncertain."},
        {{"MEASUREMENTS_SCATTER"}, "Places of {} differ beyond their waves: few places may not stand for the whole."},
        {{"SPIKES", "SCARS", "SCAN_DIRECTION", "CLIPPED", "QUANTISED"},
         "Heights of {} carry marks of the instrument (spikes, scars, lines that jump, clipping or steps of the digitiser): a part of the roughness may be theirs."},
        {{"TILT_LARGE", "CURVATURE_LEFT"},
         "Tilt or bow of {} exceeds its roughness: the longest waves depend on how it is taken off."},
        {{"UNDEF", "UNDEFINED"}, "Of {} some points are undefined: what stands there is in no number."},
        {{"PIXEL_NOISE", "TRACE_NOISE"}, "Noise covers the shortest waves of {}."},
        {{"VACUUM_ASSUMED", "TWO_EDGES", "LOW_CONTRAST"}, "Which edge of {} is the surface is not certain."},
        {{"REENTRANT"}, "Contours of {} turn back: overhangs are in no number."},
        {{"FOIL_THICKNESS", "FOIL_PROJECTION"},
         "Contours of {} are silhouettes of a foil: waves shorter than some foil thicknesses read low."},
        {{"SLOPES_INTEGRATED"}, "Heights of {} are integrals of slopes: their longest waves are the least certain."},
        {{"SINGLE_INSTRUMENT_DECADE"},
         "Some decades of {} are seen by one instrument alone: nothing checks them there."},
        {{"SINGLE_MEASUREMENT_DECADE"},
         "Some decades of {} are covered by one measurement: how places differ there is not known."},
        {{"ONE_DIRECTION"},
         "Lines on {} see one direction: that the others are alike is assumed where no map shows it."},
        {{"ANISOTROPIC", "STRETCHED"},
         "The roughness of {} differs with direction: the isotropic spectrum is the mean over all."},
        {{"NON_GAUSSIAN"}, "Slopes of {} are not Gaussian, which (9) assumes: true areas by it are approximate."},
        {{"MEASURED_SLOPES"}, "Slopes of {} are not Gaussian: true areas are taken from the measured ones."},
        {{"HEIGHT_UNKNOWN"},
         "The height of the soft body of {} is not given: its modulus counts as that of a half-space and is too high for a lens."},
        {{"MODULUS_IMPLAUSIBLE"},
         "The modulus of {} is not what the molar mass of its network gives: one of the two is wrong."},
        {{"NOISY_RECORD"}, "The record of {} is noisy: intervals of E* and W are somewhat too short."},
        {{"STEP_IN_CONTACT"}, "The force of {} changes at once within contact: E*, W and the energy may be off."},
        {{"FORCE_DRIFT", "DRIFT_NOT_LINEAR", "STEP_IN_FREE_FLIGHT"},
         "The zero of force of {} drifts or steps: the drift was removed, and the ± include what is not known of it."},
        {{"POOR_FIT", "BEYOND_NOISE", "RANGE_SENSITIVE", "WORK_NEGATIVE"},
         "The JKR fit of {} leaves residuals or depends on its range: so do E* and W."},
        {{"LARGE_STRAIN", "TABOR_RANGE"}, "The contact of {} is outside the range of JKR's theory."},
        {{"CONTACT_POINT_UNKNOWN", "CONTACT_POINT_SPREAD"},
         "Where {} first touches is not certain: E* from displacement goes with it."},
        {{"STIFFNESS_UNRESOLVED"},
         "The machine is soft beside the contact of {}: E* from displacement is not resolved."},
        {{"NO_BASELINE", "DRIFT_UNKNOWN", "ONE_BASELINE", "DRIFT_IRREGULAR", "FORCE_SATURATED"},
         "The zero, the drift or the end of the force of {} is not known: forces may be off by it."},
        {{"NO_RETRACTION"}, "The record of {} ends before pull-off: it says nothing of the energy lost."},
        {{"LOOP_UNDERSAMPLED"}, "The loop of {} is sampled coarsely: so is its energy."},
        {{"FRAME_MISSING", "FRAMES_BAD", "FRAMES_OUTSIDE", "CLOCK_DOUBTFUL"},
         "Contact radii of {} are missing in part, or their clock is doubtful."},
        {{"TIME_BACKWARDS"}, "The time of {} runs backwards: which branch is which is not certain."},
        {{"TWO_CONTACTS"}, "The record of {} holds several contacts, of which one is analysed."},
        {{"CONFORMAL_INVALID"},
         "At some wavelengths the roughness of {} stores more than it gains: the contact that (7) assumes is not to be expected there."},
        {{"NEEDS_PRESSURE"},
         "The roughness of {} closes under pressure alone: what approach measures may be partial contact."},
        {{"REFERENCE_INCOMPLETE"},
         "The smooth reference {} is not whole: it cannot tell the loss of roughness from the material's."},
        {{"REFERENCE_HYSTERESIS"},
         "The smooth reference on {} is not shown to be free of hysteresis: of that on rough surfaces a part is not the roughness's."},
        {{"LOSS_CONTRADICTS_WORKS"},
         "The energy lost by {} is not what its own works would lose: W_ret at pull-off is not the work of its whole retraction."},
        {{"SPEED_BEYOND_BULK"},
         "The edge of {} needs more at speed than the relaxation stated for its bulk can take: one of the two is not whole."},
        {{"REFERENCE_LOSS"},
         "The smooth reference on {} is not shown to lose no more than an ideal sphere: of the loss on rough surfaces a part is not the roughness's."}};
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
