#include "owl2/judgement.hpp"

namespace geminga::owl2 {

std::expected<Outside, std::string> read_outside(std::string_view text) {
  Outside outside;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (line.empty() || line.starts_with('#')) continue;
    const std::size_t tab = line.find('\t');
    if (tab == 0 || tab == std::string_view::npos || tab + 1 == line.size())
      return std::unexpected("line " + std::to_string(number) + ": not NAME<TAB>REASON");
    if (!outside.try_emplace(std::string(line.substr(0, tab)), line.substr(tab + 1)).second)
      return std::unexpected("line " + std::to_string(number) + ": a second time the same name");
  }
  return outside;
}

Judgement judge(std::string_view question, bool is_yes, int status, const Outside& outside) {
  const auto reason = outside.find(question);
  if (status != 0 && status != 1) {
    if (reason != outside.end()) return {true, "cannot be decided, as OUTSIDE.tsv says: " + reason->second};
    return {false, "cannot be decided, and OUTSIDE.tsv does not say why"};
  }
  if ((status == 0) != is_yes) return {false, is_yes ? "answered no, and it is yes" : "answered yes, and it is no"};
  if (reason != outside.end()) return {false, "answered rightly: take it out of OUTSIDE.tsv"};
  return {true, "answered rightly"};
}

}  // namespace geminga::owl2
