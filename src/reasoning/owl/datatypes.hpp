// The datatypes of OWL 2 and the values of literals: which type holds which value, which type is part of which, which
// have no value in common.
#ifndef GEMINGA_REASONING_OWL_DATATYPES_HPP
#define GEMINGA_REASONING_OWL_DATATYPES_HPP

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace geminga::owl {

inline constexpr std::string_view xsd_namespace = "http://www.w3.org/2001/XMLSchema#";
inline constexpr std::string_view rdf_namespace = "http://www.w3.org/1999/02/22-rdf-syntax-ns#";
inline constexpr std::string_view xsd_decimal = "http://www.w3.org/2001/XMLSchema#decimal";
/// The datatype of all values.
inline constexpr std::string_view rdfs_literal = "http://www.w3.org/2000/01/rdf-schema#Literal";

/// Value spaces that have nothing in common (OWL 2 structural specification, section 4).
enum class DataFamily : std::uint8_t { number, text, double_, float_, boolean, hex, base64, uri, time, xml };
inline constexpr std::size_t data_family_count = 10;

/// A datatype of OWL 2. Of other datatypes nothing is known.
class Datatype {
 public:
  [[nodiscard]] static std::optional<Datatype> find(std::string_view iri);

  [[nodiscard]] DataFamily family() const;
  /// Whether every value of this one is one of `other`. Exact.
  [[nodiscard]] bool is_within(Datatype other) const;
  /// Whether they have no value in common. Exact.
  [[nodiscard]] bool is_disjoint(Datatype other) const;
  /// Whether it has finitely many values. OWL 2 EL excludes such types, because they are unions of their literals.
  [[nodiscard]] bool is_finite() const;

  friend bool operator==(Datatype, Datatype) = default;

 private:
  friend struct DataValue;
  explicit Datatype(std::uint8_t row) : row_(row) {}
  std::uint8_t row_;
};

/// The value of a literal.
struct DataValue {
  DataFamily family = DataFamily::text;
  /// Equal for equal values of a family. For numbers: sign, digits, and a point only before a fraction.
  std::string canonical;
  /// Whether different canonical forms are certainly different values.
  bool is_exact = true;

  /// Nothing for an unknown datatype; `is_ill_formed` says that the lexical form is not of its datatype.
  [[nodiscard]] static std::optional<DataValue> read(std::string_view lexical, std::string_view datatype_iri,
                                                     std::string_view language, bool& is_ill_formed);
  /// Exact where the value is exact. Otherwise true is certain and false is not.
  [[nodiscard]] bool is_in(Datatype type) const;
};

}  // namespace geminga::owl

#endif
