#include <signorini/elasticity/model.h>
#include <signorini/elasticity/stress.h>
#include <signorini/output/probes.h>
#include <signorini/parameters/raw.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    using Cell = typename DoFHandler<dim>::active_cell_iterator;

    // Distances in units of the cell. Within `same`, points on faces belong to both their cells.
    constexpr double same = 1e-6, farthest = 0.02;

    /// What decides between the cells that a probe may lie in; the same on whatever rank they are.
    template <int dim>
    struct Claim
    {
      double       distance = std::numeric_limits<double>::infinity();
      unsigned int body     = numbers::invalid_unsigned_int;
      Point<dim>   center;
      double       size = 0;

      template <class Archive>
      void
      serialize(Archive &ar, const unsigned int)
      {
        ar &distance &body &center &size;
      }
    };

    /// A cell of this rank with its claim.
    template <int dim>
    struct Place
    {
      Claim<dim> claim;
      Cell<dim>  cell;
      Point<dim> unit;
    };



    template <int dim>
    bool
    goes_before(const Claim<dim> &a, const Claim<dim> &b)
    {
      if (a.distance != b.distance)
        return a.distance < b.distance;
      if (a.body != b.body)
        return a.body < b.body;
      for (unsigned int d = 0; d < dim; ++d)
        if (std::abs(a.center[d] - b.center[d]) > same * (a.size + b.size))
          return a.center[d] < b.center[d];
      return false;
    }



    template <int dim>
    Place<dim>
    place_in(const Mapping<dim> &mapping, const Cell<dim> &cell, const Point<dim> &x)
    {
      Place<dim> place;
      try
        {
          const Point<dim> unit     = mapping.transform_real_to_unit_cell(cell, x);
          const double     distance = GeometryInfo<dim>::distance_to_unit_cell(unit);
          if (distance <= farthest)
            {
              place.cell  = cell;
              place.unit  = GeometryInfo<dim>::project_to_unit_cell(unit);
              place.claim = {distance <= same ? 0 : distance,
                             cell->material_id(),
                             cell->center(),
                             cell->diameter()};
            }
        }
      catch (const typename Mapping<dim>::ExcTransformationFailed &)
        {
          // So the point is far from the cell.
        }
      return place;
    }



    template <int dim>
    bool
    may_be_in(const Probe<dim> &probe, const std::string &body, const BoundingBox<dim> &box)
    {
      return (probe.body.empty() || probe.body == body) && box.point_inside(probe.point);
    }



    /// The best place of each probe on this rank.
    template <int dim>
    std::vector<Place<dim>>
    own_places(const Elasticity<dim> &elasticity, const std::vector<Probe<dim>> &probes)
    {
      const Mesh<dim>        &mesh = elasticity.mesh();
      std::vector<Place<dim>> best(probes.size());
      for (const auto &cell : elasticity.dof_handler().active_cell_iterators())
        if (cell->is_locally_owned())
          {
            // The box is that of the vertices; an edge that is a quarter of a circle leaves it by
            // a fifth of its length.
            BoundingBox<dim> box = cell->bounding_box();
            box.extend(0.25 * cell->diameter());
            for (unsigned int i = 0; i < probes.size(); ++i)
              if (may_be_in(probes[i], mesh.body_name(cell->material_id()), box))
                {
                  const Place<dim> place = place_in<dim>(mesh.mapping(), cell, probes[i].point);
                  if (goes_before(place.claim, best[i].claim))
                    best[i] = place;
                }
          }
      return best;
    }



    template <int dim>
    std::string
    point_text(const Point<dim> &x)
    {
      std::ostringstream text;
      text.precision(8);
      for (unsigned int d = 0; d < dim; ++d)
        text << (d == 0 ? "(" : ", ") << x[d];
      return text.str() + ")";
    }



    /// "from (0, 0) to (1, 1)"
    template <int dim>
    std::string
    extent_of_body(const Mesh<dim> &mesh, const unsigned int body)
    {
      const auto &[low, high] = mesh.extent(body).get_boundary_points();
      return "from " + point_text(low) + " to " + point_text(high);
    }



    template <int dim>
    [[noreturn]] void
    refuse(const Probe<dim> &probe, const Mesh<dim> &mesh)
    {
      std::vector<std::string> extents, names;
      for (unsigned int b = 0; b < mesh.n_bodies(); ++b)
        {
          names.push_back(mesh.body_name(b));
          if (probe.body.empty() || probe.body == names.back())
            extents.push_back("'" + names.back() + "' extends " + extent_of_body(mesh, b));
        }
      const std::string which = "probe '" + probe.name + "' at " + point_text(probe.point) + ": ";
      if (extents.empty())
        throw SceneError(which + "there is no body '" + probe.body + "'; the bodies are " +
                         join(names));
      throw SceneError(which + "the point is outside of " +
                       (probe.body.empty() ? "all bodies" : "its body") + "; " +
                       join(extents, ", "));
    }



    template <int dim>
    void
    evaluate(const Elasticity<dim> &elasticity,
             const LA::Vector      &displacement,
             const Place<dim>      &place,
             Tensor<1, dim>        &u,
             Tensor<2, dim>        &gradient)
    {
      FEValues<dim> values(elasticity.mesh().mapping(),
                           place.cell->get_fe(),
                           Quadrature<dim>(place.unit),
                           update_values | update_gradients);
      values.reinit(place.cell);
      std::vector<Tensor<1, dim>> us(1);
      std::vector<Tensor<2, dim>> gradients(1);
      values[FEValuesExtractors::Vector(0)].get_function_values(displacement, us);
      values[FEValuesExtractors::Vector(0)].get_function_gradients(displacement, gradients);
      u        = us[0];
      gradient = gradients[0];
    }



    /// The rank with the best claim to probe i.
    template <int dim>
    unsigned int
    winner(const std::vector<std::vector<Claim<dim>>> &claims, const unsigned int i)
    {
      return std::min_element(claims.begin(),
                              claims.end(),
                              [i](const auto &a, const auto &b) {
                                return goes_before(a[i], b[i]);
                              }) -
             claims.begin();
    }
  } // namespace



  template <int dim>
  std::vector<ProbeValue<dim>>
  evaluate_probes(const Elasticity<dim>         &elasticity,
                  const LA::Vector              &displacement,
                  const std::vector<Probe<dim>> &probes)
  {
    const MPI_Comm                comm    = elasticity.mesh().communicator();
    const LA::Vector              ghosted = elasticity.with_ghosts(displacement);
    const std::vector<Place<dim>> places  = own_places(elasticity, probes);
    std::vector<Claim<dim>>       claims;
    for (const Place<dim> &place : places)
      claims.push_back(place.claim);
    const auto all_claims = Utilities::MPI::all_gather(comm, claims);

    std::vector<ProbeValue<dim>> result(probes.size());
    for (unsigned int i = 0; i < probes.size(); ++i)
      {
        const unsigned int rank  = winner(all_claims, i);
        const Claim<dim>  &claim = all_claims[rank][i];
        if (claim.distance > farthest)
          refuse(probes[i], elasticity.mesh());

        Tensor<1, dim> u;
        Tensor<2, dim> gradient;
        if (rank == Utilities::MPI::this_mpi_process(comm))
          evaluate(elasticity, ghosted, places[i], u, gradient);
        result[i].name                       = probes[i].name;
        result[i].found                      = true;
        result[i].displacement               = Utilities::MPI::sum(u, comm);
        gradient                             = Utilities::MPI::sum(gradient, comm);
        const Material             &material = elasticity.material(claim.body);
        const SymmetricTensor<2, 3> sigma    = stress(
          material,
          strain(elasticity.model(), material, gradient, result[i].displacement, probes[i].point));
        result[i].von_mises = von_mises(sigma);
        result[i].stress    = sigma;
      }
    return result;
  }



  template std::vector<ProbeValue<2>>
  evaluate_probes(const Elasticity<2> &, const LA::Vector &, const std::vector<Probe<2>> &);
  template std::vector<ProbeValue<3>>
  evaluate_probes(const Elasticity<3> &, const LA::Vector &, const std::vector<Probe<3>> &);
} // namespace Signorini
