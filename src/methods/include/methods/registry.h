#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "methods/method.h"

namespace taut {

/// Every method, in the order in which lists, charts and tests show them.
std::span<const Method> all_methods();

/// The method of that name, or nullptr.
const Method* find_method(std::string_view name);

/// The same; throws BadRequest, naming the nearest one, where there is none.
const Method& method_called(std::string_view name);

/// The parameter of that name of a method, or nullptr.
const Param* find_param(const Method& method, std::string_view name);

/// Fills in the defaults of what `given` leaves out. Throws BadRequest for a method or parameter that does
/// not exist (naming the nearest one) and for values out of range.
Settings complete_settings(const Settings& given);
/// The same for a method at hand, which need not be one of all_methods(); the settings then bear its name.
Settings complete_settings(const Method& method, const Settings& given);

/// What is wrong with one value for a parameter, as a sentence with the range or the choices; empty when it
/// is fine.
std::string param_problem(const Param& param, const std::variant<double, std::string>& value);

/// About how much memory (bytes) a step by the method takes beside model and states (Method::memory).
double memory_of_step(const Method& method, const Model& model);

/// What the model needs that the method can't do, one sentence each, naming the methods that can; empty when
/// it can do all.
std::vector<std::string> capability_problems(const Model& model, const Method& method);

/// Everything that a method would refuse of a run from a start with complete settings, one sentence each:
/// what it lacks, and what it can't do with these settings or steps. Empty: the run can begin.
std::vector<std::string> refusals(const Model& model, const State& start, const Settings& settings);
std::vector<std::string> refusals(const Method& method, const Model& model, const State& start,
                                  const Settings& settings);

}  // namespace taut
