// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>

#include "setae/imaging/micrograph.hpp"
#include "setae/io/force_curve.hpp"
#include "setae/io/format.hpp"
#include "setae/workflow/tidy_table.hpp"
#include "verbs.hpp"

namespace setae::cli {
namespace {

/// Formats that are read alone.
template <class Formats>
workflow::Json as_json(const Formats& formats) {
    workflow::Json list = workflow::Json::array();
    for (const auto& f : formats)
        list.push_back({{"identifier", f.identifier}, {"name", f.name}, {"extensions", f.extensions}, {"description", f.description},
                        {"reference", f.reference}, {"tested_on_real_files", f.tested_on_real_files}});
    return list;
}

std::string yes(bool value) { return value ? "yes" : "no"; }

template <class Formats>
workflow::TidyTable as_table(const std::string& title, const Formats& formats) {
    workflow::TidyTable table{title, {"format", "name", "extensions", "real files", "description"}, {}};
    for (const auto& f : formats) table.rows.push_back({f.identifier, f.name, f.extensions, yes(f.tested_on_real_files), f.description});
    return table;
}

ExitCode run(const Common& common) {
    if (common.explain) {
        for (const auto& f : io::formats()) print(f.identifier + ": " + f.description + " [" + f.reference + "]\n");
        for (const auto& f : io::force_curve_formats()) print(f.identifier + ": " + f.description + " [" + f.reference + "]\n");
        for (const auto& f : imaging::micrograph_formats()) print(f.identifier + ": " + f.description + " [" + f.reference + "]\n");
        return ExitCode::done;
    }
    if (common.json) {
        workflow::Json list = workflow::Json::array();
        for (const auto& f : io::formats())
            list.push_back({{"identifier", f.identifier}, {"name", f.name}, {"extensions", f.extensions}, {"description", f.description},
                            {"reference", f.reference}, {"writes", f.writes()}, {"tested_on_real_files", f.tested_on_real_files}});
        print_json({{"formats", list}, {"force_curves", as_json(io::force_curve_formats())}, {"micrographs", as_json(imaging::micrograph_formats())}});
        return ExitCode::done;
    }
    workflow::TidyTable table{"", {"format", "name", "extensions", "writes", "real files", "description"}, {}};
    for (const auto& f : io::formats())
        table.rows.push_back({f.identifier, f.name, f.extensions, yes(f.writes()), yes(f.tested_on_real_files), f.description});
    const auto curves = as_table("force curves, for setae jkr", io::force_curve_formats());
    const auto micrographs = as_table("micrographs, for setae contour", imaging::micrograph_formats());
    print(workflow::as_text(table) + "\n" + workflow::as_text(curves) + "\n" + workflow::as_text(micrographs) +
          "\nloops of force, displacement and contact radius: any table with units, workbooks (.xlsx), docs/loop-format.md\n");
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
