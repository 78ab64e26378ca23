#include "sim/specification.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <string_view>

namespace geminga::sim {
namespace {

std::vector<std::string> split(std::string_view text, std::string_view separators) {
  std::vector<std::string> parts;
  while (true) {
    const std::size_t end = std::min(text.find_first_of(separators), text.size());
    parts.emplace_back(text.substr(0, end));
    if (end == text.size()) return parts;
    text.remove_prefix(end + 1);
  }
}

Counterpart counterpart(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  const bool is_excluded = text.starts_with('!');
  if (is_excluded) text.remove_prefix(1);
  const std::size_t slash = text.find('/');
  return {std::string(text.substr(0, slash)), std::string(text.substr(slash + 1)), is_excluded};
}

bool is_host(const Counterpart& counterpart, const Post& own, const Post& other) {
  if (counterpart.host == "any") return true;
  if (counterpart.host == "localhost") return own.name == other.name;
  const std::string group = counterpart.host.substr(0, counterpart.host.find('_'));
  return (other.name + "-").contains("-" + group + "-");
}

}  // namespace

std::optional<std::filesystem::path> specification_file() {
  const char* named = std::getenv("GEMINGA_TEST_DATA");
  for (const std::filesystem::path& folder :
       {std::filesystem::path(named == nullptr ? "" : named),
        std::filesystem::path(GEMINGA_SOURCE_DIR).parent_path() / "shared" / "data"}) {
    auto file = folder / "carpe-noctem" / "modules.tsv";
    if (std::filesystem::is_regular_file(file)) return file;
  }
  return std::nullopt;
}

std::vector<SpecificationRow> read_specification(const std::filesystem::path& file) {
  std::vector<SpecificationRow> rows;
  std::ifstream lines(file);
  std::string line;
  std::getline(lines, line);  // the names of the columns
  while (std::getline(lines, line)) {
    const auto fields = split(line, "\t");
    if (fields.size() < 5) continue;
    SpecificationRow& row = rows.emplace_back();
    row.module = fields[0];
    row.is_publication = fields[1] == "pub";
    row.message = fields[2];
    for (const std::string& one : split(fields[4], ",;")) row.counterparts.push_back(counterpart(one));
  }
  return rows;
}

bool names(const SpecificationRow& row, const Post& own, const Post& other, const std::string& module) {
  bool is_named = false;
  for (const Counterpart& one : row.counterparts) {
    if (one.module != module || !is_host(one, own, other)) continue;
    if (one.is_excluded) return false;
    is_named = true;
  }
  return is_named;
}

bool is_same_message(const std::string& published, const std::string& wanted, bool is_mended) {
  static const std::map<std::string, std::string> meant{{"CorrectedOrometryMessage", "CorrectedOdometryMessage"},
                                                        {"SharedMallMessage", "SharedBallMessage"},
                                                        {"KickStat", "KickerStat"},
                                                        {"BehaviorEngineInfo", "BehaviourEngineInfo"},
                                                        {"BehaviorEngineControl", "BehaviourEngineControl"}};
  const auto mended = [](const std::string& name) {
    const auto found = meant.find(name);
    return found == meant.end() ? name : found->second;
  };
  return is_mended ? mended(published) == mended(wanted) : published == wanted;
}

}  // namespace geminga::sim
