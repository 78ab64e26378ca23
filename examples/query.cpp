// Asks who could serve a request, best first, and why the best one can, without asking for the service itself.
#include <iostream>

#include "geminga/client.hpp"

int main() {
  auto client = geminga::Client::connect();
  if (!client) {
    std::cerr << "query: " << client.error().text << '\n';
    return 3;
  }

  const auto matches = client->query("match", {{"concept", "soccer:TrackedObject"}, {"limit", "3"}});
  if (!matches) {
    std::cerr << "query: " << matches.error().text << '\n';
    return 2;
  }
  for (const geminga::Record& match : matches->records) {
    std::cout << match["degree"] << ' ' << match["distance"] << "  " << match["concept"] << " from " << match["name"]
              << '\n';
  }
  if (matches->records.empty()) return 1;

  const std::string found(matches->records.front()["concept"]);
  const auto reasons = client->query("explain", {{"sub", found}, {"super", "soccer:TrackedObject"}});
  if (!reasons) {
    std::cerr << "query: " << reasons.error().text << '\n';
    return 2;
  }
  for (const geminga::Record& axiom : reasons->records) std::cout << "  because " << axiom["axiom"] << '\n';
  return 0;
}
