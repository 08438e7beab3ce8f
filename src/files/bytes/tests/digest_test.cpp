// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/bytes/digest.hpp"

#include <gtest/gtest.h>

namespace setae::bytes::digest_test {
namespace {

// examples of RFC 1321 and FIPS 180-4
TEST(Digest, MatchesTheExamplesOfTheStandards) {
    EXPECT_EQ(md5("message digest"), "f96b697d7cb7938d525a2f31aaf161d0");
    EXPECT_EQ(md5(""), "d41d8cd98f00b204e9800998ecf8427e");
    EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256(std::string(1000000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Digest, OfASourceEqualsTheDigestOfItsContent) {
    std::string content(10000019, '\0');
    for (std::size_t i = 0; i < content.size(); ++i) content[i] = static_cast<char>(i * i % 251);
    EXPECT_EQ(sha256(memory_source("memory", content)), sha256(content));
    EXPECT_EQ(md5(memory_source("memory", content)), md5(content));
    EXPECT_EQ(sha256(memory_source("memory", "")), sha256(""));
}

}  // namespace
}  // namespace setae::bytes::digest_test
