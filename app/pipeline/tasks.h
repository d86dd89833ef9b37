#pragma once
// The names of what a bake does, as a person is told them (atlas/base/task_meter.h), in its order.
namespace burl::tasks {

inline constexpr const char* read = "reading the mesh";
inline constexpr const char* layout = "laying out the atlas";
inline constexpr const char* points = "finding the solid's points";
inline constexpr const char* masks = "working out masks of the shape";
inline constexpr const char* texture = "synthesising the texture";
inline constexpr const char* levels = "making MIP levels";
inline constexpr const char* normals = "deriving normals";
inline constexpr const char* pictures = "encoding pictures";
inline constexpr const char* write = "writing";
inline constexpr const char* bakes = "baking";  ///< of several bakes at a time

}  // namespace burl::tasks
