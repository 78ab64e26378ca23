// Records and entries for tests of recordings.
#ifndef GEMINGA_TESTS_TOOLS_RECORDING_ROWS_HPP
#define GEMINGA_TESTS_TOOLS_RECORDING_ROWS_HPP

#include <sstream>
#include <string>
#include <vector>

#include "recording/reader.hpp"

namespace geminga::recording {

/// The beginning of every recording here.
inline constexpr Time first_time{std::chrono::milliseconds(1'795'000'000'000)};

inline Record participant(const std::string& id, const std::string& heard, bool is_self = false) {
  return {"participants",
          {{"id", id}, {"name", "robot" + id}, {"heard", heard}, {"loss", "0.250"}, {"self", is_self ? "1" : "0"}},
          {}};
}
inline Record service(const std::string& key, const std::string& concept_name, Attributes attributes = {}) {
  return {"services",
          {{"service", key},
           {"provider", key.substr(0, key.rfind('/'))},
           {"name", "vision"},
           {"participant_name", "robot" + key.substr(0, key.find('/'))},
           {"concept", concept_name},
           {"mode", "oto"},
           {"priority", "0"},
           {"age", "0.100"},
           {"local", "0"},
           {"used", "0"}},
          std::move(attributes)};
}
inline Record request(const std::string& key, const std::string& text) {
  return {"requests",
          {{"subscription", key},
           {"consumer", key.substr(0, key.rfind('/'))},
           {"text", text},
           {"mode", "oto"},
           {"age", "0.100"},
           {"local", "1"},
           {"served", "0"},
           {"why", "nobody"},
           {"because", "nobody offers text=" + text}},
          {}};
}

inline Entry entry(At at, Event event) { return {at, first_time + at, std::move(event)}; }
inline Entry present(At at, Record record, Present::Change change = Present::Change::add) {
  return entry(at, Present{change, std::move(record)});
}

/// The entries of a text, and the findings about it in words; the reader's error is the last of them.
struct ReadText {
  std::vector<Entry> entries;
  std::vector<std::string> findings;
};
inline ReadText read_text(const std::string& text) {
  ReadText result;
  std::istringstream in(text);
  Reader reader(in, [&](const Finding& finding) { result.findings.push_back(to_string(finding)); });
  while (true) {
    auto next = reader.next();
    if (!next) result.findings.push_back("ends: " + to_string(next.error()));
    if (!next || !*next) return result;
    result.entries.push_back(std::move(**next));
  }
}

inline std::string text_of(const std::vector<Entry>& entries) {
  std::string text;
  for (const Entry& one : entries) text += line_of(one);
  return text;
}

}  // namespace geminga::recording

#endif
