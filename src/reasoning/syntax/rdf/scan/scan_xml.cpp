// The tags, texts and references of an XML file (XML 1.0, 5th edition), measured against the limits.
#include <algorithm>
#include <array>
#include <string>
#include <unordered_set>

#include "base/parallel/both.hpp"
#include "base/text.hpp"
#include "reasoning/syntax/rdf/scan/doctype.hpp"
#include "reasoning/syntax/rdf/scan/pieces.hpp"
#include "reasoning/syntax/rdf/scan/scan.hpp"
#include "reasoning/syntax/rdf/scan/xml_repairs.hpp"

namespace geminga::rdf {
namespace {

class XmlScan {
 public:
  XmlScan(std::string_view bytes, const syntax::FileLimits& limits)
      : bytes_(bytes), limits_(limits), pieces_(limits.piece_bytes) {}

  std::expected<Layout, ScanProblem> run() {
    while (place_ < bytes_.size() && !problem_) step();
    if (problem_) return std::unexpected(std::move(*problem_));
    // Below such an element the roles of elements are exchanged.
    if (!element_repairs_.empty() && bytes_.find("parseType=\"Resource\"") == std::string_view::npos)
      repairs_.insert(repairs_.end(), element_repairs_.begin(), element_repairs_.end());
    return Layout{.pieces = std::move(pieces_),
                  .has_collections = has_collections_,
                  .base_texts = std::move(bases_),
                  .repairs = std::move(repairs_)};
  }

 private:
  /// An open element.
  struct Element {
    std::size_t begin = 0;  ///< of its tag
    std::size_t end = 0;    ///< of its tag
    bool has_text = false;
    bool has_elements = false;
  };

  void step() {
    const std::size_t open = std::min(bytes_.find('<', place_), bytes_.size());
    text(place_, open);
    place_ = open;
    if (place_ == bytes_.size()) return;
    switch (place_ + 1 < bytes_.size() ? bytes_[place_ + 1] : '\0') {
      case '/':
        return end_tag();
      case '?':
        return skip_behind("?>", 2, "a processing instruction");
      case '!':
        return declaration();
      default:
        return start_tag();
    }
  }

  /// A comment, a CDATA section or a DOCTYPE.
  void declaration() {
    const std::string_view rest = bytes_.substr(place_, 9);
    if (rest.starts_with("<!--")) {
      comment();
    } else if (rest == "<![CDATA[") {
      const std::size_t begin = place_;
      skip_behind("]]>", 9, "a CDATA section");
      add_text(place_ - begin);
      if (!open_.empty()) open_.back().has_text = true;
    } else if (rest == "<!DOCTYPE") {
      doctype();
    } else {
      start_tag();
    }
  }

  void end_tag() {
    const std::size_t begin = place_;
    if (!open_.empty()) {
      if (open_.back().has_text && open_.back().has_elements) note_markup(open_.back());
      open_.pop_back();
      --depth_;
    }
    if (depth_ < literal_depth_) literal_depth_ = 0;
    skip_behind(">", 2, "a tag");
    end_of_tag(begin);
    if (depth_ == 1 && pieces_.wants(place_)) pieces_.cut({place_, line_here(), 0});
  }

  void skip_behind(std::string_view end, std::size_t from, const char* what) {
    const std::size_t found = bytes_.find(end, place_ + from);
    if (found == std::string_view::npos) return fail(std::string("has ") + what + " without end");
    place_ = found + end.size();
  }

  /// libxml2 reports each `--` inside a comment by itself, at a length that makes a megabyte of them take minutes.
  void comment() {
    const std::size_t dashes = bytes_.find("--", place_ + 4);
    if (dashes == std::string_view::npos) return fail("has a comment without end");
    if (bytes_.substr(dashes, 3) != "-->") return fail("has -- inside a comment, which XML forbids");
    place_ = dashes + 3;
  }

  /// A text goes from tag to tag. An XML literal is one text with its tags.
  void end_of_tag(std::size_t begin) {
    if (literal_depth_ == 0) {
      text_bytes_ = 0;
    } else {
      add_text(place_ - begin);
    }
  }

  /// Whether an element's content is an XML literal: rdf:parseType is neither Resource nor Collection.
  [[nodiscard]] static bool makes_literal(std::string_view tag) {
    const std::size_t name = tag.find("parseType");
    if (name == std::string_view::npos) return false;
    const std::size_t quote = tag.find_first_of("'\"", name);
    const std::string_view value = quote == std::string_view::npos ? "" : tag.substr(quote + 1);
    return !value.starts_with("Resource") && !value.starts_with("Collection");
  }

  void add_text(std::size_t count) {
    text_bytes_ += count;
    if (text_bytes_ > limits_.literal_bytes)
      fail("has a text of more than " + std::to_string(limits_.literal_bytes) + " bytes");
  }

  /// Measures character data, its references expanded.
  void text(std::size_t begin, std::size_t end) {
    add_text(end - begin);
    add_text(references(begin, end, false));
    if (open_.empty() || open_.back().has_text) return;
    const std::size_t first = bytes_.find_first_not_of(xml_space, begin);
    open_.back().has_text = first < end;
  }

  /// Octets that the entity references between two places expand to, beyond those of the references.
  /// One to an entity that only another file declares stands as it is written.
  std::size_t references(std::size_t begin, std::size_t end, bool is_attribute) {
    if (!doctype_) return 0;
    std::size_t expansion = 0;
    const std::string_view part = bytes_.substr(begin, end - begin);
    for (std::size_t at = part.find('&'); at != std::string_view::npos; at = part.find('&', at + 1)) {
      const std::size_t close = part.find(';', at);
      if (close == std::string_view::npos) break;
      const std::string_view name = part.substr(at + 1, close - at - 1);
      if (doctype_->is_elsewhere(name)) {
        if (is_attribute) {
          fail("refers to the entity " + base::printable(name, 60) + " of another file, which is never read");
        } else {
          repair({begin + at, 1, "&amp;"}, "a reference to an entity of another file, kept as it is written");
        }
      }
      expansion += doctype_->expanded_bytes(name);
      if (expansion > limits_.literal_bytes) break;
    }
    expansion_ += expansion;
    if (expansion_ > limits_.expansion_bytes + limits_.entity_growth * bytes_.size())
      fail("expands its entities to more than " + std::to_string(expansion_ - expansion) + " bytes");
    return expansion;
  }

  void start_tag() {
    const std::size_t begin = place_++;
    std::size_t attributes = 0;
    bool has_parse_type = false;
    bool has_id = false;
    while (place_ < bytes_.size() && bytes_[place_] != '>') {
      const char c = bytes_[place_];
      if (c != '"' && c != '\'') {
        ++place_;
        continue;
      }
      const std::size_t close = std::min(bytes_.find(c, place_ + 1), bytes_.size());
      const std::string_view name = attribute_name(bytes_.substr(begin, place_ - begin));
      if (name == "xml:base") add_base(place_ + 1, close);
      has_parse_type = has_parse_type || name.ends_with("parseType");
      has_id = has_id || name.ends_with(":ID");
      if (name.ends_with(":nodeID")) note_node_id(place_ + 1, close);
      const std::size_t value_bytes = close - place_ + references(place_, close, true);
      if (value_bytes > limits_.literal_bytes)
        return fail("has an attribute of more than " + std::to_string(limits_.literal_bytes) + " bytes");
      if (++attributes > limits_.attributes)
        return fail("has an element with more than " + std::to_string(limits_.attributes) + " attributes");
      place_ = close + 1;
    }
    if (place_ - begin > limits_.tag_bytes)
      return fail("has a tag of more than " + std::to_string(limits_.tag_bytes) + " bytes");
    if (place_ >= bytes_.size()) return fail("has a tag without end");
    const bool is_empty_element = bytes_[place_ - 1] == '/';
    if (!is_empty_element && ++depth_ > limits_.nesting)
      return fail("nests elements more than " + std::to_string(limits_.nesting) + " deep");
    ++place_;
    if (!open_.empty()) open_.back().has_elements = true;
    if (!is_empty_element) open_.push_back({begin, place_});
    end_of_tag(begin);
    const std::string_view tag = bytes_.substr(begin, place_ - begin);
    if (has_parse_type && !is_empty_element && literal_depth_ == 0 && makes_literal(tag)) literal_depth_ = depth_;
    has_collections_ = has_collections_ || (has_parse_type && tag.find("Collection") != std::string_view::npos);
    if (depth_ == 1 && !is_empty_element) root(tag);
    if (!has_id) return;
    pieces_.forbid();  // raptor refuses a name that is given twice in what it reads
    note_id(begin, tag, is_empty_element ? depth_ + 1 : depth_);
  }

  [[nodiscard]] static constexpr bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

  /// The name of the attribute before whose value a tag was cut off. It ends at quotation marks, too, so that a tag is
  /// walked once however it is written.
  [[nodiscard]] static std::string_view attribute_name(std::string_view tag) {
    while (!tag.empty() && (tag.back() == '=' || is_space(tag.back()))) tag.remove_suffix(1);
    std::size_t begin = tag.size();
    while (begin > 0 && !is_space(tag[begin - 1]) && tag[begin - 1] != '"' && tag[begin - 1] != '\'') --begin;
    return tag.substr(begin);
  }

  void add_base(std::size_t begin, std::size_t end) {
    const std::string_view written = bytes_.substr(begin, end - begin);
    if (written.size() > limits_.iri_bytes) return;
    if (auto iri = expanded(written, doctype_ ? &*doctype_ : nullptr); iri && iri->size() <= limits_.iri_bytes)
      bases_.push_back({begin, written.size(), std::move(*iri)});
  }

  /// Only elements directly below rdf:RDF can be parsed by themselves.
  void root(std::string_view tag) {
    const std::string_view name = element_name(tag);
    if (name != "RDF" && !name.ends_with(":RDF")) return pieces_.forbid();
    rdf_prefix_ = name.substr(0, std::max<std::size_t>(name.size(), 4) - 4);
    pieces_.begin_at(place_, line_here() - 1, "</" + std::string(name) + ">");
  }

  /// A name by rdf:ID that is given twice, or is no name of XML, stands as rdf:about. Only on elements of nodes, which
  /// stand at even depths below rdf:RDF: on those of properties it names a statement.
  void note_id(std::size_t begin, std::string_view tag, std::size_t depth) {
    if (depth % 2 != 0 || depth_ == literal_depth_) return;
    auto found = id_attribute(tag, begin);
    if (!found) return;
    const bool is_new = known_ids_.emplace(std::to_string(bases_.size()) + ' ' + std::string(found->id)).second;
    if (is_new && is_xml_name(found->id)) return;
    repair_element(std::move(found->as_about), "rdf:ID given twice or no name of XML, read as rdf:about");
  }

  /// The OWL API has written names such as `_:genid1`, which are no names of XML.
  void note_node_id(std::size_t begin, std::size_t end) {
    const std::string_view name = bytes_.substr(begin, end - begin);
    if (name.empty() || is_xml_name(name) || name.find('\n') != std::string_view::npos) return;
    repair({begin, name.size(), legal_node_id(name)}, "rdf:nodeID that is no name of XML, read as one");
  }

  /// Elements of properties stand at odd depths below rdf:RDF.
  void note_markup(const Element& element) {
    if (rdf_prefix_.empty() || literal_depth_ != 0 || depth_ < 3 || depth_ % 2 == 0) return;
    auto literal =
        as_xml_literal(bytes_.substr(element.begin, element.end - element.begin), element.begin, rdf_prefix_);
    if (literal) repair_element(std::move(*literal), "markup in a text, read as an XML literal");
  }

  void repair(Rewrite rewrite, std::string_view remark) {
    repairs_.push_back({std::move(rewrite), remark});
    limit_repairs();
  }

  /// A repair that depends on whether an element is of a node or of a property.
  void repair_element(Rewrite rewrite, std::string_view remark) {
    element_repairs_.push_back({std::move(rewrite), remark});
    limit_repairs();
  }

  void limit_repairs() {
    if (repairs_.size() + element_repairs_.size() > limits_.repairs)
      fail("has more than " + std::to_string(limits_.repairs) + " places that are not as RDF/XML has it");
  }

  /// The line of the place, which only grows.
  std::uint32_t line_here() {
    line_ += line_of(bytes_.substr(counted_), place_ - counted_) - 1;
    counted_ = place_;
    return line_;
  }

  void doctype() {
    if (doctype_) return fail("has a second DOCTYPE");
    auto read = Doctype::read(bytes_, place_, limits_);
    if (!read) {
      problem_ = std::move(read.error());
      return;
    }
    place_ = read->end();
    doctype_ = std::move(*read);
    const std::string_view remark =
        doctype_->names_other_files() ? "an external DTD or entity, which is never read" : "";
    for (const Rewrite& cut : doctype_->cuts()) repair(cut, remark);
  }

  void fail(std::string text) {
    if (!problem_) problem_ = ScanProblem{line_of(bytes_, std::min(place_, bytes_.size())), std::move(text)};
  }

  std::string_view bytes_;
  const syntax::FileLimits& limits_;
  Pieces pieces_;
  std::size_t place_ = 0;
  std::size_t counted_ = 0;  ///< lines were counted up to here
  std::uint32_t line_ = 1;
  std::vector<Element> open_;
  std::size_t depth_ = 0;          ///< of open_
  std::string_view rdf_prefix_;    ///< of the root rdf:RDF; empty: it has none
  bool has_collections_ = false;   ///< rdf:parseType="Collection"
  std::size_t literal_depth_ = 0;  ///< of the element whose content is an XML literal; 0: none is open
  std::size_t text_bytes_ = 0;     ///< character data since the last tag
  std::size_t expansion_ = 0;      ///< of all references so far
  std::optional<Doctype> doctype_;
  std::vector<BaseText> bases_;
  std::vector<Repair> repairs_;
  std::vector<Repair> element_repairs_;
  std::unordered_set<std::string> known_ids_;  ///< with the number of bases before it
  std::optional<ScanProblem> problem_;
};

}  // namespace

DeclaredEncoding declared_encoding(std::string_view xml) {
  constexpr std::size_t npos = std::string_view::npos;
  const std::size_t mark = xml.size() - base::without_mark(xml).size();
  if (!xml.substr(mark).starts_with("<?xml")) return {};
  const std::string_view declaration = xml.substr(0, std::min(xml.find("?>"), std::size_t{1024}));
  const std::size_t word = declaration.find("encoding");
  const std::size_t open = word == npos ? npos : declaration.find_first_of("'\"", word);
  const std::size_t close = open == npos ? npos : declaration.find(declaration[open], open + 1);
  if (close == npos) return {};
  return {word, close + 1 - word, declaration.substr(open + 1, close - open - 1)};
}

namespace {

/// Refuses other encodings than UTF-8 and ISO-8859-1, NUL bytes and bad UTF-8.
std::optional<ScanProblem> scan_encoding(std::string_view bytes) {
  constexpr std::array<std::string_view, 4> utf8_names{"utf-8", "utf8", "us-ascii", "ascii"};
  constexpr std::array<std::string_view, 3> latin1_names{"iso-8859-1", "latin1", "iso_8859-1"};
  const auto refuse = [](const char* text) { return ScanProblem{1, text}; };
  const std::string encoding = base::in_lower_case(declared_encoding(bytes).name);
  const bool is_latin1 = std::ranges::find(latin1_names, encoding) != latin1_names.end();
  const bool is_utf8 = encoding.empty() || std::ranges::find(utf8_names, encoding) != utf8_names.end();
  if (!is_latin1 && !is_utf8) return refuse("is in an encoding that is not read: convert it to UTF-8");
  if (is_latin1 && base::without_mark(bytes).size() != bytes.size())
    return refuse("begins as UTF-8 and declares ISO-8859-1: correct its declaration");
  return scan_text(bytes, is_utf8);
}

/// Whether a DOCTYPE stands before the first element.
bool has_doctype(std::string_view bytes) {
  for (std::size_t at = bytes.find('<'); at != std::string_view::npos;) {
    const std::string_view rest = bytes.substr(at);
    if (rest.starts_with("<!DOCTYPE")) return true;
    const bool is_comment = rest.starts_with("<!--");
    if (!is_comment && !rest.starts_with("<?")) return false;
    const std::size_t end = rest.find(is_comment ? "-->" : "?>", 2);
    at = end == std::string_view::npos ? end : bytes.find('<', at + end);
  }
  return false;
}

}  // namespace

std::expected<Layout, ScanProblem> scan_xml(std::string_view bytes, const syntax::FileLimits& limits,
                                            unsigned threads) {
  std::optional<ScanProblem> problem;
  std::expected<Layout, ScanProblem> layout = Layout{Pieces(limits.piece_bytes)};
  const auto look_at_tags = [&] { layout = XmlScan(bytes, limits).run(); };
  const auto look_at_encoding = [&] { problem = scan_encoding(bytes); };
  if (threads > 1 && bytes.size() > limits.watched_bytes) {
    parallel::do_both(threads, look_at_tags, look_at_encoding);
  } else {
    look_at_encoding();
    if (!problem) look_at_tags();
  }
  if (problem) return std::unexpected(std::move(*problem));
  return layout;
}

std::expected<Layout, ScanProblem> scan_owl_xml(std::string_view bytes, const syntax::FileLimits& limits) {
  if (auto problem = scan_encoding(bytes)) return std::unexpected(std::move(*problem));
  if (has_doctype(bytes)) return XmlScan(bytes, limits).run();
  return Layout{Pieces(limits.piece_bytes)};
}

}  // namespace geminga::rdf
