#include <signorini/fields/nodal_fields.h>
#include <signorini/fields/point_values.h>

#include <set>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// u at all degrees of freedom that the points' gaps depend on, wherever they live.
    template <int dim>
    LA::Vector
    displacement_of_partners(const Snapshot<dim> &s, const ContactSurface<dim> &surface)
    {
      std::set<types::global_dof_index> needed;
      for (const ContactPoint<dim> &point : surface.points)
        for (const auto &entry : point.row)
          needed.insert(entry.first);
      IndexSet all = s.elasticity.owned();
      all.add_indices(needed.begin(), needed.end());
      LA::Vector u(s.elasticity.owned(), all, s.elasticity.mesh().communicator());
      u = s.displacement;
      return u;
    }
  } // namespace



  template <int dim>
  PointValues
  point_values(const Snapshot<dim> &s, const unsigned int pair)
  {
    PointValues values;
    const auto &points = s.surfaces[pair].points;
    if (!samples_nodes(s.contact))
      {
        types::global_dof_index row = first_row(s, pair);
        for (unsigned int q = 0; q < points.size(); ++q, ++row)
          {
            values.gap.push_back(s.gap(row));
            values.pressure.push_back(s.pressure(row));
          }
        return values;
      }
    const LA::Vector u = displacement_of_partners(s, s.surfaces[pair]);
    const LA::Vector p = s.elasticity.with_ghosts(nodal_field(s, s.pressure, pair));
    for (const ContactPoint<dim> &point : points)
      {
        const double share =
          point.gap < 0 && !s.contact.interference.empty() ? s.contact.interference[pair] : 1.;
        double gap = share * point.gap, pressure = 0;
        for (const auto &[dof, value] : point.row)
          gap += value * u(dof);
        for (const auto &[node, value] :
             point.interpolation.empty() ? point.shape : point.interpolation)
          pressure += value * p(node);
        values.gap.push_back(gap);
        values.pressure.push_back(pressure);
      }
    return values;
  }



  template PointValues
  point_values(const Snapshot<2> &, unsigned int);
  template PointValues
  point_values(const Snapshot<3> &, unsigned int);
} // namespace Signorini
