// The C interface between image_file.cpp and the module glint_image.so, which is the only part of
// Glint that links OpenImageIO. Functions return 1 for success; else 0 with a message in `error`.
// No exception crosses it, either way.
#pragma once

#include <cstddef>

extern "C" {

/// Takes a picture that is being read, top row first.
struct GlintPictureSink {
    void* context;
    /// Also take the alpha channel, if there is one.
    int alpha;
    /// Called first. `channels`: 3, or 4 with alpha. `integers`: the file holds whole numbers. 0
    /// refuses the picture.
    int (*begin)(void* context, int width, int height, int channels, int integers);
    /// Space for the next `count` rows of width x channels floats, or null.
    float* (*rows)(void* context, int count);
    /// Takes the file's description, if there is one; may be null.
    int (*describe)(void* context, const char* text);
};

struct GlintText {
    const char* key;
    const char* value;
};

enum class GlintSample { Byte, Word, Float };

/// A picture to write: width x height x channels (3, or 4 with unmultiplied alpha), row-major, top
/// row first.
struct GlintPicture {
    int width, height, channels;
    const void* pixels;
    GlintSample sample;
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

/// Reads the first picture of a file. Grey becomes RGB, alpha is dropped (or kept, if asked for)
/// without having been multiplied.
GlintReadPicture glintReadPicture;
/// Encodes as the format of a file name's ending (".png").
GlintEncodePicture glintEncodePicture;
}
