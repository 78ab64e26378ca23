#include "web/recording.hpp"

#include <array>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <optional>

#include "recording/reader.hpp"
#include "recording/state.hpp"
#include "shell/report.hpp"
#include "shell/timestamp.hpp"
#include "web/settings.hpp"

namespace geminga::web {
namespace {

constexpr std::array<const char*, 3> kind_words{"participants", "services", "requests"};

void observe(const recording::State& state, History::Time at, History& history) {
  if (!state.lost().empty()) return history.miss(at, state.lost());
  std::array<answers::Known, 3> known;
  for (std::size_t kind = 0; kind < known.size(); ++kind) {
    for (const auto& [key, record] : state.of(kind_words[kind])) known[kind].emplace(key, state.aged(record));
  }
  history.observe(at, std::move(known));
}

}  // namespace

std::expected<void, std::string> read_recording(const std::string& file, History& history) {
  std::ifstream in(file, std::ios::binary);
  if (!in || in.peek() == std::char_traits<char>::eof()) {
    return std::unexpected(file + " cannot be read, or is empty: name a file that geminga-query record wrote");
  }
  std::size_t findings = 0;
  recording::Reader reader(in, [&](const recording::Finding&) { ++findings; });
  recording::State state;
  std::optional<recording::Time> former;  // of the last observation
  std::optional<recording::Time> last;
  while (true) {
    const auto entry = reader.next();
    if (!entry) return std::unexpected(file + ": " + to_string(entry.error()));
    if (!*entry) break;
    // The state before an entry is that of all entries until then.
    const recording::Time time = (*entry)->time;
    if (last && time != *last && (!former || *last - *former >= history_pause)) {
      former = last;
      observe(state, *last, history);
    }
    state.apply(**entry);
    state.stand_at((*entry)->at);
    last = last ? std::max(*last, time) : time;
  }
  if (!last) return std::unexpected(file + " has no snapshot: it is no recording of geminga-query record");
  observe(state, *last, history);
  history.be_recording(std::filesystem::path(file).filename().string());
  if (findings > 0) {
    shell::complain(program, file + ": " + std::to_string(findings) +
                                 " lines are wrong and left out: geminga-query replay says which");
  }
  if (history.is_cut()) {
    shell::complain(program, file + " has more changes than are kept: it is shown from " +
                                 shell::timestamp(history.begin()) + " on");
  }
  return {};
}

}  // namespace geminga::web
