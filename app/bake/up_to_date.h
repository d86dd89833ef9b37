#pragma once
// Records of bakes, by which outputs that are up to date are not baked again. A bake of OUT writes
// the record OUT.burl.json: all that the outputs depend on (the inputs' content, the whole recipe,
// the options, the program's version), the files that were written, and the report. The record is a
// file beside the outputs, not a part of them: a .bin or .mtl has no place for it, one record
// covers all files of a bake, an output that was edited, replaced or deleted later is noticed, and
// the outputs' bytes depend on the picture alone.
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/base/atomic_file.h"
#include "app/base/json_text.h"
#include "app/base/sha256.h"

namespace burl {

/// The path of the record of an output: "a.png.burl.json" for "a.png".
std::string record_path(const std::string& out_path);

/// The path of a file relative to the output's folder, so that a folder may be moved as a whole.
std::string place_of(const std::string& file, const std::string& out_path);

/// The names (without folders) and SHA-256 of the files, as JSON; files that cannot be read are
/// left out.
Json content_of(std::span<const std::string> files, FileDigests& digests);

/// The report in the record of `out_path`, if the record's made_from equals `made_from` and all its
/// files have the size, modification time and inode that they were written with. None if the record
/// is missing or damaged (its digest differs).
std::optional<Json> report_if_up_to_date(const std::string& out_path, const Json& made_from);

/// The names of the files that the record of `out_path` tells of, that are as they were written,
/// and that are not among `outputs`: they are left of an earlier bake and belong to another
/// picture.
std::vector<std::string> left_of_earlier_bake(const std::string& out_path,
                                              std::span<const CommittedFile> outputs);

/// Writes the record of `out_path`. `outputs` are the files as they were committed: another bake
/// may have replaced them since. Throws Error(io).
void write_record(const std::string& out_path, const Json& made_from,
                  std::span<const CommittedFile> outputs, const Json& report);

}  // namespace burl
