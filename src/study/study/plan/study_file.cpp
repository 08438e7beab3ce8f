// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <limits>
#include <tuple>

#include <fmt/format.h>

#include "keys.hpp"
#include "loop_keys.hpp"
#include "setae/bytes/toml_reader.hpp"
#include "setae/core/constants.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/core/units.hpp"
#include "setae/study/pipeline_file.hpp"
#include "setae/study/study.hpp"
#include "setae/tables/mapping_folder.hpp"

namespace setae::study {
namespace {

namespace fs = std::filesystem;
using bytes::TomlReader;

/// The steps of a pipeline, read with the study, so that errors in them are reported before any computation.
void read_pipeline_of(TomlReader& reader, MeasurementInput& input) {
    const auto file = reader.text("pipeline");
    if (!file) return;
    input.pipeline = reader.resolved_path(*file);
    input.steps = step_lines(read_pipeline(*input.pipeline));
}

/// A channel by its number or its name.
void read_channel(TomlReader& reader, MeasurementInput& input) {
    if (!reader.is_number("channel")) {
        input.channel = reader.text("channel");
        return;
    }
    const auto number = reader.integer("channel");
    if (*number < 0) reader.fail("channel", "expected a number from 0 or a name");
    input.channel = fmt::format("{}", *number);
}

double direction_from_text(const std::string& text) {
    if (text == "x") return 0.0;
    return text == "y" ? 0.5 * pi : parse_quantity(text, dimension::none);
}

/// A scan less itself is nothing.
void require_other_references(const TomlReader& reader, const MeasurementInput& input) {
    for (const auto& reference : input.references) {
        std::error_code ignored;
        if (fs::path(reference).lexically_normal() == fs::path(input.file).lexically_normal() ||
            fs::equivalent(reference, input.file, ignored))
            reader.fail("references",
                        fmt::format("{} is the measurement itself, expected scans of a smooth reference", reference));
    }
}

const Keys<MeasurementInput>& measurement_keys() {
    using Input = MeasurementInput;
    static const auto keys =
        Keys<Input>()
            .file("file", &Input::file, "file of a map, line scan or contour")
            .required()
            .add({"channel", "whole number from 0 or text", "", "",
                  "number or name of the channel of the file, or the beginning of the name; without this key, "
                  "a container gives all measurements that it contains, and another file gives its [preferred "
                  "channel](formats/README.md#which-channel)"},
                 read_channel)
            .choice<std::string>("instrument", &Input::instrument,
                                 {{"stylus", "stylus"}, {"afm", "afm"}, {"tem", "tem"}, {"optical", "optical"}},
                                 "kind of the instrument")
            .add("tip_radius", &Input::tip_radius, positive(dimension::length),
                 "radius of the tip; wavelengths that the tip does not resolve are removed from the spectrum")
            .plausible(1e-10, 1e-3)
            .choice<std::string>(
                "tip_shape", &Input::tip_shape, {{"sphere", "sphere"}, {"cone", "cone"}, {"paraboloid", "paraboloid"}},
                "shape of the tip, with `tip_radius` as the radius of the apex; without this key a sphere")
            .parsed(
                "tip_half_angle", "an angle such as `20 deg`",
                [](Input& input, const std::string& text) {
                    input.tip_half_angle = parse_quantity(text, {dimension::none, domain::acute_angle});
                },
                "angle between the axis and the flank of a conical tip")
            .file("tip_file", &Input::tip_file,
                  "map of the tip, apex up, as `setae tip` writes it, in place of a shape; used for the fitted "
                  "spectrum")
            .add("foil_thickness", &Input::foil_thickness, positive(dimension::length),
                 "thickness of the foil of a projected contour (TEM) along the beam; without this key, the "
                 "thickness that the contour file states, else zero (a line)")
            .plausible(1e-9, 1e-4)
            .add("height_calibration", &Input::height_calibration, positive(dimension::none),
                 "true heights divided by heights of the file, such as `1.00 ± 0.02`; heights are multiplied "
                 "by it after the pipeline. If it has a name in `[inputs]`, it is one input of one instrument "
                 "in all surfaces")
            .plausible(0.01, 100.0)
            .add("lateral_calibration", &Input::lateral_calibration, positive(dimension::none),
                 "true lengths along the surface divided by lengths of the file; lengths are multiplied by it "
                 "after the pipeline. Both calibrations of a micrograph have one name")
            .plausible(0.01, 100.0)
            .add("numerical_aperture", &Input::numerical_aperture, positive(dimension::none),
                 "numerical aperture of an optical profiler; with `light_wavelength`, the fitted spectrum "
                 "takes the optical transfer function into account")
            .plausible(0.01, 1.6)
            .add("light_wavelength", &Input::light_wavelength, positive(dimension::length),
                 "mean wavelength of the light of an optical profiler")
            .plausible(1e-7, 1e-5)
            .add("resolution", &Input::resolution, positive(dimension::length),
                 "lateral resolution of the instrument; shorter wavelengths are removed from the spectrum")
            .plausible(1e-11, 1e-3)
            .parsed(
                "trend", "`none`, `mean`, `tilt`, `parabola`",
                [](Input& input, const std::string& name) { input.trend = topography::trend_from_name(name); },
                "trend that is subtracted from the heights; without this key: none after a pipeline that "
                "levels, else the trend that a container states, else `parabola` for a stylus and `tilt` for "
                "other instruments")
            .parsed(
                "direction", "`x`, `y`, an angle such as `30 deg`",
                [](Input& input, const std::string& text) { input.direction = direction_from_text(text); },
                "direction of the lines, or of the x axis of a map, on the surface; without this key x. "
                "Required for anisotropic surfaces whose files were not all measured along one direction")
            .file("references", &Input::references, "scans of a smooth reference; their average is subtracted")
            .add("unit", &Input::unit, "unit of lengths and heights, where the file does not state it")
            .add({"size", "one or two quantities above 0", "m", "",
                  "length of a line, or both lengths of a map, where the file does not state them"},
                 [](TomlReader& reader, Input& input) {
                     auto lengths = reader.quantities("size", positive(dimension::length));
                     if (lengths.size() > 2)
                         reader.fail("size",
                                     fmt::format("{} lengths, expected one for a line, two for a map", lengths.size()));
                     if (!lengths.empty()) input.size = std::move(lengths);
                 })
            .choice<std::string>(
                "layout", &Input::layout, {{"matrix", "matrix"}, {"columns", "columns"}},
                "meaning of the columns of a text file where it is ambiguous: rows of a map, or positions and heights")
            .add("keep_values", &Input::keep_values,
                 "values that [mark missing heights](undefined-heights.md) but are kept as heights")
            .add({"pipeline", "file", "", "",
                  "[processing steps](../guides/processing.md) that are applied before the analysis"},
                 read_pipeline_of);
    return keys;
}

/// An input without a name belongs to an instrument, not to a file: the position in the study file is removed from its
/// name.
void forget_places(MeasurementInput& input) {
    for (auto* value :
         {&input.tip_radius, &input.foil_thickness, &input.height_calibration, &input.lateral_calibration})
        if (*value && (*value)->input.find(".measurements[") != std::string::npos) (*value)->input.clear();
}

/// Moments without names are those of one spectrum; the end of the model is an input of its own.
void forget_places(PublishedMoments& moments) {
    for (auto* value : {&moments.rms_height, &moments.rms_slope, &moments.rms_curvature})
        if (value->input.find(".moments.") != std::string::npos) value->input.clear();
}

const Keys<PublishedMoments>& moment_keys() {
    using Moments = PublishedMoments;
    static const auto keys =
        Keys<Moments>()
            .add("rms_height", &Moments::rms_height, positive(dimension::length), "rms height h_rms")
            .plausible(1e-12, 1e-3)
            .required()
            .add("rms_slope", &Moments::rms_slope, positive(dimension::none), "rms slope h'_rms")
            .plausible(1e-7, 1e2)
            .required()
            .add("rms_curvature", &Moments::rms_curvature, positive(dimension::wavevector), "rms curvature h''_rms")
            .plausible(1e-3, 1e11)
            .required()
            .add("short_wavevector", &Moments::short_wavevector, positive(dimension::wavevector),
                 "wavevector at which the spectrum ends")
            .plausible(1e2, 1e12)
            .required();
    return keys;
}

const Keys<SurfaceInput>& surface_keys() {
    using Input = SurfaceInput;
    static const auto keys =
        Keys<Input>()
            .add("description", &Input::description, "free text")
            .add({"measurements", "list of tables", "", "", "files of the surface; keys of each file are listed below"},
                 [](TomlReader& reader, Input& surface) {
                     reader.each_table("measurements", [&](TomlReader inner) {
                         const auto place = inner;
                         surface.measurements.push_back(measurement_keys().from(std::move(inner)));
                         require_other_references(place, surface.measurements.back());
                         forget_places(surface.measurements.back());
                     });
                 })
            .file("power_spectrum", &Input::power_spectrum,
                  "table of C1D or C_iso against wavevector, frequency or wavelength, in place of measurements")
            .parsed(
                "power_spectrum_unit", "two columns such as `1/um, nm3`",
                [](Input& input, const std::string& text) {
                    input.spectrum_units = tables::SpectrumUnits::from_text(text);
                },
                "units and kind of the columns where the header does not state them: `frequency 1/um, "
                "one-sided nm3`, `wavevector, W1` (h_rms² = ∫ W1 dk over ±k), `Wr`, `W2`")
            .add({"pipeline", "file", "", "", "processing steps of all measurements without a pipeline of their own"},
                 [](TomlReader& reader, Input& surface) {
                     MeasurementInput of_all;
                     read_pipeline_of(reader, of_all);
                     for (auto& measurement : surface.measurements)
                         if (!measurement.pipeline)
                             std::tie(measurement.pipeline, measurement.steps) =
                                 std::tie(of_all.pipeline, of_all.steps);
                 })
            .table<PublishedMoments>(
                "moments", moment_keys(),
                [](Input& surface, PublishedMoments moments) {
                    forget_places(moments);
                    surface.moments = moments;
                },
                "published moments in place of measurements; a self-affine spectrum is reconstructed from them");
    return keys;
}

SurfaceInput read_surface(const std::string& name, TomlReader reader) {
    auto surface = surface_keys().from(reader);
    surface.name = name;
    const int sources = static_cast<int>(!surface.measurements.empty()) +
                        static_cast<int>(surface.power_spectrum.has_value()) +
                        static_cast<int>(surface.moments.has_value());
    if (sources != 1)
        reader.fail(
            "measurements",
            fmt::format(
                "surface '{}' has {} sources of roughness, expected exactly one of measurements, power_spectrum, moments",
                name, sources));
    return surface;
}

/// γ1 of stretched area, with the form it enters by.
StretchedSurfaceEnergy read_surface_energy_law(TomlReader reader) {
    const auto form = reader.choice<StretchedSurfaceEnergy::Form>(
        "form",
        {{"end_states", StretchedSurfaceEnergy::Form::end_states}, {"printed", StretchedSurfaceEnergy::Form::printed}});
    const auto ratios = reader.quantities("area_ratio", dimension::none);
    const auto energies = reader.quantities("surface_energy", dimension::surface_energy);
    reader.finish();
    const auto as_array = [](const std::vector<double>& values) -> Array1D {
        return Eigen::Map<const Array1D>(values.data(), static_cast<Index>(values.size()));
    };
    adhesion::SurfaceEnergyLaw law{as_array(ratios), as_array(energies)};
    parse_at(reader, "area_ratio", [&] { law.validate(); });
    return {std::move(law), form.value_or(StretchedSurfaceEnergy::Form::end_states)};
}

const Keys<StatedEdgeSpeed>& edge_speed_keys() {
    using Stated = StatedEdgeSpeed;
    static const auto keys =
        Keys<Stated>()
            .add("reference_speed", &Stated::reference_speed, positive(dimension::length / dimension::time),
                 "reference speed v0 of G(v) = W_ret [1 + (v/v0)^n]")
            .plausible(1e-15, 100.0)
            .required()
            .add("exponent", &Stated::exponent, positive(dimension::none), "exponent n of G(v)")
            .plausible(1e-3, 100.0)
            .required();
    return keys;
}

const Keys<StatedRelaxation>& relaxation_keys() {
    using Stated = StatedRelaxation;
    static const auto keys =
        Keys<Stated>()
            .add("share", &Stated::share, non_negative(dimension::none), "share g of E(t)/E∞ = 1 + Σ g e^(−t/τ)")
            .plausible(1e-6, 1e3)
            .required()
            .add("time", &Stated::time, positive(dimension::time), "relaxation time τ")
            .plausible(1e-9, 1e9)
            .required();
    return keys;
}

const Keys<ElastomerInput>& elastomer_keys() {
    using Input = ElastomerInput;
    static const auto keys =
        Keys<Input>()
            .add("youngs_modulus", &Input::youngs_modulus, positive(dimension::pressure),
                 "Young's modulus; without this key, the mean of the loops on this elastomer")
            .plausible(1e2, 2e8)
            .add("poisson_ratio", &Input::poisson_ratio, {dimension::none, domain::poisson_ratio}, "Poisson's ratio")
            .by_default("0.5")
            .add("surface_energy", &Input::surface_energy, non_negative(dimension::surface_energy), "surface energy γ1")
            .plausible(1e-3, 1.0)
            .required()
            .add({"surface_energy_law", "table", "", "",
                  "`{ area_ratio = [1.0, …], surface_energy = [\"25 mJ/m2\", …], form = \"end_states\" }`: γ1 "
                  "against the ratio of stretched to unstretched area, for the balance with a strain-dependent "
                  "surface energy (Eq. 6); `form = \"printed\"` uses Eqs. 5 and 6 as printed, with ∫ γ1 dA"},
                 [](TomlReader& reader, Input& elastomer) {
                     reader.table("surface_energy_law", [&](TomlReader inner) {
                         elastomer.surface_energy_law = read_surface_energy_law(std::move(inner));
                     });
                 })
            .add("interface_change", &Input::interface_change, dimension::surface_energy,
                 "coefficient χ of an interfacial energy that changes with the stretch of the soft side, γ1s2 "
                 "− γ12 = χ (r − 1), for the balance with a strain-dependent surface energy (Eq. 6)")
            .add("sphere_radius", &Input::sphere_radius, positive(dimension::length), "radius of curvature of the lens")
            .plausible(1e-9, 1.0)
            .add("sphere_height", &Input::sphere_height, positive(dimension::length), "height of the lens")
            .plausible(1e-8, 1.0)
            .add("preload", &Input::preload, non_negative(dimension::force),
                 "largest force of the predicted loops; requires `sphere_radius`. Loops are predicted for "
                 "measured and unmeasured pairs")
            .plausible(1e-12, 10.0)
            .add("speed", &Input::speed, positive(dimension::length / dimension::time),
                 "speed of the motor for pairs without a measured loop; without this key, the mean of the "
                 "loops on this elastomer")
            .plausible(1e-12, 1.0)
            .add("hold_time", &Input::hold_time, non_negative(dimension::time),
                 "hold time at maximum preload for pairs without a measured loop; without this key, the mean "
                 "of the loops on this elastomer")
            .plausible(1e-6, 1e7)
            .table<StatedEdgeSpeed>(
                "crack_speed", edge_speed_keys(),
                [](Input& e, StatedEdgeSpeed stated) { e.crack_speed = std::move(stated); },
                "`{ reference_speed = \"1.0 ± 0.1 um/s\", exponent = \"0.60 ± 0.02\" }`: dependence of the "
                "work of retraction on the speed of the contact edge; without this key, it is fitted to the "
                "references on this elastomer ([hysteresis](../concepts/hysteresis.md))")
            .add({"relaxation", "list of tables", "", "",
                  "`[{ share = \"0.10 ± 0.02\", time = \"20 s\" }, …]`: terms of the bulk relaxation E(t)/E∞ = "
                  "1 + Σ g e^(−t/τ)"},
                 [](TomlReader& reader, Input& elastomer) {
                     reader.each_table("relaxation", [&](TomlReader inner) {
                         elastomer.relaxation.push_back(relaxation_keys().from(std::move(inner)));
                     });
                 })
            .add("crosslink_molar_mass", &Input::crosslink_molar_mass, positive(dimension::molar_mass),
                 "molar mass M_c between crosslinks; E is compared with ρRT/M_c")
            .plausible(1e-3, 1e5)
            .add("density", &Input::density, positive({{-3, 1, 0, 0, 0, 0}}), "density ρ, for ρRT/M_c")
            .plausible(100.0, 1e4)
            .add("temperature", &Input::temperature, positive(dimension::temperature), "temperature T, for ρRT/M_c")
            .plausible(50.0, 1000.0);
    return keys;
}

const Keys<CameraInput>& camera_keys() {
    using Input = CameraInput;
    static const auto keys =
        Keys<Input>()
            .file("file", &Input::file,
                  "file of contact radii with the camera's clock, or pictures: TIFF stack, AVI, folder")
            .required()
            .file("mapping", &Input::mapping, "mapping of the columns of a foreign table: a file or a name")
            .add("clock_offset", &Input::clock_offset, dimension::time,
                 "time that is added to the camera's times; without this key, it is determined from the record")
            .add("pixel_size", &Input::pixel_size, positive(dimension::length),
                 "size of a pixel, for pictures that do not state it")
            .plausible(1e-10, 1e-2)
            .add("frame_rate", &Input::frame_rate, positive(dimension::none / dimension::time),
                 "frame rate, for pictures that do not state it")
            .plausible(1e-5, 1e8)
            .add("fringes", &Input::fringes, "whether the pictures contain Newton's rings around the contact");
    return keys;
}

const Keys<ExperimentInput>& experiment_keys() {
    using Input = ExperimentInput;
    static const auto keys =
        Keys<Input>()
            .file("file", &Input::file, "file of a loop: table, workbook or force curve")
            .required()
            .file("mapping", &Input::mapping,
                  "mapping of the columns of a foreign table (examples/mappings/eoh.toml): a file, or the name "
                  "of a mapping that setae contains, such as `eoh`")
            .table<CameraInput>(
                "camera", camera_keys(), [](Input& e, CameraInput camera) { e.camera = std::move(camera); },
                "contact radii from a separate file; keys are listed below")
            .add(
                "spring_constant", [](auto& e) -> auto& { return e.force_curve.spring_constant; },
                positive(dimension::stiffness), "spring constant, for force curves whose file does not state it")
            .plausible(1e-6, 1e9)
            .parsed(
                "sensitivity", "quantity",
                [](Input& e, const std::string& text) { e.force_curve.sensitivity = tables::parse_sensitivity(text); },
                "deflection sensitivity, in m/V or m/A, for force curves whose file does not state it")
            .add({"segments", "list of texts", "", "",
                  "corrections to the segments that were found in the record, such as `\"loading=120:900\"`, "
                  "`\"ignore=30:35 (slip)\"` ([loops](../concepts/loops.md))"},
                 [](TomlReader& reader, Input& e) {
                     for (const auto& edit : reader.texts("segments"))
                         parse_at(reader, "segments", [&] { loops::add_segment_edit(e.options.segments.edits, edit); });
                 })
            .choice<bool>("role", &Input::reference, {{"rough", false}, {"reference", true}},
                          "kind of the loop: a loop on a rough surface of the study, or a reference on a smooth "
                          "surface, which names no surface")
            .add("surface", &Input::surface, "name of one of [surfaces]")
            .add("elastomer", &Input::elastomer, "name of one of [elastomers]")
            .required()
            .add("sphere_radius", &Input::sphere_radius, positive(dimension::length),
                 "radius of curvature of the lens of this loop, in place of the value of the elastomer")
            .plausible(1e-9, 1.0)
            .choice<std::string>("stage", &Input::stage, {{"before", "before"}, {"after", "after"}},
                                 "whether a reference was measured before or after the rough loops")
            .add("lens", &Input::lens,
                 "label of the lens of a repeated loop, given for all loops on an elastomer or for none; "
                 "measured values are then means of a mixed model ([replicates](../guides/replicates.md))")
            .add("spot", &Input::spot,
                 "label of the spot on the surface, given for all loops on an elastomer or for none, like `lens`")
            .add({"exclude", "text", "", "",
                  "reason for which the loop is left out of all means; the loop is still analysed and shown"},
                 [](TomlReader& reader, Input& e) {
                     const auto reason = reader.text("exclude");
                     if (reason && trimmed(*reason).empty())
                         reader.fail("exclude", "an exclusion without a reason; state why the loop is left out");
                     e.exclusion = reason.value_or("");
                 });
    return keys;
}

/// Loops on one elastomer that are fitted together share the same, by the same model and errors.
void require_same_shared_fit(const TomlReader& reader, const ExperimentInput& experiment, const Study& study) {
    const auto asks = [](const ExperimentInput& e) { return e.models.shared() && !e.excluded(); };
    const auto fit = [](const LoopModelOptions& m) {
        return std::tuple(m.share_contact_modulus, m.share_work_of_adhesion, m.shared_model(), m.errors);
    };
    if (!asks(experiment)) return;
    for (const auto& other : study.experiments)
        if (other.elastomer == experiment.elastomer && asks(other) && fit(other.models) != fit(experiment.models))
            reader.fail(
                "share",
                fmt::format("expected the share, models and fit_errors of {} on the same elastomer, as both are in one "
                            "fit; or share = [] to leave this loop out of the fit",
                            other.file));
}

/// The mapping of that name in a folder, where there is no such file next to the study.
void find_mapping(const TomlReader& reader, const char* key, std::optional<std::string>& mapping,
                  const std::string& folder) {
    const auto name = mapping ? fs::path(*mapping).filename() : fs::path();
    const bool bare = mapping && name.extension().empty() && reader.resolved_path(name.string()) == *mapping;
    if (!bare || folder.empty() || fs::exists(*mapping)) return;
    try {
        mapping = tables::mapping_path(name.string(), folder);
    } catch (const FileError& error) {
        reader.fail(key, error.what());
    }
}

/// An experiment of a study whose preceding experiments are read; it starts with the values of [loops].
ExperimentInput read_experiment(TomlReader reader, const Study& study, ExperimentInput experiment,
                                const std::string& mapping_folder) {
    loop_keys().read(reader, experiment);
    experiment_keys().read(reader, experiment);
    find_mapping(reader, "mapping", experiment.mapping, mapping_folder);
    if (experiment.camera) find_mapping(reader, "camera", experiment.camera->mapping, mapping_folder);
    require_same_shared_fit(reader, experiment, study);
    reader.finish();
    if (experiment.surface.empty() != experiment.reference)
        reader.fail("surface",
                    experiment.reference
                        ? "a reference is measured on a smooth reference surface and names no surface of the study"
                        : "missing; expected a declared surface, or role = \"reference\"");
    return experiment;
}

/// Rows of published values, one per surface, one entry per elastomer.
class PublishedTables {
public:
    explicit PublishedTables(Study& study) : study_(study) {}

    void read(TomlReader reader) {
        elastomers_ = reader.texts("elastomers");
        for (const auto& name : elastomers_)
            if (!study_.elastomer(name)) reader.fail("elastomers", fmt::format("'{}' is not declared", name));
        for (const auto& field : fields())
            reader.table(field.key, [&](TomlReader rows) { read_rows(rows, field.dimension, field.member); });
        reader.table(radius_key, [&](TomlReader rows) {
            for (const auto& surface : rows.keys())
                assign(rows, surface, rows.uncertains(surface.c_str(), dimension::length), set_contact_radius);
        });
        reader.table("reference", [&](TomlReader rows) {
            for (const auto& field : fields())
                assign_reference(rows, field.key, rows.uncertains(field.key, field.dimension),
                                 [&](PublishedPair& pair, const Estimate& value) { pair.*field.member = value; });
            assign_reference(rows, radius_key, rows.uncertains(radius_key, dimension::length), set_contact_radius);
            rows.finish();
        });
        reader.finish();
    }

    [[nodiscard]] static std::vector<KeyDescription> descriptions() {
        std::vector<KeyDescription> keys{{"elastomers", "list of texts", "", "",
                                          "names of the elastomers, in the order of the entries of each row"}};
        for (const auto& field : fields())
            keys.push_back({field.key, "table", si_unit(field.dimension), "", field.meaning});
        keys.push_back({radius_key, "table", si_unit(dimension::length), "", "contact radius at maximum preload"});
        keys.push_back({"reference", "table", "", "",
                        "`KEY = [one value per elastomer]` of the smooth reference, with KEY one of approach, "
                        "pull_off, retraction, loss, contact_radius"});
        return keys;
    }

private:
    static constexpr const char* radius_key = "contact_radius";
    static void set_contact_radius(PublishedPair& pair, const Estimate& value) { pair.contact_radius = value.value; }

    struct Field {
        const char* key;
        Dimension dimension;
        std::optional<Estimate> PublishedPair::*member;
        const char* meaning;
    };
    static const std::vector<Field>& fields() {
        static const std::vector<Field> list{
            {"approach", dimension::surface_energy, &PublishedPair::approach, "work of adhesion W of loading"},
            {"pull_off", dimension::surface_energy, &PublishedPair::pull_off,
             "work of adhesion W from the pull-off force (Eq. S1)"},
            {"retraction", dimension::surface_energy, &PublishedPair::retraction,
             "work of adhesion W from the points before pull-off (Eq. S2) or from the retraction branch"},
            {"loss", dimension::energy, &PublishedPair::loss, "energy loss E_loss of a loop"}};
        return list;
    }

    template <class Field>
    void read_rows(TomlReader& rows, const Dimension& dimension, Field field) {
        for (const auto& surface : rows.keys()) {
            const auto values = rows.uncertains(surface.c_str(), dimension);
            if (dimension == dimension::surface_energy)
                for (const auto& value : values)
                    remark_implausible(rows, surface.c_str(), value.value, 1e-6, 10.0, si_unit(dimension));
            assign(rows, surface, values, [field](PublishedPair& pair, const Estimate& value) { pair.*field = value; });
        }
    }

    template <class Assign>
    void assign(TomlReader& rows, const std::string& surface, const std::vector<Estimate>& values, Assign set) {
        if (!study_.surface(surface)) rows.fail(surface.c_str(), fmt::format("surface '{}' is not declared", surface));
        require_length(rows, surface.c_str(), values.size());
        for (std::size_t i = 0; i < values.size(); ++i) set(pair(surface, elastomers_[i]), values[i]);
    }

    template <class Assign>
    void assign_reference(TomlReader& rows, const char* key, const std::vector<Estimate>& values, Assign set) {
        if (values.empty()) return;
        require_length(rows, key, values.size());
        for (std::size_t i = 0; i < values.size(); ++i) set(pair("", elastomers_[i]), values[i]);
    }

    void require_length(const TomlReader& rows, const char* key, std::size_t length) const {
        if (length != elastomers_.size())
            rows.fail(key, fmt::format("{} values, expected {}, one for each entry of published.elastomers", length,
                                       elastomers_.size()));
    }

    PublishedPair& pair(const std::string& surface, const std::string& elastomer) {
        for (auto& known : study_.published)
            if (known.surface == surface && known.elastomer == elastomer) return known;
        study_.published.push_back({surface, elastomer});
        return study_.published.back();
    }

    Study& study_;
    std::vector<std::string> elastomers_;
};

const Keys<SurfaceAnalysisOptions>& analysis_keys() {
    using Options = SurfaceAnalysisOptions;
    using roughness::Conversion, spectra::ContourTreatment, spectra::Weighting;
    static const auto keys =
        Keys<Options>()
            .choice<SpectrumMethod>(
                "spectrum", &Options::spectrum,
                {{"average", SpectrumMethod::average}, {"likelihood", SpectrumMethod::likelihood}},
                "spectrum of a surface: the mean of C1D over measurements, or C_iso fitted to all "
                "measurements at once; without this key `likelihood` for surfaces with several measurements")
            .add("longest_wavelength", &Options::longest_wavelength, positive(dimension::length),
                 "longest wavelength of all integrals; its standard error is propagated to every result of "
                 "every surface whose data reach it")
            .plausible(1e-10, 1.0)
            .add(
                "shortest_wavelength", &Options::shortest_wavelength, positive(dimension::length),
                "shortest wavelength of all integrals; its standard error is propagated to every result of every surface whose data reach it")
            .plausible(1e-11, 1e-3)
            .add(
                "surface_shortest_wavelength", [](auto& o) -> auto& { return o.likelihood.shortest_wavelength; },
                positive(dimension::length),
                "shortest wavelength of the surface; the spectrum has no shorter wavelengths, and data at "
                "shorter wavelengths are left out; for likelihoods")
            .plausible(1e-11, 1e-3)
            .choice<Conversion>(
                "conversion", &Options::conversion, {{"exact", Conversion::exact}, {"eq11", Conversion::eq11}},
                "conversion of C1D to 2D parameters; results of the other conversion are reported, too; for "
                "averages and given spectra")
            .choice<ContourTreatment>(
                "contours", &Options::contours,
                {{"sinc_corrected", ContourTreatment::sinc_corrected}, {"segments", ContourTreatment::segments}},
                "treatment of contours; `segments` is that of Dalvi et al. 2019; for averages")
            .choice<Weighting>("weighting", &Options::weighting,
                               {{"equal", Weighting::equal},
                                {"per_instrument", Weighting::per_instrument},
                                {"inverse_variance", Weighting::inverse_variance}},
                               "weights of measurements in averages")
            .parsed(
                "window", "`automatic`, `none`, `hann`, `blackman_harris`",
                [](Options& options, const std::string& name) { options.window = spectra::window_from_name(name); },
                "window of the periodogram; `automatic`: Hann for data that are not periodic; for averages")
            .by_default("`automatic`")
            .add("tip_percentile", &Options::tip_percentile, {dimension::none, domain::share},
                 "share of positions that may be sharper than the tip; 0 is the strict criterion; for averages")
            .whole("bootstrap_resamples", &Options::bootstrap_resamples, 0, 1'000'000,
                   "number of bootstrap replicas over measurements, or of draws of fitted spectra (at least "
                   "40); 0: averages have neither standard errors nor intervals")
            .whole("seed", &Options::seed, std::numeric_limits<std::int64_t>::min(), Keys<Options>::unbounded,
                   "seed of the random numbers of the replicas")
            .add("cutoff_scan", &Options::cutoff_scan, positive(dimension::length),
                 "shortest wavelengths for which W_int is fitted again")
            .plausible(1e-11, 1e-2);
    return keys;
}

/// The rough, hard body.
struct RoughSolid {
    Estimate youngs_modulus, poisson_ratio;
};

const Keys<RoughSolid>& rough_solid_keys() {
    static const auto keys =
        Keys<RoughSolid>()
            .add("youngs_modulus", &RoughSolid::youngs_modulus, positive(dimension::pressure), "Young's modulus")
            .plausible(1e6, std::numeric_limits<double>::infinity())  // a rigid one is stated by any large number
            .required()
            .add("poisson_ratio", &RoughSolid::poisson_ratio, {dimension::none, domain::poisson_ratio},
                 "Poisson's ratio")
            .required();
    return keys;
}

const Keys<ComparisonOptions>& comparison_keys() {
    using Options = ComparisonOptions;
    static const auto keys =
        Keys<Options>()
            .add("crossed", &Options::crossed,
                 "levels that are crossed with surfaces: `[\"lens\"]` where one label of a lens is one lens "
                 "on all surfaces ([replicates](../guides/replicates.md)); without this key, each surface has "
                 "lenses of its own")
            .add("margin", &Options::margin, positive(dimension::surface_energy),
                 "margin of an equivalence test: whether hysteresis and loss per area of a smooth reference "
                 "are smaller")
            .plausible(1e-6, 10.0);
    return keys;
}

/// @throws FormatError for a level that cannot cross surfaces and for a margin of zero.
ComparisonOptions read_comparison(TomlReader reader) {
    auto options = comparison_keys().from(reader);
    for (const auto& level : options.crossed)
        if (level != "lens" && level != "spot")
            reader.fail("crossed", fmt::format("'{}' is no level of replicates; expected lens or spot", level));
    if (!(options.margin > 0.0))
        reader.fail("margin", fmt::format("{} J/m2; expected more than 0, such as \"5 mJ/m2\"", options.margin));
    return options;
}

/// Published results of one fit.
struct Reported {
    std::optional<Estimate> work_of_adhesion, r_squared;
    std::string source;
};

const Keys<Reported>& reported_keys() {
    static const auto keys =
        Keys<Reported>()
            .add("work_of_adhesion", &Reported::work_of_adhesion, positive(dimension::surface_energy), "reported W_int")
            .add("r_squared", &Reported::r_squared, dimension::none, "reported R²")
            .add("source", &Reported::source, "place in the report, such as a table or figure");
    return keys;
}

const Keys<Study>& top_keys() {
    static const auto keys = Keys<Study>()
                                 .add("title", &Study::title, "title of the report")
                                 .by_default("name of the file")
                                 .add("description", &Study::description, "free text")
                                 .file("output", &Study::output, "folder of the results")
                                 .by_default("`NAME_results` beside `NAME.toml`")
                                 .add("work_of_adhesion", &Study::work_of_adhesion, positive(dimension::surface_energy),
                                      "work of adhesion W_int for predictions; without this key, the fitted W_int")
                                 .plausible(1e-4, 10.0);
    return keys;
}

void require_declared_names(const Study& study) {
    const auto complain = [&](const ExperimentInput& experiment, const char* kind, const std::string& name) {
        throw FormatError(
            study.path, {},
            fmt::format("experiment {} names the {} '{}', which is not declared", experiment.file, kind, name));
    };
    for (const auto& experiment : study.experiments) {
        if (!study.elastomer(experiment.elastomer)) complain(experiment, "elastomer", experiment.elastomer);
        if (!experiment.reference && !study.surface(experiment.surface))
            complain(experiment, "surface", experiment.surface);
    }
}

/// Checks that all loops on one elastomer name their lens (spot), or none of them.
void require_complete_labels(const Study& study) {
    const auto require = [&](const char* key, std::string ExperimentInput::*label) {
        for (const auto& elastomer : study.elastomers) {
            const ExperimentInput *with = nullptr, *without = nullptr;
            for (const auto& e : study.experiments)
                if (!e.reference && e.elastomer == elastomer.name) ((e.*label).empty() ? without : with) = &e;
            if (with && without)
                throw FormatError(
                    study.path, {},
                    fmt::format(
                        "experiment {} names no {}, experiment {} with the same elastomer does; name it for all or for none",
                        without->file, key, with->file));
        }
    };
    require("lens", &ExperimentInput::lens);
    require("spot", &ExperimentInput::spot);
}

}  // namespace

const ElastomerInput* Study::elastomer(const std::string& name) const {
    const auto found =
        std::find_if(elastomers.begin(), elastomers.end(), [&](const auto& e) { return e.name == name; });
    return found == elastomers.end() ? nullptr : &*found;
}

const SurfaceInput* Study::surface(const std::string& name) const {
    const auto found = std::find_if(surfaces.begin(), surfaces.end(), [&](const auto& s) { return s.name == name; });
    return found == surfaces.end() ? nullptr : &*found;
}

Study read_study(const std::string& path, const std::string& mapping_folder) {
    const auto document = bytes::parse_toml_file(path);
    TomlReader reader(document, path, "");
    Study study;
    study.path = path;
    study.title = fs::path(path).stem().string();
    study.output = reader.resolved_path(study.title + "_results");
    reader.name_inputs("inputs");
    top_keys().read(reader, study);
    reader.table("analysis", [&](TomlReader inner) { study.analysis = analysis_keys().from(std::move(inner)); });
    reader.table("comparison", [&](TomlReader inner) { study.comparison = read_comparison(std::move(inner)); });
    reader.table("rough_solid", [&](TomlReader inner) {
        const auto solid = rough_solid_keys().from(std::move(inner));
        study.counter_youngs_modulus = solid.youngs_modulus.value;
        study.counter_poisson_ratio = solid.poisson_ratio.value;
    });
    reader.named_tables("surfaces", [&](const std::string& name, TomlReader inner) {
        study.surfaces.push_back(read_surface(name, std::move(inner)));
    });
    reader.named_tables("elastomers", [&](const std::string& name, TomlReader inner) {
        study.elastomers.push_back(elastomer_keys().from(std::move(inner)));
        study.elastomers.back().name = name;
    });
    ExperimentInput of_all;
    reader.table("loops", [&](TomlReader inner) { of_all = loop_keys().from(std::move(inner)); });
    reader.each_table("experiments", [&](TomlReader inner) {
        study.experiments.push_back(read_experiment(std::move(inner), study, of_all, mapping_folder));
    });
    reader.table("published", [&](TomlReader inner) { PublishedTables(study).read(std::move(inner)); });
    reader.named_tables("reported", [&](const std::string& fit, TomlReader inner) {
        const auto reported = reported_keys().from(std::move(inner));
        if (const auto& work = reported.work_of_adhesion)
            study.reported.push_back({fit, "work_of_adhesion", *work, reported.source});
        if (const auto& r_squared = reported.r_squared)
            study.reported.push_back({fit, "r_squared", *r_squared, reported.source});
    });
    reader.table("costs", [&](TomlReader inner) {
        for (const auto& name : inner.keys()) {
            const auto time = inner.quantity(name.c_str(), positive(dimension::time));
            constexpr double hour = 3600.0;
            study.costs[name] = *time / hour;
        }
    });
    reader.finish();
    reader.require_inputs_used();
    for (const auto& remark : reader.warnings())
        study.alerts.push_back({"UNITS_IMPLAUSIBLE", remark.place, remark.key + " = " + remark.text, "check its unit"});
    if (!study.elastomers.empty() && !(study.counter_youngs_modulus > 0.0))
        throw FormatError(
            path, {}, "missing [rough_solid] with youngs_modulus and poisson_ratio, which the contact modulus needs");
    require_declared_names(study);
    require_complete_labels(study);
    return study;
}

std::vector<KeyTable> study_keys() {
    return {
        {"", "Keys at the top of the file.", top_keys().descriptions()},
        {"[analysis]", "Determination of spectra from measurements, and of parameters from spectra.",
         analysis_keys().descriptions()},
        {"[rough_solid]", "Rough, hard body; required if the study has elastomers.", rough_solid_keys().descriptions()},
        {"[surfaces.NAME]", "Rough surface, with exactly one of measurements, power_spectrum, moments.",
         surface_keys().descriptions()},
        {"measurements of [surfaces.NAME]", "File of a surface.", measurement_keys().descriptions()},
        {"moments of [surfaces.NAME]", "", moment_keys().descriptions()},
        {"[elastomers.NAME]", "Soft solid.", elastomer_keys().descriptions()},
        {"[[experiments]]", "Loop. Every key of [loops] can be given for one loop, too.",
         experiment_keys().descriptions()},
        {"crack_speed of [elastomers.NAME]", "", edge_speed_keys().descriptions()},
        {"relaxation of [elastomers.NAME]", "", relaxation_keys().descriptions()},
        {"camera of [[experiments]]", "", camera_keys().descriptions()},
        {"[loops]",
         "Analysis of loops, and models that are fitted to them; keys of an experiment override these "
         "keys.",
         loop_keys().descriptions()},
        {"[comparison]", "Comparison of repeated loops and of the smooth reference.", comparison_keys().descriptions()},
        {"[published]", "Published measured values, with rows `SURFACE = [one value per elastomer]`.",
         PublishedTables::descriptions()},
        {"[inputs]",
         "Named values, to which any key below can refer by name ([inputs](../guides/shared-inputs.md)).",
         {{"any name", "quantity ± error", "", "", "value, such as `\"1.25 ± 0.01 mm\"`, or `\"1.2 to 1.3 mm\"`"}}},
        {"[costs]",
         "Duration of further measurements, for `setae study STUDY --next`.",
         {{"loop", "quantity above 0", "s", "", "duration of one more loop on a pair, such as `\"0.5 h\"`"},
          {"measurements", "quantity above 0", "s", "", "duration of repeating the measurements of a surface"},
          {"any name", "quantity above 0", "s", "",
           "duration of halving the standard error of the input of that name"}}},
        {"[reported.FIT]",
         "Reported results of `modified`, `persson_tosatti` or `loop`; printed next to those of setae.",
         reported_keys().descriptions()}};
}

}  // namespace setae::study
