// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study/study.hpp"

#include <algorithm>
#include <filesystem>
#include <tuple>

#include <fmt/format.h>

#include "experiments/loop_options.hpp"
#include "setae/bytes/toml_reader.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/text.hpp"
#include "setae/study/pipeline_file.hpp"

namespace setae::study {
namespace {

namespace fs = std::filesystem;
using bytes::TomlReader;

/// Paths in a study are relative to its file.
std::string beside(const std::string& study_path, const std::string& file) {
    const fs::path path(file);
    return path.is_absolute() ? file : (fs::path(study_path).parent_path() / path).lexically_normal().string();
}

std::optional<std::string> file_beside(TomlReader& reader, const char* key, const std::string& study_path) {
    const auto file = reader.text(key);
    return file ? std::optional(beside(study_path, *file)) : std::nullopt;
}

/// The steps of a pipeline, read with the study, so that what is wrong in them is said before anything is computed.
void read_pipeline_of(TomlReader& reader, MeasurementInput& input, const std::string& study_path) {
    input.pipeline = file_beside(reader, "pipeline", study_path);
    if (input.pipeline) input.steps = step_lines(read_pipeline(*input.pipeline));
}

MeasurementInput read_measurement(TomlReader reader, const std::string& study_path) {
    MeasurementInput input;
    input.file = beside(study_path, reader.required_text("file"));
    if (const auto channel = reader.integer("channel")) {
        if (*channel < 0) reader.fail("channel", "expected a number from 0");
        input.channel = static_cast<std::size_t>(*channel);
    }
    input.instrument =
        reader
            .choice<std::string>("instrument",
                                 {{"stylus", "stylus"}, {"afm", "afm"}, {"tem", "tem"}, {"optical", "optical"}})
            .value_or("");
    input.tip_radius = reader.uncertain("tip_radius", dimension::length);
    input.resolution = reader.quantity("resolution", dimension::length);
    if (const auto trend = reader.text("trend")) {
        try {
            input.trend = topography::trend_from_name(*trend);
        } catch (const InvalidArgument& error) {
            reader.fail("trend", error.what());
        }
    }
    for (const auto& file : reader.texts("references")) input.references.push_back(beside(study_path, file));
    input.unit = reader.text("unit");
    if (const auto size = reader.quantities("size", dimension::length); !size.empty()) input.size = size;
    read_pipeline_of(reader, input, study_path);
    reader.finish();
    return input;
}

SurfaceInput read_surface(const std::string& name, TomlReader reader, const std::string& study_path) {
    SurfaceInput surface;
    surface.name = name;
    surface.description = reader.text("description").value_or("");
    reader.each_table("measurements", [&](TomlReader inner) {
        surface.measurements.push_back(read_measurement(std::move(inner), study_path));
    });
    surface.power_spectrum = file_beside(reader, "power_spectrum", study_path);
    MeasurementInput of_all;
    read_pipeline_of(reader, of_all, study_path);
    for (auto& measurement : surface.measurements)
        if (!measurement.pipeline)
            std::tie(measurement.pipeline, measurement.steps) = std::tie(of_all.pipeline, of_all.steps);
    reader.table("moments", [&](TomlReader inner) {
        PublishedMoments moments;
        moments.rms_height = inner.required_uncertain("rms_height", dimension::length);
        moments.rms_slope = inner.required_uncertain("rms_slope", dimension::none);
        moments.rms_curvature = inner.required_uncertain("rms_curvature", dimension::wavevector);
        moments.short_wavevector = inner.required_uncertain("short_wavevector", dimension::wavevector).value;
        inner.finish();
        surface.moments = moments;
    });
    reader.finish();
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

adhesion::SurfaceEnergyLaw read_surface_energy_law(TomlReader reader) {
    const auto ratios = reader.quantities("area_ratio", dimension::none);
    const auto energies = reader.quantities("surface_energy", dimension::surface_energy);
    reader.finish();
    const auto as_array = [](const std::vector<double>& values) -> Array1D {
        return Eigen::Map<const Array1D>(values.data(), static_cast<Index>(values.size()));
    };
    adhesion::SurfaceEnergyLaw law{as_array(ratios), as_array(energies)};
    try {
        law.validate();
    } catch (const InvalidArgument& error) {
        reader.fail("area_ratio", error.what());
    }
    return law;
}

ElastomerInput read_elastomer(const std::string& name, TomlReader reader) {
    ElastomerInput elastomer;
    elastomer.name = name;
    elastomer.youngs_modulus = reader.uncertain("youngs_modulus", dimension::pressure).value_or(Estimate{});
    elastomer.poisson_ratio = reader.number("poisson_ratio").value_or(elastomer.poisson_ratio);
    elastomer.surface_energy = reader.required_uncertain("surface_energy", dimension::surface_energy);
    reader.table("surface_energy_law",
                 [&](TomlReader inner) { elastomer.surface_energy_law = read_surface_energy_law(std::move(inner)); });
    elastomer.sphere_radius = reader.quantity("sphere_radius", dimension::length);
    elastomer.sphere_height = reader.quantity("sphere_height", dimension::length);
    elastomer.crosslink_molar_mass = reader.quantity("crosslink_molar_mass", dimension::molar_mass);
    elastomer.density = reader.quantity("density", {{-3, 1, 0, 0, 0, 0}}).value_or(elastomer.density);
    elastomer.temperature = reader.quantity("temperature", dimension::temperature).value_or(elastomer.temperature);
    reader.finish();
    return elastomer;
}

CameraInput read_camera(TomlReader reader, const std::string& study_path) {
    CameraInput camera;
    camera.file = beside(study_path, reader.required_text("file"));
    camera.mapping = file_beside(reader, "mapping", study_path);
    camera.clock_offset = reader.quantity("clock_offset", dimension::time);
    camera.pixel_size = reader.quantity("pixel_size", dimension::length);
    camera.frame_rate = reader.quantity("frame_rate", dimension::none / dimension::time);
    camera.fringes = reader.boolean("fringes").value_or(camera.fringes);
    reader.finish();
    return camera;
}

ExperimentInput read_experiment(TomlReader reader, const std::string& study_path,
                                const loops::AnalysisOptions& defaults) {
    ExperimentInput experiment;
    experiment.file = beside(study_path, reader.required_text("file"));
    experiment.mapping = file_beside(reader, "mapping", study_path);
    reader.table("camera", [&](TomlReader inner) { experiment.camera = read_camera(std::move(inner), study_path); });
    experiment.force_curve.spring_constant = reader.quantity("spring_constant", dimension::stiffness);
    if (const auto sensitivity = reader.text("sensitivity")) {
        try {
            experiment.force_curve.sensitivity = tables::parse_sensitivity(*sensitivity);
        } catch (const InvalidArgument& error) {
            reader.fail("sensitivity", error.what());
        }
    }
    experiment.options = read_loop_options_of_record(reader, defaults);
    experiment.reference = reader.choice<bool>("role", {{"rough", false}, {"reference", true}}).value_or(false);
    experiment.surface = reader.text("surface").value_or("");
    experiment.elastomer = reader.required_text("elastomer");
    experiment.sphere_radius = reader.quantity("sphere_radius", dimension::length);
    experiment.stage = reader.choice<std::string>("stage", {{"before", "before"}, {"after", "after"}}).value_or("");
    experiment.lens = reader.text("lens").value_or("");
    experiment.spot = reader.text("spot").value_or("");
    if (const auto reason = reader.text("exclude")) {
        if (trimmed(*reason).empty())
            reader.fail("exclude", "an exclusion without a reason; write why the loop is left out");
        experiment.exclusion = *reason;
    }
    reader.finish();
    if (experiment.surface.empty() != experiment.reference)
        reader.fail("surface", experiment.reference ? "a reference is made on a smooth standard and names no surface"
                                                    : "missing; expected a declared surface, or role = \"reference\"");
    return experiment;
}

/// Rows of published values, one a surface, one entry an elastomer.
class PublishedTables {
public:
    explicit PublishedTables(Study& study) : study_(study) {}

    void read(TomlReader reader) {
        elastomers_ = reader.texts("elastomers");
        for (const auto& name : elastomers_)
            if (!study_.elastomer(name)) reader.fail("elastomers", fmt::format("'{}' is not declared", name));
        using Field = std::optional<Estimate> PublishedPair::*;
        const std::vector<std::pair<const char*, Field>> fields{{"approach", &PublishedPair::approach},
                                                                {"pull_off", &PublishedPair::pull_off},
                                                                {"retraction", &PublishedPair::retraction}};
        for (const auto& [key, field] : fields)
            reader.table(key,
                         [&, member = field](TomlReader rows) { read_rows(rows, dimension::surface_energy, member); });
        reader.table("loss", [&](TomlReader rows) { read_rows(rows, dimension::energy, &PublishedPair::loss); });
        reader.table("contact_radius", [&](TomlReader rows) {
            for (const auto& surface : rows.keys())
                assign(rows, surface, rows.uncertains(surface.c_str(), dimension::length),
                       [](PublishedPair& pair, const Estimate& value) { pair.contact_radius = value.value; });
        });
        reader.table("reference", [&](TomlReader rows) {
            for (const auto& [key, field] : fields)
                assign_reference(rows, key, rows.uncertains(key, dimension::surface_energy), field);
            assign_reference(rows, "loss", rows.uncertains("loss", dimension::energy), &PublishedPair::loss);
            rows.finish();
        });
        reader.finish();
    }

private:
    template <class Field>
    void read_rows(TomlReader& rows, const Dimension& dimension, Field field) {
        for (const auto& surface : rows.keys())
            assign(rows, surface, rows.uncertains(surface.c_str(), dimension),
                   [field](PublishedPair& pair, const Estimate& value) { pair.*field = value; });
    }

    template <class Assign>
    void assign(TomlReader& rows, const std::string& surface, const std::vector<Estimate>& values, Assign set) {
        if (!study_.surface(surface)) rows.fail(surface.c_str(), fmt::format("surface '{}' is not declared", surface));
        require_length(rows, surface.c_str(), values.size());
        for (std::size_t i = 0; i < values.size(); ++i) set(pair(surface, elastomers_[i]), values[i]);
    }

    template <class Field>
    void assign_reference(TomlReader& rows, const char* key, const std::vector<Estimate>& values, Field field) {
        if (values.empty()) return;
        require_length(rows, key, values.size());
        for (std::size_t i = 0; i < values.size(); ++i) pair("", elastomers_[i]).*field = values[i];
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

AnalysisOptions read_analysis(TomlReader reader) {
    AnalysisOptions options;
    options.spectrum = reader.choice<SpectrumMethod>(
        "spectrum", {{"average", SpectrumMethod::average}, {"likelihood", SpectrumMethod::likelihood}});
    options.limits.longest = reader.quantity("longest_wavelength", dimension::length);
    options.limits.shortest = reader.quantity("shortest_wavelength", dimension::length);
    options.conversion = reader
                             .choice<roughness::Conversion>("conversion", {{"exact", roughness::Conversion::exact},
                                                                           {"eq11", roughness::Conversion::eq11}})
                             .value_or(options.conversion);
    options.contours = reader
                           .choice<spectra::ContourTreatment>(
                               "contours", {{"sinc_corrected", spectra::ContourTreatment::sinc_corrected},
                                            {"segments", spectra::ContourTreatment::segments}})
                           .value_or(options.contours);
    options.weighting =
        reader
            .choice<spectra::Weighting>("weighting", {{"equal", spectra::Weighting::equal},
                                                      {"per_instrument", spectra::Weighting::per_instrument},
                                                      {"inverse_variance", spectra::Weighting::inverse_variance}})
            .value_or(options.weighting);
    if (const auto window = reader.text("window")) {
        try {
            options.window = spectra::window_from_name(*window);
        } catch (const InvalidArgument& error) {
            reader.fail("window", error.what());
        }
    }
    options.tip_percentile = reader.number("tip_percentile").value_or(options.tip_percentile);
    if (const auto resamples = reader.integer("bootstrap_resamples")) {
        if (*resamples < 0 || *resamples > 1'000'000)
            reader.fail("bootstrap_resamples", "expected a number from 0 to 1000000");
        options.bootstrap_resamples = static_cast<int>(*resamples);
    }
    if (const auto seed = reader.integer("seed")) options.seed = static_cast<std::uint64_t>(*seed);
    options.cutoff_scan = reader.quantities("cutoff_scan", dimension::length);
    reader.finish();
    return options;
}

std::vector<ReportedValue> read_reported(const std::string& fit, TomlReader reader) {
    const auto source = reader.text("source").value_or("");
    std::vector<ReportedValue> values;
    if (const auto work = reader.uncertain("work_of_adhesion", dimension::surface_energy))
        values.push_back({fit, "work_of_adhesion", *work, source});
    if (const auto r_squared = reader.uncertain("r_squared", dimension::none))
        values.push_back({fit, "r_squared", *r_squared, source});
    reader.finish();
    return values;
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

/// Of the loops on one elastomer either all name their lens (spot) or none does.
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

Study read_study(const std::string& path) {
    const auto document = bytes::parse_toml_file(path);
    TomlReader reader(document, path, "");
    Study study;
    study.path = path;
    study.title = reader.text("title").value_or(fs::path(path).stem().string());
    study.description = reader.text("description").value_or("");
    study.output = beside(path, reader.text("output").value_or(fs::path(path).stem().string() + "_results"));
    reader.table("analysis", [&](TomlReader inner) { study.analysis = read_analysis(std::move(inner)); });
    reader.table("rough_solid", [&](TomlReader inner) {
        study.counter_youngs_modulus = inner.required_uncertain("youngs_modulus", dimension::pressure).value;
        study.counter_poisson_ratio = inner.required_uncertain("poisson_ratio", dimension::none).value;
        inner.finish();
    });
    study.work_of_adhesion = reader.uncertain("work_of_adhesion", dimension::surface_energy);
    reader.named_tables("surfaces", [&](const std::string& name, TomlReader inner) {
        study.surfaces.push_back(read_surface(name, std::move(inner), path));
    });
    reader.named_tables("elastomers", [&](const std::string& name, TomlReader inner) {
        study.elastomers.push_back(read_elastomer(name, std::move(inner)));
    });
    loops::AnalysisOptions loop_options;
    reader.table("loops", [&](TomlReader inner) {
        loop_options = read_loop_options(inner, loop_options);
        study.loop_models = read_loop_models(inner, study.loop_models);
        inner.finish();
    });
    reader.each_table("experiments", [&](TomlReader inner) {
        study.experiments.push_back(read_experiment(std::move(inner), path, loop_options));
    });
    reader.table("published", [&](TomlReader inner) { PublishedTables(study).read(std::move(inner)); });
    reader.named_tables("reported", [&](const std::string& fit, TomlReader inner) {
        const auto values = read_reported(fit, std::move(inner));
        study.reported.insert(study.reported.end(), values.begin(), values.end());
    });
    reader.finish();
    if (!study.elastomers.empty() && !(study.counter_youngs_modulus > 0.0))
        throw FormatError(
            path, {}, "missing [rough_solid] with youngs_modulus and poisson_ratio, which the contact modulus needs");
    require_declared_names(study);
    require_complete_labels(study);
    return study;
}

}  // namespace setae::study
