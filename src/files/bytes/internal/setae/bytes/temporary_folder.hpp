// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace setae::bytes {

/// A new folder that only this user may enter, removed with everything in it. Every temporary file that is not beside
/// its final name belongs into one: its path cannot be foreseen, so that nothing can lie there before.
///
/// It is made in $TMPDIR; where that fails in /tmp, /var/tmp or the current folder.
class TemporaryFolder {
public:
    /// name: of the folder begins with "setae_NAME_". @throws FileError where it can be made nowhere.
    explicit TemporaryFolder(const std::string& name);
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    [[nodiscard]] const std::string& path() const { return path_; }
    [[nodiscard]] std::string file(const std::string& name) const { return path_ + "/" + name; }

private:
    std::string path_;
};

}  // namespace setae::bytes
