// Callbacks of raptor's parsers. No exception passes through its C frames: a callback that fails stops the parser.
#include "reasoning/syntax/rdf/triples/raptor_parser.hpp"

#include <libxml/parser.h>
#include <raptor2.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <exception>
#include <string_view>
#include <unordered_set>

#include "base/text.hpp"
#include "reasoning/syntax/former_words.hpp"
#include "reasoning/syntax/rdf/triples/namespace_ends.hpp"
#include "reasoning/syntax/rdf/triples/recent_iris.hpp"

#ifdef __SANITIZE_ADDRESS__
// Raptor's Turtle grammar forgets the terms on its stack at a syntax error, its N-Triples reader one URI for each
// different datatype. We make no terms ourselves, and one URI a piece. Rasqal forgets names of blank nodes. Programs
// that clang has made name no function where llvm-symbolizer is missing.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
#ifdef __clang__
  return "leak:libraptor2.so\nleak:librasqal.so\n";
#else
  return "leak:raptor_new_term\nleak:raptor_new_uri_from_counted_string\nleak:rasqal_world_default_generate_bnodeid_"
         "handler\n";
#endif
}
#endif

namespace geminga::rdf {
namespace {

/// libxml2 goes on to the end of a chunk after an error, and reports every other one in it.
constexpr std::size_t piece_bytes = std::size_t{1} << 16;
/// Faults of one piece that are named.
constexpr std::size_t max_passed = 250;

/// Declared external entities are empty: libxml2 opens nothing.
xmlParserInputPtr no_external_entity(const char*, const char*, xmlParserCtxtPtr) { return nullptr; }

const char* parser_name(syntax::Syntax syntax) {
  switch (syntax) {
    case syntax::Syntax::rdf_xml:
      return "rdfxml";
    case syntax::Syntax::turtle:
      return "turtle";
    case syntax::Syntax::n_triples:
      return "ntriples";
    default:
      return "";  // never asked for
  }
}

std::string_view view_of(raptor_uri* uri) {
  std::size_t size = 0;
  const auto* text = reinterpret_cast<const char*>(raptor_uri_as_counted_string(uri, &size));
  return {text, size};
}

std::string_view view_of(const unsigned char* text, std::size_t size) {
  return {reinterpret_cast<const char*>(text), text == nullptr ? 0 : size};
}

/// Whether an IRI can be written between angle brackets on one line.
bool is_writable(std::string_view iri) {
  return std::ranges::none_of(iri, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == '<' || c == '>'; });
}

bool is_comment(NodeId predicate) {
  switch (static_cast<syntax::Word>(predicate)) {
    case syntax::Word::rdfs_comment:
    case syntax::Word::rdfs_see_also:
    case syntax::Word::rdfs_is_defined_by:
    case syntax::Word::owl_version_info:
      return true;
    default:
      return false;
  }
}

}  // namespace

struct RaptorParser::World {
  explicit World(const syntax::FileLimits& named_limits) : limits(named_limits) {}

  const syntax::FileLimits& limits;
  raptor_world* world = nullptr;

  // Of the piece that is being read.
  raptor_parser* parser = nullptr;
  Graph* graph = nullptr;
  const FileText* file = nullptr;  ///< null while none is read: libxml2 reports what other readers meet, too
  std::string blank_letters;       ///< before the number of a blank node that raptor makes up
  std::int64_t line_shift = 0;
  std::size_t place = 0;  ///< of the next triple among those of the file
  std::uint64_t triples = 0;
  std::vector<std::pair<std::string, std::string>> prefixes;
  std::unordered_set<std::string> known_prefixes;
  std::vector<Passed> passed;
  std::uint32_t generated = 0;
  std::vector<NodeId> made_up;  ///< the blank nodes that raptor made up, by their numbers from 1; none: not seen yet
  std::optional<syntax::LoadError> error;
  bool out_of_memory = false;

  RecentIris recent;
  std::string label;
  std::string restored;

  [[nodiscard]] std::uint32_t line() const {
    raptor_locator* locator = parser == nullptr ? nullptr : raptor_parser_get_locator(parser);
    const int number = locator == nullptr ? 0 : raptor_locator_line(locator);
    if (number > 0) return static_cast<std::uint32_t>(std::max<std::int64_t>(number + line_shift, 1));
    // Raptor knows no line before it has read the first tag.
    return file != nullptr && file->syntax == syntax::Syntax::rdf_xml ? 1 + file->layout.pieces.preamble_lines() : 0;
  }

  /// Hands a chunk to raptor; false when nothing more may come.
  bool parse(std::string_view chunk, bool is_end);
  void parse_piece(std::size_t number);

  void fail(std::string text) {
    if (!error) error = syntax::LoadError{{}, line(), std::move(text)};
    if (parser != nullptr) raptor_parser_parse_abort(parser);
  }

  [[nodiscard]] bool has_failed() const { return error.has_value() || out_of_memory; }

  /// Builds no message, since that would need memory.
  void stop_for_memory() {
    out_of_memory = true;
    if (parser != nullptr) raptor_parser_parse_abort(parser);
  }

  /// An IRI as the file means it. Valid until the next one.
  std::string_view full_iri(raptor_uri* uri) { return file->layout.bases.restored(view_of(uri), restored); }

  NodeId node(raptor_term* term) {
    switch (term->type) {
      case RAPTOR_TERM_TYPE_URI:
        return iri(full_iri(term->value.uri));
      case RAPTOR_TERM_TYPE_BLANK:
        return blank(view_of(term->value.blank.string, term->value.blank.string_len));
      case RAPTOR_TERM_TYPE_LITERAL:
        return literal(term->value.literal);
      default:
        fail("has a node that is neither IRI, blank node nor literal");
        return NodeId{};
    }
  }

  NodeId iri(std::string_view text) {
    if (const NodeId known = recent.find(text); known != NodeId{}) return known;
    const NodeId node = searched_iri(text);
    recent.keep(graph->text(node), node);  // of a former word that of OWL 2
    return node;
  }

  NodeId searched_iri(std::string_view text) {
    const std::size_t known = graph->node_count();
    const NodeId node = graph->iri(text);
    if (static_cast<std::uint32_t>(node) < static_cast<std::uint32_t>(syntax::Word::count)) return node;
    if (const auto word = syntax::word_of_owl2(text)) {
      if (text == syntax::mistyped_nil && passed.size() < max_passed)
        passed.push_back({"rdf:nill, read as rdf:nil", line(), true});
      return graph->iri(*word);
    }
    if (graph->node_count() == known) return node;
    if (text.size() > limits.iri_bytes) fail("has an IRI of more than " + std::to_string(limits.iri_bytes) + " bytes");
    if (!is_writable(text)) fail("has an IRI with a control character or an angle bracket in it");
    return node;
  }

  NodeId blank(std::string_view name) {
    const std::uint32_t number = number_of(name);
    if (number >= made_up.size()) made_up.resize(number + std::size_t{1});
    if (made_up[number] != NodeId{}) return made_up[number];
    label = file->blank_prefix;
    label += name;
    return number == 0 ? graph->blank(label) : made_up[number] = graph->new_blank(label);
  }

  /// The number of a blank node that on_blank() made up for this piece; 0: the file names it. The N-Triples reader
  /// takes names as they are, and makes none up.
  [[nodiscard]] std::uint32_t number_of(std::string_view name) const {
    if (!name.starts_with(blank_letters)) return 0;
    const auto number = base::parse_number<std::uint32_t>(name.substr(blank_letters.size()));
    return number && *number <= generated ? *number : 0;
  }

  NodeId literal(const raptor_term_literal_value& value) {
    const std::string_view lexical = view_of(value.string, value.string_len);
    if (lexical.size() > limits.literal_bytes)
      fail("has a literal of more than " + std::to_string(limits.literal_bytes) + " bytes");
    if (lexical.find('\0') != std::string_view::npos) fail("has a literal with a NUL in it");
    const NodeId datatype = value.datatype == nullptr ? NodeId{} : iri(full_iri(value.datatype));
    if (value.language == nullptr) return graph->literal(lexical, datatype, NodeId{});
    // Raptor does this for RDF/XML and not for Turtle.
    const std::string language = base::in_lower_case(view_of(value.language, value.language_len));
    return graph->literal(lexical, datatype, graph->literal(language, NodeId{}, NodeId{}));
  }

  void take(raptor_statement* statement) {
    if (error || out_of_memory) return;
    if (++triples > limits.triples)
      return fail("is beyond " + std::to_string(limits.triples) + " triples in all files");
    const std::size_t number = place++;
    const NodeId predicate = node(statement->predicate);
    if (!limits.keeps_annotations && is_comment(predicate)) return;
    const Triple triple{node(statement->subject), predicate, node(statement->object),
                        number < file->layout.lines.size() ? file->layout.lines[number] : line()};
    if (!error) graph->add(triple);
  }

  static void on_statement(void* self, raptor_statement* statement) {
    auto* world = static_cast<World*>(self);
    try {
      world->take(statement);
    } catch (const std::exception&) {
      world->stop_for_memory();
    }
  }

  static void on_namespace(void* self, raptor_namespace* name) {
    auto* world = static_cast<World*>(self);
    raptor_uri* uri = raptor_namespace_get_uri(name);
    if (uri == nullptr) return;
    const auto* prefix = reinterpret_cast<const char*>(raptor_namespace_get_prefix(name));
    try {
      std::pair declared(std::string(prefix == nullptr ? "" : prefix), std::string(world->full_iri(uri)));
      // The same declaration on every element is common, and has nothing to say.
      if (!world->known_prefixes.insert(declared.first + ' ' + declared.second).second) return;
      world->prefixes.push_back(std::move(declared));
      if (world->prefixes.size() > world->limits.prefixes)
        world->fail("declares more than " + std::to_string(world->limits.prefixes) + " prefixes");
    } catch (const std::exception&) {
      world->stop_for_memory();
    }
  }

  static void on_log(void* self, raptor_log_message* message) {
    auto* world = static_cast<World*>(self);
    if (message->level < RAPTOR_LOG_LEVEL_ERROR || world->error) return;
    try {
      std::string_view text = message->text == nullptr ? "cannot be parsed" : message->text;
      // The first on the thread that opened raptor, the second on others.
      for (const std::string_view chatter : {"XML parser error: ", "XML parser error - "}) {
        if (text.starts_with(chatter)) text.remove_prefix(chatter.size());
      }
      const bool has_collections = world->file == nullptr || world->file->layout.has_collections;
      auto passed = passed_over(text, has_collections, world->line());
      if (!passed) {
        world->fail(base::printable(text, 300));
      } else if (world->passed.size() < max_passed) {
        world->passed.push_back(std::move(*passed));
      }
    } catch (const std::exception&) {
      world->stop_for_memory();
    }
  }

  /// Blank nodes that a file names and those that raptor makes up get different first letters, so that `_:genid1` in a
  /// file is never one that raptor made up.
  static unsigned char* on_blank(void* self, unsigned char* given) {
    auto* world = static_cast<World*>(self);
    const std::size_t given_size = given == nullptr ? 32 : std::strlen(reinterpret_cast<const char*>(given));
    auto* name = static_cast<char*>(raptor_alloc_memory(given_size + 2));
    if (name == nullptr) return nullptr;
    if (given == nullptr) {
      std::memcpy(name, world->blank_letters.data(), world->blank_letters.size());
      char* const digits = name + world->blank_letters.size();
      *std::to_chars(digits, name + given_size, ++world->generated).ptr = '\0';
    } else {
      name[0] = 'u';
      std::memcpy(name + 1, given, given_size + 1);
      raptor_free_memory(given);
    }
    return reinterpret_cast<unsigned char*>(name);
  }
};

RaptorParser::RaptorParser(const syntax::FileLimits& limits, syntax::Syntax syntax)
    : world_(std::make_unique<World>(limits)) {
  xmlSetExternalEntityLoader(no_external_entity);
  raptor_world* world = raptor_new_world();
  if (world == nullptr) return;
  raptor_world_set_flag(world, RAPTOR_WORLD_FLAG_WWW_SKIP_INIT_FINISH, 1);
  // We intern for ourselves; raptor's tree of all URIs costs a sixth of its time. Its N-Triples reader forgets the
  // datatype of every literal, and only the tree remembers.
  raptor_world_set_flag(world, RAPTOR_WORLD_FLAG_URI_INTERNING, syntax == syntax::Syntax::n_triples ? 1 : 0);
  raptor_world_set_log_handler(world, world_.get(), World::on_log);
  raptor_world_set_generate_bnodeid_handler(world, world_.get(), World::on_blank);
  if (raptor_world_open(world) != 0) {
    raptor_free_world(world);
    return;
  }
  // Opening libxml2 may have put its own loader back.
  xmlSetExternalEntityLoader(no_external_entity);
  world_->world = world;
}

RaptorParser::~RaptorParser() {
  if (world_->world != nullptr) raptor_free_world(world_->world);
}

const std::vector<std::pair<std::string, std::string>>& RaptorParser::prefixes() const { return world_->prefixes; }
const std::vector<Passed>& RaptorParser::passed() const { return world_->passed; }
std::uint64_t RaptorParser::triple_count() const { return world_->triples; }

bool RaptorParser::World::parse(std::string_view chunk, bool is_end) {
  if (has_failed()) return false;
  const auto* bytes = reinterpret_cast<const unsigned char*>(chunk.data());
  if (raptor_parser_parse_chunk(parser, chunk.empty() ? nullptr : bytes, chunk.size(), is_end ? 1 : 0) == 0)
    return !has_failed();
  if (!has_failed()) fail("cannot be parsed");
  return false;
}

void RaptorParser::World::parse_piece(std::size_t number) {
  const std::vector<Piece>& parts = file->layout.pieces.parts();
  const std::string_view view = file->bytes.view();
  const Piece& piece = parts[number];
  const bool is_last = number + 1 == parts.size();
  const std::size_t end = is_last ? view.size() : parts[number + 1].begin;
  const std::size_t preamble = file->layout.pieces.preamble();
  if (number > 0 && !parse(base::without_mark(view.substr(0, preamble)), false)) return;
  // The preamble stays, because the other pieces need it, too.
  std::size_t released = std::max(piece.begin, preamble);
  std::size_t at = number == 0 ? view.size() - base::without_mark(view).size() : piece.begin;
  while (at < end) {
    const std::size_t next = std::min(at + piece_bytes, end);
    if (!parse(view.substr(at, next - at), false)) return;
    released = file->bytes.release(released, next);
    at = next;
  }
  if (!is_last && !parse(file->layout.pieces.closing(), false)) return;
  if (!parse({}, true) || file->syntax != syntax::Syntax::n_triples) return;
  // Raptor's N-Triples reader may skip what it does not understand. One that counts with it makes sure.
  const std::size_t expected = (is_last ? file->layout.lines.size() : parts[number + 1].triples) - piece.triples;
  if (triples != expected)
    fail("holds " + std::to_string(expected) + " triples, of which " + std::to_string(triples) +
         " can be read: check its quotation marks");
}

std::optional<syntax::LoadError> RaptorParser::read(const FileText& text, std::size_t piece, Graph& graph) {
  World& state = *world_;
  syntax::LoadError short_of_memory{{}, 0, "cannot be read: Redland does not start, memory is short"};
  if (state.world == nullptr) return short_of_memory;
  const Piece& part = text.layout.pieces.parts()[piece];
  state.graph = &graph;
  state.file = &text;
  state.blank_letters = piece == 0 ? "g" : 'g' + std::to_string(piece) + '_';
  state.line_shift = piece == 0 ? 0 : std::int64_t{part.line} - 1 - text.layout.pieces.preamble_lines();
  state.place = part.triples;
  state.triples = 0;
  state.generated = 0;
  state.made_up.clear();
  state.recent.forget();
  state.prefixes.clear();
  state.known_prefixes.clear();
  state.passed.clear();
  state.error.reset();
  state.out_of_memory = false;

  forget_namespace_depths();
  state.parser = raptor_new_parser(state.world, parser_name(text.syntax));
  raptor_uri* base = raptor_new_uri(state.world, reinterpret_cast<const unsigned char*>(text.base_iri.c_str()));
  if (state.parser == nullptr || base == nullptr) {
    state.error = short_of_memory;
  } else {
    raptor_parser_set_statement_handler(state.parser, &state, World::on_statement);
    raptor_parser_set_namespace_handler(state.parser, &state, World::on_namespace);
    raptor_parser_set_option(state.parser, RAPTOR_OPTION_NO_NET, nullptr, 1);
    raptor_parser_set_option(state.parser, RAPTOR_OPTION_NO_FILE, nullptr, 1);
    raptor_parser_set_option(state.parser, RAPTOR_OPTION_LOAD_EXTERNAL_ENTITIES, nullptr, 0);
    if (raptor_parser_parse_start(state.parser, base) == 0) {
      state.parse_piece(piece);
    } else if (!state.has_failed()) {
      state.fail("cannot be parsed");
    }
    if (state.out_of_memory) state.fail("needs more memory than there is");
  }
  if (base != nullptr) raptor_free_uri(base);
  if (state.parser != nullptr) raptor_free_parser(state.parser);
  state.parser = nullptr;
  state.file = nullptr;
  return std::move(state.error);
}

}  // namespace geminga::rdf
