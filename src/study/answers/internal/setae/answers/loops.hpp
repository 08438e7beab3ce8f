// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "setae/loops/analysis.hpp"
#include "setae/output/json.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/study/loop_models.hpp"
#include "setae/study/open_loop.hpp"

namespace setae::answers {

/// Loops that are read: files, how their columns are named, the camera's record, constants of force curves.
struct LoopFiles {
    std::vector<std::string> files;
    std::vector<std::string> columns;  ///< "ROLE=COLUMN", chosen in place of what names and units say
    std::string map, camera, camera_map, clock_offset, pixel, spring_constant, sensitivity;
    std::string mapping_folder;  ///< of mappings that go by their names
    std::optional<double> frame_rate;
    std::optional<long> curve_number;
    bool fringes = false;

    /// What is chosen of columns. @throws InvalidArgument for one that is no ROLE=COLUMN.
    [[nodiscard]] tables::ChosenColumns chosen() const;
    /// The files, those of folders in alphabetical order and without what setae wrote of results. @throws
    /// InvalidArgument where there is none.
    [[nodiscard]] std::vector<std::string> expanded() const;
    [[nodiscard]] study::LoopSource source(const std::string& file) const;
    /// The file of the mapping that was named, by its path or by the name it has in the folder; nothing where none was.
    /// @throws FileError.
    [[nodiscard]] std::optional<std::string> mapping() const;
    /// The loop, or the force curve of the number wanted.
    [[nodiscard]] study::OpenedLoop open(const std::string& file) const;
};

/// What was pressed on what.
struct LoopBodies {
    std::string radius, lens_height, layer_thickness, counter_modulus;
    std::optional<double> poisson_ratio, counter_poisson_ratio;

    /// What is said here, else what the loop's metadata say. @throws InvalidArgument where nobody says the sphere's
    /// radius.
    [[nodiscard]] study::StatedBodies bodies(const Table& loop) const;
    /// The same for tips that have no radius.
    [[nodiscard]] study::StatedBodies without_radius(const Table& loop) const;
};

/// How a loop is analysed.
struct LoopSettings {
    std::string machine_stiffness, rigid_contact, contact_point = "auto", displacement_drift;
    std::string drift = "auto", force_zero;  ///< loops::DriftModel; the zero of force where it is known
    std::vector<std::string> segments, relaxation;
    std::optional<double> baseline_share;
    double area_ratio = 1.0;
    long samples_dropped = 3;
    bool unweighted = false, modulus_free = false, no_drift = false, whole_retraction = false;

    /// What is said here; the machine's stiffness else from the loop's metadata.
    /// @throws as reading and analysing the rigid contact.
    [[nodiscard]] loops::AnalysisOptions options(const Table& loop) const;
    [[nodiscard]] loops::DriftModel drift_model() const;
};

/// What is fitted to a loop beside JKR's own routes.
struct LoopModelsRequest {
    std::vector<std::string> models, shared;
    std::string branch = "loading", errors = "orthogonal_distance";
    std::string contact_point, cohesive_stress;
    bool profile = false, crack_speed = false;
    std::optional<double> exponent;

    /// @throws InvalidArgument for a malformed quantity.
    [[nodiscard]] study::LoopModelOptions options() const;
};

/// A loop read and analysed.
struct AnalysedLoop {
    std::string file;
    study::OpenedLoop opened;
    loops::LensAndCounterBody bodies;
    loops::AnalysisOptions options;
    loops::LoopAnalysis analysis;
};

/// @throws what reading and analysing throw.
[[nodiscard]] AnalysedLoop analysed_loop(const std::string& file, const LoopFiles& files, const LoopBodies& bodies,
                                         const LoopSettings& settings);
/// The same of a loop already open.
[[nodiscard]] AnalysedLoop analysed_loop(study::OpenedLoop opened, const std::string& file, const LoopBodies& bodies,
                                         const LoopSettings& settings);

[[nodiscard]] study::LoopModels models_of(const AnalysedLoop& loop, const study::LoopModelOptions& models);

/// What `setae jkr fit` says of one loop: its analysis, "file", and "models" where some were asked for.
[[nodiscard]] output::Json fit_json(const AnalysedLoop& loop, const study::LoopModelOptions& models = {});
/// What `setae jkr energy` says of it.
[[nodiscard]] output::Json energy_json(const AnalysedLoop& loop);

}  // namespace setae::answers
