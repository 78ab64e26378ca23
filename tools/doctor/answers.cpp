#include "doctor/answers.hpp"

#include <utility>

namespace geminga::doctor {

std::expected<Answers, ClientError> ask(Client& client) {
  Answers answers;
  std::vector<Record> status;
  const std::pair<const char*, std::vector<Record>*> questions[] = {
      {"status", &status},
      {"interfaces", &answers.interfaces},
      {"participants", &answers.participants},
      {"security", &answers.security},
      {"ontology", &answers.ontology},
  };
  for (const auto& [kind, records] : questions) {
    auto answer = client.query(kind);
    if (!answer && answer.error().kind != ClientError::Kind::refused) return std::unexpected(answer.error());
    if (answer) *records = std::move(answer->records);
  }
  auto unmatched = client.query("requests", {{"unmatched", "1"}});
  if (!unmatched && unmatched.error().kind != ClientError::Kind::refused) return std::unexpected(unmatched.error());
  if (unmatched) answers.unmatched = std::move(unmatched->records);
  if (!status.empty()) answers.status = std::move(status.front());
  return answers;
}

}  // namespace geminga::doctor
