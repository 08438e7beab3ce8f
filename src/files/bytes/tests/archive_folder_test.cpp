// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/bytes/archive_folder.hpp"

#include <gtest/gtest.h>

#include "error_message.hpp"
#include "sample_files.hpp"
#include "setae/core/errors.hpp"

using namespace setae::tests;

namespace setae::bytes::archive_folder_test {
namespace {

TEST(ArchiveFolder, ListsFilesBeforeFoldersWithoutHiddenOnes) {
    const TemporaryFolder folder;
    const auto path = folder.write("a.zip", zip_archive({{"b/c.txt", "1"},
                                                         {"z.txt", "2"},
                                                         {".hidden", "3"},
                                                         {"__MACOSX/z.txt", "4"},
                                                         {"b/a.txt", "5"},
                                                         {"a.txt", "6"}}));
    EXPECT_TRUE(is_archive(path));
    EXPECT_EQ(files_of_archive(path),
              (std::vector<std::string>{path + "/a.txt", path + "/z.txt", path + "/b/a.txt", path + "/b/c.txt"}));
    EXPECT_EQ(file_source(path + "/b/a.txt").all(), "5");
    EXPECT_EQ(file_source(path + "/b/a.txt").name, path + "/b/a.txt");
}

TEST(ArchiveFolder, RefusesMissingMembersAndPathsOutsideTheArchive) {
    const TemporaryFolder folder;
    const auto path = folder.write("a.zip", zip_archive({{"a.txt", "1"}}));
    EXPECT_NE(message_of([&] { (void)file_source(path + "/b.txt"); }).find("no such file in the archive"),
              std::string::npos);
    EXPECT_THROW((void)file_source(folder.write("t.txt", "text") + "/b.txt"), FileError);
    const auto slip = folder.write("s.zip", zip_archive({{"../b.txt", "1"}}));
    EXPECT_THROW((void)files_of_archive(slip), FormatError);
    const auto nested = folder.write("n.zip", zip_archive({{"in.zip", zip_archive({{"a.txt", "1"}})}}));
    EXPECT_THROW((void)file_source(nested + "/in.zip/a.txt"), FileError) << "archives in archives are not entered";
    EXPECT_FALSE(is_archive(folder.path("t.txt")));
    EXPECT_FALSE(is_archive(folder.path("missing")));
}

}  // namespace
}  // namespace setae::bytes::archive_folder_test
