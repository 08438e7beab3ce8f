// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "program/options.hpp"
#include "setae/answers/surface_request.hpp"
#include "setae/processing/steps.hpp"

namespace setae::cli {

/// Processing before analysis: --pipeline p.yml, then --step "despike threshold=5" as often as need be.
void add_processing_options(Options& options, answers::ProcessingRequest& processing);

struct PipelineOption : answers::ProcessingRequest {
    void add_to(Options& options) { add_processing_options(options, *this); }
};

/// What a step did, on one line for a reader: its name and its numbers.
[[nodiscard]] std::string as_line(const processing::StepRecord& record);

/// All steps with their parameters, for --explain.
[[nodiscard]] std::string step_list();

/// The same as a page of Markdown: docs/reference/processing-steps.md.
[[nodiscard]] std::string step_page();

}  // namespace setae::cli
