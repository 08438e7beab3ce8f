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
         "Heights have exactly a value that marks missing heights. They are undefined unless "
         "keep_values is set.",
         "The message gives the number of these heights, their share, and the range of the others.",
         "If they are heights, set keep_values to true.",
         "The evidence is strong ([undefined-heights.md](undefined-heights.md)); the surfaces "
         "tried there give no false alarm."},
        {"NO_DATA_SUSPECTED", about,
         "Heights have exactly a value that may mark missing heights, or one height is far from "
         "all others. They are kept.",
         "The message gives the number of these heights, their share, and the range of the others.",
         "If they are not heights, add the step `undefine` that the warning names.",
         "The evidence is weaker than for NO_DATA ([undefined-heights.md](undefined-heights.md))."},
        {"LABELS_NOT_HEIGHTS", about,
         "The first row or column of a table contains positions or numbers of rows, not heights. "
         "They are not used as heights.",
         "The map has one row or column less; if both contain positions, they also give its size.",
         "If they are heights, set keep_values to true."},
        {"ROWS_MISSING", about,
         "Steps along a profile of equal steps are two or more times the usual one. The heights "
         "between are undefined.",
         "The message gives the number of missing rows and gaps and the longest step.",
         "Export all rows, with an empty cell where there is no height.",
         "Rows that were left out make whole multiples of a step."},
        {"POSITIONS_REPEATED", about,
         "Several points of a profile have the same position. Rounding hides equal steps, or "
         "heights at equal positions are averaged.",
         "The message gives the number of these points.", "Export the positions with more digits."},
        {"PASSES_SPLIT", about, "The positions of a profile run back and forth. Each pass is a channel.",
         "The message gives the number of passes; only one of them is used.",
         "Choose one with channel; to average passes, analyse several as measurements of one "
         "surface."},
        {"UNIT_ASSUMED", about,
         "The file does not state a unit. The unit that its format implies, or that of another "
         "column, is used.",
         "A wrong unit multiplies all heights or lengths by a factor, often 1000.",
         "Compare the heights with what is known about the surface, or give unit."},
        {"UNIT_GUESSED", about, "A table of a spectrum states no units. SI units are assumed.",
         "A wrong unit changes h_rms, slope and energy by powers of 1000.",
         "Write the units in the header as q [1/m], C1D [m3]."},
        {"UNIT_MISMATCH", about, "Two places state different units.",
         "The message gives both units and the one that was used.",
         "Correct the wrong one, in the file, the index or the study."},
        {"UNIT_PREFIX", about, "The file states heights in a unit with a prefix, which Gwyddion reads as m.",
         "Gwyddion and setae differ in heights by the factor of the prefix.",
         "Check that the program that wrote the file meant this prefix."},
        {"SIZE_MISMATCH", about,
         "A size was given, and the file states another one, which was used. They differ by more "
         "than 1e-4.",
         "The message gives both sizes; wavevectors and slopes change by their ratio.",
         "Check which of the two is right.", "Programs round the sizes that they write."},
        {"SIZE_BETWEEN_POINTS", about,
         "The file states the distance from the first point to the last as its size. The size used "
         "is n/(n − 1) times that.",
         "The two definitions differ by one part in n points.",
         "Compare with the pixel size that the instrument shows."},
        {"SIZE_NOT_STATED", about,
         "The file states a size that is not possible: zero, negative, no number, below 1 fm or "
         "above 10⁹ m.",
         "The file cannot be analysed without a size.", "Give size.",
         "The limits are the size of a nucleus and the distance to the moon: no scan is smaller or "
         "larger."},
        {"CHANNEL_CHOSEN", about, "The file has several channels of heights, and the preferred one was used.",
         "The message lists the channels with heights.", "Choose another channel by number or name with channel."},
        {"SIZE_FROM_NAME", about, "The size follows from the name of the file (latitude of a tile of elevations).",
         "The message gives the length of a degree and its change over the tile.",
         "Give size if the map has another projection."},
        {"SCALE_NOT_APPLIED", about, "The header has a scale factor of heights, which was not applied.",
         "The message gives the factor; heights are wrong by it if it applies.",
         "Compare the range of heights with that in the program of the instrument."},
        {"SCALE_TWICE", about,
         "A scale of heights is stated twice and applied once. Between measurements: one of them "
         "seems to be scaled twice.",
         "The message gives the factor; heights are wrong by it in programs that apply both "
         "scales.",
         "In a container, remove the scale from the index with `setae container write`. Between "
         "measurements, compare with the program of the instrument."},
        {"NO_HEIGHT_SCALE", about, "The numbers of a channel cannot be converted to heights.",
         "The channel cannot be used as heights.", "Export the map again with its calibration."},
        {"SENSITIVITY_MISSING", about, "The header lacks the sensitivity that converts the numbers to heights.",
         "The channel cannot be used as heights.", "Save the file again with the program of the instrument."},
        {"MASK_NOT_APPLIED", about,
         "The channel has a mask, which was not applied. A mask is a selection and removes "
         "nothing.",
         "Points below the mask count like all others.",
         "If the mask marks bad points, remove them in Gwyddion first."},
        {"HIDDEN_MEASUREMENT", about,
         "The file marks a measurement as hidden. It is read as a channel like the others.",
         "It counts in all results like the others.",
         "Check whether it belongs to the others; choose another channel if not."},
        {"FORCE_CURVES_NOT_READ", about, "The file is a force volume. Its images are read, its force curves are not.",
         "Results of the images are not affected.", "Fit the curves with `setae jkr fit`."},
        {"SLOPES_INTEGRATED", about, "The file contains slopes. Heights are their integral.",
         "Mean height and mean slope are arbitrary.", "Subtract a line or the figure of the mirror."},
        {"AMBIGUOUS_COLUMNS", about,
         "Columns of numbers without a header were assigned to positions and heights by their "
         "values.",
         "The message gives the assignment; a wrong choice makes all results meaningless.",
         "Check the shape of the data; set layout if it is wrong."},
        {"CHECKSUM", about, "A part of the file differs from its checksum.",
         "The file was changed or is damaged; sizes and offsets may be wrong.",
         "Check the increments and offsets of the axes."},
        {"UNREADABLE_ARRAY", about, "An array is packed in a way that cannot be read.",
         "This channel is missing; the others are read.",
         "Save the array again without compression, or as the message states."},
        {"UNREADABLE_MEMBER", about, "A measurement of a container cannot be read. The others can.",
         "The spectrum of the surface lacks this measurement.", "Repair or replace the measurement."},
        {"COPY_DIFFERS", about,
         "The processed copy in a container differs from its original: rms heights by more than "
         "1e-3, or single points by ten times as much.",
         "The message gives both rms heights, or the largest difference. The original is used.",
         "Find out which of the two is right.", "Fits of trends by other programs stay within a thousandth."},
        {"NO_PROCESSED_COPY", about,
         "The processed copy of a container needs a filling method that setae does not have. It "
         "was not written.",
         "Programs that read only processed copies lack this measurement.",
         "Use a program that makes the copy from the original."},
        {"ORIGINAL_MISSING", about, "A container has only a processed copy, which was used.",
         "The copy is already scaled, filled and levelled; undefined heights are hidden.",
         "Ask the author of the container for the original."},
        {"MALFORMED_FIELD", about,
         "A field of the index of a container does not have the form that its schema requires. It "
         "is kept, but not used.",
         "What the field states, such as a size or a unit, is missing.", "Correct the index."},
        {"NOT_IN_SCHEMA", about, "The index of a container lacks something that its schema requires.",
         "contact.engineering may refuse the container; results are not affected.", "Complete the index."},
        {"UNKNOWN_FIELD", about,
         "The index of a container has a field that setae does not know. It is kept when the "
         "container is written again.",
         "Results are not affected, unless the name of a known field is misspelled.", "Check its spelling."},
        {"NAME_MISSING", about, "A surface of a container had no name and was given one.", "Only the name is affected.",
         "Give another name with name."},
        {"LARGE_MAP", about,
         fmt::format("Heights need more than {:g} GiB. The map is read by bands of scan lines.",
                     static_cast<double>(study::SurfaceAnalysisOptions{}.largest_map) / (1 << 30)),
         "Slope distribution, triangulated area and arithmetic height are missing; all other "
         "results are unchanged.",
         "Allow more memory to get these results too.", "A small computer can spare this memory."}};
}

std::vector<AlertKind> of_micrographs() {
    const char* about = "micrographs and contours";
    return {
        {"BAD_CALIBRATION", about, "The file states a pixel size that is not possible. It is not used.",
         "The picture has no pixel size.", "Give the pixel size, or calibrate on the scale bar."},
        {"DEFAULT_CALIBRATION", about,
         "An MRC file states a pixel of 1 Å, which programs write if no pixel size is known.",
         "All lengths may be wrong by an arbitrary factor.",
         "Check the pixel size, or give it and ignore the stated one."},
        {"BAD_NUMBER", about, "A field of the header is not a number and is left out.",
         "Only this field, such as a voltage, is missing.",
         "If you need the field, read its value in the program of the microscope."},
        {"UNKNOWN_UNIT", about, "The pixel size has a unit that is not a length. It is not used.",
         "The picture has no pixel size.", "Give the pixel size, or calibrate on the scale bar."},
        {"RECIPROCAL_UNITS", about,
         "The axes are reciprocal lengths: the picture is a diffraction pattern or a Fourier "
         "transform.",
         "The picture contains no contour of a surface.", "Read the image itself."},
        {"PIXELS_NOT_SQUARE", about, "Pixels differ in width and height by more than 1e-3. Both sizes are used.",
         "The message gives both sizes; slopes change by their ratio.",
         "Check the sizes if the camera has square pixels.", "Headers round the sizes of pixels."},
        {"PIXEL_SIZE_DISAGREES", about, "Two statements of the pixel size differ by more than 1 %. The first was used.",
         "The message gives both; lengths change by their ratio.",
         "Compare the picture with the pixel size that the file states.",
         "The length of a bar of some hundred pixels is read to one pixel."},
        {"SCALE_BAR_UNCONFIRMED", about, "The label of a scale bar was read, and nothing else confirms it.",
         "A misread label changes all lengths, for instance by 10 or 1000.",
         "Look at the picture and confirm the length of the scale bar."},
        {"SCALE_BAR_AMBIGUOUS", about, "The bar or its label can be read in several ways. The first reading was used.",
         "The message gives both readings; lengths change by their ratio.", "Give the pixel size."},
        {"SCALE_BAR_DISAGREES", about, "Scale bar and file give different pixel sizes. The first was used.",
         "The message gives both sizes; lengths change by their ratio.",
         "Compare the picture with the pixel size that the file states."},
        {"COMPLEX_MAGNITUDE", about, "The pixels are complex numbers. Their magnitude is read.",
         "The magnitude of a Fourier transform contains no contour of a surface.",
         "If this is a Fourier transform, read the real image."},
        {"SEVERAL_IMAGES", about, "The file contains several images. One of them is read.",
         "The message lists the images and the one that was read.", "Choose another with image, by number or title."},
        {"STACK", about, "The file contains a stack. The first plane is read.",
         "The message gives the number of planes.", "To use another plane, save it as a separate file."},
        {"VACUUM_ASSUMED", about,
         "Neither phase of the picture has more structure than the other. The bright one is taken "
         "as vacuum.",
         "If this is wrong, heights have the opposite sign.", "Set vacuum to bright or dark."},
        {"TWO_EDGES", about, "The picture has several edges. They are sorted by length, and the longest is the first.",
         "The message gives the lengths of the two longest.", "Choose one by its number in segment, or by anchors."},
        {"LOW_CONTRAST", about, "The contrast of the edge is below the noise of a pixel.",
         "The message gives the contrast in units of the noise and the scatter of the positions of "
         "the edge.",
         "Look at the overlay; add anchors where the trace leaves the visible edge.",
         "Below this contrast, a single pixel does not show the step; the edge is found only from "
         "its neighbours."},
        {"SPIKES", about,
         "Single points deviate from all their neighbours by more than 6 robust standard "
         "deviations, pixels by 8.",
         "The message gives their number and, for heights, rms height, slope and C1D with and "
         "without them.",
         "Look at the spikes; remove them (step despike) if they come from the instrument. Pixels "
         "are replaced already.",
         "For pictures, 8 robust standard deviations occur once in 1e15 pixels of normal noise. "
         "For heights, 200 surfaces without fault give no false alarm "
         "([diagnostics.md](diagnostics.md))."},
        {"CLOSED_OUTLINE", about, "The outline is closed. The part from its leftmost to its rightmost point is used.",
         "The message gives the share of the outline that is used.",
         "For a spectrum, trace a straight part of the surface; for the whole outline, use the "
         "parametric statistics."},
        {"REENTRANT", about,
         "Stretches of a contour turn back. A function h(x) cannot describe them, and they are "
         "left out or replaced by their envelope.",
         "The message gives their share of the length.",
         "Look at the curve; if the share exceeds a few per cent, slope and curvature are lower "
         "bounds."},
        {"FOIL_THICKNESS", about, "The contour is the silhouette of a foil of unknown thickness.",
         "C1D is too low for wavelengths below about ten times the thickness.",
         "Give the thickness of the foil; [tem-projection.md](../concepts/tem-projection.md) gives "
         "the size of the effect."},
        {"FOIL_PROJECTION", about,
         "The contour is the silhouette of a foil: C1D is too low at wavelengths below 10 times "
         "its thickness.",
         "C1D is up to a third too low, and the rms slope 1 to 7 %; the likelihood corrects this, "
         "the average does not.",
         "Use the results of the likelihood, or measure thinner foils.",
         "At this wavelength C1D is 5 % too low "
         "([tem-projection.md](../concepts/tem-projection.md))."},
        {"UNTESTED_FORMAT", about,
         "The format is read according to its description and was not tested on an instrument "
         "file.",
         "Heights or sizes may be wrong without another sign of it.",
         "Compare picture and pixel size with those of another program."}};
}

std::vector<AlertKind> of_surfaces() {
    const char* about = "surfaces and spectra";
    return {
        {"UNDEF", about, "Points of a measurement or picture are undefined.",
         "The message gives their number and share.", "Crop ragged borders and fill small holes before transforms."},
        {"UNDEFINED", about, "Heights are undefined or became undefined, or a parameter has no value.",
         "The message gives the number of heights. Spectra interpolate the gaps, which the "
         "likelihood takes into account and the average does not.",
         "Measure again if the gaps are wide; after levelling, reduce the degree or enlarge the "
         "region."},
        {"CLIPPED", about,
         "Five points or more have exactly the highest or the lowest height, three times as many "
         "as the levels next to it.",
         "The message gives their share; heights, skewness and curvature are truncated.",
         "Measure again with a larger range, or mark these points as undefined.",
         "200 surfaces without fault give no false alarm ([diagnostics.md](diagnostics.md))."},
        {"QUANTISED", about,
         "More than 5 % of neighbouring points have equal heights, and heights are multiples of "
         "one step; or all heights are equal.",
         "The message gives the step and what rounding adds to the rms height.",
         "Read a finer channel of the file, or measure with a smaller range.",
         "200 surfaces without fault give no false alarm ([diagnostics.md](diagnostics.md))."},
        {"SCARS", about,
         "Stretches of 16 points of scan lines deviate from both neighbouring lines, four times as "
         "many as across the lines.",
         "The message gives the rms height with and without them.",
         "Remove the strokes (step remove_scars), or scan more slowly.",
         "200 surfaces without fault give no false alarm ([diagnostics.md](diagnostics.md))."},
        {"SCAN_DIRECTION", about,
         "Steps of the mean from scan line to scan line vary more than twice as much as along the "
         "lines.",
         "The message gives the rms offset and its share of the mean square slope along y.",
         "Align the rows (step align_rows), or use C1D along the fast axis only.",
         "200 surfaces without fault give no false alarm ([diagnostics.md](diagnostics.md))."},
        {"TILT_LARGE", about, "The rms height of the tilt is more than 3 times that of the rest.",
         "The message gives the rms height with and without the tilt.", "Subtract a plane, for a line a straight line.",
         "Beyond this ratio the rms height is mainly that of the tilt; 200 surfaces without fault "
         "give no false alarm ([diagnostics.md](diagnostics.md))."},
        {"CURVATURE_LEFT", about,
         "The curvature of the levelled surface contributes more than 1.5 times the rms height of "
         "the rest.",
         "The message gives the radius and the rms height with and without the curvature.",
         "Subtract a parabola unless the form of the sample is what you study.",
         "200 surfaces without fault give no false alarm ([diagnostics.md](diagnostics.md))."},
        {"ANISOTROPIC", about,
         "Rms slopes of perpendicular directions differ by more than 10 % (`setae check`: 15 %), p "
         "< 0.01.",
         "The message gives the ratio of the slopes.",
         "Measure along several directions: 2D parameters computed from line scans assume "
         "isotropy.",
         "The probability excludes chance; a stretch of 1.1 changes the rms slope of one direction "
         "by 5 %."},
        {"ONE_DIRECTION", about, "A line contains slopes along one direction only.",
         "The isotropy that 2D parameters assume cannot be tested.",
         "Measure lines along several directions, or a map."},
        {"NON_GAUSSIAN", about,
         "The slopes have an excess kurtosis or skewness above 0.5, p < 0.01. Eq. 9 for the true "
         "area assumes Gaussian slopes.",
         "The message gives both numbers. An excess kurtosis of 0.5 changes A_true/A_app − 1 by 1 "
         "to 2 % at slopes of 0.5 to 1.5.",
         "Use the triangulated area of maps.",
         "The probability excludes chance; smaller values change A_true/A_app − 1 by less than the "
         "effect above."},
        {"PIXEL_NOISE", about, "The spectrum ends in a white floor: noise that is independent from point to point.",
         "The message gives the rms noise, the wavelength below which it dominates, and the rms "
         "slope with and without it.",
         "End spectra and parameters of slope and curvature above this wavelength, or measure more "
         "slowly and average more."},
        {"TRACE_NOISE", about,
         "The noise of a traced contour was subtracted, or exceeds all waves. The band ends where "
         "the signal falls below twice its power.",
         "The message gives C1D of the noise and the wavelength at which the band ends.",
         "To use shorter waves, take pictures with a higher magnification or less noise.",
         "The noise is known to 20 %, which is a tenth of the remaining signal."},
        {"CONTOUR_STEPS", about,
         "Straight segments between the points of a contour lower its spectrum. This is corrected.",
         "The message gives the share of C1D that remains and the changes of slope and curvature.",
         "Trace with finer steps, or choose segments if the polyline itself is the surface."},
        {"TIP_NOT_CONVERGED", about, "The estimate of a tip from its own scan still became sharper in its last round.",
         "The tip may be sharper than the estimate.", "Allow more rounds."},
        {"TIP_BELOW_PIXEL", about,
         "The apex radius of a tip estimated from its own scan is below the pixel size of the "
         "scan.",
         "The message gives both; the radius is only an upper limit.",
         "Use the pixel size as an upper limit of the radius, or scan with smaller pixels.",
         "The neighbours of the apex cannot resolve a parabola through it."},
        {"MAP_NOT_PERIODIC", about,
         "A measured map is repeated in a contact, and its heights do not match at the seam. The "
         "step at the seam is more than twice that between neighbouring points, or rises like a "
         "tilt.",
         "The message gives both steps. A seam changes only the area next to it.",
         "Set edges to windowed, or to periodic if the surface is periodic; with free, nothing "
         "touches beyond the map.",
         "A map of many wavelengths has few points at the seam."},
        {"CONTACT_NOT_CONVERGED", about, "The pressures of a contact were not found to the tolerance.",
         "The message gives the remaining error.",
         "Increase the tolerance, or resolve the surface and the range of attraction with more "
         "points."},
        {"ADHESION_GRID", about, "Pixels trap the edge of an adhesive contact: w dx/(E* ρ²) is above 0.5.",
         "The message gives the number. At 1, opening needs a sixth too much work.",
         "Use smaller pixels, or a longer range of attraction.", "Works of adhesion are right to 1 % at 0.5."},
        {"FRONT_THEORY", about,
         "A condition of the crack-front theory of a contact edge is not met. The theory assumes "
         "little stored energy compared with the gained energy, a front longer than its Larkin "
         "length, eight points per wave, and no place twice.",
         "The message gives the number and its limit.",
         "Follow the message; [crack-front.md](../concepts/crack-front.md) explains the "
         "conditions."},
        {"TIP_CUTOFF", about, "Waves shorter than the tip can resolve are removed from the spectrum.",
         "The message gives the wavelength and the end of the band.",
         "Use a sharper tip, or another instrument for these wavelengths."},
        {"LOW_Q_GAP", about, "The spectrum still rises at its longest wavelength.",
         "The message gives the factor by which the rms height would grow in a scan ten times as "
         "long.",
         "Give the rms height together with the scan size, or measure larger scans until C1D "
         "becomes flat."},
        {"COVERAGE_GAP", about, "No measurement covers a band of wavelengths between those of others.",
         "The message gives the band; integrals bridge it by a power law.", "Measure these wavelengths."},
        {"SINGLE_INSTRUMENT_DECADE", about, "Only one instrument covers a decade of the spectrum.",
         "A wrong scale or tip of this instrument remains unnoticed in this decade.",
         "Measure this decade with a second instrument."},
        {"SINGLE_MEASUREMENT_DECADE", about,
         "Only one of several measurements covers a decade. Its ± is the scatter of the modes of "
         "this measurement.",
         "The ± does not contain the variation between places of the surface.",
         "Measure this decade at three places or more."},
        {"DISAGREE", about,
         "Spectra of two measurements or instruments differ by more than 3 standard errors where "
         "both are reliable.",
         "The message gives the ratio of their C1D.", "Check scale, unit, tip, noise and reliable bands of both.",
         "Chance gives 3 in 1000 for one decade."},
        {"INSTRUMENTS_DISAGREE", about,
         fmt::format("The χ² of an instrument in a decade has a probability below {:g} according to the fit of "
                     "the likelihood.",
                     spectral_fit::improbable_agreement),
         "The message gives the ratio of its periodograms to the fit.",
         "Check calibration, tip radius and tip shape of this instrument; compare its own spectrum "
         "with the others.",
         "Several decades and instruments are tested; where they agree, the probabilities are "
         "distributed as expected (test LikelihoodSpectrum.AgreementTestHasTheStatedProbability)."},
        {"MEASUREMENTS_SCATTER", about,
         "The measurements of an instrument differ from each other more than their waves explain, "
         "p < 0.01.",
         "The message gives the scatter in power. The intervals include it, with or without this "
         "warning.",
         "Measure more places.", "The probability excludes chance."},
        {"SAME_MEASUREMENT", about,
         "Two measurements of a surface, or two loops, contain the same numbers, whatever their "
         "files are called.",
         "The message gives the number of different ones. Intervals are too narrow by up to the "
         "square root of the ratio.",
         "List each measurement and each loop once.",
         "No two scans of a surface and no two records of a force have the same noise."},
        {"GAP_BRIDGED", about,
         "2 % or more of the length of a polyline lie in steps of more than 20 times the usual "
         "one.",
         "The message gives the share. Slopes and curvatures are too low.",
         "Export all points, or list the parts as separate measurements.",
         "A straight line through missing points does not have the slopes of the surface. Contours "
         "with long straight edges are reported, too."},
        {"HEIGHTS_IMPLAUSIBLE", about, "The rms slope is above 100, or the rms height above the extent.",
         "The message gives both; results of this measurement have no meaning.",
         "Look at the heights (`setae info --preview`); mark missing heights, or state the unit.",
         "No instrument measures such a surface; values that mark missing heights cause it."},
        {"MEASURED_SLOPES", about,
         "A_true/A_app is computed from the measured distribution of slopes, not from Eq. 9. More "
         "than half of the measured area has the warning NON_GAUSSIAN or ANISOTROPIC, or the "
         "surface is stretched.",
         "The message gives A_true/A_app − 1 relative to Eq. 9.",
         "To compare with Eq. 9, use true_area_ratio_gaussian.", "This is the majority of the measured surface."},
        {"STRETCHED", about,
         "Features are longer along one direction than across it by more than 5 %, which chance "
         "causes less than once in a hundred times. The fitted spectrum is the mean over "
         "directions.",
         "The message gives the stretch and its direction.",
         "Give the direction of each file if it is not x for all files.",
         "A stretch of 1.05 changes the rms slope by 0.2 % (10 % at 1.5, by the square of its "
         "logarithm)."},
        {"FILES_LEFT_OUT", about, "Measurements of a surface failed. Its spectrum uses the others.",
         "The message gives their number and names.", "Repair the files, or remove them from the study."},
        {"WAVES_BEYOND_DATA", about,
         "Waves of the surface shorter than the finest data would add more than 5 % to "
         "A_true/A_app − 1.",
         "The message gives what they would add to the rms slope, A_true/A_app − 1 and U_el.",
         "Measure at smaller scales, or give surface_shortest_wavelength.",
         "Some twenty measurements determine A_true/A_app − 1 to 5 % "
         "([closure.md](../validation/closure.md))."},
        {"BAND_LIMITED", about,
         "Waves longer than the measured ones would add more than 5 % to h_rms or U_el. The "
         "spectrum is continued as in its first decade, to ten times the longest wavelength.",
         "The message gives what they would add to h_rms and U_el.",
         "Measure a larger area of the surface; if these waves are longer than the contact, set "
         "longest_wavelength.",
         "Some twenty measurements determine U_el to 5 % ([closure.md](../validation/closure.md))."},
        {"ONE_PLACE", about, "A surface has a single measurement, which shows no variation between places.",
         "The ± holds for other places only if the surface is the same everywhere.", "Measure three places or more."},
        {"LIKELIHOOD_FAILED", about,
         "The likelihood could not be fitted, or leaves h_rms or h'_rms uncertain by more than a "
         "factor of ten either way. The average replaces it.",
         "The message gives the reason. All results are those of the average over measurements.",
         "Check units and tips of the measurements, then repeat the analysis."},
        {"SPECTRUM_CONVERTED", about,
         "The first column of a given spectrum contains frequencies or wavelengths, or its density "
         "has another normalisation. It was converted.",
         "The message gives the conversion and the resulting h_rms.",
         "Name the columns q and C1D if that is what they contain, or describe them in unit."},
        {"FEW_POINTS", about,
         "A measurement has too few points in a line. It is used in the average, but not in the "
         "fitted spectrum.",
         "The message gives the number of points and the limit.",
         "Measure with more points, or remove the measurement from the study."},
        {"PART_FAILED", about,
         "An elastomer, a pair or a comparison of a study cannot be computed. All other results "
         "are complete.",
         "The message gives the reason.", "Check the values that this part uses."},
        {"SPECTRUM_CONVENTION", about,
         "A given spectrum does not state how its density is normalised. A convention is assumed.",
         "The message gives the convention and the resulting h_rms; other conventions differ by "
         "factors of 2 or 2π.",
         "Name the columns q and C1D, or describe them in unit."},
        {"SPECTRUM_WITHOUT_ERROR", about, "A given spectrum has no column of standard errors.",
         "The ± of all results leave the error of the spectrum out.", "Fill a third column, standard_error [m3]."},
        {"NO_INSTRUMENT", about,
         "The instrument that measured the heights is not stated. All waves down to the sampling "
         "are used.",
         "The message gives this wavelength. Waves that the instrument cannot resolve bias slope "
         "and curvature.",
         "Set instrument, and tip_radius or resolution."},
        {"NO_TIP_RADIUS", about, "The radius of the tip is not stated. All waves down to the sampling are used.",
         "The message gives this wavelength. Waves that the tip cannot resolve bias slope and "
         "curvature.",
         "Set tip_radius."},
        {"NOT_CONVERGED", about, "An iteration ended before its change was small: in a fit, a trace or a facet level.",
         "The values are not those of the optimum.", "Do not use these values; follow the action of the warning."},
        {"ROLLOFF_NOT_SEEN", about,
         "The longest measured waves contribute more than half as much to the height, per decade, "
         "as any others.",
         "Rms height and stored energy contain only the measured waves.", "Scan longer until C1D is flat.",
         "The limit is a factor of two in q² C_iso, which is lower at the longest wave of a "
         "spectrum with a roll-off inside the data."},
        {"CUTOFF_NOT_SEEN", about, "The spectrum of a self-affine fit does not show its short cutoff.",
         "The message gives the upper end of the cutoff; curvature depends on it.",
         "Measure with a sharper instrument, or fit without a short cutoff.",
         "The interval of the cutoff by profile likelihood has no lower end."},
        {"MODEL_MISSES", about, "Values scatter about a self-affine model by more than their errors, p < 0.001.",
         "The message gives the factor, by which the standard errors are multiplied.",
         "Look at the residuals; narrow the range to where one power law holds.", "The probability excludes chance."},
        {"MODEL_MISSES_BEYOND", about,
         "Reliable values outside the range of a self-affine fit are on average above 1.25 times "
         "the model or below 0.8, and more than four standard errors away.",
         "The message gives the ratio to the model. The fit holds only within its range.",
         "Fit both ranges separately (fit_range) and compare their H, or limit the reliable band "
         "(tip_radius, resolution).",
         "A quarter of C1D changes the rms slope by 12 %; false alarms are in "
         "[spectra.md](../validation/spectra.md)."},
        {"FIT_AT_BOUND", about, "A parameter of a self-affine fit ended at the limit of its range.",
         "The message names the parameter. The model does not fit these values.",
         "Choose a range in which C1D is one power law, or one power law with a roll-off."},
        {"STEEP_SLOPES", about,
         "The rms slope is above 0.5. The stored energy U_el assumes small slopes; A_true/A_app "
         "does not.",
         "U_el is approximate, and so are works of adhesion that contain it.", "Use U_el and these works as estimates.",
         "At 0.5, A_true/A_app − 1 for small slopes is 8 % above the exact value."},
        {"RECONSTRUCTION", about, "The spectrum is reconstructed from three published moments.",
         "Rms height, slope and curvature are fixed by the data; the stored energy is that of the "
         "model.",
         "Use the stored energy as a model value, or give the spectrum itself."},
        {"SPREAD_INCOMPLETE", about,
         "More than a tenth of the values that the ± of the moments allow belong to no self-affine "
         "spectrum with 0 < H < 1. They are left out.",
         "The standard errors are too small by this contribution.",
         "Give the spectrum itself with its errors (power_spectrum) instead of its moments."},
        {"FILTER_CUTOFF", about,
         "The cutoff of a filter is shorter than its sampling, or longer than the data, allows.",
         "The message gives the cutoff in pixels, or the length of the data.",
         "Choose a cutoff of at least 5 pixels, or a shorter one than the data."},
        {"CONSTANT", about, "All heights are equal, or differ by less than 1e-15 m (rms).",
         "The measurement has no spectrum and no roughness.",
         "Leave the file out, check that the right channel was read, or state the unit of its "
         "heights.",
         "No instrument can distinguish smaller heights."},
        {"FEW_PATCHES", about, "A map contains fewer than 10 independent patches.",
         "The message gives their number. Below it the standard errors themselves are uncertain by "
         "more than a quarter.",
         "Measure a larger map, or remove long waves with an L-filter.",
         "Standard errors follow from the number of patches."},
        {"RAL_UNDEFINED", about, "The autocorrelation of a profile has no decay length.", "Ral is missing.",
         "Resample a polyline; if all heights are equal, check that the right channel was read."},
        {"SAL_UNDEFINED", about, "The autocorrelation of a map does not decay within the map.",
         "Sal and Str are missing.", "Measure a larger map, or remove long waves with an L-filter."},
        {"STR_UNDEFINED", about, "The autocorrelation of a map does not decay in every direction.",
         "The message gives an upper limit of Str.",
         "Measure a larger map; straight lines without end have Str near 0."},
        {"STD_WITHOUT_DIRECTION", about, "No direction of the texture is distinct: Str is above 0.5.",
         "The message gives Str; Std has little meaning.", "Use Std only where Str is below 0.5.",
         "The limit is half way between Str of a directional texture, 0, and that of an isotropic one, 1."}};
}

std::vector<AlertKind> of_loops() {
    const char* about = "loops";
    const loops::AlertLimits limits;
    return {
        {"POOR_FIT", about,
         fmt::format("The rms residual is above {} of the fitted range and beyond the noise, where the noise "
                     "is known.",
                     percent(limits.relative_residual)),
         "The message gives the residual and its share of the fitted range.",
         "Look at the residuals; after a slip, a second contact, drift or a sensor fault, E* and W "
         "have no meaning.",
         "Four records of PDMS leave 0.4 to 1.4 %, one of a faulty sensor 2.2 %."},
        {"BEYOND_NOISE", about,
         fmt::format("Residuals exceed the noise (χ²_red above 4), neighbouring residuals are correlated "
                     "(above 0.5), and they exceed {} of the fitted range.",
                     percent(limits.relative_misfit)),
         "The message gives the residual and χ²_red.",
         "Look at the residuals; report E* and W with their fit range, on which they depend.",
         "Simulated JKR loops with noise of any size or correlation stay below; real contacts "
         "rarely do."},
        {"WORK_NEGATIVE", about,
         fmt::format("The fit would give a W below 0 by more than {:g} standard errors; 0 is reported.",
                     limits.work_deviations),
         "The message gives the value of the fit.",
         "Check the zero of force, the contact point and the stiffness of the testing machine.",
         "Chance gives this once in 700."},
        {"FORCE_DRIFT", about,
         fmt::format("The zero of force drifts within contact by more than {} of the largest tension. The "
                     "drift was removed.",
                     percent(limits.drift_share)),
         "The message gives the drift; the ± of all results include its uncertainty.",
         "Let the sensor settle before the record starts.", "The limit is a choice; the ± do not depend on it."},
        {"DRIFT_NOT_LINEAR", about,
         "The zero of force does not drift linearly: means and slopes of free flight differ from a "
         "line (χ², p < 0.02). A polynomial was removed.",
         "The message gives the largest distance from a line within contact.",
         "Let the sensor settle before the record starts, or record faster.",
         "The probability excludes chance; a polynomial counts if it differs from the line by 0.3 "
         "% of the largest tension."},
        {"DRIFT_IRREGULAR", about,
         "No polynomial of degree 3 or less describes the drift of the zero of force. A line was "
         "removed.",
         "Forces may be off by up to the ± that is reported.", "Look for a step of the sensor."},
        {"ONE_BASELINE", about,
         "Free flight is recorded only before or only after contact. A line is extrapolated from "
         "there.",
         "The message gives the error of the zero of force at the other end of contact.",
         "Record free flight before and after contact; set drift to none if the sensor is known "
         "not to drift."},
        {"NOISY_RECORD", about,
         fmt::format("The noise of a sample exceeds {} of the largest tension or penetration.",
                     percent(limits.noise_share)),
         "The message gives the noise. 95 % intervals cover the true value in 86 to 99 % of cases.",
         "Average over neighbouring samples, or record more slowly.",
         "The coverage is that of simulated records with 10 % of noise "
         "([loops.md](../concepts/loops.md))."},
        {"STEP_IN_FREE_FLIGHT", about,
         "The force steps in free flight by more than 6 standard errors. Only the part next to "
         "contact is used.",
         "The message gives the size and the place of the step.",
         "Check the sensor; look for other steps within contact.", "The size excludes chance."},
        {"STEP_IN_CONTACT", about,
         "The force changes at once within contact, by more than 6 standard errors and 2 % of the "
         "largest tension.",
         "The message gives the size and the place of the step.",
         "Do not use E*, W and the energy of this loop until the step is explained.", "The size excludes chance."},
        {"RANGE_SENSITIVE", about,
         fmt::format("W varies by more than {} over the fit ranges that were tried.", percent(limits.work_spread)),
         "The message gives the smallest and the largest W.", "Report W together with its fit range.",
         "In four records of PDMS, two vary by 30 and 85 %, two by less."},
        {"LARGE_STRAIN", about,
         fmt::format("The contact is large: a/R is above {:g}.", limits.contact_radius_per_sphere_radius),
         "The message gives the difference between sphere and paraboloid.",
         "Reduce the load, or treat E* and W as those of an effective paraboloid.",
         "The paraboloid of JKR then differs from the sphere by a hundredth of the depth."},
        {"THIN_LAYER", about,
         fmt::format("The soft body is thin: a/h is above {:g}. The fits are corrected for it.",
                     limits.contact_radius_per_thickness),
         "The message gives the error of E* without the correction.",
         "If the soft body is not a layer bonded to a rigid base, use a higher body or a smaller "
         "load.",
         "E* from force and displacement would be 12 % too high without the correction "
         "([contact-models.md](../concepts/contact-models.md))."},
        {"HEIGHT_UNKNOWN", about,
         fmt::format("The displacement is measured, the height of the soft body is not given, and a/R is above "
                     "{:g}.",
                     limits.contact_radius_per_unknown_height),
         "The message gives the error of E* for two heights.", "Give lens_height or layer_thickness.",
         "E* from force and displacement is then 1 % too high or more if the body is as high as "
         "the sphere is wide."},
        {"TABOR_RANGE", about, fmt::format("The Tabor parameter is below {:g}.", limits.tabor_parameter),
         "The message gives the Tabor parameter. E* and W of JKR are biased below the limit.",
         "Fit maugis_dugdale, or dmt if the Tabor parameter is below 0.1.",
         "JKR holds above (Johnson, Greenwood, J. Colloid Interface Sci. 192 (1997) 326)."},
        {"CONTACT_POINT_UNKNOWN", about, "No estimate of the contact point could be made.",
         "Fits of force against displacement are missing; the message gives the reason.",
         "Choose another estimator of the contact point, or give the contact point."},
        {"CONTACT_POINT_SPREAD", about,
         fmt::format("Estimates of the contact point spread over more than {} of the largest penetration.",
                     percent(limits.contact_point_share)),
         "The message gives the spread and each estimate.",
         "Check the drift and the compliance of the testing machine; E* and W change with the "
         "contact point.",
         "E* varies with the penetration to the power −3/2, which gives 7.5 %."},
        {"STIFFNESS_UNRESOLVED", about,
         fmt::format("The contact is more than {:g} times stiffer than the testing machine.", limits.stiffness_ratio),
         "The message gives both stiffnesses and the error of the penetration.",
         "Use E* as a lower bound only; measure with a stiffer sensor or a softer sample.",
         "An error of one per cent in the stiffness of the testing machine is then ten per cent of "
         "that of the contact."},
        {"NO_RETRACTION", about, "The record ends before pull-off.",
         "W_ret, the pull-off force and the energy of the loop are missing.",
         "Record the retraction to pull-off and beyond."},
        {"NO_BASELINE", about, "The record has no free flight before or after contact.",
         "The forces are used without a correction of their zero; their drift is unknown.",
         "Record free flight before or after contact, or check that the zero of force is right."},
        {"DRIFT_UNKNOWN", about, "No drift of the zero of force was removed.", "Forces may be off by the drift.",
         "Leave the drift setting at its default, so that the drift is found and removed."},
        {"LOOP_UNDERSAMPLED", about,
         fmt::format("The sampling leaves more than {} of the loop energy uncertain.",
                     percent(limits.loop_sampling_share)),
         "The message gives the error, which the ± of the energy includes.",
         "Record more samples per second, above all at jump-in and pull-off.",
         "The limit is a choice; the ± do not depend on it."},
        {"TIME_BACKWARDS", about, "Time runs backwards in the record.",
         "The drift is computed along the sample number; speeds have no meaning.",
         "Sort the rows, or split a file that contains several records."},
        {"FORCE_SATURATED", about, "The force stays at the end of its range.",
         "The message gives the samples, which every fit leaves out; the loop energy lacks the "
         "forces beyond.",
         "Use a larger range of the force sensor."},
        {"FRAME_MISSING", about,
         fmt::format("More than {} of the frames in contact have no contact radius.", percent(limits.frames_missing)),
         "The message gives the share and the longest gap; radii are interpolated.", "Look at the images of the gap.",
         "The limit is a choice."},
        {"UNITS_IMPLAUSIBLE", about,
         fmt::format("A value is far outside its usual range: a contact radius above that of the sphere, E* "
                     "outside {:g} … {:g} Pa, or W above {:g} J/m². In a study, W of an adhesive contact must "
                     "also be above {:g} J/m².",
                     limits.contact_modulus_min, limits.contact_modulus_max, limits.work_of_adhesion_max,
                     study::min_work_of_adhesion),
         "The message gives the likely factor, a power of 1000.",
         "Check the units of the columns and of the sphere radius.",
         "The limits include gels and diamond, adhesives that flow, and contacts in "
         "a liquid."},
        {"TWO_CONTACTS", about, "The record contains several contacts. Each is analysed.",
         "The results of the record are those of the first contact.",
         "Split the file, or use the results of the contact you need."},
        {"SHEET_CHOSEN", about, "A workbook has tables on several sheets. The first one with a loop was read.",
         "The message lists the other sheets.",
         "Read another sheet with `setae jkr import --sheet NAME`, or with a mapping file that "
         "names it."},
        {"COLUMN_GUESSED", about,
         "A column was assigned to force, displacement, contact radius or time by its name and "
         "unit.",
         "A wrong assignment makes all results meaningless.",
         "Check the message; set columns to assign another column."},
        {"COLUMN_UNUSED", about, "Columns of the table are not used.", "The message names them.",
         "If one of them is force, displacement, contact_radius or time, name it so."},
        {"CLOCK_DOUBTFUL", about, "The offset found between the clocks of camera and force is doubtful.",
         "The message gives the offset and the reason; contact radii may belong to other forces.",
         "Compare jump-in and pull-off in both records and give the offset."},
        {"FRAMES_BAD", about, "Frames of the recording have no contact radius.",
         "The message gives their number; the radii are missing there.",
         "Look at these frames in the overlay of `setae jkr radius`."},
        {"FRAMES_OUTSIDE", about, "Frames lie outside the force record.",
         "The message gives their number; they are not used.", "Check the clock offset."},
        {"INPUT_LOST", about,
         "A loop analysed with one of its inputs changed by a thousandth lacks a result that it "
         "has without the change.",
         "The standard error of this input is missing in all results of the loop.",
         "Set the segments in segments, or look at the warnings of the loop."}};
}

std::vector<AlertKind> of_studies() {
    const char* about = "studies";
    return {
        {"EMPTY_STUDY", about, "The study names no surface and no experiment.", "The study has no results.",
         "Add [surfaces.NAME] or [[experiments]]."},
        {"INPUT_CHANGED", about,
         "Another program changed a file of the study during the run. Device, number, size or a "
         "time of the file differ.",
         "Results may be those of the old or of the new content; they are not kept for later runs.",
         "Wait until the file is complete, then run the study again."},
        {"MODULUS_IMPLAUSIBLE", about,
         "E differs by more than a factor of 30 from the value that the molar mass between "
         "crosslinks gives.",
         "The message gives both moduli.", "Check the unit of the modulus and of the molar mass between crosslinks.",
         "Entanglements raise E of lightly linked networks by less."},
        {"WILL_NOT_CONFORM", about, "The full-contact balance (Eq. 7) gives a negative value.",
         "The message gives this value and what partial contact gains.",
         "Use the values of partial contact: area and energy of full contact do not apply "
         "([conformity.md](../concepts/conformity.md))."},
        {"CONFORMAL_INVALID", about, "At some wavelengths roughness stores more energy than contact gains.",
         "The message gives the range of wavelengths.",
         "Do not use area and energy of full contact at these wavelengths, where the solid rather "
         "forms bridges."},
        {"NEEDS_PRESSURE", about,
         fmt::format("Roughness stores more than {:.2f} of the energy that contact gains. Full contact needs "
                     "pressure, and then remains.",
                     adhesion::closing_energy_share),
         "The message gives the range of wavelengths and the pressure for 99 % contact.",
         "Press harder, or compare with loops at other loads: contact measured on approach may be "
         "partial.",
         "On simulated patches, 99 % of the area come into contact spontaneously below this share "
         "([conformity.md](../validation/conformity.md))."},
        {"PINNING_EXTRAPOLATED", about,
         "k of the pinning models is outside the range of the simulated fronts: U_el/AW 0.001 to "
         "0.3, N 0.4 N0 to 0.6 … 62.",
         "The standard error of k includes the distance from this range.",
         "Use the pinning models as estimates for these pairs.",
         "[crack-front.md](../validation/crack-front.md) gives the range; N is the number of "
         "Larkin lengths along the edge of the contact."},
        {"REFERENCE_INCOMPLETE", about, "The loop of a smooth reference is not complete.",
         "The reference contributes no W_ret and no loss.",
         "Record the whole loop of a reference, including the retraction."},
        {"REFERENCE_HYSTERESIS", about,
         "W_ret of a smooth reference at pull-off is not shown to be within the margin "
         "([comparison] margin) of its W_app.",
         "The message gives the difference and its share of the hysteresis on rough surfaces.",
         "Compare speeds and holds, and subtract this part before drawing conclusions about "
         "roughness.",
         "The user chooses the margin; the default of 5 mJ/m² is a seventh of W of PDMS on "
         "diamond."},
        {"LOSS_CONTRADICTS_WORKS", about,
         "The energy that a loop lost differs from the loss computed with its own W_app and W_ret "
         "by more than three standard errors and a fifth.",
         "The message gives both energies.",
         "Look at G(a) along the retraction, and use energies from the loops instead of the works.",
         "W_ret is measured at pull-off; the energy includes the whole retraction."},
        {"SPEED_BEYOND_BULK", about,
         "W_ret at the speed of the contact edge, relative to W_ret at rest, exceeds 1 + Σ g by "
         "more than two standard errors. Here g are the terms of the relaxation that the study "
         "states for the elastomer.",
         "The message gives the ratio and the limit.",
         "Measure the modulus at higher frequencies, or take the speed dependence from the "
         "references.",
         "The theory of Persson and Brener (Phys. Rev. E 71 (2005) 036123) tends to 1 + Σ g for a "
         "fast crack."},
        {"REFERENCE_LOSS", about,
         "The loss of a smooth reference is not shown to be below the margin ([comparison] "
         "margin). The loss is per unit contact area, beyond the jumps of an ideal sphere.",
         "The message gives the loss and the margin.",
         "Check speed, drift and the sphere: part of the loss of the rough loops is not due to "
         "roughness.",
         "The margin is that of REFERENCE_HYSTERESIS."}};
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
