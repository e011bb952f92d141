// GLINT_CHECK: stops the program when the programmer is wrong. Bad input from a person is a Result,
// never a check.
#pragma once

#include <cstdio>
#include <cstdlib>

/// Prints the condition with its place and aborts when `condition` is false. Stays on in release
/// builds.
#define GLINT_CHECK(condition)                                                                 \
    do {                                                                                       \
        if (!(condition)) {                                                                    \
            std::fprintf(stderr, "%s:%d: check failed: %s\n", __FILE__, __LINE__, #condition); \
            std::abort();                                                                      \
        }                                                                                      \
    } while (false)
