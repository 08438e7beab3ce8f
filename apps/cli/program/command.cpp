// SPDX-License-Identifier: GPL-3.0-or-later
#include "program/command.hpp"

#include "program/messages.hpp"

namespace setae::cli {

void Common::add_to(Options& options) {
    options.flag("--json", json, "print JSON, SI units").in(OptionGroup::output);
    if (!options.has("--all")) options.flag("--all", all, "every warning and column in full").in(OptionGroup::output);
    options.flag("--explain", explain, "print formulas and sources, then stop");
    options.add("--threads", threads, "number of threads; results do not depend on it")
        .between(1, 1024)
        .value_named("N")
        .in(OptionGroup::advanced);
}

void Common::apply() const {
    parallel::limit_threads(workers());
    show_every_warning(all);
}

ExitCode explained(const Explanation& explanation) {
    const auto* text = std::get_if<const char*>(&explanation);
    print(text ? *text : std::get<std::string (*)()>(explanation)());
    return ExitCode::done;
}

}  // namespace setae::cli
