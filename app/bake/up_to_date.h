#pragma once
// Outputs that need not be made again. Beside its output OUT a bake leaves OUT.burl.json: what it
// was made from (the inputs' content, the whole recipe, the options, the program's version), the
// files it wrote and its report. Why a file of its own, and nothing in the outputs: a .bin or .mtl
// has no place for it, one record covers all files of a bake, an output that was edited, replaced
// or deleted since shows, and the outputs' own bytes go on depending on nothing but the picture.
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/base/atomic_file.h"
#include "app/base/json_text.h"
#include "app/base/sha256.h"

namespace burl {

/// "a.png.burl.json".
std::string record_path(const std::string& out_path);

/// Name (without its folder) and SHA-256 of every file; those that cannot be read are left out.
Json content_of(std::span<const std::string> files, FileDigests& digests);

/// The report of the bake that made `out_path`, if that was made from the same and all its files
/// are as it left them, by size, time and inode; a record that is missing, damaged or of other
/// bytes than were written is none.
std::optional<Json> report_if_up_to_date(const std::string& out_path, const Json& made_from);

/// Leaves the record beside `out_path` after `outputs` were written: what was committed, since
/// another bake may have put its own files there meanwhile. Throws Error(io).
void write_record(const std::string& out_path, const Json& made_from,
                  std::span<const CommittedFile> outputs, const Json& report);

}  // namespace burl
