// SPDX-License-Identifier: GPL-3.0-or-later
// Pages and JSON of studies of many things: in proportion to their number, the page bounded.
#include <gtest/gtest.h>

#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "allocated_bytes.hpp"
#include "pages.hpp"
#include "report/table.hpp"
#include "setae/output/json.hpp"
#include "setae/report/report.hpp"

namespace setae::report::growth_test {
namespace {

using output::Json;

const RunRecord run{"setae study study.toml", "2026-11-21T18:40:20Z"};

/// A study of one surface of one scan, from which larger ones are made by copies.
const study::StudyResult& one() {
    static const auto result = [] {
        const tests::Folder folder("growth");
        folder.write_scan("a.csv", 20e-9);
        return folder.run("[surfaces.A]\nmeasurements = [{ file = \"a.csv\", instrument = \"stylus\" }]\n");
    }();
    return result;
}

study::StudyResult of_measurements(std::size_t n) {
    auto result = one();
    auto& all = result.surfaces[0].measurements;
    auto& stated = result.study.surfaces[0].measurements;
    for (std::size_t i = 1; i < n; ++i) {
        all.push_back(all[0]);
        stated.push_back(stated[0]);
        stated.back().file = all.back().file = fmt::format("m{}.csv", i);
    }
    return result;
}

study::StudyResult of_surfaces(std::size_t n) {
    auto result = one();
    for (std::size_t i = 1; i < n; ++i) {
        result.surfaces.push_back(result.surfaces[0]);
        result.study.surfaces.push_back(result.study.surfaces[0]);
        result.study.surfaces.back().name = result.surfaces.back().name = fmt::format("S{}", i);
    }
    return result;
}

study::StudyResult of_missing_loops(std::size_t n) {
    auto result = one();
    for (std::size_t i = 0; i < n; ++i) {
        study::ExperimentResult missing;
        missing.input.file = fmt::format("l{}.csv", i);
        missing.input.surface = "A";
        missing.input.elastomer = "E";
        missing.error = missing.input.file + ": no such file";
        result.experiments.push_back(missing);
        result.study.experiments.push_back(missing.input);
    }
    return result;
}

std::string page_of(const study::StudyResult& result) {
    return as_html(result,
                   study_figures::study_figures(
                       result, {.threads = {1}, .max_of_a_kind = study_figures::max_of_a_kind_in_reports}),
                   run);
}

std::size_t json_size(const study::StudyResult& result) {
    std::size_t size = 0;
    output::write_json(result, [&](std::string_view piece) { size += piece.size(); });
    return size;
}

using Many = study::StudyResult (*)(std::size_t);

TEST(LargeReport, IsBoundedWithMemoryInProportion) {
    for (const Many of : {of_measurements, of_surfaces, of_missing_loops}) {
        double before = 0.0;
        for (const std::size_t n : {10u, 100u, 1000u}) {
            const auto result = of(n);
            std::size_t page = 0;
            const double bytes = tests::bytes_of([&] { page = page_of(result).size(); });
            EXPECT_LT(page, 10'000'000u) << n;
            if (before > 0.0) {
                EXPECT_LT(tests::exponent(static_cast<double>(n) / 10.0, before, static_cast<double>(n), bytes), 1.1)
                    << n;
            }
            before = bytes;
        }
    }
}

TEST(LargeJson, IsWrittenInPiecesWithBoundedMemory) {
    for (const Many of : {of_measurements, of_surfaces, of_missing_loops}) {
        double before = 0.0;
        for (const std::size_t n : {100u, 1000u}) {
            const auto result = of(n);
            std::size_t size = 0;
            const double bytes = tests::bytes_of([&] { size = json_size(result); });
            if (before > 0.0) {
                EXPECT_LT(tests::exponent(static_cast<double>(n) / 10.0, before, static_cast<double>(n), bytes), 1.1)
                    << n;
                EXPECT_LT(size, 20'000u * n);
            }
            before = bytes;
        }
    }
}

TEST(LargeJson, EqualsTheWholeDocument) {
    for (const Many of : {of_measurements, of_surfaces, of_missing_loops}) {
        const auto result = of(70);
        std::string text;
        output::write_json(result, [&](std::string_view piece) { text += piece; });
        EXPECT_EQ(text, output::as_text(output::to_json(result)));
    }
}

TEST(LargeReport, StatesOmittedRowsAndTheirFile) {
    const auto page = page_of(of_measurements(1000));
    EXPECT_NE(page.find(fmt::format(
                  "The table shows the first {} of 1000 rows. The file measurements.csv contains all rows.", max_rows)),
              std::string::npos);
    EXPECT_NE(page.find("800 more. The file alerts.csv contains all warnings."), std::string::npos);
    EXPECT_NE(page.find("The figure shows 200 of them, at equal steps through the list."), std::string::npos);
    const auto of_many_surfaces = page_of(of_surfaces(1000));
    EXPECT_NE(of_many_surfaces.find("The figure shows the first 100 of 1000 surfaces."), std::string::npos);
    EXPECT_NE(of_many_surfaces.find("more surfaces are not in this page"), std::string::npos);
    EXPECT_EQ(page_of(of_measurements(20)).find("The table shows the first"), std::string::npos);
}

}  // namespace
}  // namespace setae::report::growth_test
