// SPDX-License-Identifier: Apache-2.0
#include "contact/constraints/condensed_columns.h"

#include <cmath>
#include <map>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// A contact point by its parameters on the slave face, with half the edge length of the square
    /// that has its share of the face's area.
    template <int dim>
    struct Place
    {
      Point<dim - 1> xi;
      double         half_width;
      unsigned int   surface; ///< number
    };

    /// True if the squares of two points of different surfaces overlap. Points that merely touch,
    /// where two masters meet on a face, do not.
    template <int dim>
    bool
    overlap(const Place<dim> &a, const Place<dim> &b)
    {
      // Squares overlap if their centers are closer than this share of the larger half width in
      // each direction; those of neighbours are farther apart.
      constexpr double touching = 0.9;
      for (unsigned int d = 0; d < dim - 1; ++d)
        if (std::abs(a.xi[d] - b.xi[d]) >= touching * std::max(a.half_width, b.half_width))
          return false;
      return true;
    }
  } // namespace



  template <int dim>
  bool
  have_coinciding_points(const std::vector<ContactSurface<dim>> &surfaces)
  {
    // Points are compared on each slave face, which is on one rank; quadratic in the points of a
    // face.
    std::map<std::pair<CellId, unsigned int>, std::vector<Place<dim>>> faces;
    for (unsigned int i = 0; surfaces.size() > 1 && i < surfaces.size(); ++i)
      {
        const ContactSurface<dim> &surface = surfaces[i];
        std::vector<double>        areas(surface.slave_faces.size(), 0.);
        for (const ContactPoint<dim> &point : surface.points)
          areas[point.face] += point.weight;
        for (const ContactPoint<dim> &point : surface.points)
          {
            const SlaveFace<dim> &face = surface.slave_faces[point.face];
            const double          share =
              face.covered * point.weight / areas[point.face] * face.reference_cell().volume();
            faces[{face.cell, face.face}].push_back(
              {point.xi, std::pow(share, 1. / (dim - 1)) / 2, i});
          }
      }
    for (const auto &[face, places] : faces)
      for (const Place<dim> &a : places)
        for (const Place<dim> &b : places)
          if (a.surface < b.surface && overlap(a, b))
            return true;
    return false;
  }



  template bool
  have_coinciding_points(const std::vector<ContactSurface<2>> &);
  template bool
  have_coinciding_points(const std::vector<ContactSurface<3>> &);
} // namespace Signorini
