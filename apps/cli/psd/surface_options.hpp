// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "program/exit_code.hpp"
#include "program/options.hpp"
#include "setae/answers/surface_request.hpp"

namespace setae::cli {

/// Options of commands that analyse files as measurements of one surface.
struct SurfaceOptions : answers::SurfaceRequest {
    void add_to(Options& options);
    /// Only the options for the measurements and their processing.
    void add_measurements_to(Options& options, const char* meaning);
};

/// Prints the errors of measurements; returns done, some_failed or nothing_done.
[[nodiscard]] ExitCode report_failures(const study::SurfaceResult& surface);

}  // namespace setae::cli
