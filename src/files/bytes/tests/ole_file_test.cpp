// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/bytes/ole_file.hpp"

#include <gtest/gtest.h>

#include "compound_file.hpp"
#include "error_message.hpp"
#include "setae/core/errors.hpp"

using namespace setae::tests;

namespace setae::bytes::tests::ole_file_test {
namespace {

std::string counting(std::size_t size) {
    std::string content(size, '\0');
    for (std::size_t i = 0; i < size; ++i) content[i] = static_cast<char>(i % 251);
    return content;
}

const Members streams{{"large", counting(9001)},
                      {"small", counting(130)},
                      {"empty", ""},
                      {"other", counting(65)},
                      {"exact", counting(4096)}};

TEST(OleFile, ReadsStreamsOfEverySizeWholeAndInParts) {
    for (const unsigned shift : {9u, 12u}) {
        const OleFile file(memory_source("a", CompoundFile(streams, shift).content()), "X");
        ASSERT_EQ(file.names().size(), streams.size());
        for (const auto& [name, content] : streams) {
            const auto stream = file.stream(name);
            EXPECT_EQ(stream.all(), content) << name;
            for (std::size_t at = 0; at + 60 < content.size(); at += 37)
                ASSERT_EQ(stream.bytes(at, 60), content.substr(at, 60)) << name << ' ' << at;
        }
    }
}

TEST(OleFile, RefusesReadingBeyondAStream) {
    const OleFile file(memory_source("a", CompoundFile(streams).content()), "X");
    EXPECT_THROW((void)file.stream("small").bytes(100, 31), FormatError);
    EXPECT_THROW((void)file.stream("nothing"), FormatError);
}

TEST(OleFile, RefusesCircularChains) {
    auto content = CompoundFile(streams).content();
    const auto table = content.size() - 512;
    for (std::size_t entry = 0; entry < 128; ++entry) {  // every sector leads to itself
        auto circular = content;
        circular.replace(table + 4 * entry, 4, ByteBuilder().number(static_cast<std::uint32_t>(entry)).content());
        try {
            const OleFile file(memory_source("a", circular), "X");
            for (const auto& name : file.names()) EXPECT_LE(file.stream(name).all().size(), content.size());
        } catch (const FormatError&) {
        }
    }
}

TEST(OleFile, FollowsLongListsOfTableSectors) {
    const auto big = counting(
        24 << 20);  // 49152 sectors need 388 of table, 109 fit into the header and 127 into each further sector
    const OleFile file(memory_source("a", CompoundFile({{"big", big}}).content()), "X");
    EXPECT_EQ(file.stream("big").all(), big);
}

}  // namespace
}  // namespace setae::bytes::tests::ole_file_test
