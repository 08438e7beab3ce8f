// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/output/result_folder.hpp"

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <deque>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "setae/bytes/protected_inputs.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/output/file_names.hpp"
#include "setae/output/force_map_output.hpp"
#include "setae/output/hysteresis_output.hpp"
#include "setae/output/loop_tables.hpp"
#include "setae/study/own_outputs.hpp"

namespace setae::output::result_folder_test {
namespace {

namespace fs = std::filesystem;

TEST(FileNames, AreReadableAndUnique) {
    const std::vector<std::string> names{"A 1", "A_1",  "A/B",       "a_b", "Ä",    "Ö",
                                         "α",   "名前", "5'' wafer", "",    "\xff", "a\nb"};
    const auto files = file_names(names);
    EXPECT_EQ(files, (std::vector<std::string>{"A_1_2", "A_1", "A_B_2", "a_b", "Ä", "Ö", "α", "名前", "5___wafer", "_",
                                               "__2", "a_b_3"}));
}

TEST(FileNames, AreTruncatedBetweenCharacters) {
    std::string name;
    for (int i = 0; i < 100; ++i) name += "ä";
    const auto files = file_names(std::vector<std::string>{name, name + "b"});
    EXPECT_EQ(files[0], name.substr(0, 120));
    EXPECT_EQ(files[1], files[0] + "_2");
}

class ResultFolderTest : public testing::Test {
protected:
    void SetUp() override {
        root = fs::temp_directory_path() / ("setae_results_" + std::to_string(getpid()));
        fs::remove_all(root);
        fs::create_directories(root);
        study.path = (root / "study.toml").string();
        study.output = (root / "results").string();
        std::ofstream(study.path) << "title = \"a\"";
    }
    void TearDown() override { fs::remove_all(root); }
    /// A run that writes these files.
    void run(const std::set<std::string>& names) const {
        ResultFolder folder(study);
        folder.begin();
        for (const auto& name : names) {
            fs::create_directories((fs::path(study.output) / name).parent_path());
            bytes::write_whole_file(folder.claim(name), name);
        }
        folder.finish();
    }
    [[nodiscard]] std::set<std::string> files() const {
        std::set<std::string> names;
        for (const auto& entry : fs::recursive_directory_iterator(study.output))
            if (entry.is_regular_file()) names.insert(entry.path().lexically_relative(study.output).string());
        return names;
    }

    fs::path root;
    study::Study study;
};

TEST_F(ResultFolderTest, ContainsFilesOfTheLastRunAndForeignFiles) {
    run({"a.csv", "b.csv", "figures/1.svg"});
    std::ofstream(fs::path(study.output) / "notes.txt") << "mine";
    EXPECT_EQ(files(), (std::set<std::string>{"a.csv", "b.csv", "figures/1.svg", "files.txt", "notes.txt"}));
    run({"b.csv", "c.csv"});
    EXPECT_EQ(files(), (std::set<std::string>{"b.csv", "c.csv", "files.txt", "notes.txt"}));
    EXPECT_FALSE(fs::exists(fs::path(study.output) / "figures"));
}

TEST_F(ResultFolderTest, KeepsForeignFiles) {
    fs::create_directories(study.output);
    std::ofstream(fs::path(study.output) / "a.csv") << "mine";
    EXPECT_THROW(run({"a.csv"}), FileError);
    EXPECT_EQ(bytes::read_back(study.output + "/a.csv"), "mine");
}

TEST_F(ResultFolderTest, RemovesFilesOfAKilledRun) {
    {
        ResultFolder folder(study);
        bytes::write_whole_file(folder.claim("a.csv"), "of the killed");
    }  // without finish()
    run({"b.csv"});
    EXPECT_EQ(files(), (std::set<std::string>{"b.csv", "files.txt"}));
}

TEST_F(ResultFolderTest, ListsEveryFileOfSimultaneousRuns) {
    constexpr int runs = 4, files_of_each = 40;
    std::deque<ResultFolder> folders;
    for (int r = 0; r < runs; ++r) folders.emplace_back(study);
    {
        std::vector<std::jthread> threads;
        for (int r = 0; r < runs; ++r)
            threads.emplace_back([r, &folder = folders[r]] {
                for (int i = 0; i < files_of_each; ++i)
                    EXPECT_NO_THROW(static_cast<void>(folder.claim(std::to_string(r) + "_" + std::to_string(i))));
                EXPECT_NO_THROW(folder.finish());
            });
    }
    const auto list = bytes::read_back(study.output + "/files.txt");
    EXPECT_EQ(std::ranges::count(list, '\n'), 2 + runs * files_of_each);
}

TEST_F(ResultFolderTest, RemovesTheFilesOfACompleteRunFirst) {
    run({"study.json", "report.html", "a.csv"});
    ResultFolder(study).begin();
    EXPECT_EQ(files(), (std::set<std::string>{"a.csv", "files.txt"}));
    fs::remove_all(study.output);
    fs::create_directories(study.output);
    std::ofstream(fs::path(study.output) / "study.json") << "mine";
    ResultFolder(study).begin();
    EXPECT_TRUE(fs::exists(fs::path(study.output) / "study.json"));
}

TEST_F(ResultFolderTest, OfAnotherStudyIsRefusedWhileThatOneIsThere) {
    run({"a.csv"});
    const auto first = study.path;
    study.path = (root / "other.toml").string();
    std::ofstream(study.path) << "title = \"b\"";
    EXPECT_THROW(run({"b.csv"}), FileError);
    fs::remove(first);  // it was renamed
    run({"b.csv"});
    EXPECT_EQ(files(), (std::set<std::string>{"b.csv", "files.txt"}));
}

TEST_F(ResultFolderTest, OfAnotherStudyIsRefusedByARelativePathToo) {
    const auto before = fs::current_path();
    fs::current_path(root);
    study.output = "results";
    run({"a.csv"});
    EXPECT_EQ(study::read_result_list("results/files.txt").study, "../study.toml");
    study.path = "other.toml";
    std::ofstream(study.path) << "title = \"b\"";
    EXPECT_THROW(run({"b.csv"}), FileError);
    EXPECT_EQ(files(), (std::set<std::string>{"a.csv", "files.txt"}));
    fs::current_path(before);
    study.output = (root / "results").string();
}

TEST_F(ResultFolderTest, OfAnotherStudyThatHasStartedIsRefused) {
    const ResultFolder first(study);
    study.path = (root / "other.toml").string();
    std::ofstream(study.path) << "title = \"b\"";
    EXPECT_THROW(ResultFolder{study}, FileError);
}

TEST_F(ResultFolderTest, TakenByAnotherStudyIsRefusedAtTheNextFile) {
    ResultFolder folder(study);
    bytes::write_whole_file(folder.claim("a.csv"), "mine");
    std::ofstream(root / "other.toml") << "title = \"b\"";
    bytes::write_whole_file(study.output + "/files.txt", study::as_text({"../other.toml", {"b.csv"}}));
    EXPECT_THROW((void)folder.claim("c.csv"), FileError);
    EXPECT_THROW((void)folder.claim("a.csv"), FileError);
    EXPECT_THROW(folder.finish(), FileError);
}

TEST_F(ResultFolderTest, WithoutStudyInItsListIsRefused) {
    run({"a.csv"});
    bytes::write_whole_file(study.output + "/files.txt",
                            std::string(study::result_list_heading) + "# study: \na.csv\n");
    EXPECT_THROW(run({"b.csv"}), FileError);
    EXPECT_TRUE(fs::exists(study.output + "/a.csv"));
}

TEST_F(ResultFolderTest, OfAStudyWithoutAPathIsIdentifiedByTitle) {
    study.path.clear();
    study.title = "one";
    run({"a.csv"});
    study.title = "two";
    EXPECT_THROW(run({"b.csv"}), FileError);
    study.title = "one";
    run({"b.csv"});
    EXPECT_EQ(files(), (std::set<std::string>{"b.csv", "files.txt"}));
}

TEST_F(ResultFolderTest, ListIsNotChangedByTheNameOfAStudy) {
    study.path = (root / "study\nnotes.txt\n.toml").string();
    std::ofstream(study.path) << "title = \"a\"";
    fs::create_directories(study.output);
    std::ofstream(fs::path(study.output) / "notes.txt") << "mine";
    run({"a.csv"});
    run({"b.csv"});
    EXPECT_EQ(files(), (std::set<std::string>{"b.csv", "files.txt", "notes.txt"}));
}

TEST_F(ResultFolderTest, KeepsFilesNamedLikeTemporaryOnes) {
    run({"a.csv"});
    for (const char* name : {"x.999999.1.part", "a.csv.999999.1.part", "x.999999-0123456789abcdef.part"})
        std::ofstream(fs::path(study.output) / name) << "mine";
    const auto elsewhere = root / "elsewhere";
    fs::create_directories(elsewhere);
    std::ofstream(elsewhere / "1.svg.999999-0123456789abcdef.part") << "mine";
    fs::create_directory_symlink(elsewhere, fs::path(study.output) / "figures");
    bytes::write_whole_file(study.output + "/files.txt", study::as_text({"../study.toml", {"a.csv", "figures/1.svg"}}));
    EXPECT_THROW(run({"figures/1.svg"}), FileError) << "it would be written elsewhere";
    run({"a.csv"});
    EXPECT_EQ(std::distance(fs::directory_iterator(elsewhere), {}), 1);
    EXPECT_TRUE(fs::exists(study.output + "/x.999999.1.part"));
    EXPECT_TRUE(fs::exists(study.output + "/a.csv.999999.1.part"));
    EXPECT_TRUE(fs::exists(study.output + "/x.999999-0123456789abcdef.part"));
}

TEST_F(ResultFolderTest, CanBeMovedWithItsStudy) {
    run({"a.csv", "b.csv"});
    const auto moved = root.string() + "_moved";
    fs::remove_all(moved);
    fs::rename(root, moved);
    root = moved;
    study.path = (root / "study.toml").string();
    study.output = (root / "results").string();
    run({"b.csv"});
    EXPECT_EQ(files(), (std::set<std::string>{"b.csv", "files.txt"}));
}

TEST_F(ResultFolderTest, NeverRemovesFilesOutside) {
    std::ofstream(root / "precious") << "mine";
    fs::create_directories(study.output);
    fs::create_directory_symlink(root, fs::path(study.output) / "link");
    std::ofstream(fs::path(study.output) / "files.txt")
        << "# study: ../study.toml\n../precious\n"
        << (root / "precious").string() << "\nlink/precious\n./../precious\n";
    run({"a.csv"});
    EXPECT_TRUE(fs::exists(root / "precious"));
}

TEST_F(ResultFolderTest, DoesNotReplaceWhatTheStudyReads) {
    const bytes::ProtectedInputs inputs;
    run({"a.csv"});
    study.surfaces.push_back({.name = "A"});
    study.surfaces.back().measurements.push_back({.file = study.output + "/a.csv"});
    EXPECT_THROW(run({"a.csv"}), FileError);
    EXPECT_THROW(run({"b.csv"}), FileError);  // nor is it removed
    EXPECT_TRUE(fs::exists(study.output + "/a.csv"));
}

TEST_F(ResultFolderTest, LeavesNoEmptyFolderBehind) {
    { const ResultFolder nothing_written(study); }
    EXPECT_FALSE(fs::exists(study.output));
    fs::create_directories(study.output);
    { const ResultFolder nothing_written(study); }
    EXPECT_TRUE(fs::exists(study.output)) << "it was there before";
    run({"a.csv"});
    EXPECT_TRUE(fs::exists(study.output + "/a.csv"));
}

TEST_F(ResultFolderTest, RecognisesTablesWrittenByCommands) {
    const auto own = [&](const tables::TidyTable& table) {
        const auto path = (root / "table.csv").string();
        bytes::write_whole_file(path, tables::as_csv(table));
        return study::is_own_output(path);
    };
    EXPECT_TRUE(own(fits_table()));
    EXPECT_TRUE(own(energies_table()));
    EXPECT_TRUE(own(curves_table({})));
    for (const auto& [name, table] : hysteresis_tables({})) EXPECT_TRUE(own(table)) << name;
}

}  // namespace
}  // namespace setae::output::result_folder_test
