#include "tracer/base/heap.h"

#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace glint {

void keepFreedMemory() {
#ifdef __GLIBC__
    constexpr int kMegabyte = 1 << 20;
    mallopt(M_MMAP_THRESHOLD, 256 * kMegabyte);
    mallopt(M_TRIM_THRESHOLD, 1024 * kMegabyte);
#endif
}

}  // namespace glint
