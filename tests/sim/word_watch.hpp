// A checker of relays: no word goes round twice.
#ifndef GEMINGA_TESTS_SIM_WORD_WATCH_HPP
#define GEMINGA_TESTS_SIM_WORD_WATCH_HPP

#include <cstddef>
#include <cstdint>
#include <map>
#include <string_view>
#include <utility>

#include "discovery/sealing/key.hpp"
#include "sim/world.hpp"

namespace geminga::sim {

/// Listens in on the air of a sealed team with its key. A relay says a word at most twice (the second is a copy against
/// loss) on each of its links but the one that it heard it on, and no word passes more than max_hops relays. Takes
/// World::on_transmit.
class WordWatch {
 public:
  WordWatch(World& world, sealing::Key key);

  /// The datagrams of relays with a word in them.
  [[nodiscard]] std::size_t words() const { return words_; }

 private:
  void see(const Host& sender, std::string_view datagram);

  World& world_;
  sealing::Key key_;
  std::map<std::pair<std::uint32_t, std::uint64_t>, std::size_t> said_;  ///< by relay and hash of the word
  std::size_t words_ = 0;
};

}  // namespace geminga::sim

#endif
