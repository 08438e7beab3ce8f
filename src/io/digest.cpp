// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/io/digest.hpp"

#include <array>

#include <fmt/format.h>
#include <openssl/evp.h>

#include "setae/core/errors.hpp"

namespace setae::io {
namespace {

std::string digest(std::string_view bytes, const EVP_MD* algorithm) {
    std::array<unsigned char, EVP_MAX_MD_SIZE> value{};
    unsigned size = 0;
    if (EVP_Digest(bytes.data(), bytes.size(), value.data(), &size, algorithm, nullptr) != 1)
        throw InternalError(fmt::format("libcrypto cannot compute {}", EVP_MD_get0_name(algorithm)));
    std::string text;
    for (unsigned i = 0; i < size; ++i) text += fmt::format("{:02x}", value[i]);
    return text;
}

}  // namespace

std::string md5(std::string_view bytes) { return digest(bytes, EVP_md5()); }

std::string sha256(std::string_view bytes) { return digest(bytes, EVP_sha256()); }

}  // namespace setae::io
