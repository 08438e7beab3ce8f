// SPDX-License-Identifier: GPL-3.0-or-later
#include "jkr/jkr_curve.hpp"

#include <fmt/format.h>

#include "program/messages.hpp"
#include "program/terminal.hpp"
#include "setae/core/layout.hpp"
#include "setae/core/uncertain_text.hpp"
#include "setae/core/units.hpp"
#include "setae/output/force_map_output.hpp"
#include "setae/output/loop_answer.hpp"
#include "setae/tables/tidy_table.hpp"

namespace setae::cli {

void print_curve(const std::string& file, const loops::ForceCurveAnalysis& analysis) {
    tables::TidyTable table{"",
                            {"segment", "tip", "model", "E* [kPa]", "E [kPa]", "W [mJ/m²]", "contact point [µm]",
                             "indentation [µm]", "n", "rms residual"},
                            {}};
    std::string reasons;
    for (const auto& segment : analysis.segments) {
        if (!segment.fit) {
            reasons += fmt::format("  {}: {}\n", segment.name, segment.fit.reason);
            continue;
        }
        const auto& fit = *segment.fit;
        table.rows.push_back({segment.name, to_string(fit.shape), to_string(fit.model),
                              uncertain_number(fit.contact_modulus, 1e3), uncertain_number(fit.youngs_modulus, 1e3),
                              fit.work_of_adhesion ? uncertain_number(*fit.work_of_adhesion, 1e-3) : "–",
                              uncertain_number(fit.contact_point, 1e-6),
                              fmt::format("{:.4g} … {:.4g}", 1e6 * fit.indentation_from, 1e6 * fit.indentation_to),
                              fmt::format("{}", fit.n), format_value(fit.rms_residual, "N", 3)});
    }
    const auto width = output_size().width;
    print(wrapped(file + ": " + output::answer(analysis.summary), width, 2) + "\n" +
          tables::as_text_within(table, width) + reasons);
}

void print_map(const study::ForceMap& map) {
    const auto width = output_size().width;
    print(wrapped(map.file + ": " + output::answer(map), width, 2) + "\n" +
          tables::as_text_within(output::spread_table(map), width));
}

}  // namespace setae::cli
