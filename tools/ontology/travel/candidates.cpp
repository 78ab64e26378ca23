#include "ontology/travel/candidates.hpp"

#include <algorithm>
#include <tuple>

#include "base/text.hpp"
#include "ontology/travel/digest.hpp"
#include "ontology/travel/limits.hpp"

namespace geminga::ontology {
namespace {

/// The part of `PARTICIPANT/PEER/NUMBER` with this number.
std::string_view part_of(std::string_view key, int number) {
  for (; number > 0; --number) key.remove_prefix(std::min(key.find('/'), key.size() - 1) + 1);
  return key.substr(0, key.find('/'));
}

}  // namespace

NumericIdentity ontology_number() { return {id32(SemanticIdentity{std::string(ontology_concept), {}})}; }

std::vector<Candidate> candidates_in(const Answer& answer) {
  std::vector<Candidate> found;
  for (const Record& record : answer.records) {
    const auto digest = record.attributes.find("digest");
    if (digest == record.attributes.end() || !is_blake2b(digest->second)) continue;
    const auto key = service_key(record["service"]);
    if (!key || record["protocol"] != "tcp") continue;
    const auto version = record.attributes.find("version");
    const auto number = version == record.attributes.end() ? std::optional<std::uint64_t>{0}
                                                           : base::parse_number<std::uint64_t>(version->second);
    if (!number || *number > max_travelling_version) continue;
    const std::string service(record["service"]);
    found.push_back({service, std::string(part_of(service, 0)), std::string(record["participant_name"]),
                     std::string(part_of(service, 1)), digest->second, *number});
  }
  std::ranges::sort(found, [](const Candidate& one, const Candidate& other) {
    return std::tie(other.version, one.digest, one.service) < std::tie(one.version, other.digest, other.service);
  });
  return found;
}

std::expected<std::vector<Candidate>, ClientError> candidates(Client& client) {
  const auto answer = client.query("match", {{"id", std::to_string(ontology_number().number)}, {"mode", "otm/pubsub"}});
  if (!answer) return std::unexpected(answer.error());
  return candidates_in(*answer);
}

std::expected<bool, ClientError> are_channels_sealed(Client& client) {
  const auto answer = client.query("security");
  if (!answer) return std::unexpected(answer.error());
  for (const Record& record : answer->records) {
    if (!record["mode"].empty()) return record["mode"] == "encrypted" || record["mode"] == "authenticated";
  }
  return false;
}

}  // namespace geminga::ontology
