// Lengths as people write them: in the mesh's own unit, in one of the world's, or as a part of the
// object.
#pragma once

#include <stdexcept>

namespace craze {

enum class LengthUnit {
  own,  ///< the mesh's: a bare number
  micrometre,
  millimetre,
  centimetre,
  metre,
  kilometre,
  inch,
  foot,
  percent,  ///< of the diagonal of the box around the object
};

/// A number and its unit. A run begins by making them all own (recipe/own_lengths.h); from then on
/// a length serves as the number that it is.
class Length {
 public:
  Length(double number = 0, LengthUnit unit = LengthUnit::own)  // NOLINT: a bare number is a length
      : number_(number), unit_(unit) {}

  double number() const { return number_; }
  LengthUnit unit() const { return unit_; }

  /// In the mesh's own unit. Throws std::logic_error where the unit is another one.
  operator double() const {  // NOLINT
    if (unit_ != LengthUnit::own) throw std::logic_error("a length is used in a unit not its own");
    return number_;
  }

 private:
  double number_;
  LengthUnit unit_;
};

}  // namespace craze
