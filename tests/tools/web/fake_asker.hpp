// An asker whose answers a test gives, at once or when it wants to.
#ifndef GEMINGA_TESTS_TOOLS_WEB_FAKE_ASKER_HPP
#define GEMINGA_TESTS_TOOLS_WEB_FAKE_ASKER_HPP

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "web/asking/asker.hpp"

namespace geminga::web {

inline Record record(std::string kind, std::vector<std::pair<std::string, std::string>> fields) {
  return {.kind = std::move(kind), .fields = std::move(fields), .attributes = {}};
}

inline Outcome answered(std::vector<Record> records) {
  return std::make_shared<const Result<Answer, ClientError>>(Answer{.records = std::move(records), .end = {}});
}

inline Outcome failed(ClientError::Kind kind, std::string text, ErrorCode code = ErrorCode::malformed) {
  return std::make_shared<const Result<Answer, ClientError>>(std::unexpected(ClientError{kind, std::move(text), code}));
}

/// Gives the outcome of each kind; that of an unknown kind is that nobody is there.
class FakeAsker : public Asker {
 public:
  void ask(const Query& query, Then then) override {
    asked.push_back(query);
    if (is_held) {
      held.emplace_back(query, std::move(then));
      return;
    }
    then(outcome_of(query));
  }
  [[nodiscard]] Presence presence() const override { return {.is_up = true}; }

  /// Answers what was held back.
  void release() {
    is_held = false;
    for (const auto& [query, then] : std::exchange(held, {})) then(outcome_of(query));
  }
  [[nodiscard]] Outcome outcome_of(const Query& query) const {
    const auto found = outcomes.find(query.kind);
    return found != outcomes.end() ? found->second : failed(ClientError::Kind::unreachable, "nobody is there");
  }

  std::map<std::string, Outcome> outcomes;
  std::vector<Query> asked;
  bool is_held = false;
  std::vector<std::pair<Query, Then>> held;
};

}  // namespace geminga::web

#endif
