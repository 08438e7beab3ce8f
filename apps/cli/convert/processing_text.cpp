// SPDX-License-Identifier: GPL-3.0-or-later
#include "convert/processing_text.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "program/markdown.hpp"
#include "program/messages.hpp"
#include "program/terminal.hpp"
#include "setae/core/layout.hpp"
#include "setae/core/units.hpp"
#include "setae/processing/step_text.hpp"

namespace setae::cli {
namespace {

std::string with_blanks(std::string name) {
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

}  // namespace

std::string as_line(const processing::StepRecord& record) {
    std::string numbers;
    for (const auto& number : record.numbers) {
        const auto value = number.unit == "1" ? fmt::format("{:.6g}", number.estimate.value)
                                              : format_value(number.estimate.value, number.unit, 5);
        numbers += fmt::format("{}{} {}", numbers.empty() ? "" : ", ", with_blanks(number.quantity), value);
    }
    return fmt::format("  {:<22} {}\n", record.step, wrapped_from(25, numbers, output_size().width));
}

std::string step_list() {
    std::string text;
    for (const auto& step : processing::step_descriptions()) {
        text += fmt::format("{}  {}\n", step.name, step.sentence);
        for (const auto& parameter : step.parameters)
            text += fmt::format("    {:<12} {}{}: {}\n", parameter.name, parameter.values,
                                parameter.default_value.empty() ? "" : " [" + parameter.default_value + "]",
                                parameter.meaning);
    }
    return text +
           "\nLengths and angles have a unit: \"8 um\", \"30 deg\". A region is a list of shapes separated by \";\". Each shape is\n"
           "  include|exclude rectangle 1 um to 5 um, 0 um to 2 um | ellipse X, Y, A, B[, ANGLE] | polygon X, Y, X, Y, X, Y … |\n"
           "  heights above 20 nm | heights 5 nm to 20 nm | percentiles 5 to 95\nA shape followed by \"grow N\" grows by N pixels.\n";
}

std::string step_page() {
    std::string text =
        "# Processing steps\n\n"
        "*Reference · [all documents](../README.md)*\n\n"
        "Made from the program's own table by `setae level --documentation docs/reference/processing-steps.md`: edit the table, not this page.\n"
        "The guide [processing](../guides/processing.md) describes how to combine steps.\n\n"
        "| step | function |\n|---|---|\n";
    for (const auto& step : processing::step_descriptions())
        text += fmt::format("| [`{0}`](#{0}) | {1} |\n", step.name, markdown_cell(step.sentence));
    for (const auto& step : processing::step_descriptions()) {
        text += fmt::format("\n## {}\n\n{}\n", step.name, step.sentence);
        if (step.parameters.empty()) continue;
        text += "\n| parameter | values | default | meaning |\n|---|---|---|---|\n";
        for (const auto& parameter : step.parameters)
            text += fmt::format("| `{}` | {} | {} | {} |\n", parameter.name, markdown_cell(parameter.values),
                                markdown_cell(parameter.default_value), markdown_cell(parameter.meaning));
    }
    return text;
}

}  // namespace setae::cli
