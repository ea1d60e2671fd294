// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "app/process/terminal.h"
#include "app/publish/html_page.h"
#include "app/store/result_directory.h"
#include "app/study/plan/study_input.h"
#include "app/study/publish/study_tables.h"

namespace frana::app::study {

struct StudyOutcome {
    bool too_many_failed = false;
    bool has_troubles = false;  ///< Troubles::any
};

/// Adds to the facts what the runs warn of, and tells it.
/// @param table that has the reasons of failures
StudyOutcome tell_of_runs(const StudyInput& input, const std::vector<MemberRecord>& runs, const std::string& table,
                          StudyFacts& facts, RunLog& log);

/// Writes the study as used, and which files it and its scenes name.
void write_study_file(const StudyInput& input, const ResultDirectory& directory);

/// Writes everything that follows from the members' records in the directory: rasters, tables, outlines, maps, charts,
/// report.html, summary.json. Throws Error(environment).
/// @param members that ran  @param computed of these in this session
StudyOutcome publish_study(StudyInput& input, std::size_t members, std::size_t computed, int threads,
                           const Stopwatch& since_start, const ResultDirectory& directory, RunLog& log);

/// Adds warnings and failed members, if there are any, to the report of a study and writes it.
void end_page(const StudyInput& input, const std::string& title, const Table& failures, const StudyFacts& facts,
              Opening opening, Document page, const std::string& folder);

/// Writes report.html of a study from its tables and the pictures already in its directory: one self-contained file.
/// Throws Error(environment).
void write_study_report(const StudyInput& input, const StudyResult& result, const StudyFacts& facts,
                        const ResultDirectory& directory);

}  // namespace frana::app::study
