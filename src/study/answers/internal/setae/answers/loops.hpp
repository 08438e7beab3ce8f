// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "setae/answers/camera_pictures.hpp"
#include "setae/fields/option.hpp"
#include "setae/loops/analysis.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/study/loop_models.hpp"
#include "setae/study/open_loop.hpp"

namespace setae::answers {

/// Loops that are read: files, how their columns are named, the camera's record, constants of force curves.
struct LoopFiles : CameraPictures {
    std::vector<std::string> files, columns;
    std::string map, camera, camera_map, clock_offset, spring_constant, sensitivity;
    std::string mapping_folder;  ///< folder of mappings that are given by name
    std::optional<long> curve_number;

    /// Chosen columns. @throws InvalidArgument for a text other than ROLE=COLUMN.
    [[nodiscard]] tables::ChosenColumns chosen() const;
    /// The files, those of folders in alphabetical order and without outputs of setae. @throws InvalidArgument without
    /// a file.
    [[nodiscard]] std::vector<std::string> expanded() const;
    [[nodiscard]] study::LoopSource source(const std::string& file) const;
    /// The file of the given mapping, by its path or by its name in the folder; empty without a mapping. @throws
    /// FileError.
    [[nodiscard]] std::optional<std::string> mapping() const;
    /// The loop, or the force curve of the requested number.
    [[nodiscard]] study::OpenedLoop open(const std::string& file) const;
};

/// Bodies of a loop.
struct LoopBodies {
    std::string radius, lens_height, layer_thickness, counter_modulus;
    std::optional<double> poisson_ratio, counter_poisson_ratio;

    /// Values given here, else those in the loop's metadata. @throws InvalidArgument without a radius of the sphere.
    [[nodiscard]] study::StatedBodies bodies(const Table& loop) const;
    /// The same for tips that have no radius.
    [[nodiscard]] study::StatedBodies without_radius(const Table& loop) const;
};

/// Settings of the analysis of a loop.
struct LoopSettings {
    std::string machine_stiffness, rigid_contact, contact_point = "auto", displacement_drift;
    std::string drift = "auto", force_zero;
    std::vector<std::string> segments, relaxation;
    std::optional<double> baseline_share;
    double area_ratio = 1.0;
    long samples_dropped = 3;
    bool unweighted = false, modulus_free = false, no_drift = false, whole_retraction = false;

    /// Values given here; the stiffness of the testing machine else from the loop's metadata.
    /// @throws as reading and analysing the rigid contact.
    [[nodiscard]] loops::AnalysisOptions options(const Table& loop) const;
    [[nodiscard]] loops::DriftModel drift_model() const;
};

/// Models that are fitted to a loop in addition to JKR.
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
/// The analysis of a loop that is already open.
[[nodiscard]] AnalysedLoop analysed_loop(study::OpenedLoop opened, const std::string& file, const LoopBodies& bodies,
                                         const LoopSettings& settings);

[[nodiscard]] study::LoopModels models_of(const AnalysedLoop& loop, const study::LoopModelOptions& models);

/// Output of `setae jkr fit` for one loop: loop_fields.hpp describes it.
struct FittedLoop {
    const AnalysedLoop* loop;
    std::optional<study::LoopModels> models;  ///< on request
};
[[nodiscard]] FittedLoop fitted(const AnalysedLoop& loop, const study::LoopModelOptions& models);

}  // namespace setae::answers

template <>
struct setae::fields::Asked<setae::answers::LoopFiles> {
    using R = answers::LoopFiles;
    /// For every command that reads loops.
    static constexpr std::array mapping{
        option<&R::map>("mapping", "mapping (TOML) that names the columns of a foreign table: a file or a known name")
            .such_as("eoh")
            .short_name("map"),
    };
    static constexpr std::array options{
        option<&R::columns>("column",
                            "column of a role as ROLE=COLUMN, by name or number from 1, or ROLE=EXPRESSION; roles are "
                            "force, displacement, contact_radius, time")
            .such_as("force=-1 * load")
            .or_else("guessed from names and units")
            .in_python("columns"),
        option<&R::camera>("camera",
                           "camera record with a separate clock: a table of time and contact_radius, a TIFF stack, an "
                           "AVI or a folder of pictures"),
        option<&R::camera_map>("camera_map", "mapping (TOML) of the camera's table").in_python("camera_mapping"),
        option<&R::clock_offset>("clock_offset", "time that is added to the camera's times")
            .of(dimension::time)
            .such_as("0.12 s")
            .or_else("found from the records"),
        option<&R::spring_constant>("spring_constant", "spring constant of the cantilever of a force curve")
            .of(positive(dimension::stiffness))
            .such_as("0.05 N/m"),
        option<&R::sensitivity>("sensitivity", "deflection sensitivity of the cantilever of a force curve")
            .such_as("55 nm/V"),
        option<&R::curve_number>("curve_number",
                                 "number of one force curve in a file of many, as the file counts them, from 0")
            .or_else("`setae jkr fit` fits every curve"),
    };
};

template <>
struct setae::fields::Asked<setae::answers::LoopBodies> {
    using R = answers::LoopBodies;
    static constexpr std::array options{
        option<&R::radius>("radius", "radius of the sphere; fits of loops include a given ±")
            .of(positive(dimension::length))
            .such_as("7.5 um")
            .or_else("as the file states"),
        option<&R::poisson_ratio>("poisson_ratio", "Poisson ratio of the soft body, from 0 to 0.5")
            .within(domain::poisson_ratio)
            .or_else("0.5")
            .short_name("nu")
            .in_python("nu"),
        option<&R::counter_modulus>("counter_E", "Young's modulus of the counter-body")
            .of(positive(dimension::pressure))
            .such_as("70 GPa")
            .or_else("rigid"),
        option<&R::counter_poisson_ratio>("counter_nu", "Poisson ratio of the counter-body, from 0 to 0.5")
            .within(domain::poisson_ratio)
            .or_else("0"),
        option<&R::lens_height>("lens_height",
                                "height of the soft sphere above the mount; fits are corrected for the finite height")
            .of(positive(dimension::length))
            .such_as("3 ± 0.1 mm"),
        option<&R::layer_thickness>(
            "layer_thickness", "thickness of a soft layer on a rigid base; fits are corrected for the finite thickness")
            .of(positive(dimension::length))
            .such_as("0.5 mm"),
    };
};

template <>
struct setae::fields::Asked<setae::answers::LoopSettings> {
    using R = answers::LoopSettings;
    static constexpr std::array options{
        option<&R::machine_stiffness>("machine_stiffness",
                                      "stiffness of the testing machine, where the displacement is that of the stage")
            .of(positive(dimension::stiffness))
            .such_as("30 ± 1 N/m"),
        option<&R::rigid_contact>("rigid_contact",
                                  "file of a loop on a rigid body that gives the stiffness of the testing machine"),
        option<&R::contact_point>(
            "contact_point",
            "contact point of force-displacement fits: auto, fit, a method such as jump_in, or a displacement")
            .default_shown(),
        option<&R::segments>("segment",
                             "range of samples or times that replaces a segment found; also cut=400 for cycles, "
                             "\"ignore=30:35 (slip)\" for excluded data")
            .such_as("loading=120:900")
            .in_python("segments"),
        option<&R::baseline_share>("baseline_share", "share of the record, from the start, that is free flight")
            .within(domain::share)
            .or_else("found from the record")
            .advanced(),
        option<&R::drift>("drift",
                          "drift of the force zero in time: auto, none, linear, quadratic, cubic, or extrapolate (only "
                          "the free flight before contact)")
            .default_shown(),
        option<&R::force_zero>("force_zero", "zero of force for a record without free flight; no drift is removed")
            .of(dimension::force)
            .such_as("0 N")
            .advanced(),
        option<&R::displacement_drift>("displacement_drift", "drift rate of the displacement, where known")
            .of(dimension::velocity)
            .such_as("0.1 nm/s")
            .advanced(),
        option<&R::area_ratio>("area_ratio",
                               "ratio of true to apparent area of the hard surface, for losses per true area")
            .within(domain::positive)
            .default_shown(),
        option<&R::samples_dropped>("samples_dropped", "number of samples left out after the jump into contact")
            .between(0, 1000000)
            .default_shown()
            .advanced(),
        option<&R::relaxation>("relaxation",
                               "term SHARE:TIME of the bulk's relaxation E(t)/E∞ = 1 + Σ g e^(−t/τ), which is removed "
                               "from the force first")
            .such_as("0.1:20s")
            .advanced(),
        option<&R::unweighted>("unweighted", "ordinary least squares in radius or depth, without errors of force")
            .advanced(),
        option<&R::no_drift>("no_drift", "constant zero of force, from the free flight before contact: drift none")
            .advanced(),
        option<&R::whole_retraction>("whole_retraction",
                                     "fit of the retraction from the largest force on, pinned stretch included")
            .advanced(),
        option<&R::modulus_free>("retraction_modulus_free", "E* as a free parameter of the retraction fit (Eq. S2)")
            .advanced(),
    };
};

template <>
struct setae::fields::Asked<setae::answers::LoopModelsRequest> {
    using R = answers::LoopModelsRequest;
    static constexpr std::array<std::string_view, 2> branches{"loading", "unloading"};
    static constexpr std::array<std::string_view, 3> kinds_of_errors{"effective_variance", "orthogonal_distance",
                                                                     "force_only"};
    static constexpr std::array<std::string_view, 2> shareable{"modulus", "work"};
    static constexpr std::array options{
        option<&R::models>("model",
                           "additional model: hertz, dmt, jkr, maugis_dugdale, transition, layer, large_strain; all "
                           "compares every model")
            .in_python("models"),
        option<&R::branch>("branch", "branch of additional models, profile likelihood and common fits")
            .one_of(branches)
            .default_shown(),
        option<&R::errors>("errors", "treatment of measurement errors in additional models and common fits")
            .one_of(kinds_of_errors)
            .default_shown()
            .advanced(),
        option<&R::contact_point>("model_contact_point", "contact point that is held fixed in additional models")
            .of(dimension::length)
            .such_as("1.2 um")
            .or_else("fitted"),
        option<&R::cohesive_stress>("cohesive_stress", "cohesive stress that is held fixed in the model maugis_dugdale")
            .of(positive(dimension::pressure))
            .such_as("5 MPa")
            .or_else("fitted")
            .advanced(),
        option<&R::profile>("profile", "intervals of E* and W by profile likelihood"),
        option<&R::crack_speed>("crack_speed", "fit of G(v) = G0 (1 + (v/v0)^n) to the edge during retraction"),
        option<&R::exponent>("exponent", "exponent n that is held fixed in the fit of G(v)")
            .or_else("fitted")
            .advanced(),
        option<&R::shared>("share", "quantity that all loops have in common in one fit; modulus, work or both")
            .one_of(shareable),
    };
};
