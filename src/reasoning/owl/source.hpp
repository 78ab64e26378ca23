// An ontology as readers fill it and the reasoner reads it: terms, axioms with file and line, labels, prefixes, files,
// and what was left out. See reasoning/owl/axiom.hpp for an example.
#ifndef GEMINGA_REASONING_OWL_SOURCE_HPP
#define GEMINGA_REASONING_OWL_SOURCE_HPP

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/interner.hpp"
#include "reasoning/owl/axiom.hpp"
#include "reasoning/owl/conversion.hpp"

namespace geminga::owl {

struct Fingerprint;
struct LoadedFile;
enum class UnitWord : std::uint8_t;

/// The most that one ontology may hold. Beyond any of them problem() says so, and what is added is ignored.
struct SourceLimits {
  std::size_t name_bytes = std::size_t{1} << 16;      ///< of one IRI or label; longer names are a problem
  std::size_t literal_bytes = std::size_t{1} << 20;   ///< of one lexical form
  std::size_t all_name_bytes = std::size_t{1} << 29;  ///< of all names together
  std::size_t terms = std::size_t{1} << 23;           ///< different terms
  std::size_t arguments = std::size_t{1} << 24;       ///< arguments of all terms, and of all axioms
  std::size_t axioms = std::size_t{1} << 23;
  std::size_t files = 10'000;
  std::size_t conversions = max_conversions;
  /// Levels of nested class expressions; an axiom with more is left out and named, it is not a problem.
  std::uint32_t nesting = 500;
};

/// owl:Thing and owl:Nothing have these numbers in every source.
inline constexpr TermId thing_term{0};
inline constexpr TermId nothing_term{1};

/// The construct under which an axiom with an ill-typed literal is left out.
inline constexpr std::string_view ill_typed_literal = "a literal that is not of its datatype";
/// The construct under which an axiom with a facet outside of the facet space of its datatype is left out.
inline constexpr std::string_view foreign_facet = "a facet or bound that its datatype does not have";
/// Whether axioms that are left out under this construct are among the ill-typed ones.
[[nodiscard]] constexpr bool is_ill_typed(std::string_view construct) {
  return construct == ill_typed_literal || construct == foreign_facet;
}
/// The remark about an axiom that read_leniently() takes in.
inline constexpr std::string_view read_as_number = "a bound or literal of another datatype, read as the number";

/// An ontology as it was read, in no particular order. Only appended to; ids stay valid. Not thread-safe.
class Ontology {
 public:
  struct Label {
    NameId entity{};
    NameId text{};
    NameId language{};  ///< the empty name: none
  };
  struct Conversion {
    NameId from{};
    NameId to{};
    std::uint32_t cost = usual_conversion_cost;  ///< 1 to max_conversion_cost
    FileId file{};
    std::uint32_t line = 0;
  };
  struct UnitStatement {
    NameId subject{};
    UnitWord word{};
    NameId value{};
    FileId file{};
    std::uint32_t line = 0;
  };
  struct Prefix {
    NameId prefix{};  ///< without the colon
    NameId iri{};
  };
  struct Omission {
    NameId construct{};
    FileId file{};
    std::uint32_t line = 0;
    std::uint32_t count = 1;
    /// Each line, in the order of reading, the first most_noted_lines of them.
    std::vector<std::uint32_t> lines{};
  };
  static constexpr std::size_t most_noted_lines = 1000;

  explicit Ontology(const SourceLimits& limits = {});
  Ontology(const Ontology&);
  Ontology(Ontology&&) noexcept;
  Ontology& operator=(const Ontology&);
  Ontology& operator=(Ontology&&) noexcept;
  ~Ontology();

  /// From here on a bound or literal of another numeric datatype is read as the number that it writes, with the remark
  /// `read_as_number` at the first axiom that has it: xsd:double[<= "1"^^xsd:integer], "5.0"^^xsd:integer.
  void read_leniently() { is_lenient_ = true; }

  /// Files are numbered in the order in which they are added. `ontology_iri` may be set later.
  FileId add_file(std::string_view path, std::string_view ontology_iri = {});
  void set_ontology_iri(FileId file, std::string_view ontology_iri);
  /// Sets the fingerprint of what the file held when it was read. It tells whether a compiled form is out of date.
  void set_content(FileId file, const Fingerprint& content);

  // Entities. These calls do not declare them: a class that no axiom names is not in the ontology.
  TermId named_class(std::string_view iri) { return entity(TermKind::named_class, iri); }
  TermId object_property(std::string_view iri) { return entity(TermKind::object_property, iri); }
  TermId data_property(std::string_view iri) { return entity(TermKind::data_property, iri); }
  TermId annotation_property(std::string_view iri) { return entity(TermKind::annotation_property, iri); }
  TermId datatype(std::string_view iri) { return entity(TermKind::datatype, iri); }
  TermId individual(std::string_view iri) { return entity(TermKind::individual, iri); }
  /// `label` must be unique to the blank node among all files.
  TermId anonymous_individual(std::string_view label) { return entity(TermKind::anonymous_individual, label); }
  /// A term of any kind that consists of a name.
  TermId entity(TermKind kind, std::string_view name);
  /// A literal. An ill-typed literal, whose lexical form is not of its datatype, is no term of OWL 2 (Structural
  /// Specification, section 4): an axiom that holds one is left out and named. An empty datatype means xsd:string, or
  /// rdf:langString if there is a language.
  TermId literal(std::string_view lexical, std::string_view datatype_iri, std::string_view language = {});
  TermId facet(std::string_view facet_iri, TermId value);
  /// An atom of a rule whose built-in has this IRI. `arguments` are literals and variables.
  TermId built_in(std::string_view iri, std::span<const TermId> arguments);
  /// A term of any kind, with the parts that another source or a compiled ontology has for it.
  TermId copy(TermKind kind, std::string_view name, std::uint32_t number, std::span<const TermId> arguments);
  /// Copies a term of another source, with everything in it.
  TermId copy(const Ontology& from, TermId id);
  /// A property, class or data range expression. Its arguments must be terms of this source, and of the number and
  /// kinds that the comment of its kind gives; see is_well_formed(). `number` is that of a cardinality.
  TermId term(TermKind kind, std::span<const TermId> arguments, std::uint32_t number = 0);
  TermId term(TermKind kind, std::initializer_list<TermId> arguments, std::uint32_t number = 0) {
    return term(kind, std::span<const TermId>(arguments.begin(), arguments.size()), number);
  }

  /// Adds an axiom. If its arguments are not of the kinds that it needs (a literal for a class), it is left out and
  /// named.
  void add(AxiomKind kind, std::span<const TermId> arguments, FileId file, std::uint32_t line);
  void add(AxiomKind kind, std::initializer_list<TermId> arguments, FileId file, std::uint32_t line) {
    add(kind, std::span<const TermId>(arguments.begin(), arguments.size()), file, line);
  }
  void add_label(std::string_view entity_iri, std::string_view text, std::string_view language = {});
  /// That one representation can be turned into another (reasoning/owl/conversion.hpp). Of two statements about one
  /// pair the lower cost counts. `cost` is as it is written, empty where none is; one that is no whole number from 1 to
  /// max_conversion_cost is left out with its conversion, and named with its line; 0: that of the conversion.
  void add_conversion(std::string_view from_iri, std::string_view to_iri, std::string_view cost, FileId file,
                      std::uint32_t line, std::uint32_t cost_line = 0);
  /// Adds an annotation or, in RDF, a triple about a named thing: in a word of unit_word(), or that it is of a class of
  /// units. `value` is an IRI or a lexical form. units_of() reads the units from all of them.
  void add_unit_statement(std::string_view subject_iri, UnitWord word, std::string_view value, FileId file,
                          std::uint32_t line);
  void add_prefix(std::string_view prefix, std::string_view iri);
  /// Notes something that was read and that no axiom can express. `construct` is a short name like "owl:onProperties".
  void leave_out(std::string_view construct, FileId file, std::uint32_t line, std::uint32_t count = 1);
  /// Notes something that is not as OWL 2 has it and costs no axiom: a bound that is read as a number of its datatype.
  void remark(std::string_view text, FileId file, std::uint32_t line, std::uint32_t count = 1);

  /// Why this ontology must be refused: one line that names the limit. Nothing if no limit was exceeded.
  [[nodiscard]] const std::optional<std::string>& problem() const { return problem_; }

  [[nodiscard]] std::string_view name(NameId id) const;
  [[nodiscard]] std::optional<NameId> find_name(std::string_view name) const;
  /// A name that nothing has: this one, with hyphens behind it where that is taken.
  [[nodiscard]] std::string unused_name(std::string_view name) const;
  [[nodiscard]] Term term(TermId id) const;
  /// Whether no literal in it is ill-typed, and no facet foreign to its datatype.
  [[nodiscard]] bool is_well_typed(TermId id) const { return !is_ill_typed(terms_[static_cast<std::size_t>(id)].form); }
  /// Fetches a term into the cache.
  void prefetch(TermId id) const { __builtin_prefetch(&terms_[static_cast<std::size_t>(id)]); }
  [[nodiscard]] TermKind kind(TermId id) const { return terms_[static_cast<std::size_t>(id)].kind; }
  /// The name of an entity, literal, language tag or facet.
  [[nodiscard]] std::string_view name_of(TermId id) const { return name(terms_[static_cast<std::size_t>(id)].name); }
  /// Levels of arguments under a term; 0 for entities.
  [[nodiscard]] std::uint32_t depth(TermId id) const { return terms_[static_cast<std::size_t>(id)].depth; }
  [[nodiscard]] std::size_t name_count() const { return name_ends_.size(); }
  [[nodiscard]] std::size_t term_count() const { return terms_.size(); }
  [[nodiscard]] std::size_t axiom_count() const { return axioms_.size(); }
  [[nodiscard]] Axiom axiom(std::size_t index) const { return axiom_of(axioms_[index]); }
  /// Axioms that were left out only because a literal in them is ill-typed, or a facet foreign to its datatype.
  [[nodiscard]] std::size_t ill_typed_count() const { return ill_typed_.size(); }
  [[nodiscard]] Axiom ill_typed(std::size_t index) const { return axiom_of(ill_typed_[index]); }
  [[nodiscard]] std::span<const Label> labels() const { return labels_; }
  /// Of different pairs, in the order of reading.
  [[nodiscard]] std::span<const Conversion> conversions() const { return conversions_; }
  /// In the order of reading, no more than a few beyond max_unit_statements.
  [[nodiscard]] std::span<const UnitStatement> unit_statements() const { return unit_statements_; }
  [[nodiscard]] std::span<const Prefix> prefixes() const { return prefixes_; }
  [[nodiscard]] std::span<const LoadedFile> files() const;
  [[nodiscard]] std::span<const Omission> omissions() const { return omissions_; }
  /// The notes of remark(), one record for each text and file.
  [[nodiscard]] std::span<const Omission> remarks() const { return remarks_; }

 private:
  /// The worst form among a term and its arguments.
  enum class Form : std::uint8_t { good, ill_typed, foreign, malformed };
  [[nodiscard]] static constexpr bool is_ill_typed(Form form) {
    return form == Form::ill_typed || form == Form::foreign;
  }
  struct TermRecord {
    TermKind kind;
    Form form;  ///< of it and everything in it
    std::uint16_t depth;
    NameId name;
    std::uint32_t number;
    std::uint32_t begin;
    std::uint32_t count;
  };
  struct AxiomRecord {
    AxiomKind kind;
    std::uint32_t begin;
    std::uint32_t count;
    FileId file;
    std::uint32_t line;
  };

  [[nodiscard]] Axiom axiom_of(const AxiomRecord& record) const {
    return {record.kind, record.file, record.line, std::span(axiom_arguments_).subspan(record.begin, record.count)};
  }
  NameId intern(std::string_view name, std::size_t max_bytes);
  TermId intern_term(TermKind kind, NameId name, std::uint32_t number, std::span<const TermId> arguments);
  [[nodiscard]] Form own_form(TermKind kind, NameId name, std::span<const TermId> arguments);
  [[nodiscard]] bool is_of_its_datatype(std::string_view lexical, std::span<const TermId> arguments) const;
  void note(std::vector<Omission>& notes, std::string_view text, FileId file, std::uint32_t line, std::uint32_t count);
  void fail(std::string text);
  [[nodiscard]] std::span<const TermKind> kinds_of(std::span<const TermId> arguments);

  SourceLimits limits_;
  std::optional<std::string> problem_;
  std::vector<char> name_bytes_;
  std::vector<std::uint32_t> name_ends_;
  base::NumberTable name_table_;
  std::vector<std::uint32_t> entity_of_name_;  ///< the last entity of each name
  std::vector<TermRecord> terms_;
  std::vector<TermId> term_arguments_;
  std::vector<TermKind> kinds_;  ///< room for kinds_of()
  base::NumberTable term_table_;
  std::vector<AxiomRecord> axioms_;
  std::vector<AxiomRecord> ill_typed_;
  std::vector<TermId> axiom_arguments_;
  std::vector<Label> labels_;
  std::vector<Conversion> conversions_;
  std::vector<UnitStatement> unit_statements_;
  std::vector<Prefix> prefixes_;
  std::vector<LoadedFile> files_;
  std::vector<Omission> omissions_;
  std::vector<Omission> remarks_;
  bool is_lenient_ = false;
  std::uint32_t lenient_readings_ = 0;  ///< since the last axiom
};

/// These terms and everything in them, each once. Written out as a tree, one part can occur 2^60 times.
[[nodiscard]] std::vector<TermId> terms_in(const Ontology& source, std::span<const TermId> roots);

/// Whether a term of this kind may stand where a class expression, property expression, data range or individual is
/// needed.
[[nodiscard]] bool is_class_expression(TermKind kind);
[[nodiscard]] bool is_object_property_expression(TermKind kind);
[[nodiscard]] bool is_data_range(TermKind kind);
[[nodiscard]] bool is_individual(TermKind kind);

/// Whether a term or axiom of this kind may have arguments of these kinds. Readers need not ask: term() marks what is
/// not well-formed, and add() leaves out an axiom that holds such a term.
[[nodiscard]] bool is_well_formed(TermKind kind, std::span<const TermKind> arguments);
[[nodiscard]] bool is_well_formed(AxiomKind kind, std::span<const TermKind> arguments);

}  // namespace geminga::owl

#endif
