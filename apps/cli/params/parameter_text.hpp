// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "setae/output/json.hpp"
#include "setae/texture/texture_parameter.hpp"

namespace setae::cli {

/// Parameters of one measurement.
struct MeasuredTexture {
    std::string file;
    std::string measurement;
    std::vector<texture::TextureParameter> parameters;
};

/// "md", "tsv", "latex" or "text", whose lines have at most `width` characters. TSV holds SI numbers, the others
/// numbers with prefixes for readers.
[[nodiscard]] std::string parameter_text(const std::vector<MeasuredTexture>& list, const std::string& format,
                                         std::size_t width);

[[nodiscard]] output::Json parameter_json(const std::vector<MeasuredTexture>& list);

/// The page docs/reference/parameters.md from the table of parameters, up to its marker.
[[nodiscard]] std::string parameter_page();

/// The page with what stands behind its marker in `existing`.
[[nodiscard]] std::string parameter_page(const std::string& existing);

}  // namespace setae::cli
