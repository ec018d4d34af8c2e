#pragma once

#include <string>

#include "model/model.h"
#include "model/state.h"

namespace taut {

/// First line of the table of masses.
std::string mass_table_header();

/// A line a mass: frame,time,mass,name,x,y,z,vx,vy,vz; SI, every number with as many digits as tell it from
/// its neighbours. In every table names with a comma, a quote or a line's end are quoted (RFC 4180).
std::string mass_table_rows(const Model& model, const State& state, int frame);

/// First line of the table of links.
std::string link_table_header();

/// A line a link: frame,time,link,a,b,rest_length,length,strain,tension,broken_at. broken_at is empty while
/// the link is whole; length, strain and tension are empty from then on, and tension is wherever it isn't
/// known.
std::string link_table_rows(const Model& model, const State& state, int frame, bool tension_known);

/// First line of the table of orientations.
std::string orientation_table_header();

/// A line a mass: frame,time,mass,name,qw,qx,qy,qz; how its links have turned since the start, as a unit
/// quaternion.
std::string orientation_table_rows(const Model& model, const State& start, const State& state, int frame);

}  // namespace taut
