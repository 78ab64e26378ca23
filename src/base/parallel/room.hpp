// Whether the address space that the process may use has room for threads.
#ifndef GEMINGA_BASE_PARALLEL_ROOM_HPP
#define GEMINGA_BASE_PARALLEL_ROOM_HPP

#include <cstddef>

namespace geminga::parallel {

/// glibc gives each thread a heap of its own, and where there is no room for that it asks the kernel again at every
/// allocation: a hundred times as slow.
[[nodiscard]] bool has_room_for(std::size_t threads);

}  // namespace geminga::parallel

#endif
