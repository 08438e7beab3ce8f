// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A generated surface or line, as the JSON of `setae synthesize` has it.

#include <array>
#include <string>
#include <variant>

#include "setae/answers/synthesis.hpp"
#include "setae/fields/describe.hpp"

namespace setae::answers {

/// A surface or line, and its file; without a name nothing was written.
struct SynthesisEntry {
    const Synthesis* synthesis;
    std::string output;
};

/// Rows before and after the size.
inline constexpr std::array first_rows_of_synthesis{
    fields::field<&SynthesisEntry::output>("output",
                                           "path of the file that was written; null where nothing was written")
        .or_null(),
    fields::made<SynthesisEntry>("points", "number of points along x and y",
                                 [](const SynthesisEntry& of) { return topography::shape(of.synthesis->measurement); }),
    fields::made<SynthesisEntry>("periodic", "whether the surface is periodic",
                                 [](const SynthesisEntry& of) { return !of.synthesis->plan.window; }),
    fields::made<SynthesisEntry>("seed", "seed of the random numbers",
                                 [](const SynthesisEntry& of) { return of.synthesis->plan.options.key.seed; }),
};
inline constexpr std::array last_rows_of_synthesis{
    fields::made<SynthesisEntry>("quantities", "roughness by the spectrum and by the heights",
                                 [](const SynthesisEntry& of) -> const auto& { return of.synthesis->quantities; }),
    fields::made<SynthesisEntry>("alerts", "warnings on the table of the spectrum",
                                 [](const SynthesisEntry& of) -> const auto& { return of.synthesis->plan.alerts; })
        .with(fields::Missing::left_out),
};

/// JSON of a surface.
inline constexpr auto rows_of_surface = fields::joined(
    first_rows_of_synthesis,
    std::array{fields::made<SynthesisEntry>("size", "extent along x and y",
                                            [](const SynthesisEntry& of) -> const auto& {
                                                return std::get<topography::HeightMap>(of.synthesis->measurement).size;
                                            })
                   .in_unit("m")},
    last_rows_of_synthesis);
inline constexpr fields::Description surface_description{"", "surface generated from its spectrum", rows_of_surface};

/// JSON of a line.
inline constexpr auto rows_of_line = fields::joined(
    first_rows_of_synthesis,
    std::array{fields::made<SynthesisEntry>("size", "extent of the line",
                                            [](const SynthesisEntry& of) {
                                                return std::get<topography::LineScan>(of.synthesis->measurement).size;
                                            })
                   .in_unit("m")},
    last_rows_of_synthesis);
inline constexpr fields::Description line_description{"", "with `--line` the line", rows_of_line};

[[nodiscard]] inline const fields::Description& description_of(const Synthesis& synthesis) {
    return std::holds_alternative<topography::HeightMap>(synthesis.measurement) ? surface_description
                                                                                : line_description;
}

}  // namespace setae::answers
