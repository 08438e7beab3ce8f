// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>

#include <unistd.h>

#include "results/pairs.hpp"
#include "setae/core/errors.hpp"
#include "setae/output/json.hpp"
#include "setae/output/replicate_report.hpp"
#include "setae/output/study_tables.hpp"
#include "setae/study/replicate_reader.hpp"

namespace setae::study::replicates_test {
namespace {

class ReplicateFiles : public testing::Test {
protected:
    void SetUp() override { std::filesystem::create_directories(folder_); }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::string write(const std::string& name, const std::string& text) {
        const auto path = (folder_ / name).string();
        std::ofstream(path, std::ios::binary) << text;
        return path;
    }
    template <class Call>
    std::string message_of(const Call& call) {
        try {
            call();
        } catch (const Error& error) {
            return error.what();
        }
        return "no error";
    }

    std::filesystem::path folder_ =
        std::filesystem::temp_directory_path() / ("setae_replicates_" + std::to_string(::getpid()));
};

constexpr const char* tidy =
    "file,surface,lens,spot,branch,method,W [mJ/m2],W standard_error [mJ/m2],E_star [MPa]\n"
    "a.csv,A,1,1,loading,radius_force,40,2,1.0\n"
    "a.csv,A,1,1,loading,linear_form,41,1,1.1\n"
    "a.csv,A,1,1,unloading,radius_force,60,2,1.2\n"
    "\"b, c.csv\",A,1,2,loading,radius_force,44,3,1.3\n";

TEST_F(ReplicateFiles, AreReadInSiByMethodAndBranch) {
    const auto path = write("fits.csv", tidy);
    const auto tables = read_replicates({path}, {.method = "radius_force", .branch = "loading"}, {});
    ASSERT_EQ(tables.data.rows.size(), 2U);
    EXPECT_EQ(tables.data.levels, (std::vector<std::string>{"surface", "lens", "spot"}));
    EXPECT_DOUBLE_EQ(tables.data.rows[1].value, 44e-3);
    EXPECT_DOUBLE_EQ(tables.data.rows[1].standard_error, 3e-3);
    EXPECT_EQ(tables.data.rows[1].name, "b, c.csv");
    EXPECT_EQ(tables.data.unit, "J/m2");
    EXPECT_TRUE(tables.bad_rows.empty());
    const auto modulus = read_replicates({path}, {.quantity = "E*", .method = "linear_form"}, {});
    EXPECT_DOUBLE_EQ(modulus.data.rows.at(0).value, 1.1e6);
    EXPECT_TRUE(std::isnan(modulus.data.rows.at(0).standard_error));
}

TEST_F(ReplicateFiles, WithSeveralMethodsRequireAChoice) {
    const auto path = write("fits.csv", tidy);
    EXPECT_NE(
        message_of([&] { (void)read_replicates({path}, {.branch = "loading"}, {}); }).find("choose one with `method`"),
        std::string::npos);
    EXPECT_NE(message_of([&] {
                  (void)read_replicates({path}, {.method = "pointwise"}, {});
              }).find("there are linear_form, radius_force"),
              std::string::npos);
}

TEST_F(ReplicateFiles, OfOtherProgramsRequireColumnNamesOnly) {
    const auto path =
        write("other.csv", "# made elsewhere\r\nProbe;Linse;Arbeit;Fehler\r\nA;1;40,5;2,5\r\nA;2;41,5;\r\n");
    const auto tables = read_replicates(
        {path}, {.group_by = {"Probe", "Linse"}, .value_column = "Arbeit", .error_column = "Fehler", .unit = "mJ/m2"},
        {});
    EXPECT_DOUBLE_EQ(tables.data.rows.at(0).value, 40.5e-3);
    EXPECT_DOUBLE_EQ(tables.data.rows.at(0).standard_error, 2.5e-3);
    EXPECT_TRUE(std::isnan(tables.data.rows.at(1).standard_error));
    EXPECT_EQ(tables.data.rows.at(1).name, path + ":4");
}

TEST_F(ReplicateFiles, UseThePrimaryFitOfEachLoopOrGiveTheReason) {
    const auto path = write(
        "tidy.csv",
        "file,surface,elastomer,lens,spot,contact,cycle,branch,method,W [J/m2],W_standard_error [J/m2],primary,reason\n"
        "a.csv,A,soft,1,1,1,1,loading,radius_force,0.04,0.001,no,\n"
        "a.csv,A,soft,1,1,1,1,loading,joint,0.05,0.001,yes,\n"
        "b.csv,A,soft,1,2,1,1,loading,,,,no,too few samples\n"
        "c.csv,A,hard,1,2,1,1,loading,joint,0.06,0.001,yes,\n");
    const auto soft = read_replicates({path}, {.elastomer = "soft"}, {});
    ASSERT_EQ(soft.data.rows.size(), 1U);
    EXPECT_EQ(soft.data.rows[0].value, 0.05);
    EXPECT_EQ(soft.bad_rows.at(0).reason, "no W: too few samples");
    EXPECT_EQ(read_replicates({path}, {.method = "radius_force"}, {}).data.rows.at(0).value, 0.04);
    EXPECT_EQ(read_replicates({path}, {.group_by = {"elastomer", "surface"}}, {}).data.rows.size(), 2U);
    EXPECT_NE(message_of([&] { (void)read_replicates({path}, {}, {}); }).find("choose one with `elastomer`"),
              std::string::npos);
}

TEST_F(ReplicateFiles, CountTheEnergyOfAContactOnce) {
    const auto path = write("energies.csv",
                            "file,surface,contact,cycle,E_loss [nJ],E_loss_standard_error [nJ],reason\n"
                            "a.csv,A,1,,3,0.1,\na.csv,A,,1,1,0.1,\na.csv,A,,2,2,0.1,\nb.csv,A,1,,4,0.1,\n");
    const auto tables = read_replicates({path}, {.quantity = "E_loss"}, {});
    ASSERT_EQ(tables.data.rows.size(), 2U);
    EXPECT_DOUBLE_EQ(tables.data.rows[1].value, 4e-9);
}

TEST_F(ReplicateFiles, NameTheLineOfAnInvalidRow) {
    const auto path = write(
        "bad.csv",
        "surface,lens,W [J/m2],W_se [J/m2]\nA,1,0.04,0.001\nA,1,,0.001\nA,,0.05,0.001\nA,2,much,0.001\nA,2,0.04,-1\n");
    const auto tables = read_replicates({path}, {}, {});
    EXPECT_EQ(tables.data.rows.size(), 1U);
    ASSERT_EQ(tables.bad_rows.size(), 4U);
    EXPECT_EQ(tables.bad_rows[0].place, path + ":3");
    EXPECT_EQ(tables.bad_rows[0].reason, "no W");
    EXPECT_EQ(tables.bad_rows[1].reason, "no lens");
    EXPECT_EQ(tables.bad_rows[2].reason, "W is 'much'; expected a number");
    EXPECT_NE(tables.bad_rows[3].reason.find("'-1'"), std::string::npos);
}

TEST_F(ReplicateFiles, ReportMissingColumns) {
    const auto message = [&](const std::string& text, const ReplicateColumns& columns = {}) {
        const auto path = write("table.csv", text);
        return message_of([&] { (void)read_replicates({path}, columns, {}); });
    };
    EXPECT_NE(message("").find("the table is empty"), std::string::npos);
    EXPECT_NE(message("surface,lens\nA,1\n").find("no column of 'W'"), std::string::npos);
    EXPECT_NE(message("surface,W\nA,1\n").find("has no unit"), std::string::npos);
    EXPECT_NE(message("sample,W [J/m2]\nA,1\n").find("`group_by`"), std::string::npos);
    EXPECT_NE(message("surface,W [J/m2]\nA,1,2\n").find("table.csv:2: 3 cells, but the header has 2"),
              std::string::npos);
    EXPECT_NE(message("surface,W [J/m2]\nA,\n").find("no row with a number"), std::string::npos);
}

TEST_F(ReplicateFiles, ExclusionsKeepTheirRowsAndReasons) {
    const auto path = write("fits.csv", tidy);
    const ReplicateColumns columns{.method = "radius_force", .branch = "loading"};
    const auto tables = read_replicates({path}, columns, {parse_exclusion("file=a.csv; reason=dust on the lens")});
    EXPECT_EQ(tables.data.rows.size(), 2U);
    ASSERT_EQ(tables.data.exclusions.size(), 1U);
    EXPECT_EQ(tables.data.exclusions[0].row, 0U);
    EXPECT_EQ(tables.data.exclusions[0].reason, "dust on the lens");
    EXPECT_NE(message_of([&] {
                  (void)read_replicates({path}, columns, {parse_exclusion("file=z.csv;reason=x")});
              }).find("no row meets"),
              std::string::npos);
    EXPECT_NE(message_of([&] {
                  (void)read_replicates({path}, columns,
                                        {parse_exclusion("spot=1;reason=x"), parse_exclusion("file=a.csv;reason=y")});
              }).find("excluded twice"),
              std::string::npos);
    EXPECT_NE(message_of([] { (void)parse_exclusion("file=a.csv"); }).find("without a reason"), std::string::npos);
    EXPECT_NE(message_of([] { (void)parse_exclusion("reason=x"); }).find("names no row"), std::string::npos);
}

TEST_F(ReplicateFiles, ExclusionsCanBeReadFromFiles) {
    const auto toml = write("out.toml", "[[exclude]]\nfile = \"a.csv\"\nspot = 1\nreason = \"dust\"\n");
    const auto rules = read_exclusions(toml);
    ASSERT_EQ(rules.size(), 1U);
    EXPECT_EQ(rules[0].reason, "dust");
    EXPECT_EQ(rules[0].conditions.at("spot"), "1");
    const auto csv = write("out.csv", "file,spot,reason\na.csv,,slipped\n");
    EXPECT_EQ(read_exclusions(csv).at(0).conditions.size(), 1U);
    const auto bad_toml = write("bad.toml", "[[exclude]]\nfile = \"a.csv\"\n"),
               bad_csv = write("bad.csv", "file,reason\na.csv,\n");
    EXPECT_NE(message_of([&] { (void)read_exclusions(bad_toml); }).find("without a reason"), std::string::npos);
    EXPECT_NE(message_of([&] { (void)read_exclusions(bad_csv); }).find("bad.csv:2: "), std::string::npos);
}

/// A loop on a surface of which only the work of adhesion is known.
ExperimentResult loop_of(const std::string& surface, const std::string& lens, const std::string& spot, double work) {
    ExperimentResult result;
    result.input.file = surface + lens + spot + ".csv";
    result.input.surface = surface;
    result.input.elastomer = "soft";
    result.input.lens = lens;
    result.input.spot = spot;
    loops::LoopAnalysis loop;
    loop.loading.radius_force = loops::Outcome<loops::JkrFit>(
        loops::JkrFit{.method = "radius_force", .converged = true, .work_of_adhesion = {work, 0.001}});
    result.analysis = loop;
    return result;
}

StudyResult study_with_lenses() {
    StudyResult result;
    result.surfaces.resize(1);
    result.surfaces[0].name = "A";
    result.elastomers.resize(1);
    result.elastomers[0].input.name = "soft";
    result.experiments = {loop_of("A", "1", "1", 0.040), loop_of("A", "1", "2", 0.042), loop_of("A", "2", "1", 0.050),
                          loop_of("A", "2", "2", 0.052)};
    return result;
}

TEST(StudyReplicates, GivePairsTheMeanOfTheMixedModel) {
    auto result = study_with_lenses();
    result.replicates = elastomer_replicates(result);
    ASSERT_EQ(result.replicates.size(), 1U);  // no pull-off, retraction or closed loop
    const auto pairs = measured_pairs(result);
    ASSERT_TRUE(pairs.at(0).approach);
    EXPECT_NEAR(pairs[0].approach->value, 0.046, 1e-12);
    EXPECT_EQ(pairs[0].approach->method, "mixed model");
    EXPECT_EQ(pairs[0].experiments, 4);
    // lens means 41 and 51: their scatter over √2
    EXPECT_NEAR(pairs[0].approach->standard_error, 0.005, 1e-9);
    EXPECT_NEAR(*pairs[0].approach->degrees_of_freedom, 1.0, 1e-5);
}

TEST(StudyReplicates, KeepExcludedLoopsWithTheirReason) {
    auto result = study_with_lenses();
    result.experiments[3].input.exclusion = "lens slipped";
    result.replicates = elastomer_replicates(result);
    result.pairs = measured_pairs(result);
    EXPECT_EQ(result.pairs[0].experiments, 3);
    const auto& data = result.replicates.at(0).data;
    EXPECT_EQ(data.rows.size(), 4U);
    EXPECT_EQ(data.exclusions.at(0).reason, "lens slipped");
    EXPECT_TRUE(result.replicates[0].model->surfaces[0].with_excluded);
    const auto table = output::replicate_table(result);
    ASSERT_EQ(table.rows.size(), 4U);
    EXPECT_EQ(std::get<std::string>(table.rows[3].back()), "lens slipped");
    const auto json = output::to_json(result);
    EXPECT_EQ(json.at("replicates").at(0).at("rows").at(3).at("excluded"), "lens slipped");
    EXPECT_EQ(json.at("experiments").at(3).at("excluded"), "lens slipped");
    EXPECT_EQ(output::replicate_mean_table(result).rows.at(0).size(),
              output::replicate_mean_table(result).columns.size());
    EXPECT_NE(output::summary(data, *result.replicates[0].model).find("lens slipped"), std::string::npos);
}

TEST(StudyReplicates, WithoutRemainingLoopsGiveTheReason) {
    auto result = study_with_lenses();
    for (auto& e : result.experiments) e.input.exclusion = "dust";
    result.replicates = elastomer_replicates(result);
    EXPECT_FALSE(result.replicates.at(0).model);
    EXPECT_EQ(result.replicates[0].model.reason, "all 4 rows are excluded; a mean needs at least one");
    result.pairs = measured_pairs(result);
    EXPECT_FALSE(result.pairs[0].approach);
    EXPECT_EQ(output::to_json(result).at("replicates").at(0).at("rows").size(), 4U);
}

TEST(StudyReplicates, WithoutLabelsAreThePlainMean) {
    auto result = study_with_lenses();
    for (auto& e : result.experiments) e.input.lens = e.input.spot = "";
    EXPECT_TRUE(elastomer_replicates(result).empty());
    EXPECT_EQ(measured_pairs(result)[0].approach->method, "mean over loops");
}

}  // namespace
}  // namespace setae::study::replicates_test
