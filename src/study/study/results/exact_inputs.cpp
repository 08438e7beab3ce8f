// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/study/exact_inputs.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <string>

#include "setae/core/words.hpp"

namespace setae::study {
namespace {

/// Adds a kind where some of its owners have no standard error; each owner once.
template <class Owners>
void add(std::vector<ExactInputs>& found, const char* what, const Owners& owners,
         const std::function<bool(const typename Owners::value_type&)>& exact,
         const std::function<std::string(const typename Owners::value_type&)>& name) {
    ExactInputs kind{what, {}};
    for (const auto& owner : owners)
        if (exact(owner) && std::find(kind.names.begin(), kind.names.end(), name(owner)) == kind.names.end())
            kind.names.push_back(name(owner));
    if (!kind.names.empty()) found.push_back(std::move(kind));
}

bool exact(const std::optional<Estimate>& value) { return !value || !value->uncertain(); }

void add_elastomers(std::vector<ExactInputs>& found, const Study& study) {
    using Input = ElastomerInput;
    const auto name = [](const Input& e) { return e.name; };
    const auto of = [&](const char* what, const std::function<bool(const Input&)>& without_error) {
        add(found, what, study.elastomers, without_error, name);
    };
    of("surface energy", [](const Input& e) { return !e.surface_energy.uncertain(); });
    of("Young's modulus", [](const Input& e) { return e.youngs_modulus.value > 0.0 && !e.youngs_modulus.uncertain(); });
    of("sphere radius", [&](const Input& e) {
        return e.sphere_radius && !e.sphere_radius->uncertain() &&
               std::any_of(study.experiments.begin(), study.experiments.end(), [&](const ExperimentInput& loop) {
                   return loop.elastomer == e.name && !loop.sphere_radius;
               });
    });
}

void add_instruments(std::vector<ExactInputs>& found, const Study& study) {
    using Input = MeasurementInput;
    std::vector<Input> measurements;
    for (const auto& surface : study.surfaces)
        measurements.insert(measurements.end(), surface.measurements.begin(), surface.measurements.end());
    const auto name = [](const Input& m) {
        return m.instrument.empty() ? std::string("instruments not named") : m.instrument;
    };
    std::vector<ExactInputs> calibrations;
    add<std::vector<Input>>(
        calibrations, "calibration of heights", measurements,
        [](const Input& m) { return exact(m.height_calibration); }, name);
    add<std::vector<Input>>(
        calibrations, "calibration of lengths", measurements,
        [](const Input& m) { return exact(m.lateral_calibration); }, name);
    if (calibrations.size() == 2 && calibrations[0].names == calibrations[1].names)
        calibrations = {{"calibration of heights and lengths", calibrations[0].names}};
    found.insert(found.end(), calibrations.begin(), calibrations.end());
    add<std::vector<Input>>(
        found, "tip radius", measurements, [](const Input& m) { return m.tip_radius && !m.tip_radius->uncertain(); },
        name);
}

void add_loops(std::vector<ExactInputs>& found, const Study& study) {
    std::vector<std::string> channels;
    const auto of = [&](const char* channel, Estimate ExperimentInput::*factor) {
        if (std::any_of(study.experiments.begin(), study.experiments.end(),
                        [&](const ExperimentInput& e) { return !(e.*factor).uncertain(); }))
            channels.emplace_back(channel);
    };
    of("force", &ExperimentInput::force_calibration);
    of("displacement", &ExperimentInput::displacement_calibration);
    of("contact radii", &ExperimentInput::contact_radius_calibration);
    if (!channels.empty()) found.push_back({"calibration of " + listed(channels), {}});
}

void add_limits(std::vector<ExactInputs>& found, const SurfaceAnalysisOptions& options) {
    const auto of = [&](const char* what, const std::optional<Estimate>& limit) {
        if (limit && !limit->uncertain()) found.push_back({what, {}});
    };
    of("longest wavelength", options.longest_wavelength);
    of("shortest wavelength", options.shortest_wavelength);
}

/// The first calibrations with an error, else the last ones.
void take_uncertain(InstrumentInputs& inputs, const InstrumentInputs& next) {
    if (exact(inputs.height_calibration)) inputs.height_calibration = next.height_calibration;
    if (exact(inputs.lateral_calibration)) inputs.lateral_calibration = next.lateral_calibration;
}

}  // namespace

std::vector<ExactInputs> exact_inputs(const Study& study) {
    std::vector<ExactInputs> found;
    add_limits(found, study.analysis);
    add_elastomers(found, study);
    add_instruments(found, study);
    add_loops(found, study);
    return found;
}

std::vector<ExactInputs> exact_inputs(const StudyResult& result) {
    auto study = result.study;
    for (std::size_t i = 0; i < study.surfaces.size() && i < result.surfaces.size(); ++i) {
        std::map<std::string, InstrumentInputs> by_file;
        for (const auto& m : result.surfaces[i].measurements) take_uncertain(by_file[m.file], m.inputs);
        for (auto& input : study.surfaces[i].measurements)
            if (const auto measured = by_file.find(input.file); measured != by_file.end()) {
                if (exact(input.height_calibration)) input.height_calibration = measured->second.height_calibration;
                if (exact(input.lateral_calibration)) input.lateral_calibration = measured->second.lateral_calibration;
            }
    }
    return exact_inputs(study);
}

}  // namespace setae::study
