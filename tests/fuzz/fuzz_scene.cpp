// SPDX-License-Identifier: Apache-2.0
// Scene files: a scene read without a problem is written and read again as the same scene.
#include <sys/mman.h>
#include <unistd.h>

#include "harness.h"
#include "params/scene/read_scene.h"
#include "params/scene/write_scene.h"

namespace {

// A file in memory; the reader of scenes needs a path.
class ScenePath {
  public:
    ScenePath() : file_(::memfd_create("scene", 0)), path_("/proc/self/fd/" + std::to_string(file_)) {}
    ~ScenePath() { ::close(file_); }
    ScenePath(const ScenePath&) = delete;
    ScenePath& operator=(const ScenePath&) = delete;

    const std::string& with(const void* data, std::size_t size) {
        if (::ftruncate(file_, 0) != 0 || ::pwrite(file_, data, size, 0) != static_cast<ssize_t>(size))
            __builtin_trap();
        return path_;
    }

  private:
    int file_;
    std::string path_;
};

frana::SceneReading read(ScenePath& path, const void* data, std::size_t size) {
    return frana::read_scene(path.with(data, size), {}, FRANA_SHARE_DIR);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static ScenePath path;
    frana::fuzz::refused_or_done([&] {
        const frana::SceneReading first = read(path, data, size);
        if (!first.problems.empty()) return;
        const std::string text = frana::scene_text(first.scene, {});
        const frana::SceneReading second = read(path, text.data(), text.size());
        if (!second.problems.empty()) __builtin_trap();
        // The source of a value is a comment and may differ; the lines with values may not.
        const auto values = [](const std::string& all) {
            std::string kept;
            for (std::size_t from = 0; from < all.size();) {
                const std::size_t end = std::min(all.find('\n', from), all.size());
                std::string line = all.substr(from, end - from);
                if (!line.empty() && line[0] != '#') kept += line.substr(0, line.find(" #")) + '\n';
                from = end + 1;
            }
            return kept;
        };
        if (values(text) != values(frana::scene_text(second.scene, {}))) __builtin_trap();
    });
    return 0;
}
