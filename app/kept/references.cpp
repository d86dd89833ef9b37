// The places of a glTF 2.0 document that refer to others by index (specification 3.2), and those of
// the extensions that KeptDocument::knows_references() names.
#include <functional>

#include "app/kept/document.h"

namespace burl {
namespace {

using Visit = std::function<void(Json&)>;

/// Calls visit(object[key]) where there is one.
void visit_key(Json& object, const char* key, const Visit& visit) {
    if (!object.is_object()) return;
    if (const auto found = object.find(key); found != object.end()) visit(*found);
}

void visit_list(Json& object, const char* key, const Visit& visit) {
    visit_key(object, key, [&](Json& list) {
        for (Json& element : list) visit(element);
    });
}

void visit_extension(Json& object, const char* name, const Visit& visit) {
    visit_key(object, "extensions", [&](Json& extensions) { visit_key(extensions, name, visit); });
}

void visit_primitives(Json& document, const Visit& visit) {
    visit_list(document, "meshes", [&](Json& mesh) { visit_list(mesh, "primitives", visit); });
}

void visit_accessors(Json& document, const Visit& visit) {
    const Visit all = [&](Json& attributes) {
        for (Json& accessor : attributes) visit(accessor);
    };
    visit_primitives(document, [&](Json& primitive) {
        visit_key(primitive, "attributes", all);
        visit_key(primitive, "indices", visit);
        visit_list(primitive, "targets", all);
    });
    visit_list(document, "skins",
               [&](Json& skin) { visit_key(skin, "inverseBindMatrices", visit); });
    visit_list(document, "animations", [&](Json& animation) {
        visit_list(animation, "samplers", [&](Json& sampler) {
            visit_key(sampler, "input", visit);
            visit_key(sampler, "output", visit);
        });
    });
    visit_list(document, "nodes", [&](Json& node) {
        visit_extension(node, "EXT_mesh_gpu_instancing",
                        [&](Json& copies) { visit_key(copies, "attributes", all); });
    });
}

void visit_views(Json& document, const Visit& visit) {
    visit_list(document, "accessors", [&](Json& accessor) {
        visit_key(accessor, "bufferView", visit);
        visit_key(accessor, "sparse", [&](Json& sparse) {
            visit_key(sparse["indices"], "bufferView", visit);
            visit_key(sparse["values"], "bufferView", visit);
        });
    });
    visit_list(document, "images", [&](Json& image) { visit_key(image, "bufferView", visit); });
    visit_primitives(document, [&](Json& primitive) {
        visit_extension(primitive, "KHR_draco_mesh_compression",
                        [&](Json& packed) { visit_key(packed, "bufferView", visit); });
    });
}

void visit_images(Json& document, const Visit& visit) {
    visit_list(document, "textures", [&](Json& texture) {
        visit_key(texture, "source", visit);
        visit_key(texture, "extensions", [&](Json& extensions) {
            for (Json& extension : extensions) visit_key(extension, "source", visit);
        });
        visit_key(texture, "extras",
                  [&](Json& extras) { visit_list(extras, "burl_levels", visit); });
    });
}

/// Calls visit for the index of every texture below a material: members called "...Texture".
void visit_textures(Json& value, const Visit& visit) {
    if (!value.is_structured()) return;
    for (const auto& item : value.items()) {
        if (value.is_object() && item.key() == "extras") continue;
        if (value.is_object() && item.key().ends_with("Texture"))
            visit_key(item.value(), "index", visit);
        visit_textures(item.value(), visit);
    }
}

}  // namespace

void for_each_reference(Json& document, GltfList list, const Visit& visit) {
    switch (list) {
        case GltfList::accessors:
            return visit_accessors(document, visit);
        case GltfList::bufferViews:
            return visit_views(document, visit);
        case GltfList::images:
            return visit_images(document, visit);
        case GltfList::textures:
            return visit_key(document, "materials",
                             [&](Json& materials) { visit_textures(materials, visit); });
        case GltfList::samplers:
            return visit_list(document, "textures",
                              [&](Json& texture) { visit_key(texture, "sampler", visit); });
    }
}

}  // namespace burl
