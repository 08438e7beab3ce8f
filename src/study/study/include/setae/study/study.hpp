// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "setae/adhesion/work_of_adhesion.hpp"
#include "setae/core/units.hpp"
#include "setae/loops/analysis.hpp"
#include "setae/roughness/spectral_moments.hpp"
#include "setae/spectra/combination.hpp"
#include "setae/spectra/options.hpp"
#include "setae/spectral_fit/likelihood_spectrum.hpp"
#include "setae/study/loop_models.hpp"
#include "setae/study/loop_source.hpp"
#include "setae/tables/power_spectrum_table.hpp"
#include "setae/topography/detrend.hpp"
#include "setae/topography/measurement.hpp"

namespace setae::study {

/// Heights without a file. They are not stored between runs, because a store key needs the content of a file.
struct HeightsInMemory {
    /// returns a copy of the heights [m]; empty without heights in memory
    std::function<topography::Measurement()> read;

    template <class Archive>
    void serialize(Archive&) {}
};

/// One file of a surface and its processing before analysis.
struct MeasurementInput {
    std::string file;  ///< path, relative to the study file where not absolute; for heights in memory their name
    std::optional<std::string>
        channel;             ///< number from 0 or name; default: the preferred one, for a container every one
    std::string instrument;  ///< type: "stylus", "afm", "tem", "optical"
    std::optional<Estimate> tip_radius;      ///< [m]
    std::string tip_shape;                   ///< "sphere", "cone", "paraboloid"; empty: sphere
    std::optional<double> tip_half_angle;    ///< half angle of a cone [rad]
    std::optional<std::string> tip_file;     ///< map of the tip, apex up
    std::optional<Estimate> foil_thickness;  ///< thickness of the foil of a projection, along the beam [m]
    std::optional<Estimate>
        height_calibration;  ///< true heights divided by those of the file, > 0; the data are multiplied by it
    /// true lengths along the surface divided by those of the file; for a contour along x
    std::optional<Estimate> lateral_calibration;
    std::optional<double> numerical_aperture;  ///< for an optical profiler, with …
    std::optional<double> light_wavelength;    ///< … the mean wavelength of its light [m]
    std::optional<double> resolution;          ///< [m]
    std::optional<topography::Trend>
        trend;  ///< default: none where `steps` level, else that stated by the container, else by instrument
    double direction = 0.0;                   ///< direction of its lines (x of a map) on the surface [rad]
    std::vector<std::string> references;      ///< scans of a smooth reference: the instrument's artefact
    std::optional<std::string> unit;          ///< where the file does not state it
    std::optional<std::vector<double>> size;  ///< [m], where the file does not state it
    std::string layout;        ///< for text with ambiguous columns: "matrix", "columns"; empty: from the numbers
    bool keep_values = false;  ///< whether values that mark missing heights are kept as heights
    std::optional<std::string> pipeline;  ///< file of `steps`
    std::vector<std::string> steps;       ///< processing before analysis, each in the form of step_from_text()
    HeightsInMemory in_memory = {};       ///< in place of the file
};

/// Published moments in place of measurements.
struct PublishedMoments {
    Estimate rms_height;        ///< [m]
    Estimate rms_slope;         ///< [1]
    Estimate rms_curvature;     ///< [1/m]
    Estimate short_wavevector;  ///< q_s of the reconstruction [1/m]
};

/// A rough surface: exactly one of measurements, power_spectrum and moments is given.
struct SurfaceInput {
    std::string name;
    std::string description;
    std::vector<MeasurementInput> measurements;
    std::optional<std::string> power_spectrum;  ///< file with columns q, C1D
    tables::SpectrumUnits spectrum_units = {};  ///< units where the header has none
    std::optional<PublishedMoments> moments;
};

/// γ1 against stretched area, and its form in the balance with a strain-dependent surface energy (Eq. 6): by the end
/// states, where it cancels, or as printed in [D19], Eqs. 5 and 6.
struct StretchedSurfaceEnergy {
    enum class Form { end_states, printed };
    adhesion::SurfaceEnergyLaw law;
    Form form = Form::end_states;
};

/// G(v) = W_ret [1 + (v/v0)^n] of an elastomer's edge, where it is stated.
struct StatedEdgeSpeed {
    Estimate reference_speed;  ///< v0 [m/s]
    Estimate exponent;         ///< n
};

/// One term of an elastomer's relaxation, E(t)/E∞ = 1 + Σ g e^(−t/τ).
struct StatedRelaxation {
    Estimate share;  ///< g
    Estimate time;   ///< τ [s]
};

/// A soft solid.
struct ElastomerInput {
    std::string name;
    Estimate youngs_modulus;  ///< [Pa]; 0 where loops determine it
    Estimate poisson_ratio{.value = 0.5, .standard_error = 0.0};
    Estimate surface_energy;  ///< γ1 [J/m²]
    std::optional<StretchedSurfaceEnergy> surface_energy_law;
    std::optional<double> interface_change;  ///< χ of γ1s2 − γ12 = χ (r − 1) [J/m²]
    std::optional<Estimate> sphere_radius;   ///< [m]
    std::optional<Estimate> sphere_height;   ///< [m]
    std::optional<double> preload;           ///< largest force of the predicted loops [N]
    std::optional<double> speed;      ///< speed of the motor in them [m/s]; without it that of the elastomer's loops
    std::optional<double> hold_time;  ///< hold time at the turning point [s]; without it that of the elastomer's loops
    std::optional<StatedEdgeSpeed> crack_speed;  ///< without it fitted to loops on the smooth reference
    std::vector<StatedRelaxation> relaxation;
    std::optional<double> crosslink_molar_mass;  ///< M_c [kg/mol]
    double density = 970.0;                      ///< [kg/m³], PDMS
    double temperature = 298.0;                  ///< [K]
};

/// A loop in a file.
struct ExperimentInput : LoopSource {
    loops::AnalysisOptions options;  ///< options of the analysis
    LoopModelOptions models;         ///< models that are fitted in addition to JKR
    std::string surface;             ///< empty for a reference
    std::string elastomer;
    std::optional<Estimate> sphere_radius;      ///< [m], in place of the elastomer's
    std::optional<Estimate> machine_stiffness;  ///< [N/m]; `options` contain its value without the standard error
    /// true value = factor × value of the file; > 0
    Estimate force_calibration = exact_factor, displacement_calibration = exact_factor,
             contact_radius_calibration = exact_factor;
    bool reference = false;  ///< on a smooth reference
    std::string stage;       ///< for references: "before" or "after" the rough loops, or empty
    std::string lens, spot;  ///< labels of repeated loops, or empty without labels
    std::string exclusion;   ///< reason for which its numbers are left out of means; empty where they are not

    static inline const Estimate exact_factor{.value = 1.0, .standard_error = 0.0};

    [[nodiscard]] bool excluded() const { return !exclusion.empty(); }
};

/// Published results of one surface × elastomer pair, or of a smooth reference.
struct PublishedPair {
    std::string surface;  ///< empty for a reference
    std::string elastomer;
    std::optional<Estimate> approach;      ///< W of the approach fit [J/m²]
    std::optional<Estimate> pull_off;      ///< W by Eq. S1 [J/m²]
    std::optional<Estimate> retraction;    ///< W by Eq. S2 or of the retraction branch [J/m²]
    std::optional<Estimate> loss;          ///< E_loss [J]
    std::optional<double> contact_radius;  ///< contact radius at maximum preload [m]
};

/// A published value of a fit, printed next to that of setae.
struct ReportedValue {
    std::string fit;       ///< "modified", "persson_tosatti", "loop"
    std::string quantity;  ///< "work_of_adhesion", "r_squared"
    Estimate value;        ///< SI
    std::string source;
};

/// Method by which the measurements of a surface give one spectrum.
enum class SpectrumMethod {
    average,     ///< arithmetic mean of C1D over the measurements of each bin ([D19])
    likelihood,  ///< C_iso fitted to all measurements at once, each with its transfer function; the average in addition
};

struct SurfaceAnalysisOptions {
    std::optional<SpectrumMethod>
        spectrum;  ///< absent: likelihood for surfaces with several measurements, average for a single one
    std::optional<Estimate> longest_wavelength, shortest_wavelength;  ///< limits of all integrals [m]
    roughness::Conversion conversion = roughness::Conversion::exact;
    spectra::ContourTreatment contours = spectra::ContourTreatment::sinc_corrected;
    spectra::Window window = spectra::Window::automatic;
    spectra::Weighting weighting = spectra::Weighting::equal;
    double tip_percentile = 0.0;
    int bootstrap_resamples = 200;
    std::uint64_t seed = 1;
    spectral_fit::LikelihoodOptions likelihood;  ///< seed and threads are those of the study
    std::uint64_t largest_map = std::uint64_t{2}
                                << 30;  ///< bytes of heights above which a map is read by bands of scan lines
    std::vector<double> cutoff_scan;    ///< shortest wavelengths [m] for W_int against the short cutoff

    [[nodiscard]] roughness::WavelengthLimits limits() const;
};

/// Comparison of repeated loops and of the smooth reference.
struct ComparisonOptions {
    std::vector<std::string> crossed;  ///< levels of replicates whose labels are common to all surfaces: lens
    /// [J/m²]: a reference with hysteresis and loss per area significantly below it counts as one without hysteresis;
    /// default: the standard error of γ1 in [D19], a lower bound of the resolution of all conclusions
    double margin = 5e-3;
};

/// A study as given in its file; every number in SI.
struct Study {
    std::string path;
    std::string title;
    std::string description;
    std::string output;         ///< folder of the results
    std::vector<Alert> alerts;  ///< warnings of possible but unlikely values, each with its line
    SurfaceAnalysisOptions analysis;
    ComparisonOptions comparison;
    double counter_youngs_modulus = 0.0;  ///< Young's modulus of the rough solid [Pa]
    double counter_poisson_ratio = 0.0;
    std::optional<Estimate> work_of_adhesion;  ///< W_int for predictions [J/m²]; else the fitted one
    std::vector<SurfaceInput> surfaces;
    std::vector<ElastomerInput> elastomers;
    std::vector<ExperimentInput> experiments;
    std::vector<PublishedPair> published;
    std::vector<ReportedValue> reported;
    std::map<std::string, double> costs;  ///< hours by input, "loop" and "measurements", where given

    [[nodiscard]] const ElastomerInput* elastomer(const std::string& name) const;
    [[nodiscard]] const SurfaceInput* surface(const std::string& name) const;
};

/// Reads a study from TOML; docs/reference/study-keys.md describes every key. A mapping that is no file next to the
/// study is looked up by name in `mapping_folder`.
/// @throws FileError; FormatError with the line for text that is no TOML, an unknown key (with the nearest known one),
/// a missing or wrong unit, a name that is not declared, a surface without data.
[[nodiscard]] Study read_study(const std::string& path, const std::string& mapping_folder = {});

}  // namespace setae::study
