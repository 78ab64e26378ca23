#include "query/near.hpp"

#include "shell/describe.hpp"

namespace geminga::query {
namespace {

/// The lines of a list, with commas between.
std::string in_one_line(std::string_view lines) {
  std::string text;
  for (const char one : lines) text += one == '\n' ? std::string(", ") : std::string(1, one);
  return text;
}

shell::Table table_of_near_participants(const std::vector<Record>& records) {
  shell::Table shown({{"ID"},
                      {"NAME", false, 8},
                      {"DEGREE"},
                      {"DESCRIPTION", false, 16},
                      {"NOT KNOWN", false, 20, 0, true},
                      {"CONTRADICTS", false, 16, 0, true}});
  for (const auto& record : records) {
    shown.add({record["id"], record["name"], record["degree"].empty() ? "-" : record["degree"], record["description"],
               in_one_line(record["missing"]), in_one_line(record["contradicting"])});
  }
  return shown;
}

std::string near_line(const Record& record) {
  return std::string(record["id"]) + "  " + std::string(record["name"]) + "  " + std::string(record["description"]) +
         "  " + (is_match(record) ? std::string(record["degree"]) : lack_words(record));
}

}  // namespace

shell::Table table_of_near(const std::vector<Record>& records) {
  shell::Table shown({{"DEGREE"},
                      {"PROVIDER", false, 12},
                      {"IDENTITY", false, 16},
                      {"NOT KNOWN", false, 20, 0, true},
                      {"CONTRADICTS", false, 16, 0, true},
                      {"SERVICE"}});
  for (const auto& record : records) {
    shown.add({record["degree"].empty() ? "-" : record["degree"],
               shell::who(record["provider"], record["name"], record["participant_name"]),
               shell::identity_words(record), in_one_line(record["missing"]), in_one_line(record["contradicting"]),
               record["service"]});
  }
  return shown;
}

bool is_match(const Record& record) { return !record["degree"].empty(); }

std::string participant_of(const Record& record) {
  const std::string_view provider = record["provider"];
  return std::string(provider.substr(0, provider.find('/')));
}

std::string lack_words(const Record& record) {
  std::string text;
  if (!record["missing"].empty()) text = "not known: " + in_one_line(record["missing"]);
  if (record["contradicting"].empty()) return text;
  return text + (text.empty() ? "" : "; ") + "contradicts: " + in_one_line(record["contradicting"]);
}

Listing near_participants(const std::string& expression, const std::string& where) {
  Listing listing{"participants",
                  {{"concept", expression}, {"missing", "1"}},
                  {},
                  "id",
                  table_of_near_participants,
                  near_line,
                  "no participant is known to satisfy that, or nearly so: geminga-query participants --json shows the "
                  "description of each"};
  if (!where.empty()) listing.parameters.emplace_back("where", where);
  listing.is_found = is_match;
  return listing;
}

}  // namespace geminga::query
