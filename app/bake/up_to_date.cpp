#include "app/bake/up_to_date.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <system_error>

#include "app/base/file_bytes.h"
#include "atlas/base/error.h"
#include "atlas/base/json.h"

namespace burl {

namespace {

namespace fs = std::filesystem;

/// The absolute path; the path as it is where the working directory is gone.
fs::path plain_path(const std::string& file) {
    std::error_code gone;
    const fs::path absolute = fs::absolute(file, gone);
    return (gone ? fs::path(file) : absolute).lexically_normal();
}

Json state_json(const CommittedFile& file) {
    return {{"bytes", file.bytes},
            {"modified", {file.seconds, file.nanoseconds}},
            {"inode", file.inode}};
}

/// Whether a file of the record still has the size, modification time and inode of its record.
bool as_it_was(const Json& output, const std::string& out_path) {
    const fs::path folder = plain_path(out_path).parent_path();
    const auto now = file_there(folder / output.at("file").get<std::string>());
    return now && output.at("state") == state_json(*now);
}

/// The JSON after printing and parsing, which change strings that are not UTF-8.
Json as_printed(const Json& json) {
    return Json::parse(print_json_value(json));
}

/// Text around the digest at the end of a record: the SHA-256 of all text before it, by which a
/// damaged record is noticed before it is parsed.
constexpr std::string_view digest_begin = ",\n  \"sha256\": \"", digest_end = "\"\n}\n";

std::string with_digest(const Json& record) {
    std::string text = print_json(record);
    text.resize(text.size() - std::string_view("\n}\n").size());
    const std::string digest = sha256(text);
    return fmt::format("{}{}{}{}", text, digest_begin, digest, digest_end);
}

bool has_its_digest(std::string_view text) {
    const std::size_t end = text.rfind(digest_begin);
    return end != std::string_view::npos &&
           text.substr(end) ==
               fmt::format("{}{}{}", digest_begin, sha256(text.substr(0, end)), digest_end);
}

/// The record of an output; none if it is missing or damaged.
std::optional<Json> read_record(const std::string& out_path) {
    std::error_code ignored;
    if (!fs::is_regular_file(record_path(out_path), ignored)) return std::nullopt;
    try {
        const auto bytes = read_file_bytes(record_path(out_path));
        if (!has_its_digest({reinterpret_cast<const char*>(bytes.data()), bytes.size()}))
            return std::nullopt;
        return Json::parse(bytes);
    } catch (const Error&) {
    } catch (const Json::exception&) {
    }
    return std::nullopt;
}

}  // namespace

std::string place_of(const std::string& file, const std::string& out_path) {
    return plain_path(file).lexically_proximate(plain_path(out_path).parent_path()).string();
}

std::string record_path(const std::string& out_path) {
    return out_path + ".burl.json";
}

Json content_of(std::span<const std::string> files, FileDigests& digests) {
    Json content = Json::array();
    for (const std::string& file : files) {
        try {
            const std::string& digest = digests.of(file);
            content.push_back({{"file", fs::path(file).filename().string()}, {"sha256", digest}});
        } catch (const Error&) {
        }
    }
    return content;
}

std::optional<Json> report_if_up_to_date(const std::string& out_path, const Json& made_from) {
    const std::optional<Json> record = read_record(out_path);
    try {
        if (!record || record->at("made_from") != as_printed(made_from)) return std::nullopt;
        for (const Json& output : record->at("outputs"))
            if (!as_it_was(output, out_path)) return std::nullopt;
        return record->at("report");
    } catch (const Error&) {
    } catch (const Json::exception&) {
    }
    return std::nullopt;
}

std::vector<std::string> left_of_earlier_bake(const std::string& out_path,
                                              std::span<const CommittedFile> outputs) {
    std::set<std::string> ours;
    for (const CommittedFile& file : outputs) ours.insert(place_of(file.path, out_path));
    const std::optional<Json> record = read_record(out_path);
    std::vector<std::string> left;
    try {
        if (!record) return left;
        for (const Json& output : record->at("outputs"))
            if (!ours.contains(output.at("file")) && as_it_was(output, out_path))
                left.push_back(output.at("file"));
    } catch (const Json::exception&) {
    }
    return left;
}

void write_record(const std::string& out_path, const Json& made_from,
                  std::span<const CommittedFile> outputs, const Json& report) {
    Json files = Json::array();
    for (const CommittedFile& file : outputs)
        files.push_back({{"file", place_of(file.path, out_path)}, {"state", state_json(file)}});
    const Json record = {
        {"made_from", made_from}, {"outputs", std::move(files)}, {"report", report}};
    write_file(record_path(out_path), with_digest(record));
}

}  // namespace burl
