// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <cstring>
#include <string_view>
#include <type_traits>

#include <cereal/archives/binary.hpp>

namespace setae::study {

/// Reads what cereal::BinaryOutputArchive wrote, from memory. No size it reads makes it take more than the bytes that
/// are left could fill. @throws cereal::Exception for bytes that end too early and sizes that cannot be.
class KeptReader : public cereal::InputArchive<KeptReader, cereal::AllowEmptyClassElision> {
public:
    explicit KeptReader(std::string_view bytes) : InputArchive(this), left_(bytes) {}

    void loadBinary(void* data, std::size_t size) {
        require(size, 1);
        std::memcpy(data, left_.data(), size);
        left_.remove_prefix(size);
    }

    /// Refuses so many elements of so many bytes each where fewer bytes are left.
    void require(std::uint64_t count, std::uint64_t each) const {
        if (count > left_.size() / each) throw cereal::Exception("a size beyond the end of the bytes");
    }

    [[nodiscard]] bool at_end() const { return left_.empty(); }

private:
    std::string_view left_;
};

template <class T>
    requires std::is_arithmetic_v<T>
void load(KeptReader& reader, T& value) {
    reader.loadBinary(&value, sizeof(value));
}
template <class T>
void serialize(KeptReader& reader, cereal::NameValuePair<T>& named) {
    reader(named.value);
}
/// Every element takes a byte or more.
template <class T>
void serialize(KeptReader& reader, cereal::SizeTag<T>& tag) {
    reader(tag.size);
    reader.require(tag.size, 1);
}
template <class T>
void load(KeptReader& reader, cereal::BinaryData<T>& data) {
    reader.loadBinary(data.data, data.size);
}

/// Rows and columns of an array whose elements follow.
template <class Index>
void load_shape(KeptReader& reader, Index& rows, Index& columns, std::size_t element) {
    reader(rows, columns);
    if (rows < 0 || columns < 0) throw cereal::Exception("a negative size");
    if (columns > 0) reader.require(static_cast<std::uint64_t>(rows), static_cast<std::uint64_t>(columns) * element);
}

}  // namespace setae::study

namespace cereal::traits::detail {
template <>
struct get_output_from_input<setae::study::KeptReader> {
    using type = BinaryOutputArchive;
};
}  // namespace cereal::traits::detail
