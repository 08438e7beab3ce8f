// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/output/study_tables.hpp"

#include <cmath>
#include <functional>

#include "setae/core/constants.hpp"
#include "setae/output/json.hpp"
#include "setae/output/loop_tables.hpp"
#include "setae/output/replicate_report.hpp"
#include "table_support.hpp"

namespace setae::output {
namespace {

double value_of(const std::optional<Estimate>& value) { return value ? value->value : undefined; }

const study::ReportedValue* reported(const study::StudyResult& result, const std::string& fit,
                                     const std::string& quantity) {
    for (const auto& r : result.study.reported)
        if (r.fit == fit && r.quantity == quantity) return &r;
    return nullptr;
}

/// Rows of the fit table.
class FitRows {
public:
    FitRows(tables::TidyTable& table, const study::StudyResult& result, const study::Conclusions& conclusions)
        : table_(table), result_(result), method_(method_name(result, conclusions)) {}

    void add(const std::string& fit, const std::string& variant, const Estimate& work, double r_squared,
             double chi_squared, double extra_scatter, int n) {
        const auto* work_reported = variant.empty() ? reported(result_, fit, "work_of_adhesion") : nullptr;
        const auto* r_reported = variant.empty() ? reported(result_, fit, "r_squared") : nullptr;
        Cells row;
        add_cells(row, fit, variant, method_, work.value);
        append(row, uncertainty_cells(work));
        add_cells(row, r_squared, chi_squared, extra_scatter, static_cast<double>(n),
                  work_reported ? work_reported->value.value : undefined,
                  work_reported && work_reported->value.uncertain() ? work_reported->value.standard_error : undefined,
                  r_reported ? r_reported->value.value : undefined);
        table_.rows.push_back(std::move(row));
    }

    /// The reported value, and least squares as in the paper.
    void add(const std::string& fit, const adhesion::WorkFit& f, const std::string& variant = "") {
        const auto of = [&](const std::string& name) { return variant.empty() ? name : variant + ", " + name; };
        if (f.posterior) add(fit, of("posterior"), *f.posterior, f.generalised.r_squared, undefined, undefined, f.n);
        add(fit, variant, f.work_of_adhesion, f.r_squared, undefined, undefined, f.n);
    }

    /// The same pairs by every other estimator.
    void add_alternatives(const std::string& fit, const adhesion::WorkFit& f, const std::string& variant = "") {
        const auto joined = [&](const char* name) { return variant.empty() ? name : variant + ", " + name; };
        const auto& generalised = f.generalised;
        add(fit, joined("generalised least squares"), generalised.estimate(), generalised.r_squared, undefined,
            generalised.scatter.pair, f.n);
        add(fit, joined("clustered errors"), f.clustered, undefined, undefined, undefined, f.n);
        const auto estimate = [&](const char* name, const std::optional<adhesion::WorkEstimate>& e) {
            if (e) add(fit, joined(name), e->work_of_adhesion, undefined, e->chi_squared, e->extra_scatter, f.n);
        };
        estimate("weighted by the measured ±", f.weighted);
        estimate("with extra scatter", f.with_extra_scatter);
        estimate("errors in both", f.errors_in_both);
        if (f.likelihood) add(fit, joined("profile likelihood"), *f.likelihood, undefined, undefined, undefined, f.n);
    }

    void add(const std::string& fit, const std::optional<adhesion::LineFit>& f, const std::string& variant) {
        if (f) add(fit, variant, f->slope, f->r_squared, undefined, undefined, f->n);
    }

private:
    tables::TidyTable& table_;
    const study::StudyResult& result_;
    std::string method_;
};

void add_alerts(tables::TidyTable& table, const std::vector<Alert>& alerts) {
    for (const auto& a : alerts) table.rows.push_back({a.code, a.subject, a.message, a.action});
}

}  // namespace

std::vector<const study::Conclusions*> by_method(const study::StudyResult& result) {
    std::vector<const study::Conclusions*> found{&result};
    if (result.by_average) found.push_back(&*result.by_average);
    return found;
}

std::string method_name(const study::StudyResult& result, const study::Conclusions& conclusions) {
    const study::SurfaceResult* of_all = nullptr;
    for (const auto& surface : result.surfaces) {
        if (surface.failed()) continue;
        if (conclusions.method_of(surface) == study::SpectrumMethod::likelihood)
            return method_name(surface, study::SpectrumMethod::likelihood);
        if (!of_all) of_all = &surface;
    }
    return of_all ? method_name(*of_all, conclusions.method_of(*of_all)) : "";
}

std::vector<std::string> uncertainty_columns(const std::string& name, const std::string& unit) {
    const std::string of = name.empty() ? "" : name + " ", in = unit.empty() ? "" : " [" + unit + "]";
    return {of + "standard_error" + in, of + "interval_low" + in,
            of + "interval_high" + in,  of + "level",
            of + "interval_method",     of + "seed"};
}

Cells uncertainty_cells(const std::optional<Estimate>& estimate) {
    const auto interval = estimate ? interval_of(*estimate) : std::nullopt;
    const bool uncertain = estimate && estimate->uncertain(), known = uncertain || interval;
    Cells cells;
    add_cells(cells, uncertain ? estimate->standard_error : undefined, interval ? interval->lower : undefined,
              interval ? interval->upper : undefined, interval ? interval->level : undefined,
              known ? estimate->method : std::string(),
              known && estimate->seed ? std::to_string(*estimate->seed) : std::string());
    return cells;
}

tables::TidyTable surface_table(const study::StudyResult& result) {
    tables::TidyTable table{"", {"surface", "method", "quantity", "symbol", "value"}, {}};
    append(table.columns, uncertainty_columns("", ""));
    append(table.columns, {"unit", "band_low [1/m]", "band_high [1/m]", "n", "source"});
    for (const auto& surface : result.surfaces) {
        if (surface.failed()) continue;
        for (const auto& [method, spectrum] : study::spectra_of(surface))
            for (const auto& q : surface_quantities(surface, *spectrum, result.study.analysis.conversion)) {
                Cells row;
                add_cells(row, surface.name, method, q.quantity, q.symbol, q.estimate.value);
                append(row, uncertainty_cells(q.estimate));
                add_cells(row, q.unit, q.band->lower, q.band->upper, q.n ? static_cast<double>(*q.n) : undefined,
                          q.source);
                table.rows.push_back(std::move(row));
            }
    }
    return table;
}

tables::TidyTable pair_table(const study::StudyResult& result) {
    tables::TidyTable table{"", {"surface", "elastomer", "method", "W_app measured [J/m2]"}, {}};
    append(table.columns, uncertainty_columns("W_app measured", "J/m2"));
    append(table.columns, {"W_app (7) [J/m2]", "W_app (7) raw [J/m2]"});
    append(table.columns, uncertainty_columns("W_app (7)", "J/m2"));
    append(table.columns, {"W_app (S13) [J/m2]", "W_app (2) [J/m2]", "A_true/A_app [1]", "U_el/A_app [J/m2]"});
    append(table.columns, uncertainty_columns("U_el/A_app", "J/m2"));
    append(table.columns, {"W pull-off [J/m2]", "W retraction [J/m2]", "E_loss [J]"});
    append(table.columns, uncertainty_columns("E_loss", "J"));
    table.columns.emplace_back("E_loss (10) [J]");
    append(table.columns, uncertainty_columns("E_loss (10)", "J"));
    append(table.columns, {"contact area [m2]", "ideal smooth loss [J]", "W_app partial contact [J/m2]"});
    append(table.columns, uncertainty_columns("W_app partial contact", "J/m2"));
    table.columns.emplace_back("partial contact A/A_app [1]");
    for (const auto* conclusions : by_method(result))
        for (const auto& p : conclusions->pairs) {
            const auto& surface = result.surface(p.surface);
            if (conclusions->of_averages && !surface.likelihood) continue;  // the same spectrum once more
            const bool predicted = p.modified.has_value();
            Cells row;
            add_cells(row, p.surface, p.elastomer, method_name(surface, conclusions->method_of(surface)),
                      value_of(p.approach));
            append(row, uncertainty_cells(p.approach));
            add_cells(row, predicted ? p.modified->work.floored : undefined,
                      predicted ? p.modified->work.raw : undefined);
            append(row, uncertainty_cells(predicted ? std::optional(p.modified->estimate) : std::nullopt));
            add_cells(row, predicted ? p.persson_tosatti->work.floored : undefined,
                      predicted ? p.without_area_change->work.floored : undefined, predicted ? p.area_ratio : undefined,
                      predicted ? p.stored_energy.value : undefined);
            append(row, uncertainty_cells(predicted ? std::optional(p.stored_energy) : std::nullopt));
            add_cells(row, value_of(p.pull_off), value_of(p.retraction), value_of(p.loss));
            append(row, uncertainty_cells(p.loss));
            const auto loss = p.predicted_loss ? std::optional(p.predicted_loss->estimate()) : std::nullopt;
            add_cells(row, value_of(loss));
            append(row, uncertainty_cells(loss));
            const auto partial = p.partial_contact ? std::optional(p.partial_contact->estimate()) : std::nullopt;
            add_cells(row, p.contact_area.value_or(undefined), p.ideal_loss.value_or(undefined), value_of(partial));
            append(row, uncertainty_cells(partial));
            add_cells(row, predicted ? p.contact.area_fraction : undefined);
            table.rows.push_back(std::move(row));
        }
    return table;
}

namespace {

tables::TidyTable table_of_fits() {
    tables::TidyTable table{"", {"fit", "variant", "method", "W_int [J/m2]"}, {}};
    append(table.columns, uncertainty_columns("W_int", "J/m2"));
    append(table.columns, {"R2", "chi2", "extra_scatter", "n", "reported W_int [J/m2]",
                           "reported W_int standard_error [J/m2]", "reported R2"});
    return table;
}

}  // namespace

tables::TidyTable work_estimate_table(const study::StudyResult& result) {
    auto table = table_of_fits();
    for (const auto* conclusions : by_method(result)) {
        FitRows rows(table, result, *conclusions);
        if (conclusions->modified) rows.add_alternatives("modified", *conclusions->modified);
        if (conclusions->persson_tosatti) rows.add_alternatives("persson_tosatti", *conclusions->persson_tosatti);
        if (conclusions->without_area_change)
            rows.add_alternatives("without_area_change", *conclusions->without_area_change);
        if (conclusions->loop) {
            rows.add_alternatives("loop", conclusions->loop->through_origin);
            if (const auto& reduced = conclusions->loop->through_origin_without_ideal_loss)
                rows.add_alternatives("loop", *reduced, "without the smooth sphere's loss");
        }
    }
    return table;
}

tables::TidyTable fit_table(const study::StudyResult& result) {
    auto table = table_of_fits();
    for (const auto* conclusions : by_method(result)) {
        FitRows rows(table, result, *conclusions);
        if (conclusions->modified) rows.add("modified", *conclusions->modified);
        if (conclusions->persson_tosatti) rows.add("persson_tosatti", *conclusions->persson_tosatti);
        if (conclusions->without_area_change) rows.add("without_area_change", *conclusions->without_area_change);
        if (conclusions->free_energies)
            rows.add("modified", "stored energy free for each surface",
                     Estimate{.value = conclusions->free_energies->work_of_adhesion},
                     conclusions->free_energies->r_squared, undefined, undefined, conclusions->modified->n);
        if (conclusions->free_energies && conclusions->free_energies->generalised) {
            const auto& free = *conclusions->free_energies->generalised;
            rows.add("modified", "stored energy free for each surface, generalised", free.work_of_adhesion,
                     free.r_squared, undefined, free.scatter.pair, free.n);
        }
        if (conclusions->strained_interface)
            rows.add("modified", "interface changes with stretch, chi fitted",
                     conclusions->strained_interface->work_of_adhesion, conclusions->strained_interface->r_squared,
                     undefined, undefined, conclusions->strained_interface->n);
        if (conclusions->loop) {
            rows.add("loop", conclusions->loop->through_origin);
            rows.add("loop", conclusions->loop->with_intercept, "with intercept");
            if (const auto& reduced = conclusions->loop->through_origin_without_ideal_loss)
                rows.add("loop", *reduced, "without the smooth sphere's loss");
            rows.add("loop", conclusions->loop->with_intercept_without_ideal_loss,
                     "without the smooth sphere's loss, with intercept");
        }
    }
    return table;
}

tables::TidyTable measurement_table(const study::StudyResult& result) {
    tables::TidyTable table{"",
                            {"surface", "file", "name", "instrument", "trend", "window", "band_low [1/m]",
                             "band_high [1/m]", "rms_height [m]", "rms_slope [1]", "rms_curvature [1/m]", "error"},
                            {}};
    for (const auto& surface : result.surfaces)
        for (const auto& m : surface.measurements) {
            const bool fine = !m.failed();
            table.rows.push_back({surface.name, m.file, m.name, m.spectrum.metadata.instrument.type,
                                  fine ? topography::name(m.trend) : "", m.spectrum.window,
                                  fine ? m.spectrum.band.lower : undefined, fine ? m.spectrum.band.upper : undefined,
                                  fine ? m.real_space.rms_height : undefined, fine ? m.real_space.rms_slope : undefined,
                                  fine ? m.real_space.rms_curvature : undefined, m.error});
        }
    return table;
}

tables::TidyTable alert_table(const study::StudyResult& result) {
    tables::TidyTable table{"", {"code", "subject", "message", "action"}, {}};
    add_alerts(table, result.alerts);
    for (const auto& surface : result.surfaces) {
        add_alerts(table, surface.alerts);
        for (const auto& m : surface.measurements) add_alerts(table, m.alerts);
    }
    for (const auto& e : result.elastomers) add_alerts(table, e.alerts);
    for (const auto& e : result.experiments) add_alerts(table, e.alerts);
    for (const auto& p : result.pairs) add_alerts(table, p.alerts);
    return table;
}

tables::TidyTable cumulative_table(const study::StudyResult& result) {
    tables::TidyTable table{"",
                            {"surface", "method", "wavevector [1/m]", "rms_height below [m]", "rms_slope below [1]",
                             "rms_curvature below [1/m]", "U_el/(A E*) below [m]"},
                            {}};
    for (const auto& surface : result.surfaces) {
        if (surface.failed()) continue;
        for (const auto& [method, spectrum] : study::spectra_of(surface)) {
            const auto c = roughness::cumulative_parameters(spectrum->curve);
            for (Index i = 0; i < c.wavevector.size(); ++i)
                table.rows.push_back({surface.name, method, c.wavevector[i], c.rms_height[i], c.rms_slope[i],
                                      c.rms_curvature[i], c.elastic_energy_per_modulus[i]});
        }
    }
    return table;
}

namespace {

LoopLabels labels_of(const study::ExperimentInput& input) {
    return {input.file, input.reference ? "reference" : input.surface, input.elastomer, input.lens, input.spot};
}

}  // namespace

tables::TidyTable loop_fit_table(const study::StudyResult& result) {
    auto table = fits_table();
    for (const auto& e : result.experiments)
        if (e.analysis) add_fits(table, labels_of(e.input), *e.analysis);
    return table;
}

tables::TidyTable loop_energy_table(const study::StudyResult& result) {
    auto table = energies_table();
    for (const auto& e : result.experiments)
        if (e.analysis) add_energies(table, labels_of(e.input), *e.analysis);
    return table;
}

tables::TidyTable cutoff_table(const study::StudyResult& result) {
    tables::TidyTable table{"", {"shortest wavelength [m]", "method", "W_int (7) [J/m2]"}, {}};
    append(table.columns, uncertainty_columns("W_int (7)", "J/m2"));
    append(table.columns, {"R2 (7)", "W_int (S13) [J/m2]", "R2 (S13)", "W_int (7) by generalised least squares [J/m2]",
                           "W_int (7) by generalised least squares standard_error [J/m2]", "log likelihood (7)"});
    for (const auto* conclusions : by_method(result))
        for (const auto& p : conclusions->cutoff_scan) {
            Cells row;
            add_cells(row, p.shortest_wavelength, method_name(result, *conclusions), p.modified.work_of_adhesion.value);
            append(row, uncertainty_cells(p.modified.work_of_adhesion));
            add_cells(row, p.modified.r_squared, p.persson_tosatti.work_of_adhesion.value, p.persson_tosatti.r_squared,
                      p.modified.generalised.work_of_adhesion.value,
                      p.modified.generalised.work_of_adhesion.standard_error(), p.modified.generalised.log_likelihood);
            table.rows.push_back(std::move(row));
        }
    return table;
}

tables::TidyTable full_contact_table(const study::StudyResult& result) {
    tables::TidyTable table{"",
                            {"surface", "elastomer", "method", "q [1/m]", "gained above [J/m2]", "stored above [J/m2]",
                             "closing", "closing pressure [Pa]"},
                            {}};
    constexpr double next = 1.122;  // twenty per decade
    for (const auto* conclusions : by_method(result))
        for (const auto& pair : conclusions->pairs) {
            if (!pair.scales) continue;
            const auto& scales = *pair.scales;
            double last = 0.0;
            for (Index i = 0; i + 1 < scales.wavevector.size(); ++i) {
                if (scales.wavevector[i] < next * last) continue;
                last = scales.wavevector[i];
                table.rows.push_back({pair.surface, pair.elastomer, method_name(result, *conclusions), last,
                                      scales.gained[i], scales.stored[i], std::string(name(scales.closing(i))),
                                      scales.closing_pressure[i]});
            }
        }
    return table;
}

tables::TidyTable balance_table(const study::StudyResult& result) {
    tables::TidyTable table{"",
                            {"balance", "method", "shortest wavelength [m]", "surface energy factor", "n", "parameters",
                             "W_int [J/m2]", "R2", "ln L", "left out rms [J/m2]"},
                            {}};
    for (const auto* conclusions : by_method(result))
        for (const auto& b : conclusions->balances)
            table.rows.push_back({b.balance, method_name(result, *conclusions),
                                  b.shortest_wavelength > 0.0 ? b.shortest_wavelength : undefined,
                                  b.surface_energy_factor, static_cast<double>(b.score.n),
                                  static_cast<double>(b.score.parameters), b.score.work_of_adhesion, b.score.r_squared,
                                  b.score.log_likelihood, b.score.left_out_deviation});
    return table;
}

namespace {

/// Tables of single elastomers under each other, the elastomer in front.
tables::TidyTable of_all_elastomers(
    const study::StudyResult& result,
    const std::function<std::optional<tables::TidyTable>(const study::ElastomerReplicates&)>& table_of) {
    tables::TidyTable all;
    for (const auto& replicates : result.replicates) {
        const auto table = table_of(replicates);
        if (!table) continue;
        if (all.columns.empty()) {
            all.columns = {"elastomer"};
            append(all.columns, table->columns);
        }
        for (const auto& row : table->rows) {
            Cells cells{replicates.elastomer};
            append(cells, row);
            all.rows.push_back(std::move(cells));
        }
    }
    return all;
}

}  // namespace

tables::TidyTable replicate_table(const study::StudyResult& result) {
    return of_all_elastomers(
        result, [](const study::ElastomerReplicates& r) { return std::optional(replicate_table(r.data)); });
}

tables::TidyTable replicate_mean_table(const study::StudyResult& result) {
    return of_all_elastomers(result, [](const study::ElastomerReplicates& r) {
        return r.model ? std::optional(replicate_mean_table(r.data, *r.model)) : std::nullopt;
    });
}

tables::TidyTable prediction_test_table(const study::StudyResult& result) {
    tables::TidyTable table{
        "",
        {"surface", "elastomer", "method", "W_app measured [J/m2]", "W_app measured standard_error [J/m2]",
         "W_app (7) [J/m2]", "W_app (7) standard_error [J/m2]", "residual [J/m2]", "residual standard_error [J/m2]",
         "residual [standard errors]", "chi2", "degrees_of_freedom", "probability", "extra_scatter [J/m2]",
         "chi2 with scatter", "probability with scatter"},
        {}};
    for (const auto* conclusions : by_method(result)) {
        if (!conclusions->prediction_test) continue;
        const auto& test = *conclusions->prediction_test;
        for (const auto& p : test.pairs)
            table.rows.push_back({p.surface, p.elastomer, method_name(result, *conclusions), p.measured.value,
                                  p.measured.standard_error, p.predicted.value, p.predicted.standard_error, p.residual,
                                  p.standard_error, p.standardised(), undefined, undefined, undefined, undefined,
                                  undefined, undefined});
        Cells row{std::string("all"), std::string("all"), method_name(result, *conclusions)};
        for (int i = 0; i < 7; ++i) row.emplace_back(undefined);
        add_cells(row, test.chi_squared, static_cast<double>(test.degrees_of_freedom), test.probability,
                  test.extra_scatter, test.chi_squared_with_scatter, test.probability_with_scatter);
        table.rows.push_back(std::move(row));
    }
    return table;
}

}  // namespace setae::output
