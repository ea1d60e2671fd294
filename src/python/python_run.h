// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <memory>
#include <optional>
#include <utility>

#include "facade/frana.h"

namespace frana::python {

namespace py = pybind11;

/// Works without Python's lock.
template <class Work>
auto unlocked(const Work& work) {
    const py::gil_scoped_release gil;
    return work();
}

/// A run whose steps hold no lock of Python and which Ctrl-C ends.
class PythonRun {
  public:
    PythonRun(const Scene& scene, int threads) : interrupted_(std::make_shared<bool>(false)) {
        Options options;
        options.threads = threads;
        options.stop_requested = [interrupted = interrupted_, next = std::chrono::steady_clock::now()]() mutable {
            if (*interrupted) return true;
            const auto now = std::chrono::steady_clock::now();
            if (now < next) return false;
            next = now + std::chrono::milliseconds(50);
            const py::gil_scoped_acquire gil;
            *interrupted = PyErr_CheckSignals() != 0;
            return *interrupted;
        };
        const py::gil_scoped_release gil;
        run_ = std::make_unique<Run>(scene, std::move(options));
    }
    std::optional<Frame> next() {
        const Turn turn(*this);
        std::optional<Frame> frame = unlocked([&] { return run_->next(); });
        raise_interrupt();
        return frame;
    }
    Result result() {
        const Turn turn(*this);
        std::optional<Result> result = unlocked([&] { return std::optional<Result>(run_->result()); });
        raise_interrupt();
        return *result;
    }
    /// While another thread computes, the time of the frame before.
    [[nodiscard]] double time() const { return is_computing_ ? time_ : run_->time(); }

  private:
    /// One thread of Python at a time computes a run. Begins and ends with Python's lock held.
    class Turn {
      public:
        explicit Turn(PythonRun& run) : run_(run) {
            if (run.is_computing_) throw py::value_error("another thread computes this run: give each thread its own");
            run.time_ = run.run_->time();
            run.is_computing_ = true;
        }
        ~Turn() { run_.is_computing_ = false; }
        Turn(const Turn&) = delete;
        Turn& operator=(const Turn&) = delete;

      private:
        PythonRun& run_;
    };

    // The signal's exception, which is set.
    static void raise_interrupt() {
        if (PyErr_Occurred() != nullptr) throw py::error_already_set();
    }

    std::shared_ptr<bool> interrupted_;
    std::unique_ptr<Run> run_;
    bool is_computing_ = false;
    double time_ = 0;
};

}  // namespace frana::python
