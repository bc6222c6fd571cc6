// SPDX-License-Identifier: Apache-2.0
#include "contact/methods/methods.h"
#include <signorini/contact/methods/method.h>
#include <signorini/parameters/section.h>

namespace Signorini
{
  /// Direct constraint elimination (doc/theory, 2.6): slave nodes that touch lie on the master
  /// surface, u^S . n = u^M . n - g_0, whatever the nodes of the master: node-to-node where meshes
  /// match, node-to-surface elsewhere. The linear solver eliminates these constraints, so that what
  /// it iterates on is symmetric and positive definite; the forces that they transmit follow from
  /// equilibrium and are returned as pressures by the areas of the nodes. Exact on matching meshes;
  /// elsewhere as any collocation it fails the patch test (by some percent).
  class DirectElimination : public ContactMethod
  {
  public:
    void
    declare(Section &section) override;

    Sampling
    sampling() const override
    {
      return Sampling::nodes;
    }

    PressureShift
    pressure_shift() const override
    {
      return PressureShift::multiplier;
    }

    bool
    has_multipliers() const override
    {
      return true;
    }

    double
    penalty(const PenaltyScale &scale) const override
    {
      return scale.stiffness;
    }

    Rule
    usual_integration() const override
    {
      return Rule::nodes;
    }

    void
    check(const Integration &integration, unsigned int degree) const override;
  };



  void
  DirectElimination::declare(Section & /*section*/)
  {}



  void
  DirectElimination::check(const Integration &integration, const unsigned int /*degree*/) const
  {
    if (integration.rule != Rule::nodes)
      throw SceneError(
        "Contact method/Integration = " + word_of(Integration::rules(), integration.rule) +
        " cannot be combined with Method = direct elimination, which is a node-to-surface method; "
        "set Integration = nodes, or Method = Lagrange multiplier");
  }



  std::shared_ptr<ContactMethod>
  make_direct_elimination()
  {
    return std::make_shared<DirectElimination>();
  }
} // namespace Signorini
