#include "reasoning/syntax/owlxml/elements.hpp"

#include <libxml/SAX2.h>
#include <libxml/parser.h>
#include <libxml/parserInternals.h>

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <new>
#include <vector>

#include "base/text.hpp"

namespace geminga::owlxml {
namespace {

/// libxml2 goes on to the end of a chunk after it was stopped.
constexpr std::size_t chunk_bytes = std::size_t{1} << 16;

std::string_view view(const xmlChar* text) {
  return text == nullptr ? std::string_view() : reinterpret_cast<const char*>(text);
}

std::string_view view(const xmlChar* text, std::ptrdiff_t size) {
  return {reinterpret_cast<const char*>(text), static_cast<std::size_t>(size)};
}

xmlParserInputPtr no_external_entity(const char*, const char*, xmlParserCtxtPtr) { return nullptr; }

/// Whether the text of an element says something; of all others, white space says nothing.
bool may_have_text(std::string_view name) {
  return name == "Literal" || name == "IRI" || name == "AbbreviatedIRI" || name == "Import";
}

/// The attributes of a tag, counted before libxml2 compares them. Nothing but a start tag has any.
std::size_t attributes_of(std::string_view tag) {
  std::size_t count = 0;
  if (tag.size() < 2 || tag[1] == '!' || tag[1] == '?' || tag[1] == '/') return 0;
  for (std::size_t at = tag.find_first_of("\"'>"); at != std::string_view::npos && tag[at] != '>';) {
    ++count;
    const std::size_t close = tag.find(tag[at], at + 1);
    if (close == std::string_view::npos) break;
    at = tag.find_first_of("\"'>", close + 1);
  }
  return count;
}

struct FreeContext {
  void operator()(xmlParserCtxt* context) const {
    if (context->myDoc != nullptr) xmlFreeDoc(context->myDoc);  // holds the entities
    context->myDoc = nullptr;
    xmlFreeParserCtxt(context);
  }
};

/// One file. libxml2 calls the static functions with its context, which knows the walk.
class Walk {
 public:
  Walk(const XmlLimits& limits, Listener& listener) : limits_(limits), listener_(listener) {}

  std::optional<Problem> run(std::string_view bytes) {
    xmlSAXHandler handler{};
    if (xmlSAXVersion(&handler, 2) != 0) return Problem{0, "cannot be read: memory is short"};
    handler.startElementNs = begin;
    handler.endElementNs = end;
    handler.characters = text;
    handler.cdataBlock = text;
    handler.ignorableWhitespace = text;
    handler.comment = nullptr;
    handler.processingInstruction = nullptr;
    handler.entityDecl = entity;
    handler.externalSubset = nullptr;
    handler.serror = on_error;
    handler.warning = nullptr;
    handler.error = nullptr;
    handler.fatalError = nullptr;
    const std::unique_ptr<xmlParserCtxt, FreeContext> context(
        xmlCreatePushParserCtxt(&handler, nullptr, nullptr, 0, nullptr));
    if (context == nullptr) return Problem{0, "cannot be read: memory is short"};
    context_ = context.get();
    context_->_private = this;
    xmlCtxtUseOptions(context_, XML_PARSE_NONET | XML_PARSE_NOENT | XML_PARSE_NOCDATA);
    context_->_private = this;
    for (std::size_t at = 0; at < bytes.size() && !problem_; at += chunk_bytes) {
      const std::string_view chunk = bytes.substr(at, chunk_bytes);
      if (!look_at_tags(bytes.substr(0, at + chunk.size()))) break;
      xmlParseChunk(context_, chunk.data(), static_cast<int>(chunk.size()), 0);
    }
    if (!problem_) xmlParseChunk(context_, nullptr, 0, 1);
    if (!problem_ && context_->wellFormed == 0) fail("is not well-formed XML");
    listener_.finish();
    return std::move(problem_);
  }

 private:
  /// Counts the attributes of the tags that the end of the text has added, before libxml2 sees it. No tag has a < in
  /// it, so that only what is long up to the next one can have many.
  bool look_at_tags(std::string_view seen) {
    constexpr std::size_t least_attribute = 5;  // ` a=""`
    while (open_ < seen.size()) {
      const std::size_t next = std::min(seen.find('<', std::max(open_ + 1, looked_)), seen.size());
      const bool is_long = next - open_ > limits_.attributes * least_attribute;
      if (is_long && attributes_of(seen.substr(open_, next - open_)) > limits_.attributes) {
        const auto lines = std::ranges::count(seen.substr(0, open_), '\n');
        problem_ = Problem{1 + static_cast<std::uint32_t>(lines),
                           "more than " + std::to_string(limits_.attributes) + " attributes of an element"};
        return false;
      }
      looked_ = next;
      if (next == seen.size()) break;  // what is behind may belong to it
      open_ = next;
    }
    return true;
  }

  static Walk& behind(void* context) { return *static_cast<Walk*>(static_cast<xmlParserCtxt*>(context)->_private); }

  [[nodiscard]] std::uint32_t line() const {
    const int line = xmlSAX2GetLineNumber(context_);
    return line > 0 ? static_cast<std::uint32_t>(line) : 1;
  }

  void fail(std::string text) {
    if (!problem_) problem_ = Problem{line(), std::move(text)};
    xmlStopParser(context_);
  }

  /// No exception may pass through libxml2.
  template <typename Call>
  void guarded(const Call& call) {
    if (problem_) return;
    try {
      if (auto refusal = call()) fail(std::move(*refusal));
    } catch (const std::bad_alloc&) {
      problem_ = Problem{0, "needs more memory than there is"};
      xmlStopParser(context_);
    }
  }

  static void begin(void* context, const xmlChar* name, const xmlChar* /*prefix*/, const xmlChar* space,
                    int /*namespace_count*/, const xmlChar** /*namespaces*/, int attribute_count, int /*defaulted*/,
                    const xmlChar** attributes) {
    Walk& walk = behind(context);
    walk.guarded([&]() -> Listener::Refusal {
      if (++walk.depth_ > walk.limits_.nesting)
        return "more than " + std::to_string(walk.limits_.nesting) + " levels of elements";
      walk.attributes_.clear();
      for (int at = 0; at < attribute_count; ++at) {
        // Local name, prefix, namespace, begin and end of the value. The schema has white space of each value
        // collapsed, and an IRI or number has none within.
        const xmlChar** attribute = attributes + std::ptrdiff_t{5} * at;
        walk.attributes_.push_back(
            {view(attribute[2]), view(attribute[0]), base::trimmed(view(attribute[3], attribute[4] - attribute[3]))});
      }
      walk.is_text_told_ = may_have_text(view(name));
      return walk.listener_.begin(view(space), view(name), walk.attributes_, walk.line());
    });
  }

  static void end(void* context, const xmlChar* /*name*/, const xmlChar* /*prefix*/, const xmlChar* /*space*/) {
    Walk& walk = behind(context);
    walk.guarded([&] {
      --walk.depth_;
      walk.is_text_told_ = false;
      return walk.listener_.end(walk.line());
    });
  }

  static void text(void* context, const xmlChar* part, int size) {
    Walk& walk = behind(context);
    const std::string_view told = view(part, size);
    if (!walk.is_text_told_ && told.find_first_not_of(" \t\r\n") == std::string_view::npos) return;
    walk.guarded([&] { return walk.listener_.text(told, walk.line()); });
  }

  /// Keeps plain internal entities, as Protégé writes them for namespaces, and nothing else.
  static void entity(void* context, const xmlChar* name, int type, const xmlChar* public_id, const xmlChar* system_id,
                     xmlChar* content) {
    Walk& walk = behind(context);
    walk.guarded([&]() -> Listener::Refusal {
      const std::string shown = base::printable(view(name), 60);
      if (type != XML_INTERNAL_GENERAL_ENTITY) return "the entity " + shown + " is not a plain internal one";
      const auto bytes = walk.expanded_bytes(view(content));
      if (!bytes) return "the entity " + shown + " has markup in it";
      if (*bytes > walk.limits_.entity_bytes)
        return "the entity " + shown + " has more than " + std::to_string(walk.limits_.entity_bytes) + " bytes";
      walk.entity_bytes_.try_emplace(std::string(view(name)), *bytes);  // the first declaration counts
      if (walk.entity_bytes_.size() > walk.limits_.entities)
        return "more than " + std::to_string(walk.limits_.entities) + " entities";
      return std::nullopt;
    });
    if (!walk.problem_) xmlSAX2EntityDecl(context, name, type, public_id, system_id, content);
  }

  /// The octets of an entity with those of entities above it that it refers to. Nothing where it has markup, or refers
  /// to anything else.
  [[nodiscard]] std::optional<std::size_t> expanded_bytes(std::string_view content) const {
    if (content.find('<') != std::string_view::npos) return std::nullopt;
    std::size_t bytes = content.size();
    for (std::size_t at = content.find('&'); at != std::string_view::npos; at = content.find('&', at + 1)) {
      const std::size_t end = content.find(';', at);
      const std::string_view name = content.substr(at + 1, std::min(end, content.size()) - at - 1);
      const auto known = entity_bytes_.find(name);
      const bool is_of_xml = name == "amp" || name == "quot" || name == "apos" || name == "gt";
      if (known == entity_bytes_.end() && !is_of_xml) return std::nullopt;
      if (known != entity_bytes_.end()) bytes += known->second;
    }
    return bytes;
  }

  static void on_error(void* context, xmlErrorPtr error) {
    if (error == nullptr || error->level < XML_ERR_ERROR) return;
    Walk& walk = behind(context);
    std::string_view words = error->message == nullptr ? "is not well-formed XML" : error->message;
    words = words.substr(0, words.find('\n'));
    if (!walk.problem_)
      walk.problem_ =
          Problem{error->line > 0 ? static_cast<std::uint32_t>(error->line) : walk.line(), base::printable(words, 200)};
    xmlStopParser(walk.context_);
  }

  const XmlLimits& limits_;
  Listener& listener_;
  xmlParserCtxt* context_ = nullptr;
  std::vector<Attribute> attributes_;
  std::optional<Problem> problem_;
  std::size_t depth_ = 0;
  std::size_t open_ = 0;       ///< the place of the last < of which the tag was not yet counted
  std::size_t looked_ = 0;     ///< up to here stands no other <
  bool is_text_told_ = false;  ///< the innermost element has text that says something
  std::map<std::string, std::size_t, std::less<>> entity_bytes_;  ///< expanded
};

}  // namespace

std::optional<Problem> walk(std::string_view bytes, const XmlLimits& limits, Listener& listener) {
  xmlInitParser();
  xmlSetExternalEntityLoader(no_external_entity);
  return Walk(limits, listener).run(bytes);
}

}  // namespace geminga::owlxml
