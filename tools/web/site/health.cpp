#include "web/site/health.hpp"

#include <string_view>

namespace geminga::web {

std::string unreadiness(const Result<Answer, ClientError>& status) {
  if (!status) return status.error().text;
  if (status->records.size() != 1) return "the daemon did not say how it is: is it gemingad?";
  const Record& daemon = status->records.front();
  const auto state = daemon["state"];
  if (state != "ready") return "the daemon is not ready: it is " + std::string(state.empty() ? "silent" : state);
  if (daemon["ontology_loading"] == "1") return "ontologies are being read: wait";
  if (const auto why = daemon["ontology_failed"]; !why.empty()) {
    return "ontologies could not be read: " + std::string(why);
  }
  if (const auto why = daemon["configuration_failed"]; !why.empty()) {
    return "the configuration could not be read: " + std::string(why);
  }
  if (daemon["ontology_contradiction"] == "1")
    return "the ontology contradicts itself: geminga-ontology check says why";
  return {};
}

}  // namespace geminga::web
