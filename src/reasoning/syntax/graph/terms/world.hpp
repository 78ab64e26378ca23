// librdf, opened once and restricted: it loads no plug-in and opens no file and no connection.
#ifndef GEMINGA_REASONING_SYNTAX_GRAPH_TERMS_WORLD_HPP
#define GEMINGA_REASONING_SYNTAX_GRAPH_TERMS_WORLD_HPP

#include <librdf.h>

#include <string>

namespace geminga::graph {

/// librdf's world with its last message. Only files of graph/ and its rooms include this one.
class World {
 public:
  World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;
  ~World();

  [[nodiscard]] bool is_open() const { return world_ != nullptr; }
  [[nodiscard]] librdf_world* redland() const { return world_; }
  [[nodiscard]] raptor_world* raptor() const { return librdf_world_get_raptor(world_); }
  [[nodiscard]] rasqal_world* rasqal() const { return librdf_world_get_rasqal(world_); }
  /// The first error since the last call, in one line. Empty if there was none.
  [[nodiscard]] std::string take_error();

 private:
  static int on_message(void* world, librdf_log_message* message);
  static void on_parser_message(void* world, raptor_log_message* message);
  void take(const char* words);

  librdf_world* world_ = nullptr;
  std::string error_;
};

/// A view of a text that Redland returns.
[[nodiscard]] inline const unsigned char* octets(const std::string& text) {
  return reinterpret_cast<const unsigned char*>(text.c_str());
}

}  // namespace geminga::graph

#endif
