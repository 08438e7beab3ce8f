// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace setae::bytes {

/// A new folder accessible only to this user, removed with its content. Every temporary file that is not next to its
/// final name belongs in such a folder: its path is unpredictable, so no other file can be there before.
///
/// It is created in $TMPDIR, otherwise in /tmp, /var/tmp or the current folder.
class TemporaryFolder {
public:
    /// name: the folder name begins with "setae_NAME_". @throws FileError if it cannot be created anywhere.
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
