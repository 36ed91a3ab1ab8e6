// SPDX-License-Identifier: MIT
//
// Runs Qhull and copies its facets out. The rings are put together here from Qhull's plain data: its own
// helpers (qh_facet3vertex and friends) report trouble by a long jump, which must not cross C++ frames.
//
// Options: Qs starts from the widest simplex, which thin bodies need; Q12 lets wide merges pass, since the
// caller judges the result; Pp keeps Qhull from printing advice.
#include "edgewise/geometry/hull/qhull_facets.hpp"

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <utility>

namespace edgewise {
namespace {

/// Collects Qhull's error stream in memory.
class ErrorStream {
  public:
    ErrorStream() : file_(open_memstream(&text_, &size_)) {}
    ~ErrorStream() {
        if (file_ != nullptr) std::fclose(file_);
        std::free(text_);
    }
    ErrorStream(const ErrorStream&) = delete;
    ErrorStream& operator=(const ErrorStream&) = delete;

    [[nodiscard]] FILE* file() { return file_; }
    [[nodiscard]] std::string first_line() {
        if (file_ == nullptr || std::fflush(file_) != 0) return {};
        const std::string all(text_, size_);
        const std::size_t start = all.find_first_not_of('\n');
        return start == std::string::npos ? all : all.substr(start, all.find('\n', start) - start);
    }

  private:
    char* text_ = nullptr;
    std::size_t size_ = 0;
    FILE* file_;
};

/// Frees Qhull's state.
struct FreeQhull {
    void operator()(qhT* state) const {
        qh_freeqhull(state, !qh_ALL);
        int current = 0;
        int total = 0;
        qh_memfreeshort(state, &current, &total);
        delete state;
    }
};

using Arc = std::pair<Index, Index>;

/// Corners of a triangle: it keeps no ridges, and a flag holds its orientation.
std::vector<Index> triangle_corners(qhT* qh, facetT* facet) {
    std::vector<Index> ring;
    vertexT *vertex, **vertexp;
    FOREACHvertex_(facet->vertices) { ring.push_back(static_cast<Index>(qh_pointid(qh, vertex->point))); }
    if (facet->toporient != 0) std::swap(ring[0], ring[1]);
    return ring;
}

/// The arcs head to tail; if they are not one cycle the ring repeats corners, and the builder refuses it.
std::vector<Index> chained(std::vector<Arc> arcs) {
    std::vector<Index> ring;
    if (arcs.empty()) return ring;
    std::sort(arcs.begin(), arcs.end());
    Index next = arcs.front().first;
    while (ring.size() < arcs.size()) {
        ring.push_back(next);
        const auto arc = std::lower_bound(arcs.begin(), arcs.end(), Arc(next, 0));
        if (arc == arcs.end() || arc->first != next) break;
        next = arc->second;
    }
    return ring;
}

/// The ridges of a merged facet, put in order.
std::vector<Index> polygon_corners(qhT* qh, facetT* facet) {
    std::vector<Arc> arcs;
    ridgeT *ridge, **ridgep;
    FOREACHridge_(facet->ridges) {
        const auto* first = static_cast<vertexT*>(ridge->vertices->e[0].p);
        const auto* second = static_cast<vertexT*>(ridge->vertices->e[1].p);
        Arc arc(static_cast<Index>(qh_pointid(qh, first->point)),
                static_cast<Index>(qh_pointid(qh, second->point)));
        if (ridge->top == facet) std::swap(arc.first, arc.second);
        arcs.push_back(arc);
    }
    return chained(std::move(arcs));
}

}  // namespace

QhullFacets qhull_facets(std::span<const Vec3d> points) {
    std::vector<coordT> coordinates;
    coordinates.reserve(3 * points.size());
    for (const Vec3d& p : points) coordinates.insert(coordinates.end(), {p.x(), p.y(), p.z()});
    ErrorStream errors;
    const std::unique_ptr<qhT, FreeQhull> state(new qhT());
    qhT* qh = state.get();
    qh_zero(qh, stderr);
    char command[] = "qhull Qs Q12 Pp";
    const int failed = qh_new_qhull(qh, 3, static_cast<int>(points.size()), coordinates.data(), False,
                                    command, nullptr, errors.file());
    QhullFacets result;
    if (failed != 0) {
        result.error = errors.first_line();
        return result;
    }
    facetT* facet;
    FORALLfacets {
        result.rings.push_back(facet->simplicial != 0 ? triangle_corners(qh, facet)
                                                      : polygon_corners(qh, facet));
    }
    return result;
}

}  // namespace edgewise
