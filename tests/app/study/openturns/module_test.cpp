// SPDX-License-Identifier: Apache-2.0
// The program's modules: found beside it or where they are installed, loaded by those who need them.
#include <cstdio>
#include <memory>

#include "study/tiny_study.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

class Modules : public Ensemble {
  protected:
    Modules() {
        write_study("samples = 4\n", k_two_keys);
        fs::create_directories(path("bin"));
        fs::copy_file(FRANA_PROGRAM, path("bin/frana"));
        fs::create_directory_symlink(fs::path(FRANA_PROGRAM).parent_path() / "share", path("share"));
    }
    [[nodiscard]] static fs::path built() { return fs::path(FRANA_PROGRAM).parent_path() / "modules"; }
    /// Runs the copy of the program.
    [[nodiscard]] Outcome copy(const std::vector<std::string>& arguments) const {
        StartedProgram program(folder_.string(), arguments, path("bin/frana"));
        return program.wait();
    }
    /// Runs the program and returns what the dynamic linker loaded, in the process and those it started.
    [[nodiscard]] std::string loaded_by(const std::string& arguments) const {
        const std::string place = path("linker");
        fs::remove_all(place);
        fs::create_directories(place);
        const std::string command = "cd '" + folder_.string() + "' && LD_DEBUG=files LD_DEBUG_OUTPUT='" + place +
                                    "/of' '" + FRANA_PROGRAM + "' " + arguments + " > said 2>&1";
        EXPECT_EQ(std::system(command.c_str()), 0) << arguments << ": " << read_text(path("said"));
        std::string all;
        for (const fs::directory_entry& file : fs::directory_iterator(place)) all += read_text(file.path().string());
        EXPECT_NE(all.find("libgdal"), std::string::npos);
        return all;
    }
    static constexpr const char* k_of_pictures[] = {"libvtk",      "libOSMesa",  "libGL",     "libLLVM",
                                                    "libavformat", "libavcodec", "libswscale"};
};

TEST_F(Modules, WhoDoesNotNeedThemStartsWithoutThem) {
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(
        ::popen(("LD_TRACE_LOADED_OBJECTS=1 '" + std::string(FRANA_PROGRAM) + "'").c_str(), "r"), ::pclose);
    std::string libraries;
    for (int byte = std::fgetc(pipe.get()); byte != EOF; byte = std::fgetc(pipe.get()))
        libraries += static_cast<char>(byte);
    EXPECT_NE(libraries.find("libgdal"), std::string::npos) << libraries;
    expect_no_words(libraries, {"libOT.so", "libopen-rte"});
    for (const std::string library : k_of_pictures) EXPECT_EQ(libraries.find(library), std::string::npos) << library;
    succeeded(copy({"--version"}));
    succeeded(copy({"check", "scene.ini"}));
}

TEST_F(Modules, DrawingIsLoadedForAPicture) {
    for (const std::string arguments :
         {"--version", "--help", "params", "materials", "check scene.ini", "check study.ini",
          "run scene.ini --out numbers --set output.maps=off --set output.animation=off"}) {
        const std::string loaded = loaded_by(arguments);
        for (const std::string library : k_of_pictures)
            EXPECT_EQ(loaded.find(library), std::string::npos) << arguments << " loads " << library;
    }
    const std::string map = loaded_by("render numbers --map max_depth");
    expect_words(map, {"libvtkRenderingOpenGL2", "libOSMesa"});
    EXPECT_EQ(map.find("libavcodec"), std::string::npos);
    EXPECT_TRUE(fs::exists(path("numbers/maps/max_depth.png")));
    EXPECT_NE(loaded_by("run scene.ini --out film --set output.maps=off --set output.animation=on "
                        "--set time.frame-interval=1")
                  .find("libavcodec"),
              std::string::npos);
    EXPECT_TRUE(fs::exists(path("film/animation.mp4")));
}

TEST_F(Modules, TheProgramOfTheBenchesIsNamedWhenItIsMissing) {
    const Outcome outcome = copy({"bench", "stability"});
    EXPECT_EQ(outcome.exit_code, 4);
    EXPECT_NE(outcome.err.find(path("bin/frana-bench") + ": a part of frana is missing"), std::string::npos)
        << outcome.err;
    succeeded(copy({"bench", "--help"}));
}

TEST_F(Modules, AMissingOneIsNamedBeforeTheRun) {
    for (const char* command : {"run", "check"}) {
        const Outcome outcome =
            copy({command, "scene.ini", "--set", "output.directory=out", "--set", "output.maps=on"});
        EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
        EXPECT_NE(outcome.err.find("vtk.so: a part of frana is missing"), std::string::npos) << outcome.err;
    }
    EXPECT_FALSE(fs::exists(path("out")));
    succeeded(copy({"run", "scene.ini", "--out", "out"}));
}

/// Expects that the command finds no library for drawing, and has computed nothing when it says so.
class WithoutDrawing : public Modules {
  protected:
    WithoutDrawing() {
        fs::create_directories(path("bin/modules"));
        fs::copy_file(built() / "openturns.so", path("bin/modules/openturns.so"));
    }
    void expect_named_first(const std::vector<std::string>& arguments, const std::string& module) const {
        const Outcome outcome = copy(arguments);
        EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
        EXPECT_NE(outcome.err.find(module + ": a part of frana is missing"), std::string::npos) << outcome.err;
        for (const fs::directory_entry& entry : fs::directory_iterator(folder_))
            EXPECT_FALSE(entry.is_directory() && entry.path().filename().string().starts_with("out")) << entry.path();
    }
};

TEST_F(WithoutDrawing, ARunIsRefusedAndSoItsCheck) {
    for (const char* command : {"run", "check"}) {
        expect_named_first({command, "scene.ini", "--set", "output.directory=out", "--set", "output.maps=on"},
                           "vtk.so");
        expect_named_first({command, "scene.ini", "--set", "output.directory=out", "--set", "output.animation=on"},
                           "vtk.so");
    }
    // Without maps a surveyed outline is not drawn.
    ran("truth");
    succeeded(copy({"run", "scene.ini", "--out", "out", "--set", "observed.perimeter=truth/extent.gpkg|layer=trace"}));
}

TEST_F(WithoutDrawing, AStudyIsRefused) {
    write_study("samples = 4\n", "[set]\noutput.maps = on\n" + k_two_keys);
    expect_named_first({"ensemble", "study.ini", "--out", "out"}, "vtk.so");
    expect_named_first({"check", "study.ini", "--out", "out"}, "vtk.so");
    write_study("samples = 4\n", k_two_keys);
    succeeded(copy({"ensemble", "study.ini", "--out", "out"}));
}

TEST_F(WithoutDrawing, ACalibrationIsRefused) {
    ran("truth");
    const std::string scene = "perimeter = truth/extent.gpkg|layer=trace\n",
                      rest = "[objective]\njaccard = 1\n" + k_two_keys;
    write("slope.ini", read_text(path("scene.ini")) + "[observed]\n" + scene);
    const auto write_calibration = [&](const std::string& maps) {
        write("study.ini",
              "[study]\nscene = slope.ini\nsamples = 8\n[set]\ntime.end = 5\noutput.maps = " + maps + "\n" + rest);
    };
    write_calibration("on");
    expect_named_first({"calibrate", "study.ini", "--out", "out"}, "vtk.so");
    write_calibration("off");
    succeeded(copy({"calibrate", "study.ini", "--out", "out"}));
}

TEST_F(WithoutDrawing, ARegionIsRefused) {
    write("region.ini", "[region]\nscene = scene.ini\n[set]\noutput.maps = on\n");
    expect_named_first({"batch", "region.ini", "--out", "out"}, "vtk.so");
}

TEST_F(WithoutDrawing, AChartIsDrawn) {
    succeeded(copy({"converge", "scene.ini", "--out", "out"}));
    EXPECT_TRUE(fs::exists(path("out/convergence.png")));
}

TEST_F(Modules, AMissingOneIsNamed) {
    const Outcome outcome = copy({"ensemble", "study.ini", "--out", "out"});
    EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
    EXPECT_NE(outcome.err.find(path("bin/modules/openturns.so") + ": a part of frana is missing"), std::string::npos)
        << outcome.err;
    EXPECT_FALSE(fs::exists(path("out")));
}

TEST_F(Modules, AreFoundWhereTheyAreInstalled) {
    fs::create_directories(path("lib/frana"));
    fs::copy_file(built() / "openturns.so", path("lib/frana/openturns.so"));
    succeeded(copy({"check", "study.ini"}));
    fs::rename(folder_ / "lib", folder_ / "elsewhere");
    fs::create_directories(path("moved"));
    fs::rename(path("bin"), path("moved/bin"));
    fs::rename(path("elsewhere"), path("moved/lib"));
    fs::rename(path("share"), path("moved/share"));
    StartedProgram moved(folder_.string(), {"check", "study.ini"}, path("moved/bin/frana"));
    succeeded(moved.wait());
}

TEST_F(Modules, ADamagedOneIsNamed) {
    fs::create_directories(path("bin/modules"));
    write("bin/modules/openturns.so", "not a library");
    const Outcome outcome = copy({"check", "study.ini"});
    EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
    EXPECT_NE(outcome.err.find("openturns.so: a part of frana cannot be loaded"), std::string::npos) << outcome.err;
}

// The module of MPI has another table.
TEST_F(Modules, OneWithAnotherTableIsRefused) {
    fs::create_directories(path("bin/modules"));
    fs::copy_file(built() / "mpi.so", path("bin/modules/openturns.so"));
    const Outcome outcome = copy({"check", "study.ini"});
    EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
    EXPECT_NE(outcome.err.find("is a part of another version of frana"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace frana::test
