// METIS draws its random numbers from the C library's one generator, seeded at every call; a lock
// keeps concurrent calls from drawing each other's.
#include "atlas/mesh/dual_graph.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <new>

#include <metis.h>

extern "C" {

/// METIS's own return to the innermost of its functions that a user called, with `signal` as the
/// cause (5.1, its error.c); null where a METIS has no such function.
[[gnu::weak]] void gk_sigthrow(int signal);

/// The function that METIS calls where it cannot go on, in place of its own, which prints a line
/// and raises `signal`: a program that blocks or handles SIGTERM and SIGABRT would have METIS go on
/// with what it lacks. It ends the program where there is no way back.
[[gnu::weak, gnu::visibility("default"), noreturn]] void gk_errexit(int signal, char* format, ...);

void gk_errexit(int signal, char*, ...) {
    if (gk_sigthrow) gk_sigthrow(signal);
    std::abort();
}

}  // extern "C"

namespace burl {
namespace {

/// Scale of the whole-number weights: the nodes weigh `area_units` in sum, an edge of mean weight
/// `edge_units`, and no edge more than `most_edge_units` (each plus 1).
constexpr double area_units = 1 << 26, edge_units = 64.0, most_edge_units = 64000.0;

Vec3d normal(const Mesh& mesh, std::uint32_t t) {
    const Triangle& v = mesh.triangles[t];
    const Vec3d n = glm::cross(mesh.positions[v[1]] - mesh.positions[v[0]],
                               mesh.positions[v[2]] - mesh.positions[v[0]]);
    const double length = glm::length(n);
    return length > 0.0 ? n / length : Vec3d(0.0);
}

/// Drops what its thread prints to C's standard output while it lives. METIS prints there when a
/// division leaves a part without nodes, and has no option against it; the parts it gives are good
/// all the same, but the program's own output is results alone. The descriptor leads to /dev/null,
/// and stdio's own lock lets other threads print before and after. At most one object may live at a
/// time.
class MutedStdout {
  public:
    MutedStdout() {
        ::flockfile(stdout);
        if (real_ >= 0) lead_to(::open("/dev/null", O_WRONLY | O_CLOEXEC));
    }
    ~MutedStdout() {
        lead_to(real_);
        ::funlockfile(stdout);
    }
    MutedStdout(const MutedStdout&) = delete;
    MutedStdout& operator=(const MutedStdout&) = delete;

  private:
    /// Flushes earlier output, lets standard output lead to what `descriptor` leads to, and closes
    /// `descriptor`. Does nothing where it is negative.
    static void lead_to(int descriptor) {
        if (descriptor < 0) return;
        std::fflush(stdout);
        ::dup2(descriptor, STDOUT_FILENO);
        ::close(descriptor);
    }

    /// A copy of standard output's descriptor; negative where standard output is closed or no
    /// descriptor is left, in which case nothing is dropped.
    const int real_ = ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
};

/// The part of each node by `partitioner`, one of METIS's, which all take the same arguments; part
/// 0 for all nodes where there is nothing to divide or METIS fails. Throws std::bad_alloc where
/// METIS runs out of memory.
std::vector<std::uint32_t> parts_of(const DualGraph& graph, std::uint32_t parts, int seed,
                                    decltype(&METIS_PartGraphKway) partitioner) {
    std::vector<std::uint32_t> result(graph.nodes(), 0);
    if (parts < 2 || graph.nodes() < 2 || graph.targets.empty()) return result;
    static_assert(sizeof(idx_t) == sizeof(std::int32_t));
    DualGraph copy = graph;  // METIS takes pointers to what it may change
    auto nodes = static_cast<idx_t>(graph.nodes());
    idx_t constraints = 1, count = static_cast<idx_t>(parts), cut = 0;
    std::array<idx_t, METIS_NOPTIONS> options{};
    METIS_SetDefaultOptions(options.data());
    options[METIS_OPTION_SEED] = seed;
    std::vector<idx_t> part(graph.nodes(), 0);
    static std::mutex one_at_a_time;
    const std::scoped_lock lock(one_at_a_time);
    const MutedStdout muted;
    const int status = partitioner(&nodes, &constraints, copy.begin.data(), copy.targets.data(),
                                   copy.node_weights.data(), nullptr, copy.edge_weights.data(),
                                   &count, nullptr, nullptr, options.data(), &cut, part.data());
    // METIS_ERROR: a partition within the partition failed, which lacks memory, too.
    if (status == METIS_ERROR_MEMORY || status == METIS_ERROR) throw std::bad_alloc();
    if (status != METIS_OK) return result;
    for (std::size_t i = 0; i < part.size(); ++i) result[i] = static_cast<std::uint32_t>(part[i]);
    return result;
}

}  // namespace

double dihedral_cosine(const Mesh& mesh, std::uint32_t t, std::uint32_t neighbour) {
    const Vec3d a = normal(mesh, t), b = normal(mesh, neighbour);
    if (a == Vec3d(0.0) || b == Vec3d(0.0)) return 1.0;
    return std::clamp(glm::dot(a, b), -1.0, 1.0);
}

double edge_length(const Mesh& mesh, std::uint32_t t, std::size_t k) {
    const Triangle& v = mesh.triangles[t];
    return glm::length(mesh.positions[v[(k + 1) % 3]] - mesh.positions[v[k]]);
}

DualGraph dual_graph(const Mesh& mesh, const Connectivity& connectivity,
                     std::span<const std::uint32_t> faces, std::vector<std::int32_t>& local) {
    for (std::size_t i = 0; i < faces.size(); ++i) local[faces[i]] = static_cast<std::int32_t>(i);
    DualGraph graph;
    graph.begin.push_back(0);
    std::vector<double> weights, areas;
    for (const std::uint32_t face : faces) {
        areas.push_back(triangle_area(mesh, face));
        for (std::size_t k = 0; k < 3; ++k) {
            const std::int32_t n = connectivity.neighbours[face][k];
            if (n < 0 || local[static_cast<std::size_t>(n)] < 0) continue;
            graph.targets.push_back(local[static_cast<std::size_t>(n)]);
            const double cosine = dihedral_cosine(mesh, face, static_cast<std::uint32_t>(n));
            weights.push_back(edge_length(mesh, face, k) * (0.5 + 0.5 * cosine));
        }
        graph.begin.push_back(static_cast<std::int32_t>(graph.targets.size()));
    }
    for (const std::uint32_t face : faces) local[face] = -1;
    double area = 0.0, length = 0.0;
    for (const double a : areas) area += a;
    for (const double w : weights) length += w;
    for (const double a : areas)
        graph.node_weights.push_back(
            1 + (area > 0.0 ? static_cast<std::int32_t>(a / area * area_units) : 0));
    const double unit = length > 0.0 ? edge_units * double(weights.size()) / length : 0.0;
    for (const double w : weights)
        graph.edge_weights.push_back(
            1 + static_cast<std::int32_t>(std::min(w * unit, most_edge_units)));
    return graph;
}

std::vector<std::uint32_t> partition_graph(const DualGraph& graph, std::uint32_t parts, int seed) {
    return parts_of(graph, parts, seed, METIS_PartGraphKway);
}

std::vector<std::uint32_t> bisect_graph(const DualGraph& graph, int seed) {
    return parts_of(graph, 2, seed, METIS_PartGraphRecursive);
}

}  // namespace burl
