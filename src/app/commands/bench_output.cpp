// SPDX-License-Identifier: Apache-2.0
#include "app/commands/bench_output.h"

#include <iostream>
#include <nlohmann/json.hpp>

#include "app/commands/command_line.h"
#include "app/commands/json_output.h"
#include "app/process/terminal.h"
#include "app/store/kept_files.h"
#include "app/text/text_table.h"
#include "core/error.h"

namespace frana::app {

namespace fs = std::filesystem;

std::optional<BenchOutput> bench_output(const boost::program_options::variables_map& values,
                                        const std::vector<const char*>& names, const std::vector<std::string>& inputs) {
    const auto folder = text_option(values, "out");
    if (!folder) return {};
    BenchOutput output(*folder, names);
    Problems problems;
    KeptFiles kept;
    for (const std::string& file : inputs) kept.add(file);
    kept.check(output.files(), "--out", problems);
    check_own(*folder, output.files(), "--out", {}, problems);
    problems.throw_if_any();
    std::error_code error;
    fs::create_directories(*folder, error);
    if (error) {
        throw Error(ErrorKind::environment,
                    Problem{"cannot be made: " + error.message(), "--out", *folder, "", "Choose another folder"});
    }
    return output;
}

int print_bench(const boost::program_options::variables_map& values, const std::string& bench, const std::string& text,
                const std::vector<BenchTable>& tables, bool good) {
    const auto code = static_cast<int>(good ? ExitCode::done : ExitCode::numerical);
    if (values.count("json") == 0) {
        std::cout << folded(text, output_width());
        return code;
    }
    Json document = document_of("bench");
    document["exit_code"] = code;
    document["bench"] = bench;
    document["passed"] = good;
    for (const BenchTable& table : tables) document[table.name] = rows_of(table.csv);
    print_document(document);
    return code;
}

}  // namespace frana::app
