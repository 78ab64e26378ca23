#include "env/cage/cage.hpp"

#include <linux/capability.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <utility>

#include "env/cage/landlock.hpp"
#include "env/cage/system_calls.hpp"

namespace geminga::cage {
namespace {

/// Root without these is nobody special: it may not look into other processes whatever else it is allowed.
void drop_capabilities(const Freedom& freedom) {
  std::uint32_t kept = 1U << CAP_DAC_READ_SEARCH;
  if (!freedom.writable_folders.empty()) kept |= 1U << CAP_DAC_OVERRIDE;
  if (freedom.may_serve) kept |= 1U << CAP_NET_BIND_SERVICE;
  __user_cap_header_struct header{_LINUX_CAPABILITY_VERSION_3, 0};
  std::array<__user_cap_data_struct, 2> sets{};
  if (::syscall(SYS_capget, &header, sets.data()) != 0) return;
  sets[0].effective &= kept;
  sets[0].permitted &= kept;
  sets[0].inheritable = 0;
  sets[1] = {};
  ::syscall(SYS_capset, &header, sets.data());
}

}  // namespace

Held close(const Freedom& freedom) {
  ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  drop_capabilities(freedom);
  Held held;
  RestrictedPaths paths = restrict_paths(freedom);
  held.by_paths = paths.hold;
  held.fault = std::move(paths.fault);
  held.by_system_calls = restrict_system_calls(freedom);
  return held;
}

}  // namespace geminga::cage
