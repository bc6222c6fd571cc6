// SPDX-License-Identifier: Apache-2.0
#include "scene/descriptions.h"

#include <deal.II/base/exceptions.h>

#include <map>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    using Sentences = std::map<std::string, std::string>;

    /// @return the sentence about a name; an error of the program if there is none, so that new
    /// names are not forgotten.
    const std::string &
    sentence(const Sentences &sentences, const std::string &name)
    {
      const auto found = sentences.find(name);
      AssertThrow(found != sentences.end(), ExcMessage("no description of '" + name + "'"));
      return found->second;
    }
  } // namespace



  std::string
  about_mesh(const std::string &generator)
  {
    static const Sentences sentences = {
      {"box",
       "A rectangle or cuboid along the axes, with cells that may grow geometrically along each axis."},
      {"disc", "A disc, or a half or a quarter of it, with an exact arc."},
      {"ring", "An annulus, in 3D a tube along z, or a half or a quarter of it, with exact arcs."},
      {"sphere", "A ball, its lower half or a quarter of that, with an exact sphere."},
      {"shell",
       "A spherical shell between two concentric spheres, its lower half or a quarter of that."},
      {"file",
       "A mesh file of Gmsh, Abaqus, CalculiX or VTK, or a part of it; see meshes/README.md."}};
    return sentence(sentences, generator);
  }



  std::string
  about_shape(const std::string &obstacle)
  {
    static const Sentences sentences = {
      {"plane", "A rigid half-space."},
      {"sphere", "A ball (in 2D a circular cylinder), or a spherical seat (Hollow = yes)."},
      {"cylinder", "A circular cylinder about an axis (in 2D about z), or a bore (Hollow = yes)."},
      {"paraboloid",
       "A paraboloid of revolution (in 2D a parabola), with the gap measured along its axis as in Hertz' theory."},
      {"punch", "A flat circular face (in 2D a strip) with rounded edges at the end of a shaft."},
      {"cone", "A circular cone (in 2D a wedge)."},
      {"profile",
       "Lines and arcs in the plane; in space moved along a line, or turned about an axis."},
      {"gap function", "Any surface, by a formula for the gap along one direction."},
      {"STL",
       "A surface of triangles from an STL file, or of the surface elements of a mesh file; the gap is the signed "
       "distance. 3D only."},
      {"attached",
       "The surface of the slaves itself, as a rigid body: with Law = tied, a rigid coupling to the Reference "
       "point."}};
    return sentence(sentences, obstacle);
  }



  std::string
  about_method(const std::string &method)
  {
    static const Sentences sentences = {
      {"penalty", "The pressure is proportional to the penetration: p = max(0, -eps g)."},
      {"augmented Lagrangian",
       "Penalty method with multiplier updates (augmentations) that remove the penetration; the result is that of Lagrange multipliers."},
      {"perturbed Lagrangian",
       "The pressure is an unknown, and contact is compliant: g + p/eps = 0 where it is active."},
      {"Lagrange multiplier",
       "The pressure is an unknown, and the weighted gap of each active slave node is zero (mortar method)."},
      {"direct elimination",
       "The displacement of active slave nodes normal to the master surface is eliminated (node to surface); exact where nodes match."},
      {"Nitsche",
       "The pressure is the normal stress of the bodies plus a stabilising penalty term, which is chosen by the program."}};
    return sentence(sentences, method);
  }



  std::string
  about_integration(const std::string &rule)
  {
    static const Sentences sentences = {
      {"auto", "the rule that suits the method"},
      {"segments", "exactly, on the intersections of slave faces with master faces"},
      {"quadrature", "by Gauss points on whole slave faces: cheaper"},
      {"nodes", "at the slave nodes: cheapest, and exact where nodes match"}};
    return sentence(sentences, rule);
  }



  std::string
  about_preconditioner(const std::string &name)
  {
    static const Sentences sentences = {
      {"interface multigrid",
       "multigrid with an exact solve on the contact interface: iterations depend neither on the penalty nor on the mesh"},
      {"block diagonal", "for systems with multipliers: multigrid, and a Schur complement"},
      {"block triangular",
       "multiplicative: the residual of the multipliers includes the update of the displacement"},
      {"SIMPLE",
       "block triangular with a correction of the displacement through the diagonal of the stiffness"},
      {"direct",
       "a factorisation of the whole system: for small problems, and for nearly incompressible bodies"}};
    return sentence(sentences, name);
  }



  std::string
  about_schur_complement(const std::string &name)
  {
    static const Sentences sentences = {{"diagonal", "from the diagonal of the stiffness"},
                                        {"mass", "the mass of the multipliers, scaled"},
                                        {"interface",
                                         "from the stiffness of the contact interface, factorised"},
                                        {"multigrid", "by inner iterations with multigrid"}};
    return sentence(sentences, name);
  }
} // namespace Signorini
