// The C interface between image_file.cpp and the module glint_image.so, which is the only part of
// Glint that links OpenImageIO. Functions return 1 for success; else 0 with a message in `error`.
// No exception crosses it, either way.
#pragma once

#include <cstddef>

extern "C" {

/// Takes a picture that is being read, top row first.
struct GlintPictureSink {
    void* context;
    /// Called first. `integers`: the file holds whole numbers. 0 refuses the picture.
    int (*begin)(void* context, int width, int height, int integers);
    /// Space for the next `count` rows of width x 3 floats, or null.
    float* (*rows)(void* context, int count);
};

struct GlintText {
    const char* key;
    const char* value;
};

/// A picture to write: width x height x 3, row-major, top row first; floats or bytes.
struct GlintPicture {
    int width, height;
    const void* pixels;
    int floats;
    const GlintText* texts;
    std::size_t textCount;
};

/// Takes the bytes of a written file.
struct GlintByteSink {
    void* context;
    int (*take)(void* context, const unsigned char* bytes, std::size_t count);
};

using GlintReadPicture = int(const char* path, const GlintPictureSink* sink, char* error,
                             std::size_t errorSize);
using GlintEncodePicture = int(const char* ending, const GlintPicture* picture,
                               const GlintByteSink* sink, char* error, std::size_t errorSize);

/// Reads the first picture of a file. Grey becomes RGB, alpha is dropped without having been
/// multiplied.
GlintReadPicture glintReadPicture;
/// Encodes as the format of a file name's ending (".png").
GlintEncodePicture glintEncodePicture;
}
