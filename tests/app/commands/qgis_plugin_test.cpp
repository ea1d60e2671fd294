// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>
#include <fstream>

#include "app/text/text_file.h"
#include "support/tiny_scene.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

/// QGIS's profiles in a folder of the test.
class QgisPlugin : public TinyScene {
  protected:
    QgisPlugin() {
        unsetenv("QGIS_CUSTOM_CONFIG_PATH");
        setenv("XDG_DATA_HOME", path("home").c_str(), 1);
    }
    ~QgisPlugin() override { unsetenv("XDG_DATA_HOME"); }

    [[nodiscard]] std::string profile(const std::string& name) const {
        return path("home/QGIS/QGIS3/profiles/" + name);
    }
    [[nodiscard]] std::string plugin(const std::string& name) const { return profile(name) + "/python/plugins/frana"; }
    void write_whole(const std::string& where, const std::string& text) const {
        fs::create_directories(fs::path(where).parent_path());
        std::ofstream(where) << text;
    }
};

TEST_F(QgisPlugin, IsPutIntoTheDefaultProfileAndReplacedWhole) {
    const Outcome outcome = succeeded(frana({"qgis-plugin", "--install"}));
    EXPECT_EQ(outcome.out, plugin("default") + "\n");
    int files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(FRANA_SOURCE_DIR "/share/qgis/frana")) {
        const std::string name = fs::relative(entry.path(), FRANA_SOURCE_DIR "/share/qgis/frana").string();
        if (!entry.is_regular_file() || name.find("__pycache__") != std::string::npos) continue;
        ++files;
        EXPECT_EQ(app::read_text_file(plugin("default") + "/" + name), app::read_text_file(entry.path().string()));
    }
    EXPECT_GT(files, 20);
    const std::string program = app::read_text_file(plugin("default") + "/program.txt");
    EXPECT_TRUE(fs::is_regular_file(program.substr(0, program.size() - 1))) << program;

    write_whole(plugin("default") + "/left_from_an_older_one.py", "");
    write_whole(profile("default") + "/python/plugins/other/metadata.txt", "name=other\n");
    succeeded(frana({"qgis-plugin", "--install", "--profile", "default"}));
    EXPECT_FALSE(fs::exists(plugin("default") + "/left_from_an_older_one.py"));
    EXPECT_FALSE(fs::exists(profile("default") + "/python/frana-plugin.partial"));
    EXPECT_TRUE(fs::exists(profile("default") + "/python/plugins/other/metadata.txt"));
}

TEST_F(QgisPlugin, AnotherProfileMustExist) {
    refusal_of(frana({"qgis-plugin", "--install", "--profile", "work"}), {"QGIS has no such profile (value work)"});
    EXPECT_FALSE(fs::exists(path("home")));
    fs::create_directories(profile("work"));
    succeeded(frana({"qgis-plugin", "--install", "--profile", "work"}));
    EXPECT_TRUE(fs::exists(plugin("work") + "/metadata.txt"));
    for (const char* name : {"", "..", "a/b"}) refusal_of(frana({"qgis-plugin", "--install", "--profile", name}));
    refusal_of(frana({"qgis-plugin"}));
}

TEST_F(QgisPlugin, AnotherPluginOfThatNameIsLeft) {
    write_whole(plugin("default") + "/metadata.txt", "[general]\nname=someone else's\n");
    const Outcome outcome = frana({"qgis-plugin", "--install"});
    EXPECT_EQ(outcome.exit_code, 4);
    EXPECT_NE(outcome.err.find("is not frana's plugin"), std::string::npos) << outcome.err;
    EXPECT_EQ(app::read_text_file(plugin("default") + "/metadata.txt"), "[general]\nname=someone else's\n");
}

// Where a file of the new one cannot be read, the older one stays.
TEST_F(QgisPlugin, AFailedInstallationLeavesTheOlderOne) {
    succeeded(frana({"qgis-plugin", "--install"}));
    write_whole(plugin("default") + "/older.py", "");
    write_whole(path("share/materials/x.ini"), "");
    write_whole(path("share/qgis/frana/metadata.txt"), "name=frana\n");
    fs::create_symlink("nowhere", path("share/qgis/frana/broken.py"));
    setenv("FRANA_SHARE", path("share").c_str(), 1);
    const Outcome outcome = frana({"qgis-plugin", "--install"});
    unsetenv("FRANA_SHARE");
    EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
    EXPECT_NE(outcome.err.find("broken.py"), std::string::npos) << outcome.err;
    EXPECT_TRUE(fs::exists(plugin("default") + "/older.py"));
    EXPECT_TRUE(fs::exists(plugin("default") + "/provider.py"));
    EXPECT_FALSE(fs::exists(profile("default") + "/python/frana-plugin.partial"));
}

}  // namespace
}  // namespace frana::test
