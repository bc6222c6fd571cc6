// SPDX-License-Identifier: Apache-2.0
#include "contact/search/boundary_faces.h"
#include "geometry/cell_rule.h"
#include "verdict/checks.h"
#include <signorini/solid/model.h>

#include <algorithm>
#include <array>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Resultant of a load on this rank, and the sum of the norms of its parts.
    template <int dim>
    struct Sum
    {
      Tensor<1, dim> force;
      double         size = 0;

      /// Add the integral over one face by a quadrature rule.
      void
      add(const Load<dim>           &load,
          const FacePatch<dim>      &face,
          const Quadrature<dim - 1> &rule,
          const Model                model,
          const double               t)
      {
        for (unsigned int q = 0; q < rule.size(); ++q)
          {
            const Point<dim - 1> xi = rule.point(q);
            const Point<dim>     x  = face.position(xi);
            // The pressure acts against the outward normal. Reference normals are used at finite
            // strain too: what is compared is the quadrature and not the load.
            const Tensor<1, dim> traction =
              load.traction_at(x, t) - load.pressure.value(x, t) * face.normal(xi);
            const double area = rule.weight(q) * face.jacobian(xi) * measure(model, x);
            force += area * traction;
            // Resultants may cancel, as that of a pressure on a closed surface; the integral of the
            // norm does not, and is the scale.
            size += area * traction.norm();
          }
      }

      void
      reduce_over_ranks(const MPI_Comm comm)
      {
        force = Utilities::MPI::sum(force, comm);
        size  = Utilities::MPI::sum(size, comm);
      }
    };
  } // namespace



  // Loads that depend on the time only are integrated exactly. The second rule has three points
  // more in each direction.
  template <int dim>
  std::vector<CheckResult>
  check_loads(const Scene<dim> &scene, const Snapshot<dim> &now)
  {
    constexpr double         small = 1e-4;
    const MPI_Comm           comm  = now.elasticity.mesh().communicator();
    std::vector<CheckResult> check_results;
    for (const Load<dim> &load : scene.loads)
      {
        if (load.axes.are_global() && !load.traction.depends_on_place() &&
            !load.pressure.depends_on_place())
          continue;
        std::array<Sum<dim>, 2> sums; // as it was integrated, and with more points
        // The usual rule is that of the load integration with p + 2 Gauss points in each direction.
        for (const std::string &boundary : load.boundaries)
          {
            const BoundaryFaces<dim> faces(now.elasticity, boundary);
            for (unsigned int i = 0; i < faces.faces.size(); ++i)
              {
                const unsigned int usual = faces.faces[i].first->get_fe().degree + 2;
                for (unsigned int k = 0; k < 2; ++k)
                  sums[k].add(load,
                              faces.patches[i],
                              cell_rule<dim - 1>(faces.patches[i].reference_cell(), usual + 3 * k),
                              now.elasticity.model(),
                              now.time);
              }
          }
        for (Sum<dim> &sum : sums)
          sum.reduce_over_ranks(comm);
        CheckResult check_result;
        check_result.check = "load quadrature error";
        check_result.where = "load " + load.name;
        // The difference of the resultants relative to the integral of the norm of the traction.
        check_result.value =
          sums[1].size > 0 ? (sums[0].force - sums[1].force).norm() / sums[1].size : 0.;
        check_result.limit   = small;
        check_result.outcome = check_result.value <= small ? Outcome::passed : Outcome::warned;
        check_result.message =
          "the formula of the load varies so much within faces that the relative error of "
          "the resultant is about that value; it may be discontinuous there";
        check_result.advice =
          "align element edges with the discontinuity, refine there, or use Total force";
        check_results.push_back(check_result);
      }
    return check_results;
  }



  // Faces are wet or dry as a whole.
  std::vector<CheckResult>
  check_fluids(const nlohmann::ordered_json &results, const double scale)
  {
    constexpr double         small = 0.05;
    std::vector<CheckResult> check_results;
    const auto               fluids = results.value("fluids", nlohmann::ordered_json::object());
    for (const auto &[name, fluid] : fluids.items())
      {
        CheckResult check_result;
        check_result.check   = "edge of the fluid";
        check_result.where   = "load " + name;
        check_result.value   = scale > 0 ? fluid.at("force_at_edge").get<double>() / scale : 0.;
        check_result.limit   = small;
        check_result.outcome = check_result.value <= small ? Outcome::passed : Outcome::warned;
        check_result.message =
          "the faces next to the fluid are wet or dry as a whole; its force on "
          "them is that part of the largest force, an error that it may have";
        check_result.advice = "refine the boundaries where the fluid ends";
        check_results.push_back(check_result);
      }
    return check_results;
  }



  template std::vector<CheckResult>
  check_loads(const Scene<2> &, const Snapshot<2> &);
  template std::vector<CheckResult>
  check_loads(const Scene<3> &, const Snapshot<3> &);
} // namespace Signorini
