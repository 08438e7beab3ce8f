// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include <unistd.h>

#include "loop_files.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/numerics/random_numbers.hpp"
#include "setae/study/study_result.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::study::same_measurements_test {
namespace {

class RepeatedMeasurements : public testing::Test {
protected:
    void SetUp() override { std::filesystem::create_directories(folder_); }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }
    [[nodiscard]] static Table walk(std::uint64_t seed) {
        const Array1D x = Array1D::LinSpaced(300, 0.0, 29.9e-6);
        Array1D h = numerics::normal_numbers({seed, 0}, 0, 300) * 5e-9;
        for (Index i = 1; i < 300; ++i) h[i] += h[i - 1];
        return {{{"x", "m", x}, {"h", "m", h}}, {}};
    }
    /// The same numbers with the line ends of other systems and fewer digits.
    void copy_as_others_write(const std::string& from, const std::string& to) const {
        const auto table = tables::read_table(path(from));
        std::string text;
        for (std::size_t c = 0; c < table.columns.size(); ++c)
            text += fmt::format("{}{} [{}]", c > 0 ? "," : "", table.columns[c].name, table.columns[c].unit);
        text += "\r\n";
        for (Index i = 0; i < table.columns[0].values.size(); ++i) {
            for (std::size_t c = 0; c < table.columns.size(); ++c)
                text += fmt::format("{}{:.9e}", c > 0 ? "," : "", table.columns[c].values[i]);
            text += "\r\n";
        }
        std::ofstream(path(to)) << text;
    }
    [[nodiscard]] StudyResult run(const std::string& text) const {
        std::ofstream(path("study.toml")) << "[analysis]\nspectrum = \"average\"\nbootstrap_resamples = 0\n" << text;
        return run_study(read_study(path("study.toml")), {});
    }
    [[nodiscard]] StudyResult surface_of(const std::vector<std::string>& files) const {
        std::string list;
        for (const auto& file : files) list += fmt::format("{{ file = \"{}\", instrument = \"stylus\" }}, ", file);
        return run("[surfaces.A]\nmeasurements = [" + list + "]\n");
    }
    [[nodiscard]] static std::string told(const std::vector<Alert>& alerts) {
        const auto found = std::ranges::find(alerts, "SAME_MEASUREMENT", &Alert::code);
        return found == alerts.end() ? "" : found->message;
    }

    const std::filesystem::path folder_ =
        std::filesystem::temp_directory_path() / ("setae_same_" + std::to_string(getpid()));
};

TEST_F(RepeatedMeasurements, OfASurfaceAreFoundInAnyFiles) {
    tables::write_csv(path("a.csv"), walk(1));
    tables::write_csv(path("b.csv"), walk(2));
    copy_as_others_write("a.csv", "copy.csv");
    std::filesystem::copy(path("a.csv"), path("bytes.csv"));
    EXPECT_EQ(told(surface_of({"a.csv", "b.csv"}).surfaces[0].alerts), "");
    for (const char* copy : {"a.csv", "copy.csv", "bytes.csv"})
        EXPECT_NE(told(surface_of({"a.csv", "b.csv", copy}).surfaces[0].alerts)
                      .find("3 measurements of the surface contain 2"),
                  std::string::npos)
            << copy;
}

TEST_F(RepeatedMeasurements, OfLoopsAreFoundAcrossElastomers) {
    tables::write_csv(path("a.csv"), walk(1));
    tables::write_csv(path("one.csv"), loop_files::noisy_loop(0.03, 0.06, 20e-6, 1));
    tables::write_csv(path("two.csv"), loop_files::noisy_loop(0.03, 0.06, 20e-6, 2));
    copy_as_others_write("one.csv", "copy.csv");
    const auto study = [&](const std::string& first, const std::string& second) {
        std::string text =
            "[rough_solid]\nyoungs_modulus = \"1e9 GPa\"\npoisson_ratio = 0.0\n"
            "[surfaces.A]\nmeasurements = [{ file = \"a.csv\", instrument = \"stylus\" }]\n";
        for (const auto& [elastomer, file] : {std::pair("soft", first), {"other", second}})
            text += fmt::format(
                "[elastomers.{0}]\nsurface_energy = \"25 mJ/m2\"\nsphere_radius = \"1 mm\"\n"
                "[[experiments]]\nfile = \"{1}\"\nsurface = \"A\"\nelastomer = \"{0}\"\n",
                elastomer, file);
        return told(run(text).alerts);
    };
    EXPECT_EQ(study("one.csv", "two.csv"), "");
    EXPECT_NE(study("one.csv", "one.csv").find("listed more than once"), std::string::npos);
    EXPECT_NE(study("one.csv", "copy.csv").find("listed again as"), std::string::npos);
}

TEST_F(RepeatedMeasurements, OfConstantHeightFailWithoutAffectingOthers) {
    tables::write_csv(path("a.csv"), walk(1));
    tables::write_csv(path("b.csv"), walk(2));
    auto flat = walk(1);
    flat.columns[1].values = 5e-9;
    tables::write_csv(path("flat.csv"), flat);
    const auto without = surface_of({"a.csv", "b.csv"}), with = surface_of({"a.csv", "flat.csv", "b.csv"});
    EXPECT_EQ(with.surfaces[0].error, "");
    EXPECT_NE(with.surfaces[0].measurements[1].error.find("flat.csv"), std::string::npos);
    EXPECT_DOUBLE_EQ(with.surfaces[0].average.parameters.rms_height, without.surfaces[0].average.parameters.rms_height);
}

TEST_F(RepeatedMeasurements, WithBridgedGapsAreNamed) {
    const auto write = [&](bool gap) {
        const auto whole = walk(1);
        std::string text = "x [um],h [nm]\n";
        for (Index i = 0; i < 300; ++i)
            if (!gap || i < 100 || i >= 175)  // a quarter is missing; the steps vary, so that no rows are counted
                text += fmt::format("{:.6f},{:.6f}\n", 1e6 * whole.columns[0].values[i] * (1.0 + 1e-3 * (i % 7)),
                                    1e9 * whole.columns[1].values[i]);
        std::ofstream(path("a.csv")) << text;
        const auto alerts = surface_of({"a.csv"}).surfaces[0].measurements[0].alerts;
        return std::ranges::any_of(alerts, [](const Alert& alert) { return alert.code == "GAP_BRIDGED"; });
    };
    EXPECT_FALSE(write(false));
    EXPECT_TRUE(write(true));
}

TEST_F(RepeatedMeasurements, WithImpossibleHeightsAreNamed) {
    auto wrong = walk(1);
    wrong.columns[1].values *= 1e6;  // nm taken for mm
    tables::write_csv(path("wrong.csv"), wrong);
    const auto surface = surface_of({"wrong.csv"}).surfaces[0];
    EXPECT_TRUE(std::ranges::any_of(surface.measurements[0].alerts,
                                    [](const Alert& alert) { return alert.code == "HEIGHTS_IMPLAUSIBLE"; }));
}

}  // namespace
}  // namespace setae::study::same_measurements_test
