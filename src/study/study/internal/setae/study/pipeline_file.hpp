// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "setae/formats/channel.hpp"
#include "setae/processing/pipeline.hpp"

namespace setae::study {

/// A pipeline from a file: YAML (.yml, .yaml) or TOML (.toml).
///
///   steps:                              [[steps]]
///     - step: align_rows                step = "align_rows"
///       method: median                  method = "median"
///     - step: gaussian_filter           [[steps]]
///       cutoff: 8 um                    step = "gaussian_filter"
///       enabled: false                  cutoff = "8 um"
///                                       enabled = false
/// A step may also be given as one text, "despike threshold=5". Lengths and angles have their unit; a region is a text
/// or a list of texts, one for each shape. A file that a step names is relative to the pipeline's folder; in the result
/// to the working one.
/// @throws FileError; FormatError with the line for text that is neither, an unknown step, parameter or key (with the
/// nearest one), an invalid value; InvalidArgument for another ending.
[[nodiscard]] processing::Pipeline read_pipeline(const std::string& path);

/// A pipeline as the text of such files; read back it is the same pipeline.
[[nodiscard]] std::string pipeline_yaml(const processing::Pipeline& pipeline);
[[nodiscard]] std::string pipeline_toml(const processing::Pipeline& pipeline);

/// Writes one as its path ends. Files that steps name, relative to the working folder, are written relative to the
/// path's folder.
/// @throws InvalidArgument for another ending; FileError.
void write_pipeline(const std::string& path, const processing::Pipeline& pipeline);

/// Returns a loader of heights for steps that name files: of the channel of that name, or the first one with heights.
/// The loader throws what reading throws, and InvalidArgument for a missing channel.
[[nodiscard]] processing::LoadMeasurement measurement_loader(formats::ReadOptions options = {});

/// The steps of a pipeline that are on, each as one line, and a pipeline of such lines. @throws InvalidArgument as
/// step_from_text() does.
[[nodiscard]] std::vector<std::string> step_lines(const processing::Pipeline& pipeline);
[[nodiscard]] processing::Pipeline pipeline_of_lines(const std::vector<std::string>& lines);

/// Files that steps, each as one line, name, in order.
[[nodiscard]] std::vector<std::string> files_of_steps(const std::vector<std::string>& lines);

}  // namespace setae::study
