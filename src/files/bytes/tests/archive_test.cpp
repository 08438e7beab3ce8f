// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/bytes/archive.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "byte_builder.hpp"
#include "error_message.hpp"
#include "sample_files.hpp"
#include "setae/core/errors.hpp"

using namespace setae::tests;

namespace setae::bytes::tests::archive_test {
namespace {

/// Bytes that do not compress.
std::string noise(std::size_t size) {
    std::string bytes(size, '\0');
    std::uint32_t state = 1;
    for (auto& byte : bytes) byte = static_cast<char>((state = state * 1664525u + 1013904223u) >> 24);
    return bytes;
}

TEST(Archive, ReadsOnlyTheRequestedBytes) {
    const auto archive = zip_archive({{"large", noise(1 << 20)}, {"small", "five!"}});
    const auto whole = memory_source("a", noise(1 << 20) + archive);
    const auto count = std::make_shared<std::atomic<std::uint64_t>>(0);
    Source counting = part_of(whole, "part", 1 << 20, archive.size());
    counting.read_into = [inner = counting.read_into, count](std::uint64_t offset, std::uint64_t bytes, char* target) {
        *count += bytes;
        inner(offset, bytes, target);
    };
    EXPECT_EQ(Archive(counting).read("small"), "five!");
    EXPECT_LT(*count, 1u << 18);
    EXPECT_EQ(Archive(counting).read("large"), noise(1 << 20));
}

/// Bytes of an archive of n small members that are read to read them all.
std::uint64_t bytes_read(int n) {
    std::vector<std::pair<std::string, std::string>> members;
    for (int i = 0; i < n; ++i) members.emplace_back("member" + std::to_string(i), "five!");
    const auto archive = memory_source("a", zip_archive({members.begin(), members.end()}));
    const auto count = std::make_shared<std::atomic<std::uint64_t>>(0);
    Source counting = archive;
    counting.read_into = [inner = archive.read_into, count](std::uint64_t offset, std::uint64_t bytes, char* target) {
        *count += bytes;
        inner(offset, bytes, target);
    };
    const Archive opened(counting);
    for (const auto& name : opened.names()) EXPECT_EQ(opened.member(name).all(), "five!");
    return *count;
}

TEST(Archive, ReadsItsDirectoryOnceForAllMembers) {
    const auto few = bytes_read(100), many = bytes_read(1000);
    EXPECT_LT(std::log10(static_cast<double>(many) / static_cast<double>(few)), 1.1);
}

TEST(Archive, WithTwoMembersOfOneNameIsRefused) {
    auto bytes = zip_archive({{"name_a", "1"}, {"name_b", "2"}});
    for (auto at = bytes.find("name_b"); at != std::string::npos; at = bytes.find("name_b")) bytes[at + 5] = 'a';
    EXPECT_NE(message_of([&] { (void)Archive(memory_source("c.zip", bytes)); }).find("c.zip: ZIP: two members"),
              std::string::npos);
}

TEST(Archive, RefusesAnAnnouncedSizeBeyondTheCompressionLimit) {
    auto archive = zip_archive({{"bomb", "a little"}});
    const auto directory = archive.rfind("PK\x01\x02");
    ASSERT_NE(directory, std::string::npos);
    archive.replace(directory + 24, 4, ByteBuilder().number(0x7fffffffu).content());
    const auto message = message_of([&] { (void)Archive(memory_source("a", archive)).member("bomb"); });
    EXPECT_NE(message.find("announces 2147483647 bytes"), std::string::npos) << message;
}

}  // namespace
}  // namespace setae::bytes::tests::archive_test
