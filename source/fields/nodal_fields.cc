#include <signorini/fields/nodal_fields.h>

#include <deal.II/base/mpi.h>

#include <cmath>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    LA::Vector
    from_nodes(const Snapshot<dim> &snapshot, const LA::Vector &values, const unsigned int pair)
    {
      LA::Vector     field = snapshot.elasticity.zero_vector();
      const IndexSet rows  = values.locally_owned_elements();
      auto           row   = rows.begin();
      for (unsigned int k = 0; k < snapshot.contact.origin.node.size(); ++k, ++row)
        if (snapshot.contact.origin.pair[k] == pair)
          field(snapshot.contact.origin.node[k]) = values(*row);
      field.compress(VectorOperation::insert);
      return field;
    }



    // int psi v dA, int psi dA and int |psi| dA of each node.
    template <int dim>
    struct Integrals
    {
      LA::Vector value, area, size;

      Integrals(const Elasticity<dim> &elasticity)
        : value(elasticity.zero_vector())
        , area(elasticity.zero_vector())
        , size(elasticity.zero_vector())
      {}

      void
      add(const ContactPoint<dim> &point, const double v)
      {
        for (const auto &[node, psi] : point.shape)
          {
            value(node) += psi * point.weight * v;
            area(node) += psi * point.weight;
            size(node) += std::abs(psi) * point.weight;
          }
      }

      void
      finish()
      {
        for (LA::Vector *v : {&value, &area, &size})
          v->compress(VectorOperation::add);
      }
    };



    template <int dim>
    LA::Vector
    from_points(const Snapshot<dim> &snapshot, const LA::Vector &values, const unsigned int pair)
    {
      Integrals<dim> integrals(snapshot.elasticity);
      auto           row = first_row(snapshot, pair);
      for (const ContactPoint<dim> &point : snapshot.surfaces[pair].points)
        integrals.add(point, values(row++));
      integrals.finish();

      LA::Vector field = snapshot.elasticity.zero_vector();
      for (const auto i : snapshot.elasticity.owned())
        // Shape functions of higher degree are negative in places: where few points have a partner,
        // their integral may come near zero, and the mean would mean nothing.
        if (integrals.size(i) > 0 && integrals.area(i) > 1e-6 * integrals.size(i))
          field(i) = integrals.value(i) / integrals.area(i);
      field.compress(VectorOperation::insert);
      return field;
    }
  } // namespace



  template <int dim>
  types::global_dof_index
  first_row(const Snapshot<dim> &snapshot, const unsigned int pair)
  {
    types::global_dof_index first = snapshot.pressure.local_range().first;
    for (unsigned int p = 0; p < pair; ++p)
      first += snapshot.surfaces[p].points.size();
    return first;
  }



  bool
  samples_nodes(const GapOperator &contact)
  {
    return Utilities::MPI::max(contact.origin.node.empty() ? 0u : 1u,
                               contact.weight.get_mpi_communicator()) == 1;
  }



  template <int dim>
  LA::Vector
  nodal_field(const Snapshot<dim> &snapshot, const LA::Vector &values, const unsigned int pair)
  {
    LA::Vector field = samples_nodes(snapshot.contact) ? from_nodes(snapshot, values, pair) :
                                                         from_points(snapshot, values, pair);
    snapshot.elasticity.hanging_nodes().distribute(field);
    return field;
  }



  template <int dim>
  LA::Vector
  nodal_coverage(const Snapshot<dim> &snapshot, const unsigned int pair)
  {
    LA::Vector ones = snapshot.contact.zero();
    ones            = 1.;
    return nodal_field(snapshot, ones, pair);
  }



  template types::global_dof_index
  first_row(const Snapshot<2> &, unsigned int);
  template LA::Vector
  nodal_field(const Snapshot<2> &, const LA::Vector &, unsigned int);
  template types::global_dof_index
  first_row(const Snapshot<3> &, unsigned int);
  template LA::Vector
  nodal_field(const Snapshot<3> &, const LA::Vector &, unsigned int);
  template LA::Vector
  nodal_coverage(const Snapshot<2> &, unsigned int);
  template LA::Vector
  nodal_coverage(const Snapshot<3> &, unsigned int);
} // namespace Signorini
