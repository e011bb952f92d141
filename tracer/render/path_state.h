// What the `path` integrator carries along a path.
#pragma once

#include "tracer/render/chain_progress.h"
#include "tracer/render/highlights.h"
#include "tracer/render/layers.h"

namespace glint {

/// A path under way.
struct PathState {
    Ray ray;
    MediaStack media;
    Rgb throughput{1.0f};
    DVec3 from{0.0};        ///< last vertex at which the direction was drawn from a density ...
    DVec3 fromNormal{0.0};  ///< ... the normal there on the side that the path came from ...
    double pdf = 0;  ///< ... and that density; 0 after a delta event or at the camera: no other way
                     ///< leads there
    ChainProgress chain;  ///< on the way from `from` over a perfect ball
    HighlightStep step;   ///< to `from`, if a highlight could have drawn it ...
    float drive = 0;  ///< ... and that the next one could be drawn so: highlightDrive() at `from`;
                      ///< 0: it could not
    MediaStack passedLights;   ///< emissive surfaces passed straight since `from`: next-event
                               ///< estimation knows their nearest face only
    float etaScale = 1;        ///< undoes the eta^2 of refractions for the roulette
    int depth = 0;             ///< surface interactions so far
    int splits = 0;            ///< those of them where both ways were followed
    std::uint32_t branch = 0;  ///< a bit for each split: whether the second way was taken
    bool allLights = false;    ///< at `from` every light was sampled, not a chosen one
    bool scattered = false;    ///< a smooth part has turned it
    bool straightFromCamera = true;
    LobeShares shares{};  ///< of the lobes by which light left the first surface (layers only)
    int bounces =
        0;  ///< turns so far: interactions that did not let the path straight on (layers only)
    int vertex = -1;  ///< the record's (layers only)
};

}  // namespace glint
