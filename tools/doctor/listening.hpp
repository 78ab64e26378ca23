// Sockets that listen for a while; and listening at ports and groups beside the usual ones, which needs no right.
#ifndef GEMINGA_DOCTOR_LISTENING_HPP
#define GEMINGA_DOCTOR_LISTENING_HPP

#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "doctor/overhearing.hpp"

namespace geminga::doctor {

inline constexpr const char* usual_group_v4 = "239.192.47.17";
inline constexpr const char* usual_group_v6 = "ff02::4717";
inline constexpr std::uint16_t usual_port = 4717;

/// Descriptors that are closed at the end.
struct Sockets {
  std::vector<int> numbers;
  Sockets() = default;
  ~Sockets();
  Sockets(const Sockets&) = delete;
  Sockets& operator=(const Sockets&) = delete;
  /// Opens one that does not block; negative: it cannot be opened.
  int open(int family, int type, int protocol);
};

/// Calls `take` for so long with each descriptor that has something to read.
void listen(const Sockets& sockets, std::chrono::milliseconds time, const std::function<void(int)>& take);

/// The ports and groups that overhear_neighbouring() listens at: ours, the usual ones, and their neighbours, each once.
struct Places {
  std::vector<std::uint16_t> ports;
  std::vector<std::string> groups;       ///< listened at on each of `ports`
  std::vector<std::string> next_groups;  ///< listened at on our port and the usual one
};
[[nodiscard]] Places places_beside(const Habits& ours);

/// overhear() without a right. Each socket is bound to a group, so that it takes nothing from the programs of this
/// host.
[[nodiscard]] std::vector<Overheard> overhear_neighbouring(const std::vector<std::string>& interfaces,
                                                           const Habits& ours, std::chrono::milliseconds time);

}  // namespace geminga::doctor

#endif
