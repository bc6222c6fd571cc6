// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/cells.h"
#include "mesh_import/division/subdivisions.h"

#include <algorithm>

namespace Signorini
{
  bool
  can_be_cut(const MeshFile &file, const std::vector<unsigned int> &cells)
  {
    const auto is_of_first_order = [&](const unsigned int c) {
      return file.elements[c].nodes.size() == n_corners(file.elements[c].shape);
    };
    const auto is_hypercube = [&](const unsigned int c) {
      return file.elements[c].shape == cell_shape<2> || file.elements[c].shape == cell_shape<3>;
    };
    return std::none_of(cells.begin(), cells.end(), is_of_first_order) &&
           !std::all_of(cells.begin(), cells.end(), is_hypercube);
  }



  std::vector<std::string>
  check_simplices(MeshFile &file, const std::vector<unsigned int> &cells, const unsigned int dim)
  {
    Centers     centers(file);
    ShapeReport report(file, dim);
    for (const unsigned int c : cells)
      {
        const MeshFile::Element &element = file.elements[c];
        if (element.nodes.size() > n_corners(element.shape))
          centers.take(element);
        report.add(element, element);
      }
    return report.warnings();
  }
} // namespace Signorini
