// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "setae/contact/jkr.hpp"
#include "setae/core/constants.hpp"
#include "setae/study_figures/study_figures.hpp"

namespace setae::study_figures {

/// A surface with a given C1D, a power law between its nodes.
inline study::SurfaceResult given_surface(const std::string& name) {
    study::SurfaceResult surface{.name = name};
    surface.average.curve = {
        Array1D{{1e5, 1e6, 1e7, 1e8}}, Array1D{{1e-20, 1e-20, 1e-23, 1e-26}}, {1e5, 1e8}, spectra::Density::C1D};
    surface.average.parameters = {
        .rms_height = 20e-9, .rms_slope = 1.0, .rms_curvature = 1e8, .elastic_energy_per_modulus = 2e-9};
    return surface;
}

inline study::ElastomerResult elastomer(const std::string& name, double modulus) {
    study::ElastomerResult result;
    result.input.name = name;
    result.input.surface_energy = {0.025, 0.001};
    result.input.sphere_radius = Estimate{1.25e-3, 0.0};
    result.youngs_modulus = {modulus, 0.01 * modulus};
    result.contact_modulus = {modulus / 0.75, 0.01 * modulus};
    return result;
}

inline study::PairResult pair_of(const std::string& surface, const std::string& elastomer, double measured,
                                 double predicted) {
    study::PairResult pair{.surface = surface, .elastomer = elastomer};
    pair.approach = Estimate{measured, 0.002};
    const Estimate estimate{predicted, 0.002};
    pair.modified = adhesion::PredictedWork{
        {predicted, std::max(0.0, predicted), predicted > 0.0}, {estimate, "everything"}, estimate};
    return pair;
}

/// Two surfaces, two elastomers and what was measured and predicted on them.
inline study::StudyResult study_of_pairs() {
    study::StudyResult result;
    result.surfaces = {given_surface("smooth"), given_surface("rough")};
    result.elastomers = {elastomer("soft", 1e6), elastomer("hard", 2e6)};
    for (const auto& e : result.elastomers) result.study.elastomers.push_back(e.input);
    result.pairs = {pair_of("smooth", "soft", 0.033, 0.030), pair_of("rough", "soft", 0.020, 0.022),
                    pair_of("rough", "hard", 0.004, -0.003)};
    result.work_of_adhesion = Estimate{0.037, 0.003};
    result.work_of_adhesion_source = "given in the study";
    return result;
}

/// A loop that is JKR's on both branches, W of unloading twice that of loading, 100 samples each.
inline study::ExperimentResult jkr_experiment(const std::string& surface, const study::ElastomerResult& elastomer,
                                              double work) {
    constexpr Index n = 100;
    const double radius = elastomer.input.sphere_radius->value, modulus = elastomer.contact_modulus.value;
    const contact::jkr::Contact loading{radius, modulus, work}, unloading{radius, modulus, 2.0 * work};
    loops::LoopAnalysis loop;
    const Array1D up = Array1D::LinSpaced(n, -1.4 * pi * radius * work, 1e-3),
                  down = Array1D::LinSpaced(n, 1e-3, -2.9 * pi * radius * work);
    loop.corrected.force.resize(2 * n);
    loop.corrected.contact_radius.resize(2 * n);
    loop.corrected.displacement.resize(2 * n);
    loop.corrected.force << up, down;
    loop.corrected.contact_radius << contact::jkr::contact_radius_at_force(up, loading),
        contact::jkr::contact_radius_at_force(down, unloading);
    loop.corrected.displacement << contact::jkr::displacement_at_force(up, loading),
        contact::jkr::displacement_at_force(down, unloading);
    loop.segments.contacts.push_back(
        {.extent = {0, 2 * n - 1}, .loading = {0, n - 1}, .unloading = loops::IndexRange{n, 2 * n - 1}});
    loops::JkrFit fit{.method = "radius_force",
                      .converged = true,
                      .contact_modulus = {modulus},
                      .work_of_adhesion = {work},
                      .contact_point = {undefined}};
    loop.loading.radius_force = loops::Outcome<loops::JkrFit>(fit);
    loop.retraction = loops::Outcome<loops::RetractionFit>(loops::RetractionFit{
        .work_of_adhesion = {2.0 * work}, .contact_modulus = {modulus}, .first = 2 * n - 6, .last = 2 * n - 1, .n = 6});
    loop.loop = loops::Outcome<loops::LoopEnergy>(loops::LoopEnergy{.energy = 1e-9});
    study::ExperimentResult result;
    result.input.surface = surface;
    result.input.elastomer = elastomer.input.name;
    result.input.file = surface + ".csv";
    result.analysis = loop;
    return result;
}

/// A measurement of an instrument with C1D between its first and last mode, reliable in `band`.
inline study::MeasurementResult measurement(const std::string& name, const std::string& instrument,
                                            const Array1D& wavevector, const Array1D& C1D, const Band& band) {
    study::MeasurementResult result{.file = name + ".csv", .name = name};
    result.spectrum.wavevector = wavevector;
    result.spectrum.density = C1D;
    result.spectrum.standard_error = Array1D::Constant(C1D.size(), undefined);
    result.spectrum.count = Array1D::Ones(C1D.size());
    result.spectrum.band.lower = band.lower;
    result.spectrum.band.upper = band.upper;
    result.spectrum.length = 2.0 * pi / wavevector[0];
    result.spectrum.metadata.instrument.type = instrument;
    result.spectrum.metadata.name = name;
    return result;
}

/// The first series of a panel whose label is `label`.
inline const figures::Series& series_of(const figures::Panel& panel, const std::string& label) {
    for (const auto& series : panel.series)
        if (series.label == label) return series;
    throw std::runtime_error("no series '" + label + "'");
}

}  // namespace setae::study_figures
