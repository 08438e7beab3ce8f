// SPDX-License-Identifier: GPL-3.0-or-later
#include "setae/half_space/loop_checkpoint.hpp"

#include <cstring>
#include <filesystem>
#include <type_traits>

#include <fmt/format.h>

#include "setae/bytes/digest.hpp"
#include "setae/bytes/whole_file.hpp"
#include "setae/core/errors.hpp"

namespace setae::half_space {
namespace {

constexpr std::string_view title = "setae sweep checkpoint 1\n";

static_assert(std::is_trivially_copyable_v<LoopStep>);

template <class Value>
void put(std::string& bytes, const Value& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// Reads values from bytes in sequence.
class Taker {
public:
    Taker(std::string_view bytes, const std::string& path) : bytes_(bytes), path_(path) {}
    void take(void* to, std::size_t count) {
        if (count > bytes_.size())
            throw FormatError(
                path_, {},
                fmt::format("the file ends {} bytes early; remove it to start again", count - bytes_.size()));
        std::memcpy(to, bytes_.data(), count);
        bytes_.remove_prefix(count);
    }
    template <class Value>
    Value value() {
        Value value;
        take(&value, sizeof value);
        return value;
    }
    [[nodiscard]] std::size_t left() const { return bytes_.size(); }

private:
    std::string_view bytes_;
    const std::string& path_;
};

}  // namespace

std::string loop_key(const ArrayView2D& heights, const Grid& grid, const Body& body, const Interaction& interaction,
                     const LoopOptions& options) {
    std::string bytes;
    const Array2D own = heights;
    bytes.append(reinterpret_cast<const char*>(own.data()), static_cast<std::size_t>(own.size()) * sizeof(double));
    bytes += fmt::format("{} {} {} {} {} {} {} {}", grid.nx, grid.ny, grid.size_x, grid.size_y, body.contact_modulus,
                         interaction.work_of_adhesion, interaction.range, name_of(interaction.law));
    if (body.layer)
        bytes += fmt::format(" layer {} {} {}", body.layer->thickness, body.layer->poisson_ratio,
                             static_cast<int>(body.layer->base));
    bytes += fmt::format(" loop {} {} {} {} {} {} {}", options.first.value_or(-1.0), options.turn,
                         options.stage_stiffness.value_or(0.0), options.max_pressure, options.jump_share,
                         options.largest_move, options.min_step);
    return bytes::sha256(bytes);
}

void write_checkpoint(const std::string& path, const std::string& key, const LoopCheckpoint& checkpoint) {
    std::string bytes(title);
    bytes += key + "\n";
    for (const Index n : {static_cast<Index>(checkpoint.steps.size()), checkpoint.gaps.rows(), checkpoint.gaps.cols()})
        put(bytes, n);
    put(bytes, checkpoint.halved);
    for (const auto& step : checkpoint.steps) put(bytes, step);
    const auto* gaps = reinterpret_cast<const char*>(checkpoint.gaps.data());
    bytes::write_whole_file(
        path, {bytes, std::string_view(gaps, static_cast<std::size_t>(checkpoint.gaps.size()) * sizeof(double))});
}

std::optional<LoopCheckpoint> read_checkpoint(const std::string& path, const std::string& key) {
    if (!std::filesystem::exists(path)) return {};
    const std::string file = bytes::read_back(path);
    const std::string_view content(file);
    if (!content.starts_with(title))
        throw FormatError(
            path, {},
            "the file is not a checkpoint of a sweep; expected a file that --restart wrote: name another one");
    if (content.substr(title.size(), key.size() + 1) != key + "\n")
        throw FormatError(path, {},
                          "the file is a checkpoint of another surface or of other options; remove it to start again");
    Taker taker(content.substr(title.size() + key.size() + 1), path);
    const auto steps = taker.value<Index>(), rows = taker.value<Index>(), columns = taker.value<Index>();
    LoopCheckpoint checkpoint{.halved = taker.value<double>()};
    const auto wanted = [](Index count, std::size_t size) { return static_cast<std::size_t>(count) * size; };
    const bool sane = steps > 0 && rows > 0 && columns > 0 && wanted(steps, sizeof(LoopStep)) <= taker.left() &&
                      wanted(rows, sizeof(double)) <= taker.left() && wanted(columns, sizeof(double)) <= taker.left();
    if (!sane || wanted(steps, sizeof(LoopStep)) + wanted(rows * columns, sizeof(double)) != taker.left())
        throw FormatError(path, {}, "the file does not have the length that it states; remove it to start again");
    for (Index n = 0; n < steps; ++n) checkpoint.steps.push_back(taker.value<LoopStep>());
    checkpoint.gaps.resize(rows, columns);
    taker.take(checkpoint.gaps.data(), wanted(rows * columns, sizeof(double)));
    return checkpoint;
}

}  // namespace setae::half_space
