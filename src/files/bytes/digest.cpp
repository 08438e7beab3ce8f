// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/bytes/digest.hpp"

#include <algorithm>
#include <array>
#include <memory>

#include <fmt/format.h>
#include <openssl/evp.h>

#include "setae/core/errors.hpp"

namespace setae::bytes {
namespace {

/// An incremental digest.
class Digest {
public:
    explicit Digest(const EVP_MD* algorithm) : context_(EVP_MD_CTX_new()) {
        require(context_ && EVP_DigestInit_ex2(context_.get(), algorithm, nullptr) == 1);
    }

    void add(std::string_view bytes) { require(EVP_DigestUpdate(context_.get(), bytes.data(), bytes.size()) == 1); }
    [[nodiscard]] std::string hexadecimal() {
        std::array<unsigned char, EVP_MAX_MD_SIZE> value{};
        unsigned size = 0;
        require(EVP_DigestFinal_ex(context_.get(), value.data(), &size) == 1);
        std::string text;
        for (unsigned i = 0; i < size; ++i) text += fmt::format("{:02x}", value[i]);
        return text;
    }

private:
    static void require(bool done) {
        if (!done) throw InternalError("libcrypto cannot compute a digest");
    }
    struct Free {
        void operator()(EVP_MD_CTX* context) const { EVP_MD_CTX_free(context); }
    };
    std::unique_ptr<EVP_MD_CTX, Free> context_;
};

std::string digest_of(std::string_view bytes, const EVP_MD* algorithm) {
    Digest digest(algorithm);
    digest.add(bytes);
    return digest.hexadecimal();
}

std::string digest_of(const Source& source, const EVP_MD* algorithm) {
    constexpr std::uint64_t piece = 1 << 22;
    Digest digest(algorithm);
    for (std::uint64_t at = 0; at < source.size; at += piece)
        digest.add(source.bytes(at, std::min(piece, source.size - at)));
    return digest.hexadecimal();
}

}  // namespace

std::string md5(std::string_view bytes) { return digest_of(bytes, EVP_md5()); }

std::string md5(const Source& source) { return digest_of(source, EVP_md5()); }

std::string sha256(std::string_view bytes) { return digest_of(bytes, EVP_sha256()); }

std::string sha256(const Source& source) { return digest_of(source, EVP_sha256()); }

}  // namespace setae::bytes
