// The ledger of datagrams: how those heard of late were sealed, and which were rejected, why, and from where.
#ifndef GEMINGA_DISCOVERY_SEALING_LEDGER_HPP
#define GEMINGA_DISCOVERY_SEALING_LEDGER_HPP

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/time.hpp"
#include "discovery/sealing/envelope.hpp"

namespace geminga::sealing {

/// The interface and source of a datagram.
struct Arrival {
  env::InterfaceIndex interface{};
  std::string_view interface_name;
  std::string_view source;
  base::Instant now;
  bool is_alone = false;  ///< it came to us alone, and not by multicast
};

/// How a datagram was sealed, as far as that can be told, and what became of it.
struct Outcome {
  Protection protection = Protection::plain;
  std::optional<KeyId> key;            ///< the key that it names
  std::optional<Rejection> rejection;  ///< nothing: it was heard
  friend auto operator<=>(const Outcome&, const Outcome&) = default;
};

/// The datagrams of one source that were rejected for one reason.
struct Rejected {
  std::string source;  ///< "10.0.0.66 on wlan0"
  Outcome outcome;
  std::uint64_t count = 0;
  base::Instant last{};
};

class Ledger {
 public:
  Ledger();

  /// Enters one datagram, at constant cost.
  void enter(const Outcome& outcome, const Arrival& arrival);
  /// A line for the log about rejected datagrams, if one is due.
  [[nodiscard]] std::optional<std::string> take_complaint();

  /// The counts since the start.
  [[nodiscard]] std::uint64_t rejected(Rejection rejection) const {
    return rejected_.at(static_cast<std::size_t>(rejection));
  }
  /// The last remembered_datagrams, by how they were sealed and what became of them.
  [[nodiscard]] std::map<Outcome, std::size_t> recent() const;
  /// The last max_sources with a rejected datagram, the last one first.
  [[nodiscard]] std::vector<Rejected> sources() const;

 private:
  struct Source {
    std::uint64_t hash = 0;  ///< of source, interface and outcome
    Rejected rejected;
  };
  /// When the log was told of one reason, and how many rejections followed.
  struct Told {
    base::Instant at = base::Instant::min();
    std::uint64_t since = 0;
  };

  void note_source(const Outcome& outcome, const Arrival& arrival);
  void complain(const Outcome& outcome, const Arrival& arrival);

  std::vector<Outcome> recent_;  ///< a ring once it is full
  std::size_t next_ = 0;         ///< where the next one goes
  std::array<std::uint64_t, rejection_count> rejected_{};
  std::array<Told, rejection_count> told_{};
  std::vector<Source> sources_;
  std::optional<std::string> complaint_;
};

}  // namespace geminga::sealing

#endif
