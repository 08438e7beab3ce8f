// SPDX-License-Identifier: GPL-3.0-or-later
// Results reused from an earlier run, reported progress, and cancellation.
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <fstream>

#include "running/serialization.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/formats/netcdf.hpp"
#include "setae/numerics/random_numbers.hpp"
#include "setae/output/json.hpp"
#include "setae/tables/table_file.hpp"

namespace setae::study::kept_results_test {
namespace {

class KeptResults : public testing::Test {
protected:
    void SetUp() override {
        std::filesystem::create_directories(folder_);
        for (std::uint64_t seed = 1; seed <= 3; ++seed) write_walk(seed, 1.0);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    [[nodiscard]] std::string walk(std::uint64_t seed) const {
        return (folder_ / ("walk" + std::to_string(seed) + ".csv")).string();
    }
    void write_walk(std::uint64_t seed, double factor) const {
        const Array1D x = Array1D::LinSpaced(300, 0.0, 29.9e-6);
        Array1D h = numerics::normal_numbers({seed, 0}, 0, 300) * (factor * 5e-9);
        for (Index i = 1; i < 300; ++i) h[i] += h[i - 1];
        tables::write_csv(walk(seed), {{{"x", "m", x}, {"h", "m", h}}, {}});
    }

    [[nodiscard]] Study study() const {
        Study study;
        study.path = (folder_ / "study.toml").string();
        std::ofstream(study.path) << "written for its digest\n";
        study.counter_youngs_modulus = 1e12;
        SurfaceInput two{"two", "", {}, {}, {}}, one{"one", "", {}, {}, {}};
        for (const std::uint64_t seed : {1, 2}) two.measurements.push_back(stylus(seed));
        one.measurements.push_back(stylus(3));
        study.surfaces = {two, one};
        return study;
    }
    [[nodiscard]] MeasurementInput stylus(std::uint64_t seed) const {
        MeasurementInput input;
        input.file = walk(seed);
        input.instrument = "stylus";
        return input;
    }
    [[nodiscard]] static std::string text_of(const StudyResult& result) { return output::to_json(result).dump(); }

    /// A run with a store, and the steps it took from there.
    struct Watched {
        StudyResult result;
        std::vector<Progress> steps;

        [[nodiscard]] std::ptrdiff_t cached(const std::string& stage) const {
            return std::count_if(steps.begin(), steps.end(),
                                 [&](const Progress& p) { return p.stage == stage && p.cached; });
        }
    };
    [[nodiscard]] Watched run(const Study& wanted) const {
        Watched watched;
        const cache::Store store((folder_ / "cache").string(), "test");
        watched.result = run_study(wanted, {.threads = {2}, .store = &store, .progress = [&](const Progress& p) {
                                                watched.steps.push_back(p);
                                            }});
        return watched;
    }

    const std::filesystem::path folder_ =
        std::filesystem::temp_directory_path() / ("setae_kept_results_" + std::to_string(getpid()));
};

TEST_F(KeptResults, EqualComputedResults) {
    const auto fresh = text_of(run_study(study()));
    const auto first = run(study()), second = run(study());
    EXPECT_EQ(text_of(first.result), fresh);
    EXPECT_EQ(text_of(second.result), fresh);
    EXPECT_EQ(first.cached("measurement") + first.cached("surface"), 0);
    EXPECT_EQ(second.cached("measurement"), 3);
    EXPECT_EQ(second.cached("surface"), 2);
    // what no JSON shows is there, too
    const auto& a = first.result.surfaces[0].measurements[0];
    const auto& b = second.result.surfaces[0].measurements[0];
    EXPECT_EQ(bytes_of(a), bytes_of(b));
    EXPECT_EQ(b.preview.heights.size(), 300);
}

TEST_F(KeptResults, OfUnchangedFilesAreUsedWhenOneChanges) {
    static_cast<void>(run(study()));
    write_walk(2, 1.5);
    const auto again = run(study());
    EXPECT_EQ(again.cached("measurement"), 2);
    EXPECT_EQ(again.cached("surface"), 1);
    EXPECT_EQ(text_of(again.result), text_of(run_study(study())));
}

TEST_F(KeptResults, DependOnTheRelevantSettings) {
    static_cast<void>(run(study()));
    auto other = study();
    other.analysis.seed = 7;  // of draws: the measurements are the same
    const auto seeded = run(other);
    EXPECT_EQ(seeded.cached("measurement"), 3);
    EXPECT_EQ(seeded.cached("surface"), 0);
    other = study();
    other.surfaces[1].measurements[0].tip_radius = Estimate{.value = 5e-6};
    const auto with_tip = run(other);
    EXPECT_EQ(with_tip.cached("surface"), 1);
    EXPECT_EQ(with_tip.cached("measurement"), 2);
    other = study();
    other.analysis.cutoff_scan = {1e-9, 2e-9};  // of fits over pairs: no surface depends on it
    EXPECT_EQ(run(other).cached("surface"), 2);
    other = study();
    other.analysis.likelihood.threads = {2};
    EXPECT_EQ(run(other).cached("surface"), 2);
}

TEST_F(KeptResults, DoNotIncludeFailures) {
    auto broken = study();
    broken.surfaces[0].measurements.push_back(stylus(9));
    EXPECT_TRUE(run(broken).result.surfaces[0].measurements[2].failed());
    write_walk(9, 1.0);
    const auto mended = run(broken);
    EXPECT_FALSE(mended.result.surfaces[0].measurements[2].failed());
    EXPECT_EQ(text_of(mended.result), text_of(run_study(broken)));
}

TEST_F(KeptResults, AreNotStoredForAFileThatChangesDuringTheRun) {
    const auto fresh = text_of(run_study(study()));
    const cache::Store store((folder_ / "cache").string(), "test");
    const auto original = bytes::read_back(walk(3));
    const auto time = std::filesystem::last_write_time(walk(3));
    const auto changing = run_study(study(), {.threads = {1}, .store = &store, .progress = [&](const Progress& p) {
                                                  if (p.stage == "measurement" && p.begins && p.item == walk(3))
                                                      write_walk(3, 50.0);
                                              }});
    const auto& changed = changing.inputs.back();
    EXPECT_EQ(changed.path, walk(3));
    EXPECT_TRUE(changed.changed);
    EXPECT_EQ(changed.sha256, "");
    EXPECT_TRUE(std::ranges::any_of(changing.alerts, [&](const Alert& alert) {
        return alert.code == "INPUT_CHANGED" && alert.subject == walk(3);
    }));
    std::ofstream(walk(3)) << original;
    std::filesystem::last_write_time(walk(3), time);
    EXPECT_EQ(text_of(run(study()).result), fresh);
}

TEST_F(KeptResults, AreMarkedInThePlanOfARun) {
    const cache::Store store((folder_ / "cache").string(), "test");
    const RunOptions options{.store = &store};
    const auto count = [&](const Study& wanted, auto of) {
        const auto steps = planned_steps(wanted, options);
        return std::count_if(steps.begin(), steps.end(), of);
    };
    const auto cached = [](const PlannedStep& step) { return step.cached; };
    EXPECT_EQ(planned_steps(study(), options).size(), 5);
    EXPECT_EQ(count(study(), cached), 0);
    static_cast<void>(run(study()));
    EXPECT_EQ(count(study(), cached), 5);
    auto broken = study();
    broken.surfaces[0].measurements.push_back(stylus(9));
    EXPECT_EQ(count(broken, cached), 4);  // three measurements and the other surface
    EXPECT_EQ(
        count(broken, [](const PlannedStep& step) { return step.error.find("no such file") != std::string::npos; }), 1);
}

TEST_F(KeptResults, AreCountedStepByStep) {
    const auto watched = run(study());
    std::size_t done = 0;
    for (const auto& step : watched.steps) {
        if (!step.begins) ++done;
        EXPECT_EQ(step.done, done);
        EXPECT_EQ(step.total, 5);
        EXPECT_GE(step.share, step.computed_share);
    }
    EXPECT_EQ(done, 5);
    EXPECT_DOUBLE_EQ(watched.steps.back().share, 1.0);
}

TEST_F(KeptResults, OfACancelledRunAreUsed) {
    const cache::Store store((folder_ / "cache").string(), "test");
    std::atomic<bool> cancelled{false};
    RunOptions options{
        .threads = {1},
        .store = &store,
        .progress = [&](const Progress& p) { cancelled = cancelled || (!p.begins && p.stage == "surface"); },
        .cancelled = &cancelled};
    EXPECT_THROW(static_cast<void>(run_study(study(), options)), Cancelled);
    const auto rest = run(study());
    EXPECT_EQ(rest.cached("surface"), 1);
    EXPECT_EQ(text_of(rest.result), text_of(run_study(study())));
}

TEST_F(KeptResults, TruncatedAreIgnored) {
    const auto bytes = bytes_of(run_study(study()).surfaces[0]);
    ASSERT_TRUE(value_of<SurfaceResult>(bytes));
    for (const std::size_t length : {std::size_t{0}, std::size_t{7}, bytes.size() / 3, bytes.size() - 1})
        EXPECT_FALSE(value_of<SurfaceResult>(bytes.substr(0, length)));
}

// A size that the bytes left could not fill takes no memory.
TEST_F(KeptResults, OfImpossibleSizesAreIgnored) {
    const auto bytes = bytes_of(run_study(study()).surfaces[0]);
    std::size_t refused = 0;
    for (std::size_t at = 0; at + 8 <= bytes.size(); at += 1 + bytes.size() / 400) {
        auto crafted = bytes;
        crafted.replace(at, 8, "\xff\xff\xff\xff\xff\xff\xff\x0f", 8);
        if (!value_of<SurfaceResult>(crafted)) ++refused;
    }
    EXPECT_GT(refused, 0u);
    EXPECT_FALSE(value_of<SurfaceResult>(bytes + "x"));
}

TEST_F(KeptResults, NameEveryInputWithItsDigest) {
    const auto result = run_study(study());
    ASSERT_EQ(result.inputs.size(), 4);
    EXPECT_EQ(result.inputs[0].path, study().path);
    for (const auto& input : result.inputs) EXPECT_EQ(input.sha256.size(), 64);
    EXPECT_EQ(result.inputs[0].size, 23);
}

TEST_F(KeptResults, DependOnTheTipPicture) {
    auto wanted = study();
    const auto picture = (folder_ / "tip.nc").string();
    const auto draw = [&](double drop) {
        Array2D heights = Array2D::Constant(9, 9, -drop);
        heights(4, 4) = 0.0;
        formats::write_netcdf(picture, topography::HeightMap{heights, {9e-8, 9e-8}, false, {}});
    };
    draw(50e-9);
    wanted.surfaces[1].measurements[0].tip_file = picture;
    EXPECT_EQ(run(wanted).result.surfaces[1].measurements[0].error, "");
    EXPECT_EQ(run(wanted).cached("measurement"), 3);
    draw(60e-9);
    EXPECT_EQ(run(wanted).cached("measurement"), 2);
}

}  // namespace
}  // namespace setae::study::kept_results_test
