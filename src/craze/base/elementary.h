// The elementary functions, the same bits on every machine.
#pragma once

/// Functions of one's own in place of the mathematical library's, which differ from one library,
/// compiler and machine to the next. They are built from + − × ÷ √, comparisons and bits alone,
/// each of which IEEE 754 rounds in one way only; so compile them, and what calls them, without
/// contraction (-ffp-contract=off) and without -ffast-math.
///
/// Each holds for all arguments, zeros, infinities, NaN and subnormal ones included, and gives
/// there what C's Annex F asks for. Errors are in units of the last place of the result, away from
/// the exact value; the tests measure them against a wider type.
namespace craze::elementary {

/// eˣ, within 1 unit.
double exp(double x);
/// Natural logarithm, within 1 unit; NaN below 0.
double log(double x);
/// xʸ, within 1 unit. x < 0 has a power where y is an integer, NaN elsewhere.
double pow(double x, double y);

/// Of an angle in radians, within 1 unit, however large; NaN for ±∞.
double sin(double x);
double cos(double x);
/// Within 2 units.
double tan(double x);

/// The angle of the point (x, y) from the x axis, in −π … π, within 1 unit.
double atan2(double y, double x);
/// In −π/2 … π/2, within 2 units; NaN outside −1 … 1.
double asin(double x);

/// Error function 2/√π ∫₀ˣ exp(−t²) dt, within 2 units.
double erf(double x);
/// √(x² + y²) without overflow or underflow on the way, within 2 units.
double hypot(double x, double y);

}  // namespace craze::elementary
