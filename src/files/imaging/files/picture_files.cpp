// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture_files.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include <fmt/format.h>

#include "setae/bytes/archive_folder.hpp"
#include "setae/bytes/source.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"
#include "setae/core/number_text.hpp"
#include "tiff_stack.hpp"

namespace setae::imaging {
namespace {

namespace fs = std::filesystem;

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// End of the run of digits that begins at `at`, and position of its first digit other than 0.
struct DigitRun {
    std::size_t end, significant;
};

DigitRun digits_from(std::string_view text, std::size_t at) {
    DigitRun run{at, at};
    while (run.end < text.size() && is_digit(text[run.end])) ++run.end;
    while (run.significant + 1 < run.end && text[run.significant] == '0') ++run.significant;
    return run;
}

constexpr long max_missing = 100;  // times the number of files: beyond, numbers are dates or serial numbers

std::string too_large(PictureSize size, long max_pixels) {
    return fmt::format("{} × {} pixels, more than the {} that a frame may have; crop the frames", size.width,
                       size.height, max_pixels);
}

}  // namespace

bool natural_order(std::string_view first, std::string_view second) {
    std::size_t i = 0, j = 0;
    while (i < first.size() && j < second.size()) {
        if (is_digit(first[i]) && is_digit(second[j])) {
            const auto a = digits_from(first, i), b = digits_from(second, j);
            const auto x = first.substr(a.significant, a.end - a.significant),
                       y = second.substr(b.significant, b.end - b.significant);
            if (x.size() != y.size()) return x.size() < y.size();
            if (x != y) return x < y;
            i = a.end;
            j = b.end;
        } else {
            if (first[i] != second[j]) return first[i] < second[j];
            ++i;
            ++j;
        }
    }
    if (i == first.size() && j == second.size()) return first < second;  // equal except for leading zeros
    return i == first.size();
}

std::vector<std::string> files_in(const std::string& folder, const std::function<bool(const bytes::Source&)>& wanted) {
    std::vector<std::string> paths;
    std::error_code error;
    if (bytes::is_archive(folder)) {
        for (const auto& path : bytes::files_of_archive(folder))
            if (wanted(bytes::file_source(path))) paths.push_back(path);
        std::sort(paths.begin(), paths.end(), [](const auto& a, const auto& b) { return natural_order(a, b); });
        return paths;
    }
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        if (!entry->is_regular_file() || entry->path().filename().string().starts_with('.')) continue;
        if (wanted(bytes::file_source(entry->path().string()))) paths.push_back(entry->path().string());
    }
    if (error) throw FileError(folder + ": cannot list the folder: " + error.message());
    std::sort(paths.begin(), paths.end(), [](const auto& a, const auto& b) { return natural_order(a, b); });
    return paths;
}

std::vector<std::string> pictures_in(const std::string& folder) {
    auto paths = files_in(
        folder, [](const bytes::Source& file) { return picture_kind(file.up_to(0, 32)) != PictureKind::none; });
    if (paths.empty())
        throw FormatError(folder, {}, "the folder contains no pictures; expected PNG, JPEG, TIFF or BMP files");
    return paths;
}

FrameNumbers numbers_of(const std::vector<std::string>& paths) {
    FrameNumbers found;
    const auto counted = [&](std::string note) {
        found = {{}, {}, std::move(note)};
        for (std::size_t i = 0; i < paths.size(); ++i) found.numbers.push_back(static_cast<long>(i) + 1);
        return found;
    };
    std::string before, after;
    for (const auto& path : paths) {
        const auto name = fs::path(path).stem().string();
        const auto last = name.find_last_of("0123456789");
        if (last == std::string::npos) return counted("");
        auto begin = last;
        while (begin > 0 && is_digit(name[begin - 1])) --begin;
        const auto number = spelled<long>(std::string_view(name).substr(begin, last + 1 - begin));
        if (!number) return counted("");
        if (&path == &paths.front()) {
            before = name.substr(0, begin);
            after = name.substr(last + 1);
        }
        if (name.substr(0, begin) != before || name.substr(last + 1) != after)
            return counted("the names differ not only by a number; frames are counted from 1");
        if (!found.numbers.empty() && *number <= found.numbers.back())
            return counted(fmt::format("number {} is repeated or out of order; frames are counted from 1", *number));
        found.numbers.push_back(*number);
    }
    const long span = found.numbers.back() - found.numbers.front() + 1;
    if (span / max_missing > static_cast<long>(paths.size()))
        return counted("the numbers in the names have too long gaps; frames are counted from 1");
    for (std::size_t i = 1; i < found.numbers.size(); ++i)
        for (long number = found.numbers[i - 1] + 1; number < found.numbers[i]; ++number)
            found.missing.push_back(number);
    return found;
}

std::optional<PictureSize> size_of_picture(const std::string& path) {
    const auto file = bytes::file_source(path);
    const auto head = file.up_to(0, 65536);
    if (picture_kind(head) != PictureKind::tiff) {
        const auto size = stated_size(head);
        return size || file.size <= head.size()
                   ? size
                   : stated_size(file.up_to(0, file.size));  // long comments before the size of a JPEG
    }
    try {
        const auto size = TiffStack(path).size_of(0);
        return size.width > 0 && size.height > 0 ? std::optional(size) : std::nullopt;
    } catch (const FormatError&) {
        return std::nullopt;
    }
}

FrameRead read_picture(const std::string& path, long max_pixels) {
    try {
        if (const auto size = size_of_picture(path); size && size->width > max_pixels / std::max(1L, size->height))
            return {{}, too_large(*size, max_pixels)};
        const auto bytes = bytes::read_file(path);
        if (picture_kind(bytes) != PictureKind::tiff) return decoded_picture(bytes);
        const TiffStack stack(path);
        if (stack.size() > 1)
            return {{},
                    fmt::format("{} pages: this is a stack among single pictures; open it separately", stack.size())};
        return stack.read(0);
    } catch (const Error& error) {
        return {{}, error.what()};
    }
}

}  // namespace setae::imaging
