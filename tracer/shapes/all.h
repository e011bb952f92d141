// Every shape. A new one is a file beside this and a word in each list.
#pragma once

#include "tracer/shapes/box.h"
#include "tracer/shapes/cone.h"
#include "tracer/shapes/cylinder.h"
#include "tracer/shapes/disk.h"
#include "tracer/shapes/mesh.h"
#include "tracer/shapes/plane.h"
#include "tracer/shapes/quad.h"
#include "tracer/shapes/sphere.h"
#include "tracer/shapes/torus.h"

namespace glint {

using AllShapes = TypeList<Sphere, Box, Plane, Quad, Disk, Cylinder, Cone, Torus, Mesh>;
using Shape = AllShapes::Variant;

/// What the tracer intersects: each analytic shape's canonical form.
using CanonicalShape =
    std::variant<CanonicalSphere, CanonicalBox, CanonicalPlane, CanonicalQuad, CanonicalDisk,
                 CanonicalCylinder, CanonicalCone, CanonicalTorus>;

}  // namespace glint
