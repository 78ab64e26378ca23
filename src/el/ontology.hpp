// A classified ontology as the daemon sees it: names, subsumption and axioms, read from its compiled form.
#ifndef GEMINGA_EL_ONTOLOGY_HPP
#define GEMINGA_EL_ONTOLOGY_HPP

#include <cstddef>
#include <cstdint>
#include <expected>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "el/fingerprint.hpp"

namespace geminga::el {

/// The dense number of a named class in one ontology, [0, class_count). Numbers of different ontologies have nothing in
/// common.
enum class ClassNumber : std::uint32_t {};

/// Why a name could not be resolved. `text` is one line that says what to do, for a user.
struct NameError {
  enum class Kind { malformed, unknown, ambiguous } kind = Kind::unknown;
  std::string text;
};

/// A compiled ontology that was refused. `text` says what is wrong and at which offset where there is one.
struct CompiledError {
  std::string text;
};

/// One file that was loaded.
struct LoadedFile {
  std::string path;
  std::string ontology_iri;  ///< empty: the file names none
  Fingerprint content{};     ///< of what was read; not known where the reader did not say
};

/// Axioms of one kind that the reasoner did not use, e.g. {"owl:inverseOf", 12, "soma.owl:17"}.
struct LeftOut {
  std::string construct;
  std::uint32_t count = 0;
  std::string first;  ///< file:line of the first
};

struct CompiledView;
class ModuleIndex;

/// An immutable classified ontology over a compiled form. Movable, not copyable; safe to read from many threads.
/// Every string_view and span points into the compiled form and lives as long as the ontology.
class Ontology {
 public:
  /// Maps a compiled file, checks its version, checksum and every number in it. Cost: linear in the file, no parsing.
  [[nodiscard]] static std::expected<Ontology, CompiledError> map(const std::string& path);
  /// The same over bytes in memory.
  [[nodiscard]] static std::expected<Ontology, CompiledError> from_bytes(std::vector<std::byte> bytes);

  Ontology(Ontology&&) noexcept;
  Ontology& operator=(Ontology&&) noexcept;
  ~Ontology();

  /// A digest of the axioms and names: equal on every host that loaded the same ontologies, whatever their order or
  /// format.
  [[nodiscard]] std::uint64_t digest() const;
  [[nodiscard]] std::uint32_t class_count() const;
  [[nodiscard]] std::vector<LoadedFile> files() const;
  /// One line for a user where a file that this was compiled from has changed since: "soma.owl has changed since this
  /// was compiled: compile it again". Files that are gone are not asked for; paths are as they were given. Reads the
  /// files, so that a copy or a checkout of the same content is no change.
  [[nodiscard]] std::optional<std::string> stale_source() const;
  [[nodiscard]] std::vector<LeftOut> left_out() const;
  /// False: some individual cannot exist, and every class is below every other.
  [[nodiscard]] bool is_consistent() const;

  /// Resolves `prefix:Name`, `<IRI>`, a bare IRI, or a label where it is unambiguous.
  [[nodiscard]] std::expected<ClassNumber, NameError> find(std::string_view name) const;
  [[nodiscard]] std::optional<ClassNumber> find_iri(std::string_view iri) const;

  [[nodiscard]] std::string_view iri(ClassNumber number) const;
  /// The label, or an empty view.
  [[nodiscard]] std::string_view label(ClassNumber number) const;
  /// `prefix:Name` where a prefix of the ontology fits, else `<IRI>`.
  [[nodiscard]] std::string short_name(ClassNumber number) const;
  /// The same for any IRI, known as a class or not.
  [[nodiscard]] std::string short_name(std::string_view iri) const;

  /// False where the class is subsumed by owl:Nothing.
  [[nodiscard]] bool is_satisfiable(ClassNumber number) const;
  /// Whether every instance of `sub` is one of `super`. Reflexive. O(1) to O(log n).
  [[nodiscard]] bool is_subsumed(ClassNumber sub, ClassNumber super) const;
  [[nodiscard]] bool is_equivalent(ClassNumber a, ClassNumber b) const {
    return is_subsumed(a, b) && is_subsumed(b, a);
  }
  /// Edges of the shortest way up the taxonomy from `sub` to `super`: 0 for equivalents; nothing where not subsumed.
  [[nodiscard]] std::optional<std::uint32_t> distance(ClassNumber sub, ClassNumber super) const;
  /// Every named class that subsumes this one, itself, its equivalents and owl:Thing included, ascending by number.
  [[nodiscard]] std::vector<ClassNumber> subsumers(ClassNumber number) const;
  /// Direct superclasses and subclasses in the reduced taxonomy, one representative a node of equivalents, ascending.
  /// Unsatisfiable classes have neither, and are the children of none.
  [[nodiscard]] std::vector<ClassNumber> parents(ClassNumber number) const;
  [[nodiscard]] std::vector<ClassNumber> children(ClassNumber number) const;

  /// The axioms and everything else, as numbers, for who reasons over them.
  [[nodiscard]] const CompiledView& view() const;
  /// From names to axioms. Built when it is asked for first, once; the cost of that is a pass over all axioms.
  [[nodiscard]] const ModuleIndex& module_index() const;

 private:
  struct Mapped;
  explicit Ontology(std::unique_ptr<const Mapped> mapped);
  std::unique_ptr<const Mapped> mapped_;
};

}  // namespace geminga::el

#endif
