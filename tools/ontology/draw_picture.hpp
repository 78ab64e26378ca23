// What a picture of a taxonomy shows: which boxes, with which names, below which others.
#ifndef GEMINGA_ONTOLOGY_DRAW_PICTURE_HPP
#define GEMINGA_ONTOLOGY_DRAW_PICTURE_HPP

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "reasoning/compiled/ontology.hpp"
#include "reasoning/el/classify.hpp"

namespace geminga::ontology {

enum class BoxKind : std::uint8_t {
  one,            ///< a class
  several,        ///< classes that are equivalent
  unsatisfiable,  ///< a class that can have no instance, where its axioms put it
  hidden,         ///< stands for classes that are too deep to be shown
  leaves,         ///< classes below the same one that nothing is below, each with its equivalents, in a list
};

struct Box {
  std::string id;  ///< "c17": the number of the class
  BoxKind kind = BoxKind::one;
  std::vector<std::string> names;    ///< of hidden ones: none
  std::size_t hidden_count = 0;      ///< how many classes a hidden one stands for
  std::vector<std::string> parents;  ///< ids of boxes in the picture
};

/// Boxes in the order of classes, a hidden one behind the box that it is below.
using Picture = std::vector<Box>;

/// The classes below `root`, itself included, or all but owl:Thing without it. With a depth no more than as many edges
/// below the root, or below owl:Thing. Unsatisfiable classes are below everything; they are drawn below the classes
/// that axioms name right above them.
[[nodiscard]] Picture make_picture(const owl::Ontology& source, const taxonomy::Classification& classification,
                                   const compiled::Ontology& ontology, std::optional<taxonomy::ClassNumber> root,
                                   std::optional<unsigned> depth);

/// The same picture with leaves that have the same parent in one box, where they are at least three. What has several
/// parents stands in the list of each, or, where one of these lists would be shorter, in none: edges that cross the
/// whole picture are what one cannot read.
[[nodiscard]] Picture with_lists_of_leaves(Picture picture);

/// The picture for Graphviz and for Mermaid.
[[nodiscard]] std::string as_dot(const Picture& picture);
[[nodiscard]] std::string as_mermaid(const Picture& picture);

}  // namespace geminga::ontology

#endif
