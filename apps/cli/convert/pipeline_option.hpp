// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "program/options.hpp"
#include "setae/output/json.hpp"
#include "setae/processing/pipeline.hpp"

namespace setae::cli {

/// Processing before analysis: --pipeline p.yml, then --step "despike threshold=5" as often as need be.
struct PipelineOption {
    std::string file;
    std::vector<std::string> steps;

    void add_to(Options& options);
    [[nodiscard]] bool given() const { return !file.empty() || !steps.empty(); }
    /// The steps of the file, then those of the command line. @throws as read_pipeline() and step_from_text() do.
    [[nodiscard]] processing::Pipeline pipeline() const;
};

/// What a step did, on one line for a reader: its name and its numbers.
[[nodiscard]] std::string as_line(const processing::StepRecord& record);

/// All steps with their parameters, for --explain.
[[nodiscard]] std::string step_list();

/// The same as a page of Markdown: docs/reference/processing-steps.md.
[[nodiscard]] std::string step_page();

}  // namespace setae::cli
