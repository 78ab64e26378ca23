// Any octets as what a peer states about the other side: `where` and `for`, `prefer` and `rank`, `scope`, units. What
// cannot be read says why; what can be read is decided for services that say all sorts of things.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "base/text.hpp"
#include "discovery/matching/arbitration/preferences.hpp"
#include "discovery/matching/conditions/scope.hpp"
#include "discovery/matching/conditions/unit.hpp"
#include "discovery/matching/conditions/where.hpp"

namespace {

using namespace geminga;
using namespace geminga::matching;

void require(bool condition) {
  if (!condition) std::abort();
}

void check_error(const Error& error) {
  require(!error.text.empty() && base::is_valid_utf8(error.text) && !base::has_control_character(error.text));
}

/// Its attributes are the words of the input, so that keys and values of an expression are often there.
registry::PublicationEntry service_of(std::string_view text) {
  registry::PublicationEntry entry;
  entry.key = {ParticipantId{0x1a2b3c4d}, PeerId{1}, 7};
  entry.participant_name = "robot1";
  entry.peer_name = "vision";
  entry.publication.identity = TextIdentity{"ball"};
  entry.publication.port = 5000;
  std::string_view key = "rate";
  for (std::size_t words = 0; !text.empty() && words < 16; ++words) {
    const std::string_view word = text.substr(0, text.find(' '));
    entry.publication.attributes[std::string(key)] = word;
    key = word;
    text.remove_prefix(word.size() < text.size() ? word.size() + 1 : text.size());
  }
  return entry;
}

void check_where(std::string_view text, const registry::PublicationEntry& entry) {
  const auto where = Where::parse(text);
  const auto error = matching::check_where(text);
  require(where.has_value() != error.has_value());
  const auto whatever_unit = Where::parse_with_any_unit(text);
  require(!where || whatever_unit);
  if (whatever_unit) {
    require(whatever_unit->accepts(entry) == whatever_unit->misses(entry).empty());
    require(base::is_valid_utf8(whatever_unit->misses(entry)));
    require(!where || where->accepts(entry) == whatever_unit->accepts(entry));
  }
  require(unit_problem(text, {}).empty() || (!where && whatever_unit));
  if (error) return check_error(*error);
  require(where->accepts(entry) == where->misses(entry).empty());
  require(base::is_valid_utf8(where->misses(entry)));
}

void check_preferences(std::string_view text, const registry::PublicationEntry& entry) {
  Subscription subscription;
  subscription.prefer = text;
  subscription.rank = text.substr(0, text.find(';'));
  const auto preferences = Preferences::parse(subscription);
  require(preferences.has_value() != matching::check_preferences(subscription).has_value());
  if (!preferences) return check_error(preferences.error());
  const Score score = preferences->score(entry, {});
  require(score.size() == preferences->margins().size());
  Rank rank;
  rank.score = score;
  require(!is_better_by(preferences->margins(), rank, rank));
  for (const double one : score) require(one == one);
}

void check_scope(std::string_view text, const registry::PublicationEntry& entry) {
  const auto scope = Scope::parse(text);
  if (!scope) return check_error(scope.error());
  const Party own{entry.key, entry.participant_name, entry.peer_name};
  static_cast<void>(scope->admits(own, {{ParticipantId{2}, PeerId{1}, 1}, "robot2", "world"}));
}

void check_quantity(std::string_view text) {
  const auto one = quantity(text);
  if (!one) return;
  require(compare(*one, *one) == 0);
  require(!unit(text) || text.size() <= max_unit_octets);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* octets, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(octets), size);
  const auto entry = service_of(text);
  check_where(text, entry);
  check_preferences(text, entry);
  check_scope(text, entry);
  check_quantity(text);
  return 0;
}
