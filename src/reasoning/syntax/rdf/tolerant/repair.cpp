#include "reasoning/syntax/rdf/tolerant/repair.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "base/text.hpp"
#include "base/utf8.hpp"
#include "reasoning/syntax/rdf/scan/encoding.hpp"
#include "reasoning/syntax/rdf/scan/scan.hpp"

namespace geminga::rdf {
namespace {

bool is_letter(unsigned char c) { return (c | 0x20U) - 'a' < 26U || c == '_' || c >= 0x80; }

/// XML's NCName, where every character beyond ASCII counts as a letter: Redland decides about those.
bool is_xml_name(std::string_view name) {
  const auto continues = [](char c) {
    return is_letter(static_cast<unsigned char>(c)) || (c >= '0' && c <= '9') || c == '-' || c == '.';
  };
  return !name.empty() && is_letter(static_cast<unsigned char>(name.front())) && std::ranges::all_of(name, continues);
}

using Names = std::set<std::string, std::less<>>;

/// Those of XML and those that a DOCTYPE declares.
Names entities_of(std::string_view xml) {
  constexpr std::string_view declaration = "<!ENTITY";
  Names names{"amp", "lt", "gt", "quot", "apos"};
  for (std::size_t at = xml.find(declaration); at != std::string_view::npos; at = xml.find(declaration, at + 1)) {
    const std::size_t begin = xml.find_first_not_of(" \t\r\n", at + declaration.size());
    if (begin == std::string_view::npos) break;
    names.emplace(xml.substr(begin, xml.find_first_of(" \t\r\n>", begin) - begin));
  }
  return names;
}

/// Whether a reference to a character or a known entity begins at this ampersand.
bool begins_reference(std::string_view rest, const Names& entities) {
  constexpr std::size_t longest = 64;
  const std::size_t end = rest.substr(0, longest).find(';');
  if (end == std::string_view::npos) return false;
  std::string_view name = rest.substr(1, end - 1);
  if (name.starts_with("#x")) return name.find_first_not_of("0123456789abcdefABCDEF", 2) == std::string_view::npos;
  if (name.starts_with('#')) return name.find_first_not_of("0123456789", 1) == std::string_view::npos;
  return entities.contains(name);
}

/// Copies a text piece by piece.
class Mender {
 public:
  explicit Mender(std::string_view xml) : xml_(xml), entities_(entities_of(xml)) {
    out_.reserve(xml.size() + xml.size() / 64);
  }

  std::string run() {
    while (place_ < xml_.size()) {
      const std::string_view rest = xml_.substr(place_);
      const auto byte = static_cast<unsigned char>(rest.front());
      if (rest.starts_with("<!--")) {
        comment();
      } else if (rest.starts_with("<![CDATA[")) {
        copy_behind("]]>", 9);
      } else if (rest.front() == '&' && !begins_reference(rest, entities_)) {
        put("&amp;", 1);
      } else if (is_attribute(rest)) {
        identifier(rest);
      } else if (byte != 0 && byte < 0x20 && byte != '\t' && byte != '\n' && byte != '\r') {
        put(" ", 1);
      } else {
        put(rest.substr(0, 1), 1);
      }
    }
    return std::move(out_);
  }

 private:
  static constexpr std::string_view attribute = "rdf:ID";

  void put(std::string_view text, std::size_t instead_of) {
    out_ += text;
    place_ += instead_of;
  }

  /// XML forbids two dashes inside, and one at the end.
  void comment() {
    const std::size_t found = xml_.find("-->", place_ + 4);
    const std::size_t end = found == std::string_view::npos ? xml_.size() : found;
    put("<!--", 4);
    while (place_ < end) {
      const bool is_doubled = xml_[place_] == '-' && (place_ + 1 == end || xml_[place_ + 1] == '-');
      put(is_doubled ? " " : xml_.substr(place_, 1), 1);
    }
    put("-->", std::min<std::size_t>(3, xml_.size() - place_));
  }

  void copy_behind(std::string_view end, std::size_t from) {
    const std::size_t found = xml_.find(end, place_ + from);
    const std::size_t behind = found == std::string_view::npos ? xml_.size() : found + end.size();
    put(xml_.substr(place_, behind - place_), behind - place_);
  }

  [[nodiscard]] bool is_attribute(std::string_view rest) const {
    return rest.starts_with(attribute) && place_ > 0 && std::string_view(" \t\r\n").contains(xml_[place_ - 1]);
  }

  /// `rdf:ID = "name"`, which means what `rdf:about = "#name"` means.
  void identifier(std::string_view rest) {
    const std::size_t equals = rest.find_first_not_of(" \t\r\n", attribute.size());
    const std::size_t open = equals != std::string_view::npos && rest[equals] == '='
                                 ? rest.find_first_not_of(" \t\r\n", equals + 1)
                                 : std::string_view::npos;
    if (open == std::string_view::npos || (rest[open] != '"' && rest[open] != '\''))
      return put(attribute, attribute.size());
    const std::size_t close = rest.find(rest[open], open + 1);
    if (close == std::string_view::npos) return put(attribute, attribute.size());
    const std::string_view name = rest.substr(open + 1, close - open - 1);
    const bool is_new = seen_.emplace(name).second;
    if (is_new && is_xml_name(name)) return put(rest.substr(0, close + 1), close + 1);
    out_ += "rdf:about=";
    out_ += rest[open];
    out_ += '#';
    place_ += open + 1;
  }

  std::string_view xml_;
  std::size_t place_ = 0;
  std::string out_;
  Names entities_;
  Names seen_;
};

/// The prefixes of the names in all tags, and those that some tag declares.
struct Prefixes {
  Names used;
  Names declared{"xml", "xmlns"};
  std::size_t root_name_end = 0;  ///< of the first element; 0: there is none
};

/// Where a tag ends, its brackets included. Takes the prefixes of its names.
std::size_t read_tag(std::string_view xml, std::size_t begin, Prefixes& prefixes) {
  std::size_t at = begin + 1;
  while (at < xml.size() && xml[at] != '>') {
    if (xml[at] == '"' || xml[at] == '\'') {
      const std::size_t close = xml.find(xml[at], at + 1);
      if (close == std::string_view::npos) return xml.size();
      at = close + 1;
      continue;
    }
    const std::size_t end = std::min(xml.find_first_of(" \t\r\n=/>\"'", at), xml.size());
    const std::string_view name = xml.substr(at, end - at);
    if (const std::size_t colon = name.find(':');
        colon != std::string_view::npos && is_xml_name(name.substr(0, colon))) {
      prefixes.used.emplace(name.substr(0, colon));
      if (name.starts_with("xmlns:")) prefixes.declared.emplace(name.substr(6));
    }
    if (prefixes.root_name_end == 0 && at == begin + 1 && !name.empty()) prefixes.root_name_end = end;
    at = std::max(end, at + 1);
  }
  return std::min(at + 1, xml.size());
}

Prefixes prefixes_of(std::string_view xml) {
  Prefixes prefixes;
  std::size_t at = 0;
  while ((at = xml.find('<', at)) != std::string_view::npos) {
    const std::string_view rest = xml.substr(at);
    const std::string_view end = rest.starts_with("<!--")        ? "-->"
                                 : rest.starts_with("<![CDATA[") ? "]]>"
                                 : rest.starts_with("<?")        ? "?>"
                                 : rest.starts_with("<!DOCTYPE") ? (rest.find('[') < rest.find('>') ? "]" : ">")
                                                                 : "";
    if (end.empty()) {
      at = rest.starts_with("</") ? at + 2 : read_tag(xml, at, prefixes);
    } else {
      const std::size_t found = xml.find(end, at);
      if (found == std::string_view::npos) break;
      at = found + end.size();
    }
  }
  return prefixes;
}

/// The usual meaning of a prefix; any other prefix gets an IRI of its own.
std::string usual_meaning(std::string_view prefix) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 8> usual{
      {{"rdf", "http://www.w3.org/1999/02/22-rdf-syntax-ns#"},
       {"rdfs", "http://www.w3.org/2000/01/rdf-schema#"},
       {"owl", "http://www.w3.org/2002/07/owl#"},
       {"xsd", "http://www.w3.org/2001/XMLSchema#"},
       {"service", "http://www.daml.org/services/owl-s/1.1/Service.owl#"},
       {"profile", "http://www.daml.org/services/owl-s/1.1/Profile.owl#"},
       {"process", "http://www.daml.org/services/owl-s/1.1/Process.owl#"},
       {"grounding", "http://www.daml.org/services/owl-s/1.1/Grounding.owl#"}}};
  for (const auto& [name, iri] : usual) {
    if (name == prefix) return std::string(iri);
  }
  return "urn:geminga:undeclared:" + std::string(prefix) + '#';
}

void declare_prefixes(std::string& xml) {
  const Prefixes prefixes = prefixes_of(xml);
  if (prefixes.root_name_end == 0) return;
  std::string declarations;
  for (const std::string& prefix : prefixes.used) {
    if (prefixes.declared.contains(prefix)) continue;
    declarations.append(" xmlns:").append(prefix).append("=\"").append(usual_meaning(prefix)).append("\"");
  }
  xml.insert(prefixes.root_name_end, declarations);
}

}  // namespace

std::optional<std::string> in_utf8(std::string_view xml) {
  constexpr std::array<std::string_view, 7> western{"windows-1252", "cp1252",  "iso-8859-1", "latin1",
                                                    "iso_8859-1",   "latin-1", "iso-8859-15"};
  constexpr std::array<std::string_view, 4> utf8{"utf-8", "utf8", "us-ascii", "ascii"};
  xml = base::without_mark(xml);
  const DeclaredEncoding declared = declared_encoding(xml);
  const std::string name = base::in_lower_case(declared.name);
  const bool is_western = std::ranges::find(western, name) != western.end();
  const bool says_utf8 = name.empty() || std::ranges::find(utf8, name) != utf8.end();
  if (!is_western && !says_utf8) return std::nullopt;
  const auto invalid = base::find_invalid_utf8(xml);
  if (says_utf8 && !invalid) return std::nullopt;
  std::string out;
  out.reserve(xml.size() + xml.size() / 64);
  // Each octet beyond ASCII is a character where windows-1252 is meant, unless all of the file is UTF-8 all the same.
  const bool takes_utf8 = says_utf8 || !invalid;
  for (std::string_view rest = xml; !rest.empty();) {
    const std::size_t plain = takes_utf8 ? base::find_invalid_utf8(rest).value_or(rest.size()) : 0;
    out += rest.substr(0, plain);
    rest.remove_prefix(plain);
    if (rest.empty()) break;
    append_windows_1252(static_cast<unsigned char>(rest.front()), out);
    rest.remove_prefix(1);
  }
  if (is_western) out.replace(declared.begin, declared.size, declared.size, ' ');
  return out;
}

std::string with_legal_names(std::string_view xml) {
  const std::size_t begin = xml.find_first_not_of(" \t\r\n");
  if (begin != std::string_view::npos && xml.substr(begin).starts_with("<?xml")) xml.remove_prefix(begin);
  std::string mended = Mender(xml).run();
  declare_prefixes(mended);
  return mended;
}

}  // namespace geminga::rdf
