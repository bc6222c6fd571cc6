// SPDX-License-Identifier: Apache-2.0
// Two blocks that overlap a little here and gap a little there, so that both states of contact
// occur.
#pragma once

#include "contact/constraints/gap_operator.h"
#include <signorini/contact/methods/method.h>
#include <signorini/parameters/section.h>

#include <deal.II/base/function.h>
#include <deal.II/numerics/vector_tools_interpolate.h>

namespace TestScene
{
  using namespace Signorini;
  using namespace dealii;

  inline std::shared_ptr<ContactMethod>
  make_method(const std::string                                      &name,
              const std::vector<std::pair<std::string, std::string>> &settings = {})
  {
    const auto method = ContactMethod::create(name);
    RawSection raw;
    for (const auto &[key, value] : settings)
      raw.set_value(key, value, "test");
    Section section(raw);
    method->declare(section);
    return method;
  }

  template <int dim>
  BodyMesh<dim>
  box(const std::string &corners, const std::string &subdivisions)
  {
    RawSection raw;
    raw.set_value("Corners", corners, "test");
    raw.set_value("Subdivisions", subdivisions, "test");
    BodyMesh<dim> mesh;
    Section       section(raw);
    mesh.declare(section);
    return mesh;
  }

  /// A VectorExpression at a fixed time, as deal.II wants a function of displacements.
  template <int dim>
  class DisplacementFunction : public Function<dim>
  {
  public:
    DisplacementFunction(const VectorExpression<dim> &expression, const double t)
      : Function<dim>(dim)
      , expression(expression)
      , t(t)
    {}

    double
    value(const Point<dim> &p, const unsigned int component) const override
    {
      return expression.value(p, t)[component];
    }

    void
    vector_value(const Point<dim> &p, Vector<double> &values) const override
    {
      const Tensor<1, dim> u = expression.value(p, t);
      for (unsigned int d = 0; d < dim; ++d)
        values[d] = u[d];
    }

  private:
    const VectorExpression<dim> expression;
    const double                t;
  };

  template <int dim>
  struct TwoBlocks
  {
    TwoBlocks(const ContactMethod &method, const unsigned int degree)
      : mesh(
          {{"lower", dim == 2 ? box<dim>("0,0 : 1,1", "4,3") : box<dim>("0,0,0 : 1,1,1", "3,3,2")},
           {"upper", dim == 2 ? box<dim>("0,1 : 1,2", "3,2") : box<dim>("0,0,1 : 1,1,2", "2,2,2")}},
          MeshSettings<dim>(),
          {{"upper.bottom", "lower.top"}},
          MPI_COMM_WORLD)
      , elasticity(mesh, {{10, 0.3}, {20, 0.2}}, supports(), {}, {degree})
    {
      elasticity.setup();
      elasticity.assemble();
      ContactPair<dim> pair;
      pair.slave       = "upper.bottom";
      pair.master      = "lower.top";
      pair.initial_gap = "0.01*cos(5*x)";
      contact          = make_gap_operator<dim>(
        elasticity,
        {make_contact_surface<dim>(elasticity, pair, nullptr, method, {Rule::quadrature, 3})},
        method);
    }

    static std::vector<Support<dim>>
    supports()
    {
      Support<dim> base;
      base.boundaries   = {"lower.bottom", "upper.top"};
      base.displacement = VectorExpression<dim>(dim == 2 ? "0;0" : "0;0;0");
      return {base};
    }

    /// Something smooth that has no symmetry, zero where displacements are prescribed.
    LA::Vector
    field(const double amplitude, const double frequency) const
    {
      const std::string a = std::to_string(amplitude), f = std::to_string(frequency);
      const std::string one = a + "*sin(" + f + "*(7*x+3*y))", two = a + "*cos(" + f + "*(5*x-y))";
      LA::Vector        u = elasticity.zero_vector();
      const VectorExpression<dim> expression(dim == 2 ? one + ";" + two :
                                                        one + ";" + two + ";" + one + "*" + two);
      VectorTools::interpolate(mesh.mapping(),
                               elasticity.dof_handler(),
                               DisplacementFunction<dim>(expression, 0),
                               u);
      elasticity.constraints().set_zero(u);
      return u;
    }

    Mesh<dim>                    mesh;
    Elasticity<dim>              elasticity;
    std::unique_ptr<GapOperator> contact;
  };
} // namespace TestScene
