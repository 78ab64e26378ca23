// Graphviz as a child process, which turns a graph in its language into SVG on standard output.
#ifndef GEMINGA_ONTOLOGY_PICTURE_GRAPHVIZ_HPP
#define GEMINGA_ONTOLOGY_PICTURE_GRAPHVIZ_HPP

#include <sys/types.h>

#include <string_view>

namespace geminga::ontology {

class Graphviz {
 public:
  /// Starts the program dot, which waits for its input. False where there is none. To be called before the cage is
  /// closed, which lets no program start.
  bool start();
  /// Gives dot the text and waits for its end. False where it failed.
  [[nodiscard]] bool draw(std::string_view text) const;

 private:
  int input_ = -1;
  pid_t child_ = 0;
};

}  // namespace geminga::ontology

#endif
