// Primitives that share their attributes share their vertices, as in the file.
#include "app/kept/carve.h"

#include <algorithm>
#include <array>
#include <bit>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "app/export/gltf_scene.h"
#include "app/export/vertices.h"
#include "app/kept/attributes.h"
#include "app/kept/carved_material.h"
#include "app/kept/frames.h"
#include "app/kept/vertices.h"
#include "atlas/base/error.h"

namespace burl {
namespace {

constexpr int triangles_mode = 4, strip_mode = 5;
constexpr const char* draco = "KHR_draco_mesh_compression";
constexpr const char* block_attribute = "_BURL_BLOCK";

/// Number of sets TEXCOORD_0, TEXCOORD_1, ... of a primitive.
std::uint32_t uv_sets(const Json& attributes) {
    std::uint32_t count = 0;
    while (attributes.contains(fmt::format("TEXCOORD_{}", count))) ++count;
    return count;
}

/// Primitives of one mesh of the document with the same attributes.
struct VertexGroup {
    std::size_t mesh = 0;
    const GltfPartOrigin* part = nullptr;
    KeptVertices vertices;
    std::vector<const GltfRun*> runs{};
    std::vector<std::vector<std::uint32_t>> indices{};  ///< new indices, a list per run
};

class Carver {
  public:
    Carver(KeptDocument& document, const CarvedMesh& carved)
        : document_(document),
          carved_(carved),
          frames_(carved.content),
          material_(document, carved.content, carved.pictures) {}

    std::vector<AtomicFile> run() {
        place_parts();
        for (const GltfRun& run : carved_.origins.runs) group_of(run).runs.push_back(&run);
        for (auto& [key, group] : groups_) carve(group);
        material_.assign();
        say_losses();
        document_.bakes.push_back(burl_extras(carved_.content));
        return material_.take_files();
    }

  private:
    Json& primitive(std::size_t mesh, const GltfRun& run) {
        return document_.json["meshes"][mesh]["primitives"][std::size_t(run.primitive)];
    }

    void place_parts();
    bool covers_all(const GltfPartOrigin& part) const;
    VertexGroup& group_of(const GltfRun& run);
    void carve(VertexGroup& group);
    void index(VertexGroup& group);
    std::pair<std::size_t, std::size_t> triangles_of(const GltfRun& run) const;
    std::uint32_t vertex_at(VertexGroup& group, std::size_t corner);
    void write_indices(const VertexGroup& group, std::size_t number, Json& target);
    Json extended_attributes(const VertexGroup& group, const Json& attributes);
    void extend_skin(const VertexGroup& group, const Json& attributes, Json& result);
    Json extended_target(const VertexGroup& group, const Json& target);
    void insert_uvs(const VertexGroup& group, Json& attributes, std::uint32_t set);
    void add_frames(const VertexGroup& group, Json& attributes);
    void add_blocks(const VertexGroup& group, Json& attributes);
    std::uint32_t uv_set_for(const Json& target) const;
    /// Whether the atlas's coordinates are the document's own, which so keep their bytes.
    bool keeps_uvs() const { return carved_.content.atlas.options.kind == AtlasKind::uv; }
    /// The number of the run's recipe.
    std::uint32_t label_of(const GltfRun& run) const {
        return carved_.labels.empty() ? 0 : carved_.labels[run.first_triangle];
    }
    bool shows_normals(const VertexGroup& group) const;
    void say_losses();

    KeptDocument& document_;
    const CarvedMesh& carved_;
    KeptFrames frames_;
    CarvedMaterial material_;
    std::vector<std::size_t> mesh_of_part_;
    std::map<std::pair<std::size_t, std::string>, VertexGroup> groups_;
    double skin_left_out_ = 0.0;
    bool drops_tangents_ = false;
};

/// Whether no node outside of the part draws its mesh.
bool Carver::covers_all(const GltfPartOrigin& part) const {
    const auto nodes = document_.json.find("nodes");
    if (nodes == document_.json.end()) return true;
    for (std::size_t n = 0; n < nodes->size(); ++n)
        if ((*nodes)[n].value("mesh", -1) == part.mesh &&
            std::ranges::find(part.nodes, int(n)) == part.nodes.end())
            return false;
    return true;
}

/// Gives each part a mesh of the document: its own, or a copy where others draw that, too.
void Carver::place_parts() {
    const std::vector<GltfPartOrigin>& parts = carved_.origins.parts;
    std::map<int, std::size_t> users;  // parts of each mesh
    for (const GltfPartOrigin& part : parts) ++users[part.mesh];
    for (const GltfPartOrigin& part : parts) {
        const bool alone = users.at(part.mesh) == 1;
        const bool copied = document_.copies.contains({part.mesh, part.nodes});
        if (!copied && alone && (!carved_.origins.drops_nodes || covers_all(part))) {
            mesh_of_part_.push_back(std::size_t(part.mesh));
            continue;
        }
        Json& meshes = document_.json["meshes"];
        const auto [copy, is_new] =
            document_.copies.try_emplace({part.mesh, part.nodes}, meshes.size());
        if (is_new) meshes.push_back(Json(meshes[std::size_t(part.mesh)]));
        mesh_of_part_.push_back(copy->second);
        for (const int node : part.nodes)
            document_.json["nodes"][std::size_t(node)]["mesh"] = copy->second;
    }
}

VertexGroup& Carver::group_of(const GltfRun& run) {
    const std::size_t mesh = mesh_of_part_[run.part];
    const Json& source = primitive(mesh, run);
    const auto& attributes = source.at("attributes");
    const std::string key =
        attributes.dump() + (source.contains("targets") ? source["targets"].dump() : "");
    const auto found = groups_.find({mesh, key});
    if (found != groups_.end()) return found->second;
    const std::size_t position = attributes.at("POSITION");
    const std::size_t count = document_.json["accessors"][position].at("count");
    return groups_
        .emplace(std::pair(mesh, key),
                 VertexGroup{mesh, &carved_.origins.parts[run.part], KeptVertices(count)})
        .first->second;
}

/// The carved mesh's triangles of a run: the first, and the one after the last.
std::pair<std::size_t, std::size_t> Carver::triangles_of(const GltfRun& run) const {
    const auto first_from = [&](std::size_t face) {
        std::size_t low = 0, high = carved_.corners.size() / 3;
        while (low < high) {
            const std::size_t middle = (low + high) / 2;
            if (carved_.corners[3 * middle].a / 3 < face)
                low = middle + 1;
            else
                high = middle;
        }
        return low;
    };
    return {first_from(run.first_triangle), first_from(run.first_triangle + run.triangle_count)};
}

std::uint32_t Carver::vertex_at(VertexGroup& group, std::size_t corner) {
    const std::vector<std::uint32_t>& vertices = carved_.origins.vertices;
    const CornerOrigin& origin = carved_.corners[corner];
    return group.vertices.of(vertices[origin.a], vertices[origin.b], frames_.bits(corner), corner);
}

/// Finds the vertices of all corners.
void Carver::index(VertexGroup& group) {
    for (const GltfRun* run : group.runs) {
        const auto [first, last] = triangles_of(*run);
        std::vector<std::uint32_t>& indices = group.indices.emplace_back();
        indices.reserve(3 * (last - first));
        for (std::size_t t = first; t < last; ++t)
            for (const std::size_t k : {0, 1, 2}) {
                const std::size_t turned = group.part->mirrored && k > 0 ? 3 - k : k;
                indices.push_back(vertex_at(group, 3 * t + turned));
            }
    }
}

/// Writes the indices of the group's run `number` unless they are those of the file; as strips
/// where they are asked for.
void Carver::write_indices(const VertexGroup& group, std::size_t number, Json& target) {
    const GltfRun& run = *group.runs[number];
    const std::vector<std::uint32_t>& indices = group.indices[number];
    if (StripCounts* const strips = carved_.content.options.strips) {
        target["indices"] =
            document_.add_indices(strip_indices(indices, *strips), group.vertices.all().size());
        target["mode"] = strip_mode;
        return;
    }
    bool same = indices.size() == 3 * run.triangle_count;
    for (std::size_t i = 0; i < indices.size() && same; ++i) {
        const std::size_t k = i % 3, turned = group.part->mirrored && k > 0 ? 3 - k : k;
        same = indices[i] == carved_.origins.vertices[3 * run.first_triangle + i - k + turned];
    }
    if (same) return;
    target["indices"] = document_.add_indices(indices, group.vertices.all().size());
    if (target.value("mode", triangles_mode) != triangles_mode) target["mode"] = triangles_mode;
}

void Carver::extend_skin(const VertexGroup& group, const Json& attributes, Json& result) {
    SkinSets sets;
    std::vector<std::string> numbers;
    for (std::size_t set = 0;; ++set) {
        const std::string number = std::to_string(set);
        if (!attributes.contains("JOINTS_" + number) || !attributes.contains("WEIGHTS_" + number))
            break;
        sets.joints.push_back(document_.elements(attributes.at("JOINTS_" + number)));
        sets.weights.push_back(document_.elements(attributes.at("WEIGHTS_" + number)));
        numbers.push_back(number);
    }
    if (numbers.empty()) return;
    const SkinSets skin = extended(sets, group.vertices.all());
    skin_left_out_ = std::max(skin_left_out_, skin.left_out);
    for (std::size_t set = 0; set < numbers.size(); ++set)
        for (const bool joint : {true, false}) {
            const std::string name = (joint ? "JOINTS_" : "WEIGHTS_") + numbers[set];
            const Json like = document_.json["accessors"][attributes.at(name).get<std::size_t>()];
            result[name] =
                document_.add_vertices(joint ? skin.joints[set] : skin.weights[set], like);
        }
}

Json Carver::extended_attributes(const VertexGroup& group, const Json& attributes) {
    Json result = attributes;
    if (!group.vertices.adds_any()) return result;
    for (const auto& [name, accessor] : attributes.items()) {
        if (name.starts_with("JOINTS_") || name.starts_with("WEIGHTS_")) continue;
        const auto number = accessor.get<std::size_t>();
        const Json like = document_.json["accessors"][number];
        result[name] = document_.add_vertices(
            extended(name, document_.elements(number), group.vertices.all()), like);
    }
    extend_skin(group, attributes, result);
    return result;
}

Json Carver::extended_target(const VertexGroup& group, const Json& target) {
    Json result = target;
    if (frames_.has_tangents() && result.erase("TANGENT") > 0) drops_tangents_ = true;
    if (!group.vertices.adds_any()) return result;
    for (auto& [name, accessor] : result.items()) {
        const auto number = accessor.get<std::size_t>();
        Json like = document_.json["accessors"][number];
        if (!like.contains("bufferView") && !like.contains("sparse")) {  // all zeros
            like["count"] = group.vertices.all().size();
            document_.json["accessors"].push_back(std::move(like));
            accessor = document_.json["accessors"].size() - 1;
            continue;
        }
        accessor = document_.add_vertices(
            extended("", document_.elements(number), group.vertices.all()), like);
    }
    return result;
}

std::uint32_t Carver::uv_set_for(const Json& target) const {
    const std::uint32_t sets = uv_sets(target.at("attributes"));
    const std::uint32_t set = carved_.uv_set.value_or(keeps_uvs() ? 0 : sets);
    if (set > sets)
        throw Error(ExitCode::usage,
                    fmt::format("--uv-set {}: a primitive has {} sets of texture coordinates, and "
                                "glTF allows no gap; use {} or less",
                                set, sets, sets));
    const bool variants =
        target.contains("extensions") && target["extensions"].contains("KHR_materials_variants");
    if (set < sets && variants && !keeps_uvs())
        throw Error(ExitCode::usage,
                    fmt::format("--uv-set {} would move texture coordinates that material variants "
                                "read; leave it out",
                                set));
    return set;
}

void Carver::insert_uvs(const VertexGroup& group, Json& attributes, std::uint32_t set) {
    const auto name = [](std::uint32_t number) { return fmt::format("TEXCOORD_{}", number); };
    if (keeps_uvs() && attributes.contains(name(set))) return;
    for (std::uint32_t from = uv_sets(attributes); from-- > set;)
        attributes[name(from + 1)] = attributes[name(from)];
    std::vector<float> uvs;
    for (const KeptVertex& vertex : group.vertices.all()) {
        const auto [u, v] = frames_.uv(vertex.corner);
        uvs.insert(uvs.end(), {u, v});
    }
    attributes[name(set)] = document_.add_floats(uvs, 2);
}

/// Whether the material of a primitive of the group has a normal map.
bool Carver::shows_normals(const VertexGroup& group) const {
    const std::vector<ExportShare>& shares = carved_.content.options.shares;
    return shares.empty() || std::ranges::any_of(group.runs, [&](const GltfRun* run) {
               return shares[label_of(*run)].normals;
           });
}

/// Adds tangents where a normal map needs them, with normals where the file has none.
void Carver::add_frames(const VertexGroup& group, Json& attributes) {
    if (!frames_.has_tangents() || !shows_normals(group)) return;
    const PartFrames local(frames_, *group.part);
    std::vector<float> normals, tangents;
    for (const KeptVertex& vertex : group.vertices.all()) {
        const Vec3f n = local.normal(vertex.corner);
        const Vec4f t = local.tangent(vertex.corner);
        normals.insert(normals.end(), {n.x, n.y, n.z});
        tangents.insert(tangents.end(), {t.x, t.y, t.z, t.w});
    }
    if (!attributes.contains("NORMAL")) attributes["NORMAL"] = document_.add_floats(normals, 3);
    attributes["TANGENT"] = document_.add_floats(tangents, 4);
}

/// Adds the rectangles of a quad atlas's blocks.
void Carver::add_blocks(const VertexGroup& group, Json& attributes) {
    attributes.erase(block_attribute);
    if (!frames_.has_blocks()) return;
    std::vector<float> rectangles;
    for (const KeptVertex& vertex : group.vertices.all()) {
        const std::array<float, 4> one = frames_.block(vertex.corner);
        rectangles.insert(rectangles.end(), one.begin(), one.end());
    }
    attributes[block_attribute] = document_.add_floats(rectangles, 4);
}

void Carver::carve(VertexGroup& group) {
    const Json source = primitive(group.mesh, *group.runs.front());
    frames_.set_splits_normals(!source.at("attributes").contains("NORMAL"));
    index(group);
    const std::uint32_t set = uv_set_for(source);
    Json attributes = extended_attributes(group, source.at("attributes"));
    insert_uvs(group, attributes, set);
    add_frames(group, attributes);
    add_blocks(group, attributes);
    Json targets = Json::array();
    if (source.contains("targets"))
        for (const Json& target : source["targets"])
            targets.push_back(extended_target(group, target));
    for (std::size_t r = 0; r < group.runs.size(); ++r) {
        Json& target = primitive(group.mesh, *group.runs[r]);
        target["attributes"] = attributes;
        if (!targets.empty()) target["targets"] = targets;
        write_indices(group, r, target);
        erase_extension(target, draco);
        material_.use_at({group.mesh, std::size_t(group.runs[r]->primitive)}, set,
                         label_of(*group.runs[r]));
    }
}

void Carver::say_losses() {
    if (skin_left_out_ > 0.0)
        document_.losses.push_back(
            fmt::format("skin weights: vertices on cut edges follow more than four joints; up to "
                        "{:.2g} of a vertex's weights is left out",
                        skin_left_out_));
    if (drops_tangents_)
        document_.losses.emplace_back(
            "TANGENT of morph targets: they belong to the old texture coordinates and are left "
            "out");
}

}  // namespace

std::vector<AtomicFile> carve(KeptDocument& document, const CarvedMesh& carved) {
    return Carver(document, carved).run();
}

}  // namespace burl
