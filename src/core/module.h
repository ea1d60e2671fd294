// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <exception>
#include <string>
#include <typeinfo>
#include <utility>

#include "core/error.h"

namespace frana {

/// Whether a module's libraries find each other's functions by themselves, or only among those of the whole process.
enum class ModuleScope { own, process };

/// Returns the table of functions that a module of the program exports, and loads the module when it is first asked
/// for: a library that few commands need costs the others neither time nor addresses. A module is the file NAME.so in
/// `modules` beside the program, or in ../lib/frana from there, which wraps one library or a few; it contains no code
/// of the program and exports one function, which FRANA_MODULE declares. Throws Error(environment) if the module, or a
/// library of it, is missing or not of this build.
///
///     struct Functions { double (*quantile)(double place); };    // a header that program and module share
///     const Functions& f = module_table<Functions>("openturns"); // in the program
///     FRANA_MODULE(Functions, {quantile})                        // in the module
template <class Table>
const Table& module_table(const std::string& name, ModuleScope scope = ModuleScope::own);

/// Throws as module_table does if the module's file is missing, without loading it.
void require_module(const std::string& name);

/// What a module's only exported function returns.
struct ModuleContent {
    const char* build;  ///< version and compiler of the program
    const char* type;   ///< of the table
    std::size_t size;
    const void* table;
};
/// The same for a table of any type: build, type and size must be these.
const void* module_table(const std::string& name, ModuleScope scope, const char* type, std::size_t size);

template <class Table>
const Table& module_table(const std::string& name, ModuleScope scope) {
    return *static_cast<const Table*>(module_table(name, scope, typeid(Table).name(), sizeof(Table)));
}

/// What a function of a module throws in place of an Error, which is code of the program.
struct ModuleFailure : std::exception {
    explicit ModuleFailure(Problem reason) : problem(std::move(reason)) {}
    Problem problem;
};

/// Calls functions of a module; throws Error(environment) in place of a ModuleFailure.
template <class Call>
auto call_module(Call&& call) {
    try {
        return std::forward<Call>(call)();
    } catch (const ModuleFailure& failure) {
        throw Error(ErrorKind::environment, failure.problem);
    }
}

inline constexpr const char* k_module_entry = "frana_module";

/// Exports a table from a module: FRANA_MODULE(Type, {function, ...}). FRANA_BUILD is defined by the build.
#define FRANA_MODULE(Type, ...)                                                             \
    extern "C" __attribute__((visibility("default"))) frana::ModuleContent frana_module() { \
        static const Type k_table = __VA_ARGS__;                                            \
        return {FRANA_BUILD, typeid(Type).name(), sizeof k_table, &k_table};                \
    }

}  // namespace frana
