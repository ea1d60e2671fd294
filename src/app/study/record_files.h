// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "app/process/terminal.h"
#include "app/study/member_record.h"

namespace frana::app::study {

/// Where a record is in a file of many.
struct RecordPlace {
    std::string file;  ///< empty: nowhere
    std::uint64_t at = 0, bytes = 0;
};

/// Returns a record as it is in its file:
///
///     8 bytes "frana mb", format, bytes of the rest, member | rest of the record | CRC-32 of all before
std::string bytes_of(MemberRecord record);
/// Returns a record whose every byte has been checked; none if they are damaged or have another format.
std::optional<MemberRecord> record_from(const std::string& bytes);

/// Returns record_from() a place; none if it cannot be read or is damaged.
std::optional<MemberRecord> read_record(const RecordPlace& place);
/// The same of a place where it must be. Throws Error(environment).
MemberRecord require_record(const RecordPlace& place);

/// Calls visit(member, place) for every whole record in a file, in order. What lies between records and is none is
/// passed over, as is a torn one at the end; the content of records is not looked at.
void for_each_record(const std::string& file,
                     const std::function<void(std::uint64_t member, const RecordPlace& place)>& visit);

/// The records of a study's members in the folder in which its result is being built: in a few files, each written by
/// one process, a record after the other. What a kill leaves at the end of a file is no record, and stays there: the
/// next process begins a file of its own. Of several records of a member the last one counts. The files that older
/// versions wrote, with one record each, are such files too.
class RecordFiles {
  public:
    /// @param folder that contains the folder of records (k_record_folder)
    explicit RecordFiles(std::string folder);

    /// Number of members that have a record, which may be damaged.
    [[nodiscard]] std::size_t count() const noexcept { return places_.size(); }
    [[nodiscard]] RecordPlace place(std::uint64_t member) const;
    /// Appends a record to the file of this process: a kill does not take it any more, but a power failure may, until
    /// sync(), which follows by itself after 64 records or a second. Throws Error(environment).
    void append(std::uint64_t member, const std::string& bytes);
    /// Waits until all records are on the disk. Throws Error(environment).
    void sync();

  private:
    std::string folder_;
    std::map<std::uint64_t, RecordPlace> places_;  ///< by member
    std::string file_;                             ///< of this process; empty: none yet
    std::uint64_t size_ = 0;
    std::size_t unsynced_ = 0;
    Stopwatch since_sync_;
};

/// Returns the number of records in a folder in which a study, or a calibration by several events, is being built.
std::size_t count_records(const std::string& folder);

/// Joins the records of all members in a file of the result that is being built (k_joined_records), after their number
/// and what they belong to. Throws Error(environment).
void join_records(const std::string& folder);
/// What the joined records of a complete study belong to, and how many they are; 0: it has none.
struct JoinedRecords {
    std::string identity;
    std::size_t members = 0;
};
/// Reads them, and adds those of members without a record to others; null: to none. Throws Error(environment) if they
/// cannot be read or written.
JoinedRecords split_records(const std::string& result, RecordFiles* to);

}  // namespace frana::app::study
