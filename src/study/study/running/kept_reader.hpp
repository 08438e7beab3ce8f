// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <cstring>
#include <string_view>
#include <type_traits>

#include <cereal/archives/binary.hpp>

namespace setae::study {

/// Reads data written by cereal::BinaryOutputArchive from memory. Allocations are limited by the number of remaining
/// bytes. @throws cereal::Exception for bytes that end too early and impossible sizes.
class KeptReader : public cereal::InputArchive<KeptReader, cereal::AllowEmptyClassElision> {
public:
    explicit KeptReader(std::string_view bytes) : InputArchive(this), left_(bytes) {}

    void loadBinary(void* data, std::size_t size) {
        require(size, 1, 1);
        if (size == 0) return;  // of an empty array, which has no address
        std::memcpy(data, left_.data(), size);
        left_.remove_prefix(size);
    }

    /// Refuses rows of so many elements of so many bytes each where fewer bytes are left.
    void require(std::uint64_t count, std::uint64_t rows, std::uint64_t bytes) const {
        if (count > left_.size() / bytes / rows) throw cereal::Exception("a size beyond the end of the bytes");
    }

    [[nodiscard]] bool at_end() const { return left_.empty(); }

private:
    std::string_view left_;
};

template <class T>
    requires(std::is_arithmetic_v<T> && !std::is_same_v<T, bool>)
void load(KeptReader& reader, T& value) {
    reader.loadBinary(&value, sizeof(value));
}
/// One byte, 0 or 1.
inline void load(KeptReader& reader, bool& value) {
    unsigned char byte = 0;
    reader.loadBinary(&byte, 1);
    if (byte > 1) throw cereal::Exception("neither true nor false");
    value = byte == 1;
}
template <class T>
void serialize(KeptReader& reader, cereal::NameValuePair<T>& named) {
    reader(named.value);
}
/// Every element takes a byte or more.
template <class T>
void serialize(KeptReader& reader, cereal::SizeTag<T>& tag) {
    reader(tag.size);
    reader.require(tag.size, 1, 1);
}
template <class T>
void load(KeptReader& reader, cereal::BinaryData<T>& data) {
    reader.loadBinary(data.data, data.size);
}

/// Makes an array of the stored size and fills it.
template <class Array>
void load_array(KeptReader& reader, Array& array) {
    using Index = typename Array::Index;
    using Scalar = typename Array::Scalar;
    Index rows = 0, columns = 0;
    reader(rows, columns);
    const auto allowed = [](Index extent, int fixed) { return extent >= 0 && (fixed < 0 || extent == fixed); };
    if (!allowed(rows, Array::RowsAtCompileTime) || !allowed(columns, Array::ColsAtCompileTime))
        throw cereal::Exception("a size that the array cannot have");
    if (rows > 0) reader.require(static_cast<std::uint64_t>(columns), static_cast<std::uint64_t>(rows), sizeof(Scalar));
    array.resize(rows, columns);
    reader.loadBinary(array.data(), static_cast<std::size_t>(array.size()) * sizeof(Scalar));
}

}  // namespace setae::study

namespace cereal::traits::detail {
template <>
struct get_output_from_input<setae::study::KeptReader> {
    using type = BinaryOutputArchive;
};
}  // namespace cereal::traits::detail
