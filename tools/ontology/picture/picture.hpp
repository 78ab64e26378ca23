// A picture of a taxonomy: its boxes, their names, and the boxes right above each.
#ifndef GEMINGA_ONTOLOGY_PICTURE_PICTURE_HPP
#define GEMINGA_ONTOLOGY_PICTURE_PICTURE_HPP

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "reasoning/compiled/ontology.hpp"
#include "reasoning/taxonomy/classification.hpp"

namespace geminga::ontology {

enum class BoxKind : std::uint8_t {
  one,            ///< a class
  several,        ///< classes that are equivalent
  unsatisfiable,  ///< a class that can have no instance, below the classes that its axioms name
  hidden,         ///< stands for classes that are too deep to be shown
  leaves,         ///< a list of classes without subclasses below the same class, each with its equivalents
};

struct Box {
  std::string id;  ///< "c17": the number of the class
  BoxKind kind = BoxKind::one;
  std::vector<std::string> names;    ///< a hidden box has none
  std::size_t hidden_count = 0;      ///< the classes that a hidden box stands for
  std::vector<std::string> parents;  ///< ids of boxes in the picture
};

/// Boxes in the order of classes. A hidden box follows the box that it is below.
using Picture = std::vector<Box>;

/// Draws `root` and the classes below it, or all classes but owl:Thing. A depth bounds the edges below the root, or
/// below owl:Thing. Unsatisfiable classes are below everything; they are drawn below the classes that axioms name right
/// above them.
[[nodiscard]] Picture make_picture(const owl::Ontology& source, const taxonomy::Classification& classification,
                                   const compiled::Ontology& ontology, std::optional<taxonomy::ClassNumber> root,
                                   std::optional<unsigned> depth);

/// Puts leaves with the same parent into one box, where there are at least three. A leaf with several parents stands in
/// the list of each, or, where one of these lists would be shorter than three, in none. So fewer edges cross the
/// picture.
[[nodiscard]] Picture with_lists_of_leaves(Picture picture);

/// Writes the picture in the language of Graphviz, or of Mermaid.
[[nodiscard]] std::string as_dot(const Picture& picture);
[[nodiscard]] std::string as_mermaid(const Picture& picture);

}  // namespace geminga::ontology

#endif
