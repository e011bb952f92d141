// Triangles from a model file. Read, kept and written back; not traced yet (the compiler says so by
// name).
#pragma once

#include <string>

#include "tracer/base/reflect.h"

namespace glint {

struct Mesh {
    std::string file;
    std::string part;

    bool operator==(const Mesh&) const = default;
    static constexpr std::string_view kind = "mesh";
    static constexpr auto fields() {
        return std::tuple{
            Field{"file",
                  &Mesh::file,
                  {.required = true, .doc = "Model file, relative to the scene"}},
            Field{"part", &Mesh::part, {.doc = "Name of one part of the file; empty for all"}}};
    }
};

}  // namespace glint
