// SPDX-License-Identifier: GPL-3.0-or-later
// How often the tests of a measurement find faults in surfaces that have none, and how many true spikes they find:
// the table of docs/reference/diagnostics.md.  diagnostics_survey [surfaces of each kind, default 100]
#include <cstdio>
#include <cstdlib>

#include <fmt/format.h>

#include "survey.hpp"

int main(int argc, char** argv) {
    const int surfaces = argc > 1 ? std::atoi(argv[1]) : 100;
    if (surfaces < 1) {
        fmt::print(stderr, "expected a number of surfaces >= 1\n");
        return 2;
    }
    fmt::print(
        "| surfaces | alarmed | findings | spikes added | found | other points blamed |\n|---|---|---|---|---|---|\n");
    const auto row = [&](const char* kind, const setae::reference::Survey& survey) {
        std::string codes;
        for (const auto& [code, count] : survey.codes)
            codes += fmt::format("{}{} {}", codes.empty() ? "" : ", ", count, code);
        fmt::print("| {} {} | {:.1f} % | {} | {} | {:.2f} % | {} |\n", survey.surfaces, kind,
                   100.0 * survey.alarm_share(), codes.empty() ? "none" : codes, survey.spikes_added,
                   100.0 * survey.found_share(), survey.points_blamed);
    };
    row("maps of 128 x 128 points", setae::reference::survey_maps(surfaces));
    row("lines of 512 points", setae::reference::survey_lines(surfaces));
    return 0;
}
