#include "reasoning/syntax/graph/terms/world.hpp"

#include <cstdlib>
#include <utility>

#include "base/text.hpp"

namespace geminga::graph {

World::World() {
  // librdf would load every storage that is installed. It is asked for none but its own, in memory.
  ::setenv("REDLAND_MODULE_PATH", "/var/empty/geminga", 1);
  world_ = librdf_new_world();
  if (world_ == nullptr) return;
  librdf_world_set_logger(world_, this, on_message);
  librdf_world_open(world_);
  // The libraries below would write to standard error.
  raptor_world_set_log_handler(raptor(), this, on_parser_message);
  rasqal_world_set_log_handler(rasqal(), this, on_parser_message);
}

World::~World() {
  if (world_ != nullptr) librdf_free_world(world_);
}

std::string World::take_error() { return std::exchange(error_, {}); }

int World::on_message(void* world, librdf_log_message* message) {
  if (librdf_log_message_level(message) >= LIBRDF_LOG_ERROR)
    static_cast<World*>(world)->take(librdf_log_message_message(message));
  return 1;
}

void World::on_parser_message(void* world, raptor_log_message* message) {
  if (message->level >= RAPTOR_LOG_LEVEL_ERROR) static_cast<World*>(world)->take(message->text);
}

void World::take(const char* words) {
  if (error_.empty() && words != nullptr) error_ = base::printable(words, 400);
}

}  // namespace geminga::graph
