// Questions to the daemon whose answers come later.
#ifndef GEMINGA_WEB_ASKING_ASKER_HPP
#define GEMINGA_WEB_ASKING_ASKER_HPP

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "geminga/client.hpp"
#include "geminga/result.hpp"

namespace geminga::web {

using Parameters = std::vector<std::pair<std::string, std::string>>;

/// `query KIND key=value...` (src/discovery/participant/QUERIES.md).
struct Query {
  std::string kind;
  Parameters parameters{};
  friend auto operator<=>(const Query&, const Query&) = default;
};

/// An answer, or why there is none. Shared by all who have asked the same.
using Outcome = std::shared_ptr<const Result<Answer, ClientError>>;

/// Whether the daemon is there; if it is not, why.
struct Presence {
  bool is_up = false;
  std::string reason{};
};

/// Neither copies nor moves. Not thread-safe.
class Asker {
 public:
  using Then = std::function<void(Outcome)>;

  Asker() = default;
  virtual ~Asker() = default;
  Asker(const Asker&) = delete;
  Asker& operator=(const Asker&) = delete;

  /// Calls `then` once with the outcome, perhaps before it returns.
  virtual void ask(const Query& query, Then then) = 0;
  [[nodiscard]] virtual Presence presence() const = 0;
};

}  // namespace geminga::web

#endif
