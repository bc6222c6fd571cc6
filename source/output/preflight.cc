// SPDX-License-Identifier: Apache-2.0
#include "output/preflight.h"

#include "contact/search/face_patches.h"
#include "geometry/cell_rule.h"
#include "geometry/face_parameter.h"
#include "geometry/lagrange.h"
#include "matrix_free/make_stiffness.h"
#include <signorini/parameters/raw.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace Signorini
{
  using namespace dealii;
  using Json = nlohmann::ordered_json;

  namespace
  {
    /// @return a point as an array.
    template <int dim>
    Json
    coordinates_of(const Point<dim> &p)
    {
      Json result = Json::array();
      for (unsigned int d = 0; d < dim; ++d)
        result.push_back(p[d]);
      return result;
    }

    /// Properties by which the boundaries of bodies can be distinguished: number of faces, size
    /// (area; in 2D length), centre and extent; one entry for each boundary, or dim.
    template <int dim>
    struct Boundaries
    {
      std::vector<double> faces, size, moment, low, high;

      /// Integrate over all boundary faces. Collective.
      explicit Boundaries(const Elasticity<dim> &elasticity)
      {
        constexpr double most  = std::numeric_limits<double>::max();
        const Mesh<dim> &mesh  = elasticity.mesh();
        const auto      &names = mesh.boundaries();
        // Extents begin with the largest numbers of the opposite sign, so that the first face
        // replaces them, and ranks without faces do not change the minima and maxima of all ranks.
        faces.assign(names.size(), 0.);
        size.assign(names.size(), 0.);
        moment.assign(dim * names.size(), 0.);
        low.assign(dim * names.size(), most);
        high.assign(dim * names.size(), -most);
        // A face with several names contributes to the boundary of each of them.
        FacePatches<dim>                                        patch_of(mesh);
        std::map<types::boundary_id, std::vector<unsigned int>> names_of;
        for (unsigned int i = 0; i < names.size(); ++i)
          for (const types::boundary_id id : mesh.boundary_ids(names[i]))
            names_of[id].push_back(i);
        for (const auto &cell : mesh.triangulation().active_cell_iterators())
          if (cell->is_locally_owned() && cell->at_boundary())
            for (const unsigned int f : cell->face_indices())
              if (cell->face(f)->at_boundary())
                for (const unsigned int i : names_of[cell->face(f)->boundary_id()])
                  add(i, patch_of(cell, f));
        // Sums and extents over all ranks.
        for (auto *numbers : {&faces, &size, &moment})
          Utilities::MPI::sum(*numbers, mesh.communicator(), *numbers);
        Utilities::MPI::min(low, mesh.communicator(), low);
        Utilities::MPI::max(high, mesh.communicator(), high);
      }

      /// Add a face to boundary i.
      void
      add(const unsigned int i, const FacePatch<dim> &patch)
      {
        const Quadrature<dim - 1> &rule = cell_rule<dim - 1>(patch.reference_cell(), 2);
        ++faces[i];
        for (unsigned int q = 0; q < rule.size(); ++q)
          {
            const Point<dim> x      = patch.position(rule.point(q));
            const double     weight = rule.weight(q) * patch.jacobian(rule.point(q));
            size[i] += weight;
            for (unsigned int d = 0; d < dim; ++d)
              moment[dim * i + d] += weight * x[d];
          }
        // The box of the patch itself is inflated where the face is curved.
        const unsigned int n = patch.get_degree() == 1 ? 1 : max_degree;
        for (unsigned int k = 0; k < (dim == 2 ? 1 : n + 1); ++k)
          for (unsigned int j = 0; j <= n - (is_triangle(patch.reference_cell()) ? k : 0); ++j)
            {
              Point<dim - 1> xi;
              xi[0]              = double(j) / n;
              xi[dim - 2]        = dim == 2 ? xi[0] : double(k) / n;
              const Point<dim> x = patch.position(xi);
              for (unsigned int d = 0; d < dim; ++d)
                {
                  low[dim * i + d]  = std::min(low[dim * i + d], x[d]);
                  high[dim * i + d] = std::max(high[dim * i + d], x[d]);
                }
            }
      }

      /// @return the properties of boundary i.
      Json
      description(const unsigned int i) const
      {
        Json center = Json::array(), from = Json::array(), to = Json::array();
        for (unsigned int d = 0; d < dim; ++d)
          {
            // The centre of gravity: the first moment over the size.
            center.push_back(size[i] > 0 ? moment[dim * i + d] / size[i] : 0.);
            from.push_back(low[dim * i + d]);
            to.push_back(high[dim * i + d]);
          }
        return {{"faces", faces[i]},
                {dim == 2 ? "length" : "area", size[i]},
                {"center", center},
                {"from", from},
                {"to", to}};
      }
    };

    /// @return the properties of the boundaries of one body, by their names.
    template <int dim>
    Json
    describe_boundaries(const Boundaries<dim> &all, const Mesh<dim> &mesh, const unsigned int body)
    {
      const std::string prefix = mesh.body_name(body) + ".";
      Json              result = Json::object();
      for (unsigned int i = 0; i < mesh.boundaries().size(); ++i)
        if (mesh.boundaries()[i].compare(0, prefix.size(), prefix) == 0)
          result[mesh.boundaries()[i].substr(prefix.size())] = all.description(i);
      return result;
    }

    /// @return thermal expansion and the range of temperatures at the end of a body. Collective.
    template <int dim>
    Json
    thermal(const Scene<dim> &scene, const Elasticity<dim> &elasticity, const unsigned int body)
    {
      const ThermalExpansion<dim> &expansion = scene.bodies[body].expansion;
      const double                 end       = scene.load_steps.ends().back();
      const auto [lowest, highest] =
        elasticity.thermal().range(elasticity.mesh().own_material(body), end);
      return {{"expansion", expansion.coefficients},
              {"reference", expansion.reference},
              {"from", lowest},
              {"to", highest}};
    }

    /// @return the properties of all bodies, by their names. Collective.
    template <int dim>
    Json
    bodies(const Decisions<dim> &decisions, const Elasticity<dim> &elasticity)
    {
      const Scene<dim>          &scene = decisions.scene;
      const Mesh<dim>           &mesh  = elasticity.mesh();
      std::vector<unsigned long> cells(mesh.n_bodies());
      for (const auto &cell : mesh.triangulation().active_cell_iterators())
        if (cell->is_locally_owned())
          ++cells[mesh.body(cell)];
      Utilities::MPI::sum(cells, mesh.communicator(), cells);
      const Boundaries<dim> boundaries(elasticity);
      Json                  result = Json::object();
      for (unsigned int b = 0; b < cells.size(); ++b)
        {
          const BoundingBox<dim> box   = mesh.extent(b);
          const auto &[low, high]      = box.get_boundary_points();
          result[scene.bodies[b].name] = {
            {"from", coordinates_of(low)},
            {"to", coordinates_of(high)},
            {"cells", cells[b]},
            {"degree", elasticity.degree(b)},
            {"boundaries", describe_boundaries(boundaries, mesh, b)},
            {"youngs_modulus", scene.bodies[b].material.youngs_modulus},
            {"poissons_ratio", scene.bodies[b].material.poissons_ratio},
            {"formulation", decisions.has_pressure_field[b].front() ? "mixed" : "displacement"},
            {"law", elasticity.is_finite_strain() ? scene.bodies[b].material.law : "linear"}};
          if (elasticity.thermal().expands(b))
            result[scene.bodies[b].name]["thermal"] = thermal(scene, elasticity, b);
        }
      return result;
    }

    /// @return what the computation omits because this scene does not need it.
    template <int dim>
    Json
    skipped_items(const Decisions<dim>                   &decisions,
                  const std::vector<ContactSurface<dim>> &surfaces,
                  const GapOperator                      &contact)
    {
      Json result = Json::array();
      for (unsigned int i = 0; i < surfaces.size(); ++i)
        if (surfaces[i].is_apart)
          result.push_back(
            "pair " + decisions.pairs[i].name +
            (surfaces[i].has_no_projection ?
               ": its surfaces do not face each other" :
               ": the initial gap is larger than the expected motion of the bodies") +
            " (checked after each solution)");
      // Without candidate points there are no inequalities.
      if (contact.empty())
        result.push_back(decisions.finite_strain ?
                           "contact: no candidates" :
                           "contact: no candidates, each load step is a linear problem");
      else if (contact.n_components() == 1)
        result.push_back("friction: contact is frictionless");
      for (const Obstacle<dim> &obstacle : decisions.scene.obstacles)
        {
          unsigned int n_free = 0;
          for (unsigned int d = 0; d < RigidBody<dim>::n_dofs; ++d)
            n_free += obstacle.body.is_free(d);
          result.push_back("mesh of the rigid " + obstacle.name + ": " +
                           (n_free > 0 ? std::to_string(n_free) + " rigid-body unknowns instead" :
                                         "it has no unknowns"));
        }
      return result;
    }

    /// Append warnings about nearly incompressible bodies in displacement form.
    template <int dim>
    void
    warn_about_bodies(const Decisions<dim> &decisions, Json &warnings)
    {
      const Scene<dim> &scene = decisions.scene;
      for (unsigned int b = 0; b < scene.bodies.size(); ++b)
        {
          const Body<dim>   &body       = scene.bodies[b];
          const unsigned int p          = decisions.degrees[b];
          const bool         wants_bars = !scene.goals.quantities.empty(); // mixed bodies have none
          if (body.material.poissons_ratio <= 0.49 || decisions.has_pressure_field[b].front() ||
              model_of(scene.model) == Model::plane_stress) // free to become thinner
            continue;
          if (p == 1)
            warnings.push_back("body " + body.name +
                               ": nearly incompressible bodies of degree 1 lock; set " +
                               (wants_bars ? "Degree = 2, or none" :
                                             "Formulation = mixed, with Degree = 2 or none"));
          else if (!wants_bars && !scene.solver.traits().factorises)
            warnings.push_back(
              "body " + body.name +
              ": for nearly incompressible bodies the displacement formulation needs hundreds of "
              "iterations; set Formulation = mixed");
        }
    }
  } // namespace



  namespace
  {
    /// Append warnings about thermal strains that are not small.
    void
    warn_about_heat(const Json &bodies, Json &warnings)
    {
      constexpr double small = 0.05; // more than materials bear, but a slip of units
      for (const auto &[name, body] : bodies.items())
        if (body.contains("thermal"))
          {
            const Json &thermal = body["thermal"];
            double      rise = 0, alpha = 0;
            for (const char *end : {"from", "to"})
              rise =
                std::max(rise,
                         std::abs(thermal[end].get<double>() - thermal["reference"].get<double>()));
            for (const auto &one : thermal["expansion"])
              alpha = std::max(alpha, std::abs(one.get<double>()));
            // The product of the largest coefficient and the largest difference from the reference
            // temperature is an upper bound of the thermal strains at the end.
            if (alpha * rise > small)
              warnings.push_back(
                "body " + name +
                ": thermal strains exceed 5 %; check the units of Thermal expansion and "
                "Temperature");
          }
    }
  } // namespace



  // Warnings are collected by all parts and printed at the end.
  template <int dim>
  Json
  preflight(const Decisions<dim>                   &decisions,
            const Elasticity<dim>                  &elasticity,
            const std::vector<ContactSurface<dim>> &surfaces,
            const GapOperator                      &contact,
            const double                            seconds)
  {
    const Scene<dim> &scene    = decisions.scene;
    unsigned int      n_points = 0;
    for (const ContactSurface<dim> &surface : surfaces)
      n_points += surface.points.size();
    // The predicted costs follow from the numbers of unknowns and contact points.
    const Prediction prediction = predict(scene, elasticity, n_points, seconds);
    Json             warnings   = Json::array();
    warn_about_bodies(decisions, warnings);
    // The bodies are described first, since the warnings about thermal strains read the ranges of
    // temperatures from their description.
    const Json of_bodies = bodies(decisions, elasticity);
    warn_about_heat(of_bodies, warnings);
    Json report = {{"model", scene.model},
                   {"dofs", elasticity.dof_handler().n_dofs()},
                   {"bodies", of_bodies},
                   {"operator",
                    word_of(stiffness_forms(),
                            choose_form(scene.solver.stiffness_form,
                                        scene.solver.traits().needs_matrix,
                                        elasticity))},
                   {"modes_constrained_by_contact", elasticity.unsupported_mode_names()},
                   {"pairs", preflight_of_pairs(decisions, elasticity, surfaces, warnings)},
                   {"skipped", skipped_items(decisions, surfaces, contact)},
                   {"warnings", warnings},
                   {"predicted",
                    {{"seconds", prediction.seconds},
                     {"seconds_before", prediction.seconds_before},
                     {"memory_mb", prediction.memory_mb},
                     {"seconds_per_cell", prediction.seconds_per_cell}}}};
    return report;
  }



  template Json
  preflight(const Decisions<2> &,
            const Elasticity<2> &,
            const std::vector<ContactSurface<2>> &,
            const GapOperator &,
            double);
  template Json
  preflight(const Decisions<3> &,
            const Elasticity<3> &,
            const std::vector<ContactSurface<3>> &,
            const GapOperator &,
            double);
} // namespace Signorini
