// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <memory>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "jkr/loop_arguments.hpp"
#include "jkr/loop_figures.hpp"
#include "program/command.hpp"
#include "program/command_line.hpp"
#include "program/messages.hpp"
#include "program/print_json.hpp"
#include "program/terminal.hpp"
#include "setae/answers/loop_fields.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/display_unit.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/uncertain_text.hpp"
#include "setae/core/units.hpp"
#include "setae/output/field_json.hpp"
#include "setae/output/loop_tables.hpp"
#include "setae/study_figures/loop_figures.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::cli::jkr_energy_command {
namespace {

constexpr const char* explanation =
    "The command computes the energy budget of a loop.\n"
    "\n"
    "E_loss    closed integral of F d(delta); F relative to free flight, drift removed\n"
    "errors    noise: of both channels\n"
    "          drift: from the zeros at both ends\n"
    "          compliance: of the testing machine\n"
    "          sampling: time of a jump within one step\n"
    "          discretisation: trapezoid rule against every second sample\n"
    "parts     jump-in, approach, retraction (< 0: recovered), jump-out; with free flight their sum is E_loss\n"
    "ideal     loss of a smooth sphere with W and E* of loading in its two jumps\n"
    "          Fixed grips: 0.663 W pi a_0^2. The second number includes the stiffness of the testing machine.\n"
    "course    work = elastic + surface + dissipated\n"
    "          U_E = E* (delta^2 a - 2/3 delta a^3/R + a^5/(5R^2)), surface energy -W pi a^2\n"
    "per area  E_loss over pi a_max^2, and over r pi a_max^2 with r = A_true/A_app from --area-ratio\n"
    "          The second is the work of the true-area loss (Eq. 10) of Dalvi et al., PNAS 116 (2019) 25484.\n";

struct Arguments {
    Common common;
    LoopAnalysisRequest request;
    std::string tidy, course, figures;
};

loops::EnergyCourse course_of(const AnalysedLoop& loop) {
    const auto& analysis = loop.analysis;
    if (!analysis.contact_points) throw UndefinedDataError(analysis.contact_points.reason);
    const auto& fit = analysis.loading.primary();
    return loops::energy_course(
        analysis.corrected, analysis.segments.contacts.front(),
        {.contact = {loop.bodies.radius, fit.contact_modulus.value, std::max(fit.work_of_adhesion.value, 0.0)},
         .contact_point = analysis.contact_points->contact_point.value});
}

Table table_of(const AnalysedLoop& loop, const loops::EnergyCourse& course) {
    const auto& record = loop.analysis.corrected;
    const Index first = course.range.first, n = course.work.size();
    Table table;
    if (record.time.size() > 0) table.columns.push_back({"time", "s", record.time.segment(first, n)});
    table.columns.push_back({"force", "N", record.force.segment(first, n)});
    table.columns.push_back({"displacement", "m", record.displacement.segment(first, n)});
    for (const auto& [name, values] :
         {std::pair{"work", &course.work}, std::pair{"elastic", &course.elastic}, std::pair{"surface", &course.surface},
          std::pair{"dissipated", &course.dissipated}, std::pair{"released", &course.released}})
        table.columns.push_back({name, "J", *values});
    table.columns.push_back({"contact_radius", "m", course.contact_radius});
    return table;
}

void print_energy_budget(const AnalysedLoop& loop) {
    const auto& budget = loop.analysis.budget;
    if (!budget) {
        print(fmt::format("{}: {}\n", loop.file, budget.reason));
        return;
    }
    const auto unit = display_unit(budget->loop.energy, "J");
    tables::TidyTable table{
        loop.file,
        {"part", fmt::format("energy [{}]", unit.name), "± of noise", "drift", "sampling", "discretisation"},
        {}};
    const auto add = [&](const std::string& part, double energy, const loops::LoopErrorBudget& e) {
        std::vector<tables::TidyTable::Cell> row{
            part, uncertain_number({.value = energy, .standard_error = e.total}, unit.factor)};
        for (const double share : {e.noise, e.drift, e.sampling, e.discretisation})
            row.emplace_back(share > 0.0 ? format_value(share, "J", 2) : "0");
        table.rows.push_back(std::move(row));
    };
    add("closed loop", budget->loop.energy, budget->loop.standard_error);
    add("free flight before", budget->before_contact.energy, budget->before_contact.standard_error);
    if (budget->jump_in) add("jump-in", budget->jump_in->energy, budget->jump_in->standard_error);
    add("approach", budget->approach.energy, budget->approach.standard_error);
    add("retraction", budget->retraction.energy, budget->retraction.standard_error);
    if (budget->jump_out) add("jump-out", budget->jump_out->energy, budget->jump_out->standard_error);
    add("free flight after", budget->after_contact.energy, budget->after_contact.standard_error);
    std::string text = tables::as_text_within(table, output_size().width);
    const auto line = [&](const char* what, const std::string& value) {
        text += fmt::format("  {:<34} {}\n", what, value);
    };
    line("smooth sphere, fixed grips", format_value(budget->ideal_fixed_grips, "J"));
    line("smooth sphere, testing machine", fmt::format("{} (k = {})", format_value(budget->ideal_this_machine, "J"),
                                                       format_value(budget->machine_stiffness, "N/m")));
    if (budget->recovered_share > 0.0)
        line("recovered work of approach", fmt::format("{:.1f} %", 100.0 * budget->recovered_share));
    line("loss per apparent area", format_value(budget->loss_per_apparent_area, "J/m2"));
    line("loss per true area",
         fmt::format("{} (r = {:.4g})", format_value(budget->loss_per_true_area, "J/m2"), budget->true_area_ratio));
    for (std::size_t i = 0; i < loop.analysis.cycles.size() && loop.analysis.cycles.size() > 1; ++i) {
        const auto& energy = loop.analysis.cycles[i].energy;
        line(fmt::format("cycle {}", i + 1).c_str(), energy ? format_value(*energy, "J") : energy.reason);
    }
    print(text);
}

/// Figures of the energy course of every loop, and of all losses.
class EnergyFigures {
public:
    explicit EnergyFigures(const Arguments& arguments) : arguments_(arguments) {}

    void add(const AnalysedLoop& loop, const loops::EnergyCourse& course) {
        const auto name = figure_name(loop.file);
        figures_.push_back(study_figures::course_figure(
            {.name = name, .analysis = loop.analysis, .bodies = loop.bodies, .options = loop.options}, course,
            command_line()));
        if (const auto& budget = loop.analysis.budget)
            losses_.push_back({name, budget->loop.estimate(), budget->largest_true_area(), budget->ideal_this_machine});
    }
    void write() {
        figures_.push_back(study_figures::loss_figure(losses_, command_line()));
        write_loop_figures(figures_, arguments_.figures, arguments_.common.workers());
    }

private:
    const Arguments& arguments_;
    std::vector<study_figures::StudyFigure> figures_;
    std::vector<study_figures::NamedLoss> losses_;
};

ExitCode run(const Arguments& arguments) {
    output::Json list = output::Json::array();
    auto energies = output::energies_table();
    EnergyFigures figures(arguments);
    std::vector<Alert> alerts;
    const bool courses = !arguments.course.empty() || !arguments.figures.empty();
    if (!arguments.course.empty()) std::filesystem::create_directories(arguments.course);
    const auto code = for_each_loop(arguments.request, arguments.common.workers(), [&](const AnalysedLoop& loop) {
        output::add_energies(energies, output::labels_stated_in(loop.opened.table, loop.file), loop.analysis);
        if (arguments.common.json) {
            list.push_back(output::described(answers::LoopEnergies{&loop}));
        } else {
            print_energy_budget(loop);
            alerts.insert(alerts.end(), loop.analysis.alerts.begin(), loop.analysis.alerts.end());
        }
        if (!courses) return;
        try {
            const auto course = course_of(loop);
            const auto name = figure_name(loop.file) + "_course.csv";
            if (!arguments.course.empty())
                tables::write_csv((std::filesystem::path(arguments.course) / name).string(), table_of(loop, course));
            if (!arguments.figures.empty()) figures.add(loop, course);
        } catch (const UndefinedDataError& error) {
            print_message(fmt::format("{}: no course of the energy: {}", loop.file, error.what()));
        }
    });
    show(alerts);
    if (arguments.common.json && !list.empty()) print_json(list.size() == 1 ? list.front() : list);
    if (code == ExitCode::nothing_done) return code;
    if (!arguments.figures.empty()) figures.write();
    if (!arguments.tidy.empty()) bytes::write_whole_file(arguments.tidy, tables::as_csv(energies));
    return code;
}

}  // namespace

Action declare(Options& options) {
    auto arguments = std::make_shared<Arguments>();
    arguments->request.add_to(options);
    options.output("--tidy", arguments->tidy, "CSV table of the energies of every contact and cycle of all loops");
    options.output("--course", arguments->course,
                   "folder of NAME_course.csv: work, elastic, surface and dissipated energy, sample by sample");
    options.output("--figures", arguments->figures,
                   "folder of figures: the course of each loop, and losses against true area");
    options.example("setae jkr energy loop.csv --radius \"1.25 mm\"", "energy budget of a loop");
    options.example("setae jkr energy loops/*.csv --radius \"1.25 mm\" --figures figures",
                    "energy budgets of several loops, with figures");
    return action(options, arguments, explanation, run);
}

}  // namespace setae::cli::jkr_energy_command
