// An answer to a query, told piece by piece, so that a long one neither delays nor crowds out other clients.
#ifndef GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_ANSWERING_HPP
#define GEMINGA_DISCOVERY_PARTICIPANT_CLIENTS_ANSWERING_HPP

#include <cstddef>
#include <cstdint>
#include <expected>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "discovery/gcnp/request.hpp"
#include "discovery/gcnp/statement.hpp"
#include "discovery/participant/knowledge/work.hpp"
#include "geminga/error.hpp"

namespace geminga::participant {

class Session;

/// The parameters of one line.
using Line = std::vector<gcnp::Parameter>;

/// One piece under way: lines go to the peer as they are told, and their work is counted at once.
class Piece {
 public:
  Piece(Session& session, WorkMeter& work, gcnp::Statement& line);
  /// Says `N msg KIND ...`.
  void tell(Line line);
  /// Counts one entry that was looked at, told of or not.
  void look_at_one() { look_at(1); }
  /// Counts so many entries, or other work that is as much.
  void look_at(std::size_t entries);
  /// Counts work of the turn that does not count towards the statements of the peer.
  void add_work(Work work) { work_.add(work); }
  /// Sets what the line `N msg end` says more, when all has been told.
  void conclude(Line end) { end_ = std::move(end); }
  /// Whether this piece has done its share of work.
  [[nodiscard]] bool is_full() const;
  [[nodiscard]] std::size_t told() const { return told_; }
  [[nodiscard]] std::size_t looked_at() const { return looked_at_; }
  [[nodiscard]] const Line& end() const { return end_; }

 private:
  Session& session_;
  WorkMeter& work_;
  gcnp::Statement& line_;
  Work begin_;
  std::size_t told_ = 0;
  std::size_t looked_at_ = 0;
  Line end_;
};

/// Tells more until the piece is full or nothing is left; gives whether all has been told. Between two pieces it keeps
/// its position by the last key, so that the registry may change: what stays is told once, what comes or goes meanwhile
/// may be told or not.
using Proceed = std::function<bool(Piece& piece)>;

struct Answering {
  std::string kind;
  Proceed proceed;
  Line end{};  ///< of the line `N msg end count=K`, beside the count
  // Of the answer as a whole.
  std::uint32_t id = 0;
  std::size_t told = 0;
  std::size_t looked_at = 0;
};

/// Begins the answer to a query, or gives the error that is the answer.
using Ask = std::function<std::expected<Answering, Error>(const gcnp::Request& query)>;

/// An answer that is ready: `N msg KIND ...` for each line, and what `N msg end count=K` says beside the count.
struct Answer {
  std::string kind;
  std::vector<Line> lines;
  Line end{};
  /// Entries that were looked through for it: what the query cost, found or not.
  std::size_t looked_through = 0;
};
/// Tells an answer that is ready piece by piece.
[[nodiscard]] Answering telling(Answer answer);

/// Begins to tell an answer to the peer: the first piece at once, the others by proceed_answer().
void begin_answer(Session& session, WorkMeter& work, std::uint32_t id, Answering answering);
/// Tells the next piece of the answer under way; there must be one.
void proceed_answer(Session& session, WorkMeter& work);

}  // namespace geminga::participant

#endif
