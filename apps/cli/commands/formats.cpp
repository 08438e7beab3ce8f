// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "setae/io/force_curve.hpp"
#include "setae/io/format.hpp"
#include "setae/workflow/tidy_table.hpp"
#include "verbs.hpp"

namespace setae::cli {
namespace {

ExitCode run(const Common& common) {
    if (common.explain) {
        for (const auto& f : io::formats()) print(f.identifier + ": " + f.description + " [" + f.reference + "]\n");
        for (const auto& f : io::force_curve_formats()) print(f.identifier + ": " + f.description + " [" + f.reference + "]\n");
        return ExitCode::done;
    }
    if (common.json) {
        workflow::Json list = workflow::Json::array();
        for (const auto& f : io::formats())
            list.push_back({{"identifier", f.identifier}, {"name", f.name}, {"extensions", f.extensions}, {"description", f.description},
                            {"reference", f.reference}, {"reads", f.reads}, {"writes", f.writes}, {"tested_on_real_files", f.tested_on_real_files}});
        workflow::Json curves = workflow::Json::array();
        for (const auto& f : io::force_curve_formats())
            curves.push_back({{"identifier", f.identifier}, {"name", f.name}, {"extensions", f.extensions}, {"description", f.description},
                              {"reference", f.reference}, {"tested_on_real_files", f.tested_on_real_files}});
        print_json({{"formats", list}, {"force_curves", curves}});
        return ExitCode::done;
    }
    workflow::TidyTable table{"", {"format", "name", "extensions", "reads", "writes", "real files", "description"}, {}};
    const auto yes = [](bool value) -> std::string { return value ? "yes" : "no"; };
    for (const auto& f : io::formats())
        table.rows.push_back({f.identifier, f.name, f.extensions, yes(f.reads), yes(f.writes), yes(f.tested_on_real_files), f.description});
    workflow::TidyTable curves{"force curves, for setae jkr", {"format", "name", "extensions", "real files", "description"}, {}};
    for (const auto& f : io::force_curve_formats()) curves.rows.push_back({f.identifier, f.name, f.extensions, yes(f.tested_on_real_files), f.description});
    print(workflow::as_text(table) + "\n" + workflow::as_text(curves) + "\nloops of force, displacement and contact radius: any table with units, workbooks (.xlsx), docs/loop-format.md\n");
    return ExitCode::done;
}

}  // namespace

void add_formats(CLI::App& program, Action& action) {
    auto common = std::make_shared<Common>();
    auto* verb = program.add_subcommand("formats", "file formats setae reads and writes");
    add_common(*verb, *common);
    verb->callback([&action, common] { action = [common] { return run(*common); }; });
}

}  // namespace setae::cli
