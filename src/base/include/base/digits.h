#pragma once

#include <string>

namespace taut {

/// A number that is not negative, with two digits that matter, written out from 1 upwards: "0.058", "3.7",
/// "1500".
std::string two_digits(double number);

/// A share that is not negative in per cent, the same: "0.58 %"; "below 0.0001 %" where it is less.
std::string percent(double share);

/// A positive number as shortly as %g writes it, but powers of ten as people do: "0.01", "10⁻⁶", "3·10⁻⁸".
std::string with_power_of_ten(double number);

}  // namespace taut
