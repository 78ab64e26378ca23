// The ledger: what each module should have been told. All views are compared with it.
#ifndef GEMINGA_TESTS_SIM_LEDGER_HPP
#define GEMINGA_TESTS_SIM_LEDGER_HPP

#include <compare>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/time.hpp"
#include "sim/world.hpp"

namespace geminga::sim {

/// How long a view may be wrong, by what is wrong with it.
struct Bounds {
  base::Duration missing = std::chrono::seconds(4);   ///< something is there and its viewer has not been told
  base::Duration surplus = std::chrono::seconds(25);  ///< something is gone and its viewer has not been told
};

/// Where something is offered or asked for: its host, and a port that nothing else on that host was given.
struct Place {
  std::uint32_t host = 0;
  std::uint16_t port = 0;
  auto operator<=>(const Place&) const = default;
};
/// "7:5003".
[[nodiscard]] std::string to_string(const Place& place);

/// The object of a view: publications (for a subscription) or subscriptions (for a publication) of one text and mode.
struct Topic {
  bool is_request = false;
  std::string text;
  std::string mode;
  auto operator<=>(const Topic&) const = default;
};

/// A request of a module: whoever is told of something.
struct Viewer {
  std::uint32_t module = 0;
  std::uint32_t number = 0;
  auto operator<=>(const Viewer&) const = default;
};

/// Why something is not there any more.
enum class End : std::uint8_t {
  withdrawn,  ///< by its module
  left,       ///< with its host's goodbye
  crashed,    ///< with its host, which said nothing
};

/// How long it took until viewers on other hosts knew.
struct Delays {
  std::vector<base::Duration> told;       ///< of what a module began to offer or to ask for while it was connected
  std::vector<base::Duration> joined;     ///< of what was there when a host, a module or a way between them began
  std::vector<base::Duration> withdrawn;  ///< of a withdrawal or a goodbye
  std::vector<base::Duration> crashed;    ///< of a death that nobody announced
};

/// Costs what changes, not what is there: only what is wrong at present is walked over.
class Ledger {
 public:
  Ledger(World& world, Bounds bounds);

  /// Something is there from now on. `is_change`: said while its module was connected.
  void begin(const Place& place, const Topic& topic, bool is_change);
  void end(const Place& place, End why);
  /// A module wants to be told of a topic from now on.
  void look(const Viewer& viewer, std::uint32_t host, const std::string& name, const Topic& topic);
  void look_away(const Viewer& viewer);
  /// The links between hosts have changed.
  void reach_changed();

  /// A viewer was told of something at a place, by a word that it will be told off with; or told off.
  void told(const Viewer& viewer, std::string_view word, const Place& place, std::string_view line);
  void told_off(const Viewer& viewer, std::string_view word);

  /// To be called now and then: complains of each view that has been wrong for too long.
  void check();
  /// Views that are wrong now do not count as wrong before this instant: faults have ended, say.
  void excuse() { excused_until_ = world_.now(); }
  /// Entries that are missing until then do not count, since things go wrong until then. Surplus entries do.
  void excuse_missing_until(base::Instant until) { missing_excused_until_ = until; }
  /// Lies and spoiled datagrams are about until then: what is told falsely is wrong like a view that is late, and no
  /// complaint by itself.
  void tampered_until(base::Instant until) { tampered_until_ = until; }

  [[nodiscard]] bool is_right() const { return wrong_.empty(); }
  /// The present faults, a line each.
  [[nodiscard]] std::string complaints() const;
  [[nodiscard]] const Delays& delays() const { return delays_; }
  /// Services and requests that were never told to somebody though they stood for `bounds.missing` and were heard.
  [[nodiscard]] std::size_t never_told() const { return never_told_; }

 private:
  struct Thing {
    Topic topic;
    base::Instant begun{};
    bool is_change = false;
    bool has_ended = false;
    End why{};
    base::Instant ended{};
  };
  struct Seen {
    std::size_t words = 0;  ///< by so many words it stands in the view
    base::Instant told_off;
    bool was_told_off = false;
  };
  struct Eye {
    std::uint32_t host = 0;
    std::string name;
    Topic topic;
    std::map<Place, Seen> seen;
    std::map<std::string, Place, std::less<>> words;
  };
  enum class Wrongness : std::uint8_t { none, missing, surplus };
  struct Wrong {
    Wrongness what{};
    base::Instant since;
    bool is_fresh = false;  ///< since the thing itself began or ended
    bool is_complained = false;
  };

  [[nodiscard]] Wrongness judge(const Eye& eye, const Place& place) const;
  void compare(const Viewer& viewer, const Eye& eye, const Place& place);
  void compare_all(const Topic& topic, const Place& place);
  void resolve(const Eye& eye, const Place& place, const Wrong& wrong);
  void forget_old();
  [[nodiscard]] std::string describe(const Viewer& viewer, const Place& place, const Wrong& wrong) const;

  World& world_;
  Bounds bounds_;
  std::map<Place, Thing> things_;
  std::map<Topic, std::set<Place>> places_;
  std::map<Topic, std::set<Viewer>> viewers_;
  std::map<Viewer, Eye> eyes_;
  std::map<std::pair<Viewer, Place>, Wrong> wrong_;
  std::vector<std::pair<base::Instant, Place>> ended_;  ///< in their order, to be forgotten
  base::Instant excused_until_{};
  base::Instant reach_changed_{};
  base::Instant missing_excused_until_{};
  base::Instant tampered_until_{};
  Delays delays_;
  std::size_t never_told_ = 0;
};

}  // namespace geminga::sim

#endif
