#include "app/up_to_date.h"

#include <algorithm>
#include <filesystem>

#include <sys/stat.h>

#include "app/atomic_file.h"
#include "app/file_bytes.h"
#include "app/sample_meshes.h"
#include "app/sha256.h"
#include "atlas/error.h"
#include "atlas/file_extension.h"
#include "atlas/gltf_container.h"

namespace burl {

namespace {

namespace fs = std::filesystem;

/// Files that the document's buffers name.
void add_buffers(const std::string& path, std::vector<std::string>& files) {
    const FileBuffer file = read_file(path);
    const Json document = Json::parse(split_gltf(file).json);
    for (const Json& buffer : document.at("buffers")) {
        const std::string uri = buffer.value("uri", "");
        const std::string name = is_data_uri(uri) ? "" : confined_file_name(uri);
        if (!name.empty()) files.push_back(fs::path(path).parent_path() / name);
    }
}

/// Where a file lies, from the folder of the output on, so that a folder may be moved as a whole.
std::string place_of(const std::string& file, const std::string& out_path) {
    const fs::path folder = fs::absolute(out_path).parent_path();
    return fs::absolute(file).lexically_normal().lexically_proximate(folder).string();
}

/// Size and time of a file that was written; null: it is not there.
Json state_of(const std::string& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) != 0) return nullptr;
    return {{"bytes", std::uint64_t(status.st_size)},
            {"modified", {std::int64_t(status.st_mtim.tv_sec), status.st_mtim.tv_nsec}}};
}

bool as_it_was(const Json& output, const std::string& out_path) {
    const fs::path folder = fs::absolute(out_path).parent_path();
    return output.at("state") == state_of(folder / output.at("file").get<std::string>());
}

}  // namespace

std::string record_path(const std::string& out_path) {
    return out_path + ".burl.json";
}

std::vector<std::string> mesh_files(const std::string& mesh_path) {
    if (is_sample_mesh(mesh_path)) return {};
    std::vector<std::string> files{mesh_path};
    if (!has_gltf_extension(mesh_path)) return files;
    try {
        add_buffers(mesh_path, files);
    } catch (const Error&) {
    } catch (const Json::exception&) {
    }
    return files;
}

Json content_of(std::span<const std::string> files) {
    Json content = Json::array();
    std::error_code ignored;
    for (const std::string& file : files)
        if (fs::is_regular_file(file, ignored))
            content.push_back(
                {{"file", fs::path(file).filename().string()}, {"sha256", sha256_of_file(file)}});
    return content;
}

std::optional<Json> report_if_up_to_date(const std::string& out_path, const Json& made_from) {
    std::error_code ignored;
    if (!fs::is_regular_file(record_path(out_path), ignored)) return std::nullopt;
    try {
        const auto bytes = read_file_bytes(record_path(out_path));
        const Json record = Json::parse(bytes);
        if (record.at("made_from") != made_from) return std::nullopt;
        for (const Json& output : record.at("outputs"))
            if (!as_it_was(output, out_path)) return std::nullopt;
        return record.at("report");
    } catch (const Error&) {
    } catch (const Json::exception&) {
    }
    return std::nullopt;
}

void write_record(const std::string& out_path, const Json& made_from,
                  std::span<const std::string> outputs, const Json& report) {
    Json files = Json::array();
    for (const std::string& file : outputs)
        files.push_back({{"file", place_of(file, out_path)}, {"state", state_of(file)}});
    write_file(
        record_path(out_path),
        print_json({{"made_from", made_from}, {"outputs", std::move(files)}, {"report", report}}));
}

}  // namespace burl
