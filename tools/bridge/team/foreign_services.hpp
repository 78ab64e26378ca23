// The services and requests of others, as they are stated to the daemon.
#ifndef GEMINGA_BRIDGE_TEAM_FOREIGN_SERVICES_HPP
#define GEMINGA_BRIDGE_TEAM_FOREIGN_SERVICES_HPP

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <variant>

#include "bridge/team/tally.hpp"
#include "client/protocol/session.hpp"
#include "geminga/named.hpp"

namespace geminga::bridge {

/// The attribute that every service of a bridge has: the kind of the bridge. No bridge carries such a service on.
inline constexpr std::string_view bridge_attribute = "bridge";

/// A service or request of somebody who does not speak Geminga. Its identity is stated as a text unless the ontology
/// of the daemon has a class of the name `concept_name`.
struct Foreign {
  std::variant<NamedPublication, NamedSubscription> stated;  ///< with the text as its identity
  std::string concept_name{};                                ///< empty: it is a text in any case
  friend bool operator==(const Foreign&, const Foreign&) = default;
};

/// States what it is given, by a key that the caller chooses. A name that the ontology does not know is refused by the
/// daemon (422), and the text is stated in its place; after a change of the ontology the name is tried again.
///
/// At most max_stated publications and as many subscriptions are stated, in the order in which they came; others wait.
/// Pure but for the session. Neither copies nor moves.
class ForeignServices {
 public:
  /// Borrows both for its life.
  ForeignServices(client::Session& session, Tally& tally) : session_(session), tally_(tally) {}

  /// States one, or changes what was stated under that key.
  void put(const std::string& key, Foreign foreign);
  /// Withdraws one, if it is there.
  void drop(const std::string& key);
  /// Withdraws all.
  void clear();
  [[nodiscard]] bool has(const std::string& key) const { return stated_.contains(key) || waiting_.contains(key); }

  /// A daemon is there, of which nothing is known: call before Session::on_up().
  void on_up();
  /// The daemon has another ontology.
  void on_other_ontology();
  /// Takes the answer to a request; false where it is about none of these.
  bool on_settled(const client::Session::Settled& settled);

  [[nodiscard]] std::size_t stated() const { return stated_.size(); }
  [[nodiscard]] std::size_t waiting() const { return waiting_.size(); }
  /// Those that are stated by a concept.
  [[nodiscard]] std::size_t concepts() const;
  /// The key of a request's number; empty: none.
  [[nodiscard]] std::string_view key_of(ChannelNumber number) const;

 private:
  struct Stated {
    Foreign foreign;
    ChannelNumber number = 0;
    bool is_concept = false;
  };

  void state(const std::string& key, Foreign foreign, bool as_concept);
  void forget(std::map<std::string, Stated>::iterator at);
  void state_waiting();
  [[nodiscard]] bool has_room(const Foreign& foreign) const;

  client::Session& session_;
  Tally& tally_;
  std::map<std::string, Stated> stated_;
  std::map<std::string, Foreign> waiting_;
  std::map<ChannelNumber, std::string> keys_;
  std::size_t publications_ = 0;  ///< of stated_
};

}  // namespace geminga::bridge

#endif
