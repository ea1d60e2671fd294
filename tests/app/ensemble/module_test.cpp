// SPDX-License-Identifier: Apache-2.0
// The program's modules: found beside it or where they are installed, loaded by those who need them.
#include <cstdio>
#include <memory>

#include "ensemble/tiny_study.h"

namespace frana::test {
namespace {

namespace fs = std::filesystem;

class Modules : public Ensemble {
  protected:
    Modules() {
        write_study("samples = 4\n", k_two_keys);
        fs::create_directories(path("bin"));
        fs::copy_file(FRANA_PROGRAM, path("bin/frana"));
    }
    [[nodiscard]] static fs::path built() { return fs::path(FRANA_PROGRAM).parent_path() / "modules"; }
    /// Runs the copy of the program.
    [[nodiscard]] Outcome copy(const std::vector<std::string>& arguments) const {
        StartedProgram program(folder_.string(), arguments, path("bin/frana"));
        return program.wait();
    }
};

TEST_F(Modules, WhoDoesNotNeedThemStartsWithoutThem) {
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(
        ::popen(("LD_TRACE_LOADED_OBJECTS=1 '" + std::string(FRANA_PROGRAM) + "'").c_str(), "r"), ::pclose);
    std::string libraries;
    for (int byte = std::fgetc(pipe.get()); byte != EOF; byte = std::fgetc(pipe.get()))
        libraries += static_cast<char>(byte);
    EXPECT_NE(libraries.find("libgdal"), std::string::npos) << libraries;
    EXPECT_EQ(libraries.find("libOT.so"), std::string::npos);
    EXPECT_EQ(libraries.find("libopen-rte"), std::string::npos);
    EXPECT_EQ(copy({"--version"}).exit_code, 0);
    EXPECT_EQ(copy({"check", "scene.ini"}).exit_code, 0);
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
    const Outcome outcome = copy({"check", "study.ini"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    fs::rename(folder_ / "lib", folder_ / "elsewhere");
    fs::create_directories(path("moved"));
    fs::rename(path("bin"), path("moved/bin"));
    fs::rename(path("elsewhere"), path("moved/lib"));
    StartedProgram moved(folder_.string(), {"check", "study.ini"}, path("moved/bin/frana"));
    EXPECT_EQ(moved.wait().exit_code, 0);
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
