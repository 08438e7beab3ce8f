// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "program/exit_code.hpp"
#include "program/options.hpp"
#include "setae/loops/analysis.hpp"
#include "setae/parallel/for_each.hpp"
#include "setae/study/open_loop.hpp"

namespace setae::cli {

/// Options of verbs that read loops: files, how their columns are named, the camera's record, constants of force
/// curves.
struct LoopArguments {
    std::vector<std::string> files;
    std::string map, camera, camera_map, clock_offset, pixel, spring_constant, sensitivity;
    std::optional<double> frame_rate;
    std::optional<long> curve_number;
    bool fringes = false;

    void add_to(Options& options);
    /// The files, those of folders in alphabetical order. @throws InvalidArgument where there is none.
    [[nodiscard]] std::vector<std::string> expanded() const;
    [[nodiscard]] study::LoopSource source(const std::string& file) const;
    /// The file of the mapping that was named, by its path or by the name it has among those that came with the
    /// program; nothing where none was. @throws FileError.
    [[nodiscard]] std::optional<std::string> mapping() const;
    /// The loop, or the force curve of the number wanted.
    [[nodiscard]] study::OpenedLoop open(const std::string& file) const;
};

/// Options that say what was pressed on what.
struct BodyArguments {
    std::string radius, lens_height, layer_thickness, counter_modulus;
    std::optional<double> poisson_ratio, counter_poisson_ratio;

    void add_to(Options& options);
    /// What the options say, else what the loop's metadata say. @throws InvalidArgument where nobody says the sphere's
    /// radius.
    [[nodiscard]] study::StatedBodies bodies(const Table& loop) const;
    /// The same for tips that have no radius.
    [[nodiscard]] study::StatedBodies without_radius(const Table& loop) const;
};

/// Options of the analysis of a loop.
struct LoopAnalysisArguments {
    std::string machine_stiffness, rigid_contact, contact_point = "auto", displacement_drift;
    std::vector<std::string> segments;
    double baseline_share = loops::SegmentOptions{}.baseline_share, area_ratio = 1.0;
    long samples_dropped = 3;
    bool unweighted = false, modulus_free = false, no_drift = false, extrapolate_drift = false,
         whole_retraction = false;

    void add_to(Options& options);
    /// What the options say; the machine's stiffness else from the loop's metadata.
    /// @throws as reading and analysing the rigid contact.
    [[nodiscard]] loops::AnalysisOptions options(const Table& loop) const;
};

/// All that verbs that analyse loops are told.
struct LoopAnalysisRequest {
    LoopArguments loops;
    BodyArguments bodies;
    LoopAnalysisArguments analysis;

    void add_to(Options& options);
};

/// A loop read and analysed.
struct AnalysedLoop {
    std::string file;
    study::OpenedLoop opened;
    loops::LensAndCounterBody bodies;
    loops::AnalysisOptions options;
    loops::LoopAnalysis analysis;
};

/// Analyses every loop on the threads given and shows them one after the other, in the order of the files. A
/// setae::Error of one loop is printed and the others go on.
[[nodiscard]] ExitCode for_each_loop(const LoopAnalysisRequest& request, parallel::Threads threads,
                                     const std::function<void(const AnalysedLoop&)>& show_loop);

}  // namespace setae::cli
