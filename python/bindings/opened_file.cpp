// SPDX-License-Identifier: GPL-3.0-or-later
#include "opened_file.hpp"

#include <chrono>
#include <mutex>
#include <optional>
#include <utility>

#include "setae/platform/files.hpp"

namespace setae::python {
namespace {

/// A file that is open, as it was before.
struct OpenedFile {
    std::string path;
    answers::FileRequest said;
    std::optional<platform::FileFacts> facts;
    std::vector<formats::Channel> channels;

    [[nodiscard]] bool is(const Item& item) const {
        return path == item.path && said == item.request.file && facts == platform::facts_of(path);
    }
};

class LastOpened {
public:
    void keep(OpenedFile file) {
        const std::lock_guard locked(mutex_);
        std::swap(last_, file);  // the one before goes when nobody waits for it
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

/// Whether what a file held is told by when it changed: within a tick of the clock it may change twice.
bool is_settled(const std::optional<platform::FileFacts>& facts) {
    using namespace std::chrono;
    const auto now = system_clock::now().time_since_epoch();
    return facts && now - nanoseconds(facts->changed) > 1s;
}

std::vector<formats::Channel> opened(const Item& item) {
    return formats::open(item.path, item.request.file.read_options());
}

}  // namespace

std::vector<formats::Channel> looked_at(const Item& item) {
    const auto facts = platform::facts_of(item.path);
    auto channels = opened(item);
    if (is_settled(facts)) last_opened().keep({item.path, item.request.file, facts, channels});
    return channels;
}

std::vector<formats::Channel> to_be_read(const Item& item) {
    if (auto kept = last_opened().take(item)) return std::move(*kept);
    return opened(item);
}

}  // namespace setae::python
