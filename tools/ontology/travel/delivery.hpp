// Which message a provider sends next: all consumers hear each, and pieces go round (TRAVEL.md).
#ifndef GEMINGA_ONTOLOGY_TRAVEL_DELIVERY_HPP
#define GEMINGA_ONTOLOGY_TRAVEL_DELIVERY_HPP

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>

#include "geminga/life.hpp"

namespace geminga::ontology {

class Delivery {
 public:
  /// The message that is sent next: the manifest, or this piece.
  struct Next {
    std::optional<std::size_t> piece;  ///< nothing: the manifest
  };

  explicit Delivery(std::size_t pieces) : pieces_(pieces) {}

  /// A consumer has come, and is sent the manifest and every piece once. O(log consumers).
  void add(Life consumer);
  void remove(Life consumer) { lacking_.erase(consumer); }
  /// The last message was left out for somebody: those who were to get it are sent another round, max_laps of them at
  /// most.
  void note_left_out();
  /// The next message; nothing where nobody lacks one. O(consumers).
  [[nodiscard]] std::optional<Next> next();
  /// Whether all who lack messages have been sent a whole round before. O(consumers).
  [[nodiscard]] bool is_repeating() const;

 private:
  struct Lacking {
    std::size_t messages = 0;  ///< to be sent before this round ends
    std::uint32_t laps = 1;    ///< begun
    bool has_gap = false;      ///< something was left out in this round
  };

  std::size_t pieces_;
  std::size_t at_ = 0;               ///< the next piece
  bool is_manifest_wanted_ = false;  ///< by somebody who has come
  std::map<Life, Lacking> lacking_;
};

}  // namespace geminga::ontology

#endif
