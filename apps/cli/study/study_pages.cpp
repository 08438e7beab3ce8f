// SPDX-License-Identifier: GPL-3.0-or-later
#include "study/study_pages.hpp"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "setae/output/alert_groups.hpp"
#include "setae/output/alert_kinds.hpp"
#include "setae/study/study_keys.hpp"
#include "setae/study_figures/figure_kinds.hpp"

namespace setae::cli {
namespace {

constexpr const char* origin =
    "*Reference · [all documents](../README.md)*\n\n"
    "Made from the program's own tables by `setae study --documentation docs/reference`: edit the tables, not\nthis page.";

std::string keys_page() {
    std::string text = fmt::format(
        "# Keys of a study\n\n{} The guide [writing a study](../guides/study.md) describes how to write and run\na study. "
        "A number with a dimension is written in quotes, with any unit of the dimension shown. `\"37.0 ± 3.7 mJ/m2\"` (or `+-`) "
        "gives\na standard error. Paths are relative to the study file.\n",
        origin);
    for (const auto& table : study::study_keys()) {
        text += fmt::format("\n## {}\n\n", table.name.empty() ? "top of the file" : "`" + table.name + "`");
        if (!table.meaning.empty()) text += table.meaning + "\n\n";
        text += "| key | type | unit | default | meaning |\n|---|---|---|---|---|\n";
        for (const auto& key : table.keys)
            text +=
                fmt::format("| `{}` | {} | {} | {} | {} |\n", key.key, key.type, key.unit, key.standard, key.meaning);
    }
    return text;
}

std::string alerts_page() {
    const auto kinds = output::alert_kinds();
    std::string text = fmt::format(
        "# Warnings\n\n{} It describes {} kinds of warnings. Each warning has a code in capitals, a subject, a message "
        "and an\naction. The warnings of a study are listed in alerts.csv and in its report.\n",
        origin, kinds.size());
    std::string about;
    for (const auto& kind : kinds) {
        if (kind.about != about) {
            about = kind.about;
            text += fmt::format("\n## {}{}\n", static_cast<char>(std::toupper(about.front())), about.substr(1));
        }
        text += fmt::format("\n### {}\n\n{}\n\n- Effect: {}\n- Action: {}\n", kind.code, kind.said, kind.effect,
                            kind.action);
        if (output::is_general_warning(kind.code))
            text += "- General warning: the terminal only counts it without `--all`.\n";
        if (!kind.rests_on.empty()) text += fmt::format("- Threshold: {}\n", kind.rests_on);
    }
    return text;
}

std::string figures_page() {
    const auto kinds = study_figures::figure_kinds();
    const auto repeated = [](const auto& kind) { return kind.identifier.ends_with(":NAME"); };
    const auto several = std::count_if(kinds.begin(), kinds.end(), repeated);
    std::string text = fmt::format(
        "# Figures of a study\n\n{} There are {} kinds of figures: {} are drawn once per study, and {} are repeated,\n"
        "once per surface with measurements (`spectra:NAME`) and once per loop (`loop:NAME`). The figure numbers up to S8 and "
        "the equation\nnumbers are those of Dalvi et al., PNAS 116 (2019) 25484. The guide [figures](../guides/figures.md) "
        "describes the figures.\n\n"
        "| identifier | title | drawn | from |\n|---|---|---|---|\n",
        origin, kinds.size(), static_cast<std::ptrdiff_t>(kinds.size()) - several, several);
    for (const auto& kind : kinds)
        text += fmt::format("| {} | {} | {} | {} |\n", kind.identifier, kind.title, kind.shows, kind.from);
    return text;
}

}  // namespace

std::map<std::string, std::string> study_pages() {
    return {{"study-keys.md", keys_page()}, {"alerts.md", alerts_page()}, {"figures.md", figures_page()}};
}

}  // namespace setae::cli
