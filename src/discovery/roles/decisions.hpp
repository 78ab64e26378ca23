// Decisions of the search for robots: those who are chosen, those who are not, and what follows from each.
#ifndef GEMINGA_DISCOVERY_ROLES_DECISIONS_HPP
#define GEMINGA_DISCOVERY_ROLES_DECISIONS_HPP

#include <cstddef>
#include <cstdint>
#include <vector>

#include "discovery/roles/pool.hpp"

namespace geminga::roles {

/// `pool` is borrowed. Decisions leave at least one best choice of at most `most` robots, as far as they follow from
/// each other:
/// - A role needs as many robots as it counts that are not out; if there are no more, all of them are in.
/// - A robot that can hold all that another can, at no more cost, is better; of equal ones it is the first. Where the
///   worse one is chosen the better one is, too: else it could stand for it.
class Decisions {
 public:
  enum class State : std::uint8_t { open, in, out };

  Decisions(const Pool& pool, std::size_t most);

  [[nodiscard]] State operator[](std::size_t robot) const { return state_[robot]; }
  [[nodiscard]] std::size_t chosen() const { return chosen_; }
  [[nodiscard]] std::size_t most() const { return most_; }
  /// How many more may be chosen.
  [[nodiscard]] std::size_t room() const { return most_ - chosen_; }
  [[nodiscard]] bool is_complete() const;
  [[nodiscard]] std::vector<bool> robots_in() const;

  /// Decides about a robot, with what follows. False if no choice is left: undo it then.
  [[nodiscard]] bool decide(std::size_t robot, State state);
  /// A place to return to.
  [[nodiscard]] std::size_t mark() const { return trail_.size(); }
  void undo(std::size_t mark);

 private:
  void compare();
  bool put(std::size_t robot, State state);
  bool follow(std::size_t robot);
  bool follow_out(std::size_t robot);
  void count(std::size_t robot, bool is_there);

  const Pool& pool_;
  std::size_t most_;
  std::size_t chosen_ = 0;
  std::vector<State> state_;
  std::vector<std::uint32_t> able_;                  ///< by role: robots that are not out and can hold it
  std::vector<std::vector<std::uint32_t>> able_to_;  ///< by role: all of them
  std::vector<std::vector<std::uint32_t>> better_;
  std::vector<std::vector<std::uint32_t>> worse_;
  std::vector<std::size_t> trail_;
};

}  // namespace geminga::roles

#endif
