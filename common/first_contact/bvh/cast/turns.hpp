#pragma once
#include <array>
#include <optional>
#include <span>

#include "first_contact/bvh/cast/sphere_cast.hpp"

namespace first_contact::bvh {

//! [turns]
/// Casts in turns. All that pause at the same kind of place make one step each, one kind after the other:
/// while memory is on its way to one, others go on, and a processor guesses well what it has just done.
class Turns {
 public:
  /// \param first  as many as `moving`
  Turns(std::span<const Moving<Sphere>> moving, const Parts& parts, std::span<std::optional<Contact>> first)
      : moving_(moving), parts_(parts), first_(first) {}

  /// All of them, to the end.
  void run() {
    for (Turn& turn : turns_) begin(turn);
    while (under_way_ > 0) {
      each(Pause::end, [&](Turn& turn) { finish(turn); });
      each(Pause::node, [&](Turn& turn) { add(turn, turn.cast->visit_node()); });
      each(Pause::leaf, [&](Turn& turn) { add(turn, turn.cast->visit_leaf()); });
      each(Pause::corners, [&](Turn& turn) { add(turn, turn.cast->decide()); });
      each(Pause::survivors, [&](Turn& turn) { add(turn, turn.cast->fetch_corners()); });
    }
  }

 private:
  static constexpr std::size_t at_once = 12;

  struct Turn {
    std::optional<SphereCast> cast;
    std::size_t number;
  };
  struct Line {
    std::array<Turn*, at_once> turns;
    std::size_t length = 0;
  };

  void add(Turn& turn, Pause pause) {
    Line& line = lines_[static_cast<std::size_t>(pause)];
    line.turns[line.length++] = &turn;
  }
  template <class Step>
  void each(Pause pause, const Step& step) {
    Line& line = lines_[static_cast<std::size_t>(pause)];
    const Line now = line;
    line.length = 0;
    for (std::size_t i = 0; i < now.length; ++i) step(*now.turns[i]);
  }

  void begin(Turn& turn) {
    if (next_ == moving_.size()) return;
    turn.number = next_++;
    turn.cast.emplace(moving_[turn.number], parts_, parts_.walker);
    ++under_way_;
    add(turn, turn.cast->begin());
  }
  void finish(Turn& turn) {
    if (!turn.cast->finish()) return add(turn, turn.cast->begin());
    first_[turn.number] = turn.cast->contact();
    --under_way_;
    begin(turn);
  }

  std::span<const Moving<Sphere>> moving_;
  const Parts& parts_;
  std::span<std::optional<Contact>> first_;
  std::array<Turn, at_once> turns_;
  std::array<Line, 5> lines_;  // one a kind of pause
  std::size_t next_ = 0, under_way_ = 0;
};
//! [turns]

}  // namespace first_contact::bvh
