// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/output/alert_kinds.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "setae/adhesion/partial_contact.hpp"
#include "setae/core/units.hpp"
#include "setae/loops/analysis.hpp"
#include "setae/spectral_fit/likelihood_spectrum.hpp"
#include "setae/study/open_loop.hpp"
#include "setae/study/study.hpp"

namespace setae::output {
namespace {

std::string percent(double share) { return fmt::format("{:g} %", 100.0 * share); }

std::vector<AlertKind> of_files() {
    const char* about = "files";
    return {
        {"NO_DATA", about,
         "heights have exactly a value that marks missing ones; they are undefined unless --keep-values is given",
         "the evidence is overwhelming (undefined-heights.md); no false alarm on the surfaces tried there"},
        {"NO_DATA_SUSPECTED", about,
         "heights have exactly a value that may mark missing ones, or one is far from all others; they are kept",
         "the evidence is weaker (undefined-heights.md)"},
        {"LABELS_NOT_HEIGHTS", about,
         "the first row or column of a table holds positions or numbers of rows, not heights"},
        {"ROWS_MISSING", about,
         "steps along a profile of equal steps are two or more times the usual one: the points between are undefined",
         "rows left out make whole multiples of a step"},
        {"POSITIONS_REPEATED", about, "several points of a profile have the same position"},
        {"PASSES_SPLIT", about, "the positions of a profile run back and forth: each pass is a channel"},
        {"UNIT_ASSUMED", about, "the file states no unit; the one its format implies was taken"},
        {"UNIT_GUESSED", about, "a table of a spectrum states no units"},
        {"UNIT_MISMATCH", about, "two places state different units; the message says which was used"},
        {"UNIT_PREFIX", about, "heights are stated in a prefixed unit that Gwyddion reads as m"},
        {"SIZE_MISMATCH", about, "a size was given, and the file states another, which was used: by more than 1e-4",
         "rounding of sizes that programs write"},
        {"SIZE_BETWEEN_POINTS", about, "the file states the distance from the first point to the last as size"},
        {"SIZE_NOT_STATED", about,
         "the file states a size that is no extent: zero, negative, no number, below 1 fm or above 10⁹ m",
         "a nucleus and the distance to the moon: no scan is smaller or larger"},
        {"CHANNEL_CHOSEN", about, "the file has several channels of heights, and the preferred one was taken"},
        {"SIZE_FROM_NAME", about, "the size follows from the file's name"},
        {"SCALE_NOT_APPLIED", about, "the header has a scale factor of heights that was not applied"},
        {"SCALE_TWICE", about,
         "a scale of heights stands twice and is applied once; between measurements: one seems scaled twice"},
        {"NO_HEIGHT_SCALE", about, "a channel's numbers cannot be made heights"},
        {"SENSITIVITY_MISSING", about, "the header lacks the sensitivity that heights need"},
        {"MASK_NOT_APPLIED", about, "the channel has a mask, which is a selection and removes nothing"},
        {"HIDDEN_MEASUREMENT", about, "the file says that a measurement is not to be shown"},
        {"FORCE_CURVES_NOT_READ", about, "a force volume: its images are read, its force curves by `setae jkr fit`"},
        {"SLOPES_INTEGRATED", about, "the file holds slopes; heights are their integral"},
        {"AMBIGUOUS_COLUMNS", about,
         "columns of numbers without a header that says what they are were taken by their values"},
        {"CHECKSUM", about, "a part of the file differs from its checksum"},
        {"UNREADABLE_ARRAY", about, "an array is packed in a way that cannot be read"},
        {"UNREADABLE_MEMBER", about, "a measurement of a container cannot be read; the others can"},
        {"COPY_DIFFERS", about,
         "a container's processed copy is not its original: rms heights differ by more than 1e-3, or points by ten times as much",
         "fits of trends by other programs stay within a thousandth"},
        {"NO_PROCESSED_COPY", about, "a container's processed copy would need what setae does not do"},
        {"ORIGINAL_MISSING", about, "a container holds a processed copy alone, which was used"},
        {"MALFORMED_FIELD", about, "a field of a container's index is not as its schema says"},
        {"NOT_IN_SCHEMA", about, "a container's index is not what its schema asks for"},
        {"UNKNOWN_FIELD", about, "a container's index has a field that setae does not know"},
        {"NAME_MISSING", about, "a surface of a container had no name and was given one"},
        {"LARGE_MAP", about,
         fmt::format(
             "heights take more than {:g} GiB: read by bands of scan lines, without slope distribution, triangulated "
             "area and arithmetic height",
             static_cast<double>(study::SurfaceAnalysisOptions{}.largest_map) / (1 << 30)),
         "memory that a small computer can spare; --memory sets it"},
        {"UNTESTED_FORMAT", about, "the format is read from its description, no real file was at hand"}};
}

std::vector<AlertKind> of_micrographs() {
    const char* about = "micrographs and contours";
    return {
        {"BAD_CALIBRATION", about, "the size of a pixel that the file states cannot be"},
        {"DEFAULT_CALIBRATION", about, "an MRC states a pixel of 1 Å, which programs write where nobody told them"},
        {"BAD_NUMBER", about, "a field of the header is no number and is left out"},
        {"UNKNOWN_UNIT", about, "the size of a pixel stands in a unit that is no length"},
        {"RECIPROCAL_UNITS", about, "axes are reciprocal lengths: a diffraction pattern"},
        {"PIXELS_NOT_SQUARE", about, "pixels differ in width and height by more than 1e-3; both are used",
         "rounding of pixel sizes in headers"},
        {"PIXEL_SIZE_DISAGREES", about, "two statements of the pixel size differ by more than 1 %",
         "a bar of some hundred pixels is read to one of them"},
        {"SCALE_BAR_UNCONFIRMED", about, "the label of a scale bar was read, and nothing else confirms it"},
        {"SCALE_BAR_AMBIGUOUS", about, "bar or label of the scale can be read in several ways"},
        {"SCALE_BAR_DISAGREES", about, "scale bar and file state different sizes"},
        {"COMPLEX_MAGNITUDE", about, "pixels are complex; their magnitude is read"},
        {"SEVERAL_IMAGES", about, "the file holds several images; one is read"},
        {"STACK", about, "the file holds a stack; one picture of it is read"},
        {"VACUUM_ASSUMED", about, "neither phase has more structure; the bright one was taken for vacuum"},
        {"TWO_EDGES", about, "there are several edges; the longest comes first"},
        {"LOW_CONTRAST", about, "the edge stands out of the noise of a pixel by less than that noise",
         "from there on the noise of a pixel hides the step across the edge, which is found by its neighbours alone"},
        {"SPIKES", about,
         "single points stand out of all their neighbours by more than 6 robust standard deviations, pixels by 8",
         "of pictures 8 robust standard deviations: once in 1e15 pixels of normal noise; of heights: no false alarm on 200 surfaces without fault (diagnostics.md)"},
        {"CLOSED_OUTLINE", about, "the outline is closed; its longest way across was taken"},
        {"REENTRANT", about, "stretches of a contour turn back and are left out"},
        {"FOIL_THICKNESS", about, "the contour is the silhouette of a foil of unknown thickness"},
        {"FOIL_PROJECTION", about,
         "the contour is the silhouette of a foil: waves shorter than 10 times its thickness read low",
         "from there on C1D is 5 % low or more (tem-projection.md)"}};
}

std::vector<AlertKind> of_surfaces() {
    const char* about = "surfaces and spectra";
    return {
        {"UNDEF", about, "points of a measurement or picture are undefined"},
        {"UNDEFINED", about, "heights are undefined or became so; a parameter has no value"},
        {"CLIPPED", about,
         "five points or more have exactly the highest or the lowest height, three times as many as the levels before it",
         "no false alarm on 200 surfaces without fault (diagnostics.md)"},
        {"QUANTISED", about,
         "more than 5 % of neighbours are equal and heights are multiples of one step, or all are equal",
         "no false alarm on 200 surfaces without fault (diagnostics.md)"},
        {"SCARS", about,
         "stretches of 16 points of scan lines stand out of both their neighbours, four times as many as across them",
         "no false alarm on 200 surfaces without fault (diagnostics.md)"},
        {"SCAN_DIRECTION", about,
         "steps of the mean from scan line to scan line vary more than twice as much as along them",
         "no false alarm on 200 surfaces without fault (diagnostics.md)"},
        {"TILT_LARGE", about, "the rms height of the tilt is more than 3 times that of the rest",
         "rms heights mean the tilt from there on; no false alarm on 200 surfaces without fault (diagnostics.md)"},
        {"CURVATURE_LEFT", about,
         "the rms height of the level surface is more than 1.5 times as large by its bow as by the rest",
         "no false alarm on 200 surfaces without fault (diagnostics.md)"},
        {"ANISOTROPIC", about,
         "rms slopes of perpendicular directions differ by more than 10 % (setae check: 15 %), p < 0.01",
         "chance; a stretch of 1.1 changes the rms slope of one direction by 5 %"},
        {"ONE_DIRECTION", about, "a line sees slopes along one direction alone"},
        {"NON_GAUSSIAN", about, "slopes have kurtosis or skewness above 0.5, p < 0.01: (9) assumes neither",
         "chance; an excess kurtosis of 0.5 changes A_true/A_app − 1 by 1 to 2 % at slopes of 0.5 to 1.5"},
        {"PIXEL_NOISE", about, "the spectrum ends in a white floor: noise from point to point"},
        {"TRACE_NOISE", about,
         "noise of a trace was taken off, or hides waves: those left with less than twice its power",
         "the noise is known to 20 %: a tenth of what is left"},
        {"CONTOUR_STEPS", about, "straight segments between points lower a contour's spectrum, which is undone"},
        {"TIP_NOT_CONVERGED", about, "the estimate of a tip from its own scan still sharpened in its last round"},
        {"TIP_BELOW_PIXEL", about, "the apex radius of a tip estimated from its own scan is below the scan's pixel",
         "a parabola through the apex and its neighbours is not resolved by them"},
        {"MAP_NOT_PERIODIC", about,
         "a measured map is repeated in a contact, and its heights do not go on where it meets itself: the step at the seam "
         "is more than twice the step between neighbouring points, or rises like a tilt",
         "a seam changes the area near it alone; a map of many wavelengths has few such places"},
        {"CONTACT_NOT_CONVERGED", about, "pressures of a contact were not found as closely as asked for"},
        {"ADHESION_GRID", about, "pixels catch the edge of an adhesive contact: w dx/(E* ρ²) is above 0.5",
         "works are right to 1 % at 0.5; at 1 opening takes a sixth too much"},
        {"FRONT_THEORY", about,
         "what the theory of a contact's edge as a crack front rests on does not hold: little energy stored beside what is gained, a front "
         "longer than its Larkin length, eight points a wave, no place twice"},
        {"TIP_CUTOFF", about, "waves shorter than the tip shows are cut from the spectrum"},
        {"LOW_Q_GAP", about, "the spectrum still rises at its longest wavelength"},
        {"COVERAGE_GAP", about, "no measurement sees a band of wavelengths between those of others"},
        {"SINGLE_INSTRUMENT_DECADE", about, "one instrument alone sees a decade: nothing checks it"},
        {"SINGLE_MEASUREMENT_DECADE", about,
         "one of several measurements covers a decade: its ± is the scatter of the modes of that measurement"},
        {"DISAGREE", about,
         "spectra of two measurements or instruments differ by more than 3 standard errors where both are reliable",
         "chance: 3 in 1000 for one decade"},
        {"INSTRUMENTS_DISAGREE", about,
         fmt::format("an instrument's χ² in a decade has a probability below {:g} by the fit of the likelihood",
                     spectral_fit::improbable_agreement),
         "χ² of neighbouring decades and instruments is one of many; where they agree its probabilities are spread as they should be (LikelihoodSpectrum.AgreementHasTheProbabilityItSays)"},
        {"MEASUREMENTS_SCATTER", about,
         "an instrument's measurements differ from each other beyond what their waves explain, p < 0.01",
         "chance; intervals allow for the scatter with or without the alert"},
        {"SAME_MEASUREMENT", about,
         "two measurements of a surface, or two loops, hold the same numbers, whatever their files",
         "no two scans of a surface and no two records of a force agree in their noise"},
        {"GAP_BRIDGED", about, "2 % of a polyline's length and more lie in steps of more than 20 times the usual one",
         "a straight line through missing points has no slope of the surface; contours with long straight edges are told, too"},
        {"HEIGHTS_IMPLAUSIBLE", about, "the rms slope is above 100, or the rms height above the extent",
         "no instrument measures such a surface; values that mark missing heights give it"},
        {"MEASURED_SLOPES", about,
         "A_true/A_app follows the slopes that maps show, since more than half of their area carries NON_GAUSSIAN or ANISOTROPIC, or the surface is stretched",
         "the majority of what was seen of the surface"},
        {"STRETCHED", about,
         "features are longer along one direction than across by more than 5 %, which chance does less than once in a "
         "hundred times; the fitted spectrum is the mean over directions",
         "chance; a stretch of 1.05 changes the rms slope by 0.2 % (10 % at 1.5, by the square of its logarithm)"},
        {"FILES_LEFT_OUT", about, "measurements of a surface failed; its spectrum rests on the others"},
        {"WAVES_BEYOND_DATA", about,
         "the surface's waves go on behind the finest data and would add more than 5 % to A_true/A_app − 1",
         "what A_true/A_app − 1 is known to from some twenty measurements (closure.md)"},
        {"BAND_LIMITED", about,
         "waves up to ten times as long as the longest measured would add more than 5 % to h_rms or U_el if the "
         "spectrum goes on as its first decade does",
         "what U_el is known to from some twenty measurements (closure.md)"},
        {"ONE_PLACE", about, "a single measurement cannot tell how places of the surface differ"},
        {"LIKELIHOOD_FAILED", about,
         "the likelihood could not be fitted, or leaves h_rms or h'_rms uncertain by more than a factor of ten either "
         "way; the average stands for it"},
        {"SPECTRUM_CONVERTED", about,
         "a given spectrum's first column holds frequencies or wavelengths, or its density has another normalisation"},
        {"FEW_POINTS", about, "a measurement has too few points in a line for a spectrum to be fitted to it"},
        {"PART_FAILED", about,
         "an elastomer, a pair or a comparison of a study cannot be computed; the rest is complete"},
        {"SPECTRUM_CONVENTION", about, "a given spectrum does not say how its density is normalised"},
        {"SPECTRUM_WITHOUT_ERROR", about, "a given spectrum has no column of standard errors"},
        {"NO_INSTRUMENT", about,
         "what instrument read the heights is not stated; waves down to their sampling are believed"},
        {"NO_TIP_RADIUS", about, "the tip's radius is not stated; waves down to the sampling are believed"},
        {"NOT_CONVERGED", about, "an iteration ended before its change was small: of a fit, a trace, a facet level"},
        {"ROLLOFF_NOT_SEEN", about,
         "the longest waves seen carry more than half as much of the height, a decade, as any do",
         "a factor of two in q² C_iso: on a spectrum with a roll-off inside the data it is below at the longest wave"},
        {"CUTOFF_NOT_SEEN", about, "the self-affine fit's spectrum does not show where it ends",
         "the interval of the cutoff by profile likelihood has no lower end"},
        {"MODEL_MISSES", about, "values scatter about a self-affine model by more than their errors, p < 0.001",
         "chance"},
        {"MODEL_MISSES_BEYOND", about,
         "reliable values outside the range of a self-affine fit are on average above 1.25 times the model or below 0.8, "
         "and more than four standard errors apart from it",
         "1.25: a quarter of C1D changes the rms slope by 12 %; false alarms in docs/validation/spectra.md"},
        {"FIT_AT_BOUND", about, "a parameter of a self-affine fit ended where it is not allowed to go further"},
        {"STEEP_SLOPES", about,
         "the rms slope is above 0.5: the stored energy U_el assumes small slopes, A_true/A_app does not",
         "0.5: there A_true/A_app − 1 by small slopes is 8 % above the exact one"},
        {"RECONSTRUCTION", about, "the spectrum is reconstructed from three published moments"},
        {"SPREAD_INCOMPLETE", about,
         "more than a tenth of what the ± of moments allows is no self-affine spectrum with 0 < H < 1 and is left out"},
        {"FILTER_CUTOFF", about, "a filter's cutoff is shorter than its sampling, or longer than the data, allows"},
        {"CONSTANT", about, "all heights are equal, or differ by less than 1e-15 m (rms)",
         "no instrument distinguishes smaller heights"},
        {"FEW_PATCHES", about, "a map holds fewer than 10 independent patches",
         "standard errors rest on the number of patches and are themselves known to a quarter from there on"},
        {"RAL_UNDEFINED", about, "the autocorrelation of a profile has no decay length"},
        {"SAL_UNDEFINED", about, "the autocorrelation of a map does not decay within it"},
        {"STR_UNDEFINED", about, "the autocorrelation of a map does not decay in every direction"},
        {"STD_WITHOUT_DIRECTION", about, "no direction of texture stands out: Str above 0.5",
         "half way between a lay (0) and none (1)"}};
}

std::vector<AlertKind> of_loops() {
    const char* about = "loops";
    const loops::AlertLimits limits;
    return {
        {"POOR_FIT", about,
         fmt::format("rms residuals above {} of the fitted range, beyond the noise where that is known",
                     percent(limits.relative_residual)),
         "four records of PDMS leave 0.4 to 1.4 %, one of a faulty sensor 2.2 %"},
        {"BEYOND_NOISE", about,
         fmt::format(
             "residuals exceed the noise (χ²_red above 4), follow each other (correlation of neighbours above 0.5) and "
             "exceed {} of the fitted range",
             percent(limits.relative_misfit)),
         "simulated JKR loops with noise of any size or correlation stay below; real contacts rarely do"},
        {"WORK_NEGATIVE", about,
         fmt::format("W would be below 0 by more than {:g} standard errors; 0 is reported", limits.work_deviations),
         "chance: once in 700"},
        {"FORCE_DRIFT", about,
         fmt::format(
             "the zero of force drifts within contact by more than {} of the largest tension; the drift was removed",
             percent(limits.drift_share)),
         "a choice: the ± include what is not known of the drift"},
        {"DRIFT_NOT_LINEAR", about,
         "the zero of force drifts along a curve: means and slopes of free flight differ from a line (χ², p < 0.02)",
         "chance; the curve counts where it leaves the line by 0.3 % of the largest tension"},
        {"DRIFT_IRREGULAR", about,
         "no curve of degree 3 or less describes the drift of the zero of force; the line was removed"},
        {"ONE_BASELINE", about, "free flight is recorded only before or only after contact; its line is extrapolated"},
        {"NOISY_RECORD", about,
         fmt::format("noise of a sample exceeds {} of the largest tension or penetration", percent(limits.noise_share)),
         "of simulated records with 10 % of noise 95 % intervals cover 86 to 99 % (loops.md)"},
        {"STEP_IN_FREE_FLIGHT", about,
         "the force steps in free flight by more than 6 standard errors; only the part next to contact counts",
         "chance"},
        {"STEP_IN_CONTACT", about,
         "the force changes at once within contact, by more than 6 standard errors and 2 % of the largest tension",
         "chance"},
        {"RANGE_SENSITIVE", about,
         fmt::format("W spreads by more than {} over the fit ranges tried", percent(limits.work_spread)),
         "of four records of PDMS two spread by 30 and 85 %, two by less"},
        {"LARGE_STRAIN", about, fmt::format("a/R above {:g}", limits.contact_radius_per_sphere_radius),
         "the parabola of JKR is then off the sphere by a hundredth of the depth"},
        {"THIN_LAYER", about,
         fmt::format("a/h above {:g}; the fits are corrected for it", limits.contact_radius_per_thickness),
         "E* from F–δ would be 12 % high without the correction (contact-models.md)"},
        {"HEIGHT_UNKNOWN", about,
         fmt::format("displacement measured, height of the soft body not given, and a/R above {:g}",
                     limits.contact_radius_per_unknown_height),
         "E* from F–δ is then 1 % high or more if the body is as high as the sphere is wide"},
        {"TABOR_RANGE", about, fmt::format("Tabor parameter below {:g}", limits.tabor_parameter),
         "JKR holds above (Johnson, Greenwood, J. Colloid Interface Sci. 192 (1997) 326)"},
        {"CONTACT_POINT_UNKNOWN", about, "no estimate of the contact point could be made"},
        {"CONTACT_POINT_SPREAD", about,
         fmt::format("estimates of the contact point spread over more than {} of the largest penetration",
                     percent(limits.contact_point_share)),
         "E* goes with the penetration to −3/2: 7.5 %"},
        {"STIFFNESS_UNRESOLVED", about,
         fmt::format("the contact is more than {:g} times stiffer than the machine", limits.stiffness_ratio),
         "a per cent of the machine's stiffness is then ten per cent of the contact's"},
        {"NO_RETRACTION", about, "the record ends before pull-off"},
        {"NO_BASELINE", about, "no free flight before or after contact"},
        {"DRIFT_UNKNOWN", about, "a drift of the zero of force was not looked for"},
        {"LOOP_UNDERSAMPLED", about,
         fmt::format("sampling leaves more than {} of the loop's energy uncertain",
                     percent(limits.loop_sampling_share)),
         "a choice: the error is in the loop's energy all the same"},
        {"TIME_BACKWARDS", about, "time runs backwards"},
        {"FORCE_SATURATED", about, "the force stands still at its end of range"},
        {"FRAME_MISSING", about,
         fmt::format("more than {} of the frames in contact have no radius", percent(limits.frames_missing)),
         "a choice: radii between frames are interpolated"},
        {"UNITS_IMPLAUSIBLE", about,
         fmt::format(
             "radius larger than the sphere's, E* outside {:g} … {:g} Pa, W above {:g} J/m², or W of an adhesive "
             "contact below {:g} J/m²; in a study a value far from what is usual",
             limits.contact_modulus_least, limits.contact_modulus_most, limits.work_of_adhesion_most,
             study::least_work_of_adhesion),
         "gels and diamond; adhesives that flow; contacts in a liquid"},
        {"TWO_CONTACTS", about, "the record holds several contacts"},
        {"SHEET_CHOSEN", about, "a workbook has tables on several sheets; the first with a loop was read"},
        {"COLUMN_GUESSED", about, "a column was taken for what its name and unit say"},
        {"COLUMN_UNUSED", about, "columns of the table play no part"},
        {"CLOCK_DOUBTFUL", about, "the offset found between the clocks of camera and force is doubtful"},
        {"FRAMES_BAD", about, "frames of the recording have no contact radius"},
        {"FRAMES_OUTSIDE", about, "frames lie outside the force record"},
        {"INPUT_LOST", about,
         "a loop analysed with one of its inputs a thousandth off lacks a number that it has without"}};
}

std::vector<AlertKind> of_studies() {
    const char* about = "studies";
    return {
        {"EMPTY_STUDY", about, "the study names no surface and no experiment"},
        {"INPUT_CHANGED", about,
         "another program changed a file of the study during the run; results of it are not kept",
         "device, number, size or a time of the file is another one"},
        {"MODULUS_IMPLAUSIBLE", about, "E is more than 30 times off what the molar mass between crosslinks gives",
         "entanglements raise E of lightly linked networks by less"},
        {"WILL_NOT_CONFORM", about, "(7) gives less than 0"},
        {"CONFORMAL_INVALID", about, "at some wavelengths roughness stores more than it gains"},
        {"NEEDS_PRESSURE", about,
         fmt::format(
             "roughness stores more than {:.2f} of what it gains: it closes under pressure alone and then stays "
             "closed",
             adhesion::closing_energy_share),
         "simulated patches: 99 % of their area touch by themselves up to there, docs/validation/conformity.md"},
        {"PINNING_EXTRAPOLATED", about,
         "k of the pinning models lies outside the simulated fronts: U_el/AW 0.001 to 0.3, N 0.4 N0 to 0.6 … 62",
         "docs/validation/crack-front.md has the range; N counts Larkin lengths along the edge of the contact"},
        {"REFERENCE_INCOMPLETE", about, "a reference's loop is not whole"},
        {"REFERENCE_HYSTERESIS", about,
         "a smooth reference's W_ret at pull-off is not shown to be within [comparison] margin of that of approach",
         "the margin is the user's; 5 mJ/m² by default, a seventh of PDMS on diamond"},
        {"LOSS_CONTRADICTS_WORKS", about,
         "the energy that a loop lost and that which its own W_app and W_ret would lose differ by more than three "
         "standard errors and a fifth",
         "W_ret is read at pull-off; the energy counts the whole retraction"},
        {"SPEED_BEYOND_BULK", about,
         "W_ret at the speed of a pair's edge over W_ret at rest is more than two standard errors above 1 + Σ g of the "
         "relaxation that the study states of the elastomer",
         "1 + Σ g is what the theory of Persson and Brener (Phys. Rev. E 71 (2005) 036123) tends to for a fast crack"},
        {"REFERENCE_LOSS", about,
         "what a smooth reference loses per contact area, beyond the ideal sphere's jumps, is not shown to be below "
         "[comparison] margin",
         "the same margin"}};
}

}  // namespace

bool concerns_reading(const std::string& code) {
    static const auto kinds = of_files();
    return std::any_of(kinds.begin(), kinds.end(), [&](const AlertKind& kind) { return kind.code == code; });
}

std::vector<AlertKind> alert_kinds() {
    std::vector<AlertKind> all;
    for (const auto& kinds : {of_files(), of_micrographs(), of_surfaces(), of_loops(), of_studies()})
        all.insert(all.end(), kinds.begin(), kinds.end());
    return all;
}

}  // namespace setae::output
