// Linked into every program. Mapping the memory of a large tree in pages of 4 kB takes up to half of the time in which it grows.
// Freed memory stays mapped for ten seconds, that of large meshes too: with the next tree it is needed again.
extern "C" {
const char* malloc_conf = "thp:always,oversize_threshold:0,background_thread:true"; // read by jemalloc
}
