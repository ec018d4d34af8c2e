#pragma once

#include "model/model.h"

namespace taut {

/// About how much memory (bytes) a factor takes that has a row for each link, beside the model and what
/// moves: next to none for chains and trees, for sheets as the pairs of links that share a mass, times log₂
/// of the rows (George, Nested dissection of a regular finite element mesh, 1973). Fitted to sheets of 64² to
/// 1024² masses with and without diagonals, by what the program's peak rises; a net that fills space takes
/// more.
double bytes_of_links_factor(const Model& model);

/// The same where only rigid links have rows.
double bytes_of_rigid_links_factor(const Model& model);

/// The same of a factor with three rows for each mass, and `bytes` for each link, times log₂ of the masses,
/// in a net; half of that in a chain or a tree.
double bytes_of_masses_factor(const Model& model, double bytes);

}  // namespace taut
