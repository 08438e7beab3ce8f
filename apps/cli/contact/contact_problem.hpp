// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "convert/pipeline_option.hpp"
#include "files/file_options.hpp"
#include "program/options.hpp"
#include "setae/answers/contact_problem.hpp"
#include "setae/processing/pipeline.hpp"

namespace setae::cli {

/// --contact-modulus, and the layer where the body is one.
void add_body_options(Options& options, answers::BodyRequest& body);

/// --w, --range and --law.
void add_interaction_options(Options& options, answers::InteractionRequest& interaction);

/// A file whose surface touches.
struct ContactSurface {
    std::string path;
    FileOptions file;
    PipelineOption processing;

    void add_to(Options& options);
    /// What the file holds after its processing. @throws InvalidArgument for no file, and as reading does.
    [[nodiscard]] processing::PipelineResult processed() const;
};

}  // namespace setae::cli
