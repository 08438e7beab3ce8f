// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "program/exit_code.hpp"
#include "program/options.hpp"
#include "setae/answers/surface_request.hpp"

namespace setae::cli {

/// Options of the verbs that analyse files as measurements of one surface.
struct SurfaceOptions : answers::SurfaceRequest {
    void add_to(Options& options);
    /// Only what says which measurements there are and how each is prepared.
    void add_measurements_to(Options& options, const char* meaning);
};

/// Prints what failed; done, some failed or nothing done.
[[nodiscard]] ExitCode report_failures(const study::SurfaceResult& surface);

}  // namespace setae::cli
