// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/bytes/hdf5_handle.hpp"

#include <algorithm>
#include <limits>
#include <mutex>

#include <fmt/format.h>

#include "hdf5_heaps.hpp"
#include "setae/bytes/cursor.hpp"
#include "setae/core/errors.hpp"

namespace setae::bytes {
namespace {

constexpr std::string_view signature = "\x89HDF\r\n\x1A\n";
constexpr std::size_t image_increment = 1 << 16;
constexpr int max_dimensions = H5S_MAX_RANK;

/// Number of nested sessions of this thread. A recursive mutex is unsuitable: a child process has another owner.
thread_local int sessions = 0;

std::mutex& guard() {
    static std::mutex mutex;
    return mutex;
}

/// An address of `bytes` bytes.
std::uint64_t address(Cursor& cursor, unsigned bytes) {
    switch (bytes) {
        case 2: return cursor.number<std::uint16_t>();
        case 4: return cursor.number<std::uint32_t>();
        case 8: return cursor.number<std::uint64_t>();
        default: cursor.fail(fmt::format("addresses of {} bytes, expected 2, 4 or 8; the file is damaged", bytes));
    }
}

/// The file is as large as its superblock states. Source: HDF5 File Format Specification 3.0, II.A.
void require_whole(const Source& source, std::uint64_t start) {
    Cursor cursor(source, "HDF5", start + signature.size());
    const unsigned version = cursor.number<std::uint8_t>();
    if (version > 3) cursor.fail(fmt::format("version {} of the superblock, expected 0 to 3", version));
    const bool old = version < 2;
    cursor.skip(old ? 4 : 0);  // versions of the following structures
    const unsigned bytes = cursor.number<std::uint8_t>();
    cursor.skip(version == 0 ? 10 : version == 1 ? 14 : 2);  // size of lengths, tree parameters, flags
    (void)address(cursor, bytes);                            // base
    (void)address(cursor, bytes);                            // free space, or the extension
    const auto end = address(cursor, bytes);
    if (end > source.size)
        throw FormatError(source.name, {.offset = source.size},
                          fmt::format("HDF5: the file ends here, expected its end at byte {}; it is truncated", end));
    if (end <= start)
        cursor.fail(fmt::format("the stated end of the file at byte {} lies before its beginning; it is damaged", end));
}

}  // namespace

Hdf5Session::Hdf5Session() {
    if (sessions++ == 0) guard().lock();
    // otherwise the library complains of damaged files at the end of the program
    static const herr_t quiet = H5dont_atexit();
    static_cast<void>(quiet);
    H5Eget_auto2(H5E_DEFAULT, &reporter_, &reporter_data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Hdf5Session::~Hdf5Session() {
    H5Eset_auto2(H5E_DEFAULT, reporter_, reporter_data_);
    if (--sessions == 0) guard().unlock();
}

Hdf5Handle::~Hdf5Handle() {
    if (id < 0) return;
    const Hdf5Session session;
    close(id);
}

std::optional<std::uint64_t> find_hdf5(std::string_view head) {
    for (std::size_t at = 0; at < head.size(); at = at == 0 ? 512 : 2 * at)
        if (head.substr(at).starts_with(signature)) return at;
    return std::nullopt;
}

Hdf5Handle opened_hdf5(const Source& source) {
    const auto start = find_hdf5(source.head(1 << 16));
    if (!start)
        throw FormatError(source.name, {.offset = std::min<std::uint64_t>(source.size, 512)},
                          "HDF5: no signature; the file is damaged or truncated");
    require_whole(source, *start);
    require_sound_heaps(source);
    const Hdf5Session session;
    const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), &H5Pclose);
    if (source.path.empty()) {
        auto image = source.all();
        H5Pset_fapl_core(access, image_increment, 0);
        H5Pset_file_image(access, image.data(), image.size());
    }
    Hdf5Handle file(H5Fopen(source.path.empty() ? source.name.c_str() : source.path.c_str(), H5F_ACC_RDONLY, access),
                    &H5Fclose);
    if (!file)
        throw FormatError(source.name, {.offset = *start},
                          "HDF5: the library cannot open the file; it is damaged, or another program is writing it");
    require_unchanged(source);
    return file;
}

std::uint64_t hdf5_product(const std::vector<hsize_t>& extents, std::uint64_t start) {
    for (const auto extent : extents) {
        if (extent != 0 && start > std::numeric_limits<std::uint64_t>::max() / extent)
            return std::numeric_limits<std::uint64_t>::max();
        start *= extent;
    }
    return start;
}

std::vector<hsize_t> hdf5_extents(hid_t space) {
    const int rank = H5Sget_simple_extent_ndims(space);
    std::vector<hsize_t> extents(static_cast<std::size_t>(std::clamp(rank, 0, max_dimensions)));
    if (!extents.empty()) H5Sget_simple_extent_dims(space, extents.data(), nullptr);
    return extents;
}

}  // namespace setae::bytes
