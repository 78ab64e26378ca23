// The differences between two answers to the same question, as --watch tells them.
#ifndef GEMINGA_ANSWERS_DIFFERENCES_HPP
#define GEMINGA_ANSWERS_DIFFERENCES_HPP

#include <boost/json/object.hpp>
#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "geminga/client.hpp"

namespace geminga::answers {

/// The pause between two questions. Shorter: changes are shown sooner, and the daemon has more work. Longer: the
/// reverse. A reader notices no shorter delay.
inline constexpr std::chrono::milliseconds watch_pause{250};

/// The records of an answer by the field that names each of them for its whole life.
using Known = std::map<std::string, Record, std::less<>>;

[[nodiscard]] Known known_by(std::string_view key, std::vector<Record> records);

/// One difference. Borrows its record.
struct Difference {
  enum class Kind : std::uint8_t { add, modify, del };
  Kind kind = Kind::add;
  const Record* record = nullptr;  ///< as it is, or as it was last
  boost::json::object former{};    ///< of modify: the values that were others before (shell/changes.hpp)
  std::string_view reason{};       ///< of del: withdrawn, gone or changed
};

/// Whether a record of `before` is not in `after`.
[[nodiscard]] bool has_gone(const Known& before, const Known& after);

/// First those that are gone, then those that are new or have changed, each by key. Fields that change with every
/// announcement (age, heard, loss) make no difference. `reason` says why the record of a key is gone.
[[nodiscard]] std::vector<Difference> differences(const Known& before, const Known& after,
                                                  const std::function<std::string_view(const std::string&)>& reason);

/// The reasons why records have left a listing.
struct Reasons {
  std::set<std::string, std::less<>> there;         ///< the keys of all that is known, whatever the listing selects
  std::set<std::string, std::less<>> participants;  ///< the identifiers of those who are known

  /// `changed` where it is known still, `withdrawn` where its participant is, else `gone`.
  [[nodiscard]] std::string_view operator()(const std::string& key) const;
};

/// The difference as the object that --watch --json prints; it bears the present time.
[[nodiscard]] boost::json::object to_json(const Difference& difference);

}  // namespace geminga::answers

#endif
