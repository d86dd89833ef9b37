#include "app/page/page.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "app/base/atomic_file.h"
#include "app/base/embedded.h"
#include "app/base/version.h"
#include "app/image/deflate.h"
#include "app/image/picture_coding.h"
#include "app/light/sun.h"
#include "app/page/data_script.h"
#include "atlas/base/error.h"
#include "atlas/base/json.h"
#include "atlas/file/file_buffer.h"

namespace burl {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view mark = "<meta name=\"generator\" content=\"burl page";
constexpr std::size_t light_rows = 256;

std::string_view viewer() {
    return embedded_viewer().front().content;
}

std::string data_file(const PageObject& object) {
    return fmt::format("objects/{}.js", object.file);
}

std::string picture_file(const PageObject& object) {
    return fmt::format("objects/{}.webp", object.file);
}

std::string light_file(std::string_view name) {
    return fmt::format("lights/{}.js", name);
}

std::string in_folder(const std::string& folder, const std::string& file) {
    return (std::filesystem::path(folder) / file).string();
}

std::span<const std::uint8_t> bytes_of(std::string_view text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/// The text as HTML shows it.
std::string escaped(std::string_view text) {
    std::string html;
    for (const char c : text) {
        if (c == '&')
            html += "&amp;";
        else if (c == '<')
            html += "&lt;";
        else if (c == '"')
            html += "&quot;";
        else
            html += c;
    }
    return html;
}

/// JSON inside a script element, without "<": "</script" would end the element, and
/// "<!--<script" would hide its end.
std::string in_script(const Json& json) {
    std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    for (std::size_t at = 0; (at = text.find('<', at)) != std::string::npos;)
        text.replace(at, 1, "\\u003c");
    return text;
}

Json numbers(const Vec3f& v) {
    return {v.x, v.y, v.z};
}

/// The files of a page, which get their names together, so that no older page is left with some of
/// this one's; beyond 200 files, 200 at a time.
class PageFiles {
  public:
    explicit PageFiles(std::string folder) : folder_(std::move(folder)) {}

    /// Writes a file of the folder: `write` gets the sink.
    template <class Write>
    void add(const std::string& name, const Write& write) {
        if (files_.size() == most_open) name_all();
        AtomicFile& file = files_.emplace_back(in_folder(folder_, name));
        write(sink_of(file));
        file.finish();
    }
    void add_text(const std::string& name, std::string_view text) {
        add(name, [&](const ByteSink& sink) { sink(bytes_of(text)); });
    }
    void name_all() {
        commit_together(files_);
        files_.clear();
    }

  private:
    static constexpr std::size_t most_open = 200;
    std::string folder_;
    std::vector<AtomicFile> files_;
};

/// Writes the data of a light; returns its entry in the page's contents.
Json write_light(PageFiles& files, const EnvironmentNote& note) {
    const SunAndSky parts = without_sun(make_environment(note.name, light_rows));
    const Image<RgbF>& sky = parts.sky.radiance;
    const std::string file = light_file(note.name);
    files.add(file, [&](const ByteSink& sink) {
        write_data_script(file, Deflater(9).stream(rgbe_pixels(sky.pixels())), sink);
    });
    Json entry{
        {"name", note.name}, {"file", file}, {"width", sky.width()}, {"height", sky.height()}};
    if (parts.sun.shines())
        entry["sun"] = {{"direction", numbers(parts.sun.direction)},
                        {"light", numbers(parts.sun.light)}};
    return entry;
}

/// Writes an object and its picture; returns its entry in the page's contents.
Json write_object(PageFiles& files, const PageObject& object) {
    const FileBuffer glb = read_file(object.path);
    files.add(data_file(object), [&](const ByteSink& sink) {
        write_data_script(data_file(object), bytes_of(glb.text()), sink);
    });
    Json entry{{"name", object.name}, {"file", data_file(object)}, {"bytes", glb.size}};
    if (object.picture) {
        files.add(picture_file(object),
                  [&](const ByteSink& sink) { encode_webp(codes_of(*object.picture), sink, 85); });
        entry["picture"] = picture_file(object);
    }
    return entry;
}

std::string index_html(const std::string& title, const Json& contents) {
    return fmt::format(
        "<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "{} {}\">\n<title>{}</title>\n<link rel=\"icon\" href=\"data:,\">\n"
        "<noscript>The objects of this page are drawn by scripts, which are switched "
        "off.</noscript>\n"
        "<script id=\"burl-contents\" type=\"application/json\">{}</script>\n"
        "<body><script src=\"viewer.js\"></script></body>\n</html>\n",
        mark, burl_version(), escaped(title), in_script(contents));
}

}  // namespace

bool has_page_viewer() {
    return !viewer().empty();
}

std::vector<std::string> page_files(const std::string& folder,
                                    std::span<const PageObject> objects) {
    std::vector<std::string> files{"viewer.js"};
    for (const EnvironmentNote& note : environment_notes()) files.push_back(light_file(note.name));
    for (const PageObject& object : objects) {
        files.push_back(data_file(object));
        if (object.picture) files.push_back(picture_file(object));
    }
    files.push_back("index.html");
    for (std::string& file : files) file = in_folder(folder, file);
    return files;
}

std::vector<std::string> left_of_older_page(const std::string& folder,
                                            std::span<const PageObject> objects) {
    std::set<std::string> left;
    std::error_code failure;
    for (const auto& entry :
         std::filesystem::directory_iterator(in_folder(folder, "objects"), failure))
        left.insert("objects/" + entry.path().filename().string());
    for (const std::string& file : page_files("", objects)) left.erase(file);
    return {left.begin(), left.end()};
}

void check_page_folder(const std::string& folder, std::span<const PageObject> objects) {
    const std::string index = in_folder(folder, "index.html");
    std::error_code failure;
    if (std::filesystem::is_regular_file(index, failure)) {
        if (read_file(index).text().find(mark) == std::string_view::npos)
            throw Error(ExitCode::io,
                        fmt::format("{}: no page of burl's; give -o another folder", index));
        return;
    }
    std::vector<std::string> files = page_files(folder, objects);
    for (const PageObject& object : objects)
        files.push_back(in_folder(folder, picture_file(object)));
    for (const std::string& file : files)
        if (std::filesystem::exists(file, failure))
            throw Error(ExitCode::io, fmt::format("{}: would be replaced, and its folder holds no "
                                                  "page of burl's; give -o another folder",
                                                  file));
}

void write_page(const std::string& folder, const std::string& title,
                std::span<const PageObject> objects) {
    if (!has_page_viewer())
        throw Error(ExitCode::unsupported,
                    "this burl was built without the viewer of pages; build it again where esbuild "
                    "is installed and three.js can be fetched (docs/build.md)");
    PageFiles files(folder);
    files.add_text("viewer.js", viewer());
    Json contents{{"title", title}, {"assets", Json::array()}, {"lights", Json::array()}};
    for (const EnvironmentNote& note : environment_notes())
        contents["lights"].push_back(write_light(files, note));
    for (const PageObject& object : objects)
        contents["assets"].push_back(write_object(files, object));
    files.add_text("index.html", index_html(title, contents));
    files.name_all();
}

}  // namespace burl
