#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "model/model.h"

namespace taut {

/// A line: links that follow each other from mass to mass, and no mass twice. Only its ends may be pins;
/// those of a line may be one pin.
struct LinkLine {
  std::size_t first_link = 0, first_mass = 0;  ///< where they begin in LinkLines
  std::size_t count = 0;                       ///< of its links, at least 1; it has one more mass
  Index lowest = 0;                            ///< the first of its links in the model
  std::size_t colour = 0;                      ///< no two lines of one colour share a free mass
};

struct LinkLines {
  std::vector<Index> links, masses;  ///< line after line, link i of a line between its masses i and i + 1
  std::vector<LinkLine> lines;       ///< in the order of their lowest links
  std::size_t colours = 0;

  std::span<const Index> links_of(const LinkLine& line) const {
    return std::span(links).subspan(line.first_link, line.count);
  }
  std::span<const Index> masses_of(const LinkLine& line) const {
    return std::span(masses).subspan(line.first_mass, line.count + 1);
  }
};

/// Lines that have each of these links in one of them. Which links go on into which follows from how masses
/// are numbered, never from where they are. At each free mass b those pair up whose other ends are b − s and
/// b + s: rows, columns and diagonals of sheets, and chains. Of a mass that has just two links left those go
/// on into each other, but round no corner of a sheet of rows and columns. Lines end at pins, a ring is cut
/// ahead of its lowest link, and what comes back to one of its masses is cut before the link that does.
/// Colours are given greedily in the order of the lines. `links`: rising.
LinkLines lines_of(const Model& model, const std::vector<Index>& links);

}  // namespace taut
