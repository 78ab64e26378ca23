// The values of SPARQL's expressions (SPARQL 1.1 Query Language, section 17): numbers, truth, and order.
#ifndef GEMINGA_REASONING_SYNTAX_GRAPH_FORMULAS_SCALARS_HPP
#define GEMINGA_REASONING_SYNTAX_GRAPH_FORMULAS_SCALARS_HPP

#include <boost/multiprecision/cpp_int.hpp>
#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "reasoning/syntax/graph/axioms/node.hpp"

namespace geminga::graph {

/// A value, or nothing: an error, or a variable that is not bound.
using Scalar = std::optional<Node>;

/// A number with its type. The wider one of two types is that of a result.
struct Numeric {
  enum class Type : std::uint8_t { integer, decimal, single, double_ } type = Type::integer;
  boost::multiprecision::cpp_rational exact;  ///< of an integer or decimal
  double approximate = 0;                     ///< of a float or double
};

/// The number of a literal; nothing for other terms, and for what is no number of its datatype.
[[nodiscard]] std::optional<Numeric> number_of(const Node& node);
/// A number of this type: the same, or the nearest.
[[nodiscard]] Numeric as_type(const Numeric& number, Numeric::Type type);
/// The literal of a number, in the form that XPath writes: a decimal has 18 digits behind the point at most.
[[nodiscard]] Node node_of(const Numeric& number);
/// +, -, * or /. Nothing for a division of exact numbers by zero, and beyond 1000 digits.
[[nodiscard]] std::optional<Numeric> calculate(char operation, const Numeric& a, const Numeric& b);
[[nodiscard]] std::partial_ordering compare(const Numeric& a, const Numeric& b);

[[nodiscard]] Node boolean(bool value);
[[nodiscard]] Node integer(std::int64_t value);
[[nodiscard]] Node text(std::string value);
/// Whether a node is a text without a language.
[[nodiscard]] bool is_text(const Node& node);

/// The effective boolean value (section 17.2.2); nothing where there is none.
[[nodiscard]] std::optional<bool> truth_of(const Node& node);
/// Whether two terms are equal; nothing where that is not known of their datatypes (section 17.3, RDFterm-equal).
[[nodiscard]] std::optional<bool> are_equal(const Node& a, const Node& b);
/// The order of two values of one kind: numbers, texts without a language, truth values, times. Nothing for others.
[[nodiscard]] std::optional<std::partial_ordering> order_of(const Node& a, const Node& b);
/// The order of ORDER BY: what is unbound, blank nodes, IRIs, literals. Total, and of equal terms alone equal.
[[nodiscard]] std::strong_ordering sorted_before(const Scalar& a, const Scalar& b);

}  // namespace geminga::graph

#endif
