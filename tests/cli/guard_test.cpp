// SPDX-License-Identifier: Apache-2.0
// What a scene must not make frana do: reach into the network, take the machine's memory, or write a result that
// another run is writing.
#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "tiny_scene.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

/// Listens on a port of this machine and says whether somebody called.
class Listener {
  public:
    Listener() : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
        address_.sin_family = AF_INET;
        address_.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof address_;
        auto* address = reinterpret_cast<sockaddr*>(&address_);
        EXPECT_EQ(::bind(socket_, address, size), 0);
        EXPECT_EQ(::listen(socket_, 8), 0);
        EXPECT_EQ(::getsockname(socket_, address, &size), 0);
    }
    ~Listener() { ::close(socket_); }
    Listener(const Listener&) = delete;
    Listener& operator=(const Listener&) = delete;

    [[nodiscard]] std::string place() const {
        return "127.0.0.1:" + std::to_string(ntohs(address_.sin_port));
    }
    /// Takes every call that came, and ends it.
    [[nodiscard]] int calls() const {
        int count = 0;
        pollfd waiting{socket_, POLLIN, 0};
        while (::poll(&waiting, 1, 0) > 0) {
            ::close(::accept(socket_, nullptr, nullptr));
            ++count;
        }
        return count;
    }

  private:
    int socket_;
    sockaddr_in address_{};
};

using Guard = TinyScene;

TEST_F(Guard, NothingIsReadOverTheNetworkUnlessAllowed) {
    const Listener listener;
    const std::string url = "http://" + listener.place() + "/a";
    const std::vector<std::string> keys{
        "terrain.dtm=" + url + ".tif",
        "terrain.dtm=/vsicurl/" + url + ".tif",
        "terrain.dtm=/vsizip//vsicurl/" + url + ".zip/a.tif",
        "terrain.dtm=WCS:" + url,
        "release.perimeter=" + url + ".geojson",
        "release.perimeter=WFS:" + url,
        "release.perimeter=PG:host=127.0.0.1 port=" + listener.place().substr(10),
        "release.thickness=raster:/vsicurl_streaming/" + url + ".tif"};
    for (const std::string& key : keys) {
        const Outcome outcome = frana({"check", "scene.ini", "--set", key});
        EXPECT_EQ(outcome.exit_code, 2) << key;
        EXPECT_NE(outcome.err.find("read over the network"), std::string::npos) << key << outcome.err;
        EXPECT_NE(outcome.err.find("--allow-network"), std::string::npos) << key << outcome.err;
        EXPECT_EQ(listener.calls(), 0) << key;
    }
    // A local file that points there: the path says nothing, GDAL has to be held back.
    write("far.vrt", "<VRTDataset rasterXSize=\"60\" rasterYSize=\"30\"><SRS>EPSG:32632</SRS><GeoTransform>" +
                         std::to_string(k_west) + ",5,0," + std::to_string(k_south + 150) +
                         ",0,-5</GeoTransform><VRTRasterBand dataType=\"Float32\" band=\"1\"><SimpleSource>"
                         "<SourceFilename>/vsicurl/" +
                         url +
                         ".tif</SourceFilename><SourceBand>1</SourceBand></SimpleSource></VRTRasterBand>"
                         "</VRTDataset>");
    write("map.xml",
          "<GDAL_WMS><Service name=\"TMS\"><ServerUrl>" + url +
              "</ServerUrl></Service><DataWindow><UpperLeftX>0</UpperLeftX></DataWindow></GDAL_WMS>");
    for (const std::string file : {"far.vrt", "map.xml"}) {
        EXPECT_EQ(frana({"check", "scene.ini", "--set", "terrain.dtm=" + file}).exit_code, 2) << file;
        EXPECT_EQ(listener.calls(), 0) << file;
    }
}

TEST_F(Guard, TheNetworkIsReachedWhereItIsAllowed) {
    const Listener listener;
    std::atomic<bool> asked = false;
    std::thread asking([&] {
        // Nobody answers as a server would: it ends as a file that cannot be read.
        EXPECT_EQ(frana({"check", "scene.ini", "--allow-network", "--set",
                         "terrain.dtm=/vsicurl/http://" + listener.place() + "/a.tif"})
                      .exit_code,
                  2);
        asked = true;
    });
    int calls = 0;
    while (!asked) {
        calls += listener.calls();
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    asking.join();
    EXPECT_GT(calls, 0);
}

TEST_F(Guard, ValuesThatNoSceneMeansAreRefusedInOnePass) {
    const std::vector<std::string> values{"terrain.cell-size=1e-6",
                                          "terrain.bounds=nan 0 1 1",
                                          "release.thickness=nan",
                                          "release.volume=1e300",
                                          "release.velocity=inf",
                                          "material.density=-1e308",
                                          "material.turbulence=nan",
                                          "material.viscosity=1e308",
                                          "material.friction-angle=-inf",
                                          "numerics.cfl=inf",
                                          "numerics.particles-per-cell=99999999999999999999",
                                          "numerics.minimum-depth=1e-320",
                                          "time.end=1e308",
                                          "time.frame-interval=",
                                          "output.map-size=4000000000x4000000000"};
    std::vector<std::string> arguments{"run", "scene.ini"};
    for (const std::string& value : values) arguments.insert(arguments.end(), {"--set", value});
    const std::vector<std::string> before = files();
    const Outcome outcome = frana(arguments);
    EXPECT_EQ(outcome.exit_code, 2);
    for (const std::string& value : values) {
        const std::string key = value.substr(0, value.find('='));
        EXPECT_NE(outcome.err.find("--set " + key + ": "), std::string::npos) << key << " in " << outcome.err;
    }
    // Nothing of that size was tried: what the program takes with its libraries.
    if (!k_sanitized) {
        EXPECT_LT(outcome.peak_memory_bytes, 300e6);
    }
    EXPECT_EQ(files(), before);
}

/// Tries the lock that a run holds on the folder in which it works.
bool locked(const fs::path& folder, int& descriptor) {
    descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY);
    return ::flock(descriptor, LOCK_EX | LOCK_NB) != 0;
}

TEST_F(Guard, TwoRunsDoNotWriteOneResult) {
    write_scene(k_numbers_only);
    const std::vector<std::string> run{"run",     "scene.ini", "--out",       "result",
                                       "--quiet", "--set",     "time.end=0.1"};
    const fs::path aside = folder_ / "result.partial-OTHER1";
    fs::create_directory(aside);
    int descriptor = -1;
    ASSERT_FALSE(locked(aside, descriptor));
    const std::vector<std::string> before = files();
    const Outcome second = frana(run);
    EXPECT_EQ(second.exit_code, 2) << second.err;
    EXPECT_NE(second.err.find("another run is writing this result now"), std::string::npos) << second.err;
    EXPECT_EQ(files(), before);  // it took its own folder away
    // A run that was killed leaves its folder, not its lock.
    ::close(descriptor);
    EXPECT_EQ(frana(run).exit_code, 0);
    EXPECT_TRUE(fs::exists(folder_ / "result" / "summary.json"));
}

TEST_F(Guard, ARunHoldsItsLockWhileItComputes) {
    write_scene("stop-when-still = off\n[numerics]\nparticles-per-cell = 16\n" + k_numbers_only);
    Outcome outcome{};
    std::atomic<bool> ended = false;
    std::thread running([&] {
        outcome = frana({"run", "scene.ini", "--out", "result", "--quiet", "--set", "terrain.cell-size=2"});
        ended = true;
    });
    bool held = false;
    while (!held && !ended) {
        for (const auto& entry : fs::directory_iterator(folder_)) {
            if (entry.path().filename().string().rfind("result.partial-", 0) != 0) continue;
            int descriptor = -1;
            held = held || locked(entry.path(), descriptor);
            ::close(descriptor);
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    running.join();
    EXPECT_TRUE(held);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

}  // namespace
}  // namespace frana::test
