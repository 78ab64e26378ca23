// An answer to a query that is told piece by piece, so that a long one neither delays nor crowds out anybody else.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_ANSWERING_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_QUERIES_ANSWERING_HPP

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "discovery/gcnp/statement.hpp"
#include "discovery/participant/work.hpp"

namespace geminga::participant {

struct Core;
class Session;

/// The parameters of one line.
using Line = std::vector<gcnp::Parameter>;

/// One piece under way: lines go to the peer as they are told, and what they cost is counted at once.
class Piece {
 public:
  Piece(Core& core, Session& session, gcnp::Statement& line);
  /// Says `N msg KIND ...`.
  void tell(Line line);
  /// Counts one entry that was looked at, told of or not.
  void look_at_one() { look_at(1); }
  /// Counts so many, or other work that is as much.
  void look_at(std::size_t entries);
  /// What the line `N msg end` says more, when all has been told.
  void conclude(Line end) { end_ = std::move(end); }
  /// Whether this piece has done its share of work.
  [[nodiscard]] bool is_full() const;
  [[nodiscard]] std::size_t told() const { return told_; }
  [[nodiscard]] std::size_t looked_at() const { return looked_at_; }
  [[nodiscard]] const Line& end() const { return end_; }

 private:
  Core& core_;
  Session& session_;
  gcnp::Statement& line_;
  Work begin_;
  std::size_t told_ = 0;
  std::size_t looked_at_ = 0;
  Line end_;
};

/// Tells more until the piece is full or nothing is left; gives whether all has been told. It keeps its place by the
/// last key, so that the registry may change between two pieces: what stays is told once, what comes or goes meanwhile
/// may be told or not.
using Proceed = std::function<bool(Core& core, Piece& piece)>;

struct Answering {
  std::string kind;
  Proceed proceed;
  Line end{};  ///< what `N msg end count=K` says beside the count
  // Of the answer as a whole.
  std::uint32_t id = 0;
  std::size_t told = 0;
  std::size_t looked_at = 0;
};

}  // namespace geminga::participant

#endif
