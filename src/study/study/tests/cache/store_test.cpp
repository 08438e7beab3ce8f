// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/cache/store.hpp"

#include <gtest/gtest.h>

#include <sys/stat.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <thread>
#include <vector>

#include "setae/cache/key.hpp"

namespace setae::cache::store_test {
namespace {

namespace fs = std::filesystem;

class StoreTest : public testing::Test {
protected:
    void SetUp() override {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        folder = (fs::temp_directory_path() / (std::string("setae_store_") + test->name())).string();
        fs::remove_all(folder);
    }
    void TearDown() override { fs::remove_all(folder); }
    [[nodiscard]] fs::path entry(const std::string& name) const {
        return fs::path(folder) / name.substr(0, 2) / (name + ".entry");
    }
    [[nodiscard]] std::string bytes(const std::string& name) const {
        std::ifstream file(entry(name), std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    void overwrite(const std::string& name, const std::string& content) const {
        std::ofstream(entry(name), std::ios::binary) << content;
    }

    std::string folder;
    const std::string key = KeyBuilder("test").add("file", "abc").key();
};

TEST(KeyBuilderTest, SeparatesPartsThatConcatenateEqually) {
    EXPECT_NE(KeyBuilder("a").add("b", "c").key(), KeyBuilder("a").add("bc", "").key());
    EXPECT_NE(KeyBuilder("a").add("b", "c 1 d 1 e").key(), KeyBuilder("a").add("b", "c").add("d", "e").key());
    EXPECT_NE(KeyBuilder("a").key(), KeyBuilder("b").key());
    EXPECT_EQ(KeyBuilder("a").add("b", "c").key(), KeyBuilder("a").add("b", "c").key());
}

TEST_F(StoreTest, ReturnsWhatWasKept) {
    const Store store(folder, "1");
    EXPECT_FALSE(store.find(key));
    const std::string content("two\nlines and \0 bytes", 20);
    store.keep(key, content);
    EXPECT_TRUE(store.holds(key));
    EXPECT_EQ(store.find(key), content);
    EXPECT_EQ(store.traffic().found, 1);
    EXPECT_EQ(store.traffic().kept, 1);
    EXPECT_EQ(Store(folder, "1").find(key), content);
}

TEST_F(StoreTest, KeepsEmptyContent) {
    const Store store(folder, "1");
    store.keep(key, "");
    EXPECT_EQ(store.find(key), "");
}

TEST_F(StoreTest, RefusesADamagedEntryAndCountsIt) {
    const Store store(folder, "1");
    store.keep(key, "content");
    const auto whole = bytes(key);
    for (std::size_t length = 0; length < whole.size(); ++length) {
        overwrite(key, whole.substr(0, length));
        EXPECT_FALSE(store.find(key)) << "of the first " << length << " bytes";
        EXPECT_FALSE(store.holds(key));
    }
    for (std::size_t i = 0; i < whole.size(); ++i) {
        auto flipped = whole;
        flipped[i] = static_cast<char>(flipped[i] ^ 1);
        overwrite(key, flipped);
        EXPECT_FALSE(store.find(key)) << "with a bit flipped at byte " << i;
    }
    const auto traffic = store.traffic();
    EXPECT_EQ(traffic.found, 0);
    EXPECT_EQ(traffic.damaged + traffic.other_version, 2 * whole.size());
    store.keep(key, "content");
    EXPECT_EQ(store.find(key), "content");
}

TEST_F(StoreTest, RefusesTheEntryOfAnotherKey) {
    const auto other = KeyBuilder("test").add("file", "def").key();
    const Store store(folder, "1");
    store.keep(key, "mine");
    store.keep(other, "of another");
    overwrite(key, bytes(other));
    EXPECT_FALSE(store.find(key));
    EXPECT_EQ(store.traffic().damaged, 1);
    EXPECT_EQ(store.find(other), "of another");
}

TEST_F(StoreTest, RecomputesAnEntryThatIsNotAFile) {
    const Store store(folder, "1");
    store.keep(key, "content");
    const auto replaced_by = [&](const std::function<void(const fs::path&)>& make) {
        fs::remove_all(entry(key));
        make(entry(key));
        EXPECT_FALSE(store.find(key));
        EXPECT_FALSE(store.holds(key));
        EXPECT_EQ(store.content().bytes, 0);
        store.keep(key, "content");
        EXPECT_EQ(store.find(key), "content");
    };
    replaced_by([](const fs::path& path) { fs::create_directory(path); });
    replaced_by([](const fs::path& path) { ASSERT_EQ(mkfifo(path.c_str(), 0600), 0); });
    replaced_by([](const fs::path& path) { fs::create_symlink("/dev/zero", path); });
    fs::remove_all(entry(key));
    fs::create_directories(entry(key) / "not empty");
    EXPECT_FALSE(store.find(key));
    store.keep(key, "content");
    EXPECT_EQ(store.traffic().not_kept, 1);
}

TEST_F(StoreTest, ReadsOnlyTheAnnouncedSizeOfAnEntry) {
    const Store store(folder, "1");
    store.keep(key, "content");
    fs::resize_file(entry(key), std::uintmax_t{1} << 36);  // a hole of 64 GiB behind it
    EXPECT_FALSE(store.find(key));
    EXPECT_EQ(store.traffic().damaged, 1);
    fs::resize_file(entry(key), 0);
    fs::resize_file(entry(key), std::uintmax_t{1} << 36);
    EXPECT_FALSE(store.find(key));
}

TEST_F(StoreTest, KeepsForeignFilesWithSimilarNames) {
    const Store store(folder, "1");
    store.keep(key, "content");
    const auto group = entry(key).parent_path();
    for (const auto& name :
         {std::string("notes.entry"), std::string(64, '0') + ".entry", key + ".entry.txt", key + ".txt"})
        std::ofstream(group / name) << "mine";
    EXPECT_EQ(store.content().entries, 1);
    EXPECT_EQ(store.remove().entries, 1);
    EXPECT_EQ(std::distance(fs::directory_iterator(group), fs::directory_iterator()), key.starts_with("00") ? 3 : 4);
}

TEST_F(StoreTest, RefusesAnEntryOfAnotherVersion) {
    Store(folder, "1").keep(key, "old");
    const Store store(folder, "2");
    EXPECT_FALSE(store.find(key));
    EXPECT_EQ(store.traffic().other_version, 1);
    EXPECT_EQ(store.content().of_other_versions, 1);
    store.keep(key, "new");
    EXPECT_EQ(store.find(key), "new");
    EXPECT_EQ(store.content().entries, 1);
}

TEST_F(StoreTest, RemovesItsOwnFilesOnly) {
    const Store store(folder, "1");
    store.keep(key, "content");
    const auto left_by_a_writer = entry(key).string() + ".99.0.part",
               foreign = (fs::path(folder) / "notes.txt").string();
    std::ofstream(left_by_a_writer) << "half";
    std::ofstream(foreign) << "mine";
    EXPECT_EQ(store.remove(true).entries, 0);
    EXPECT_FALSE(fs::exists(left_by_a_writer));
    EXPECT_TRUE(store.holds(key));
    EXPECT_EQ(store.remove().entries, 1);
    EXPECT_EQ(store.content().entries, 0);
    EXPECT_TRUE(fs::exists(foreign));
}

TEST_F(StoreTest, WithoutFolderStoresNothing) {
    const Store store;
    store.keep(key, "content");
    EXPECT_FALSE(store.find(key));
    EXPECT_FALSE(store.enabled());
    EXPECT_EQ(store.content().entries, 0);
}

TEST_F(StoreTest, ContinuesWhenItCannotWrite) {
    std::ofstream(folder) << "a file stands where the folder should be";
    const Store store(folder, "1");
    store.keep(key, "content");
    EXPECT_FALSE(store.find(key));
    EXPECT_EQ(store.traffic().not_kept, 1);
}

TEST_F(StoreTest, ServesManyThreadsAtOnce) {
    const Store store(folder, "1");
    const std::string content(100000, 'x');
    std::vector<std::thread> threads;
    std::atomic<int> wrong{0};
    for (int t = 0; t < 4; ++t)
        threads.emplace_back([&] {
            for (int i = 0; i < 50; ++i) {
                store.keep(key, content);
                if (store.find(key) != content) ++wrong;
            }
        });
    for (auto& thread : threads) thread.join();
    EXPECT_EQ(wrong, 0);
    EXPECT_EQ(store.content().entries, 1);
}

TEST(DefaultFolder, FollowsTheEnvironmentVariables) {
    const auto set = [](const char* name, const char* value) { value ? setenv(name, value, 1) : unsetenv(name); };
    set("SETAE_CACHE", "/here");
    EXPECT_EQ(default_folder(), "/here");
    set("SETAE_CACHE", nullptr);
    set("XDG_CACHE_HOME", "/there");
    EXPECT_EQ(default_folder(), "/there/setae");
    set("XDG_CACHE_HOME", nullptr);
    set("HOME", "/home/someone");
    EXPECT_EQ(default_folder(), "/home/someone/.cache/setae");
    set("HOME", nullptr);
    EXPECT_EQ(default_folder(), "");
}

}  // namespace
}  // namespace setae::cache::store_test
