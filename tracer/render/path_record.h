// PathRecord: why one sample has the value it has. The tree of the paths that it followed, with
// what each surface did to them and the light found at each. Written by kernels with
// Feature::Layers if one asks for it; all others know nothing of it.
#pragma once

#include <string>
#include <vector>

#include "tracer/render/kernel.h"
#include "tracer/render/scattering.h"

namespace glint {

/// How a path left the surface before.
enum class PathEvent { Camera, Smooth, Reflection, Refraction, Straight };

/// By where a delta branch goes.
[[nodiscard]] inline PathEvent eventOf(const SurfacePoint& point, const DeltaBranch& branch) {
    if (branch.straight) return PathEvent::Straight;
    return sameSide(point.wo, branch.wi) ? PathEvent::Reflection : PathEvent::Refraction;
}

/// Light that a vertex adds to the sample.
struct PathLight {
    enum class Kind { Emission, Environment, Direct };
    Kind kind = Kind::Direct;
    LightKind source = LightKind::Point;
    ObjectId object;    ///< the shape that shines, if one does
    LightId light;      ///< else the scene's light, if it is one
    Rgb visible{1.0f};  ///< Direct: share that the way to the light lets through
    Rgb value{0.0f};  ///< contribution to the sample: radiance times all factors back to the camera
};

/// One end of a piece of path.
struct PathVertex {
    int parent = -1;                      ///< index of the vertex before; -1: the camera
    PathEvent event = PathEvent::Camera;  ///< how the path left the parent ...
    Rgb weight{1.0f};  ///< ... the factor of that: Fresnel's and the colour, or f cos / pdf of a
                       ///< smooth part ...
    double chance =
        1;  ///< ... and the probability of having chosen it, already within `throughput`
    double length = 0;          ///< of the way from there, metres
    double absorbedLength = 0;  ///< of it in media that absorb
    Rgb transmitted{1.0f};      ///< share that these media left
    bool hit = false;  ///< false: the way ended in the sky, or was given up by Russian roulette
    ObjectId object;
    DVec3 position{0.0};   ///< world space, metres
    bool outside = true;   ///< the surface was met from its outward side
    float eta = 1;         ///< refractive index before the surface over that behind
    Rgb throughput{1.0f};  ///< factor between light here and the sample
    std::vector<PathLight> lights;
};

struct PathRecord {
    std::vector<PathVertex> vertices;  ///< a parent stands before its children
    Rgb value{0.0f};  ///< of the sample, as renderSample() gives it: the sum of all lights' values

    // Called by the kernels.
    [[nodiscard]] int leave(int parent, PathEvent event, const Rgb& weight, double chance);
    void travel(int vertex, double length, const Medium& medium);
    void arrive(int vertex, const RenderScene& scene, const SurfacePoint& point,
                const Rgb& throughput);
    void add(int vertex, const RenderScene& scene, PathLight::Kind kind, std::uint32_t light,
             const Rgb& visible, const Rgb& adds);
};

/// Renders a sample once more and records it. `value` has the bits of renderSample(); the
/// contributions add up to it but for the rounding of the sum (1e-6 of it).
[[nodiscard]] PathRecord recordSample(const RenderScene& scene, const SamplePlace& place);

/// Tells the state's record, if one is kept (layers only).
template <Features F, class Tell>
void record(KernelState& state, Tell&& tell) {
    if constexpr (has(F, Feature::Layers))
        if (state.record) tell(*state.record);
}

/// What a vertex is and adds, for a person: texts for the columns of a table.
struct PathRow {
    int vertex = 0, depth = 0;
    std::string what;        ///< "reflection → Ball (Glass)", "direct light: Lamp"
    std::string how;         ///< Fresnel weight, chance, length, absorption
    Rgb contribution{0.0f};  ///< of the vertex' own light
    Rgb total{0.0f};         ///< of all below it too
    ObjectId object;
};
/// In the order of the tree, parents before children. Names are those of `document`.
[[nodiscard]] std::vector<PathRow> pathRows(const PathRecord& record, const Scene& document);
/// The rows as lines of text with the sum.
[[nodiscard]] std::string pathText(const PathRecord& record, const Scene& document);

}  // namespace glint
