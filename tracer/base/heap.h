// How the program's heap treats memory that is freed.
#pragma once

namespace glint {

/// Has the heap keep up to a gigabyte of freed memory for the next who asks, in the place of giving
/// it back to the system: the first touch of a page may take longer than what is done with it. To
/// be called once, before there are threads.
void keepFreedMemory();

}  // namespace glint
