// A gathering of robots that fill all roles, taken as they come.
#ifndef GEMINGA_DISCOVERY_ROLES_GATHERING_HPP
#define GEMINGA_DISCOVERY_ROLES_GATHERING_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include "discovery/roles/pool.hpp"

namespace geminga::roles {

/// Holders of roles that are not shared are a matching, which grows along augmenting paths (Kuhn 1955). `pool` is
/// borrowed.
class Gathering {
 public:
  explicit Gathering(const Pool& pool);

  /// Takes a robot if it helps to fill a role that lacks somebody.
  bool take(std::uint32_t robot);
  /// Takes a robot that is there in any case.
  void bring(std::uint32_t robot);
  [[nodiscard]] bool is_complete() const { return lacking_ == 0; }
  /// Sends a robot away if the others fill all roles without it.
  void dismiss(std::uint32_t robot);
  [[nodiscard]] const std::vector<bool>& robots() const { return is_there_; }

 private:
  bool place(std::uint32_t robot);
  bool place(std::uint32_t robot, std::vector<bool>& is_tried);

  const Pool& pool_;
  std::vector<bool> is_there_;
  std::vector<std::size_t> sharing_;                 ///< by shared role: robots that can hold it
  std::vector<std::vector<std::uint32_t>> holders_;  ///< by role that is not shared
  std::size_t lacking_ = 0;                          ///< holders, of all roles together
};

/// The robots that are in already, and of the others the first that help, less those that turn out to be unneeded, the
/// last first. Empty if they do not fill all roles.
[[nodiscard]] std::vector<bool> gather(const Pool& pool, const std::vector<bool>& in,
                                       const std::vector<std::uint32_t>& others);

}  // namespace geminga::roles

#endif
