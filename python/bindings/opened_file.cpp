// SPDX-License-Identifier: GPL-3.0-or-later
#include "opened_file.hpp"

#include <chrono>
#include <mutex>
#include <optional>
#include <utility>

#include "setae/platform/files.hpp"

namespace setae::python {
namespace {

/// An open file with its state when it was opened.
struct OpenedFile {
    std::string path;
    answers::FileRequest request;
    std::optional<platform::FileFacts> facts;
    std::vector<formats::Channel> channels;

    [[nodiscard]] bool is(const Item& item) const {
        return path == item.path && request == item.request.file && facts == platform::facts_of(path);
    }
};

class LastOpened {
public:
    void keep(OpenedFile file) {
        const std::lock_guard locked(mutex_);
        std::swap(last_, file);  // the earlier file is released after the lock
    }

    std::optional<std::vector<formats::Channel>> take(const Item& item) {
        const std::lock_guard locked(mutex_);
        if (last_.channels.empty() || !last_.is(item)) return std::nullopt;
        return std::exchange(last_, {}).channels;
    }

private:
    std::mutex mutex_;
    OpenedFile last_;
};

LastOpened& last_opened() {
    static LastOpened last;
    return last;
}

/// True if the time of change identifies the content of a file: within one tick of the clock a file can change twice.
bool is_settled(const std::optional<platform::FileFacts>& facts) {
    using namespace std::chrono;
    const auto now = system_clock::now().time_since_epoch();
    return facts && now - nanoseconds(facts->changed) > 1s;
}

std::vector<formats::Channel> opened(const Item& item) {
    return formats::open(item.path, item.request.file.read_options());
}

}  // namespace

std::vector<formats::Channel> open_and_keep(const Item& item) {
    const auto facts = platform::facts_of(item.path);
    auto channels = opened(item);
    if (is_settled(facts)) last_opened().keep({item.path, item.request.file, facts, channels});
    return channels;
}

std::vector<formats::Channel> kept_or_opened(const Item& item) {
    if (auto kept = last_opened().take(item)) return std::move(*kept);
    return opened(item);
}

}  // namespace setae::python
