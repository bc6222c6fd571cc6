// SPDX-License-Identifier: Apache-2.0
#include "solid/unsupported_modes.h"

#include "geometry/cell_size.h"
#include "linear_algebra/dense.h"
#include "solid/cell_nodes.h"
#include "solid/equation_lines.h"
#include "solid/rigid_body_modes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>


namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The name of a combination of rigid-body modes: that of its largest component.
    template <int dim>
    std::string
    mode_name(const Vector<double> &mode)
    {
      const auto largest =
        std::max_element(mode.begin(),
                         mode.end(),
                         [](const double a, const double b) { return std::abs(a) < std::abs(b); }) -
        mode.begin();
      return RigidBody<dim>::name_of(largest);
    }

    /// The rigid-body modes of each connected piece, about the center of its bounding box.
    template <int dim>
    std::vector<RigidBodyModes<dim>>
    modes_of_pieces(const Mesh<dim> &mesh)
    {
      std::vector<RigidBodyModes<dim>> result;
      for (const BodyPiece<dim> &piece : mesh.pieces())
        result.emplace_back(piece.extent);
      return result;
    }

    /// Call visit(body, i) for the free components i of moving rigid bodies.
    template <int dim, typename Visit>
    void
    for_free_components(const Displacements<dim> &displacements, const Visit &visit)
    {
      for (unsigned int body = 0; body < displacements.rigid_bodies().size(); ++body)
        for (unsigned int i = 0; i < RigidBody<dim>::n_dofs; ++i)
          if (displacements.is_free(body, i))
            visit(body, i);
    }

    /// Orthonormal combinations of the modes in the kernel of a Gram matrix of constrained
    /// directions: those that move no constrained direction. Eigenvalues below 1e-8 of the matrix
    /// norm (plus 1) count as zero.
    template <int dim>
    std::vector<Vector<double>>
    kernel_of(const FullMatrix<double> &gram)
    {
      constexpr unsigned int n = RigidBodyModes<dim>::n;
      Eigen::MatrixXd        matrix(n, n);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < n; ++j)
          matrix(i, j) = gram(i, j);
      const SymmetricEigenpairs pairs = eigenpairs_of_symmetric(matrix);
      // Modes are scaled to the size of the piece, so that a constrained direction contributes
      // about one. Adding one keeps the tolerance positive if nothing is constrained at all.
      const double                scale = 1 + gram.linfty_norm();
      std::vector<Vector<double>> result;
      for (unsigned int i = 0; i < n; ++i)
        if (pairs.values[i] < 1e-8 * scale)
          {
            result.emplace_back(n);
            for (unsigned int j = 0; j < n; ++j)
              result.back()[j] = pairs.vectors(j, i);
          }
      return result;
    }
  } // namespace



  template <int dim>
  UnsupportedModes<dim>::UnsupportedModes(const Displacements<dim> &displacements)
    : displacements(displacements)
  {}



  // For each piece the Gram matrix G_ab = sum over constrained directions n of (n . z_a)(n . z_b)
  // of its rigid-body modes z. Modes in its kernel are unconstrained by supports. Nodes are summed
  // on their owners, then over ranks. Collective.
  template <int dim>
  std::vector<FullMatrix<double>>
  UnsupportedModes<dim>::gram_of_constrained_directions() const
  {
    constexpr unsigned int                 n     = RigidBodyModes<dim>::n;
    const std::vector<RigidBodyModes<dim>> modes = modes_of_pieces(displacements.mesh());
    std::vector<FullMatrix<double>>        gram(modes.size(), FullMatrix<double>(n));
    // Orthonormal directions count a direction once that several supports constrain. A direction
    // that depends on earlier ones is the zero vector and adds nothing.
    for (const auto &[index, node] : displacements.constrained_nodes())
      if (displacements.owned().is_element(index))
        for (const Tensor<1, dim> &direction : node.orthonormal())
          {
            std::array<double, n> along{};
            for (unsigned int d = 0; d < dim; ++d)
              {
                const auto at = modes[node.piece].at(node.position, d);
                for (unsigned int a = 0; a < n; ++a)
                  along[a] += direction[d] * at[a];
              }
            for (unsigned int a = 0; a < n; ++a)
              for (unsigned int b = 0; b < n; ++b)
                gram[node.piece](a, b) += along[a] * along[b];
          }
    for (FullMatrix<double> &one : gram)
      Utilities::MPI::sum(one, displacements.mesh().communicator(), one);
    return gram;
  }



  // Equations hold the modes of a piece against pieces that cannot move, and against itself. Those
  // between several pieces that can move are left out: such pieces count as unconstrained.
  template <int dim>
  void
  UnsupportedModes<dim>::add_equations(std::vector<FullMatrix<double>> &gram) const
  {
    constexpr unsigned int                 n     = RigidBodyModes<dim>::n;
    const std::vector<RigidBodyModes<dim>> modes = modes_of_pieces(displacements.mesh());
    auto                                   rest  = displacements.constraint_equations().terms();
    std::vector<bool>                      moves;
    for (const FullMatrix<double> &one : gram)
      moves.push_back(!kernel_of<dim>(one).empty());
    for (bool any_added = !rest.empty(); any_added;)
      {
        any_added = false;
        for (auto &equation : rest)
          {
            std::set<unsigned int> pieces;
            for (const auto &term : equation)
              if (moves[term.node->piece])
                pieces.insert(term.node->piece);
            if (pieces.size() != 1)
              continue;
            const unsigned int    piece = *pieces.begin();
            std::array<double, n> along{};
            double                scale = 0;
            for (const auto &[node, component, factor] : equation)
              if (node->piece == piece)
                {
                  const auto at = modes[piece].at(node->position, component);
                  for (unsigned int a = 0; a < n; ++a)
                    along[a] += factor * at[a];
                  scale = std::max(scale, std::abs(factor));
                }
            for (unsigned int a = 0; a < n; ++a)
              for (unsigned int b = 0; b < n; ++b)
                gram[piece](a, b) += along[a] * along[b] / (scale * scale);
            equation.clear();
            moves[piece] = !kernel_of<dim>(gram[piece]).empty();
            any_added    = true;
          }
      }
  }



  // Determine the unconstrained combinations of rigid-body modes of all pieces; the small
  // eigenvalue problems are solved on each rank. Collective.
  template <int dim>
  void
  UnsupportedModes<dim>::find()
  {
    of_pieces.clear();
    std::vector<FullMatrix<double>> gram = gram_of_constrained_directions();
    add_equations(gram);
    for (unsigned int piece = 0; piece < gram.size(); ++piece)
      {
        if (displacements.model() == Model::axisymmetric)
          // Radial displacements and tilting are resisted by the hoop strain; only the translation
          // along the axis can be free.
          for (const unsigned int a : {0, 2})
            gram[piece](a, a) += 1 + gram[piece].linfty_norm();
        for (const Vector<double> &modes : kernel_of<dim>(gram[piece]))
          of_pieces.push_back({piece, modes});
      }
  }



  // Free components of rigid obstacles are unconstrained without any eigenvalue problem.
  template <int dim>
  bool
  UnsupportedModes<dim>::any() const
  {
    bool result = !of_pieces.empty();
    for_free_components<dim>(displacements, [&](auto, auto) { result = true; });
    return result;
  }



  // The order of names is that of motions(): first the pieces of the mesh, then the obstacles.
  template <int dim>
  std::vector<std::string>
  UnsupportedModes<dim>::names() const
  {
    std::vector<std::string> result;
    for (const PieceMotion &motion : of_pieces)
      result.push_back(displacements.mesh().pieces()[motion.piece].name + ": " +
                       mode_name<dim>(motion.modes));
    const std::vector<RigidBody<dim>> &bodies = displacements.rigid_bodies();
    for_free_components<dim>(displacements, [&](const unsigned int body, const unsigned int i) {
      result.push_back(bodies[body].name_of_motion(i));
    });
    return result;
  }



  // Diagonal stiffness Sigma of doc/theory, 4.10: for each piece with free modes, strength E/L^2
  // per volume, distributed equally to the degrees of freedom of each cell, so that modes of size
  // one have about the stiffness strength E L.
  template <int dim>
  LA::Vector
  UnsupportedModes<dim>::stabilisation(const std::vector<Material> &materials,
                                       const double                 of_rigid_bodies,
                                       const double                 strength) const
  {
    if (!any())
      return {};
    const Mesh<dim>    &mesh = displacements.mesh();
    std::vector<double> per_volume(mesh.pieces().size(), 0.);
    for (const PieceMotion &motion : of_pieces)
      {
        const BodyPiece<dim> &piece = mesh.pieces()[motion.piece];
        const double          size  = RigidBodyModes<dim>(piece.extent).size();
        per_volume[motion.piece] =
          strength * materials[mesh.own_material(piece.body)].youngs_modulus / (size * size);
      }

    LA::Vector                           result = displacements.zero_vector();
    std::vector<types::global_dof_index> indices;
    for (const auto &cell : displacements.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned() && per_volume[mesh.piece(cell)] > 0)
        {
          read_indices<dim>(cell, indices);
          // A cell has indices.size()/dim nodes for each of its dim components: each degree of
          // freedom gets its part of the stiffness per volume times the volume.
          const double share = per_volume[mesh.piece(cell)] * volume_of(cell) *
                               measure(displacements.model(), cell->center()) * dim /
                               indices.size();
          for (const auto i : indices)
            if (!displacements.constraints().is_constrained(i))
              result(i) += share;
        }
    for_free_components<dim>(displacements, [&](const unsigned int body, const unsigned int i) {
      const auto dof = displacements.first_dof(body) + i;
      if (displacements.owned().is_element(dof))
        result(dof) += strength * of_rigid_bodies;
    });
    result.compress(VectorOperation::add);
    return result;
  }



  // The values of the modes at the nodes of their piece; zero at constrained degrees of freedom.
  template <int dim>
  void
  UnsupportedModes<dim>::set_motions_of_pieces(std::vector<UnconstrainedMode> &result) const
  {
    const Mesh<dim>                       &mesh  = displacements.mesh();
    const std::vector<RigidBodyModes<dim>> modes = modes_of_pieces(mesh);
    CellNodes<dim>                         nodes_of(mesh, displacements.finite_elements());
    std::vector<types::global_dof_index>   indices;
    for (const auto &cell : displacements.dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        for (unsigned int k = 0; k < of_pieces.size(); ++k)
          // A node belongs to one piece only, so that each entry is set by cells of the same piece,
          // and always to the same value.
          if (of_pieces[k].piece == mesh.piece(cell))
            {
              const std::vector<Point<dim>> &nodes = nodes_of(cell);
              read_indices<dim>(cell, indices);
              for (unsigned int i = 0; i < indices.size(); ++i)
                if (displacements.owned().is_element(indices[i]) &&
                    !displacements.constraints().is_constrained(indices[i]))
                  {
                    const unsigned int c   = cell->get_fe().system_to_component_index(i).first;
                    const auto         at  = modes[of_pieces[k].piece].at(nodes[i], c);
                    double             sum = 0;
                    for (unsigned int m = 0; m < at.size(); ++m)
                      sum += at[m] * of_pieces[k].modes[m];
                    result[k].motion(indices[i]) = sum;
                  }
            }
  }



  // Displacement fields of the unconstrained modes; each entry is set by the rank that owns it. A
  // free component of an obstacle is the unit vector of its degree of freedom. Collective.
  template <int dim>
  std::vector<UnconstrainedMode>
  UnsupportedModes<dim>::motions() const
  {
    std::vector<UnconstrainedMode> result;
    for (const std::string &name : names())
      result.push_back({name, displacements.zero_vector()});
    set_motions_of_pieces(result);
    unsigned int k = of_pieces.size();
    for_free_components<dim>(displacements, [&](const unsigned int body, const unsigned int i) {
      const auto dof = displacements.first_dof(body) + i;
      if (displacements.owned().is_element(dof))
        result[k].motion(dof) = 1;
      ++k;
    });
    for (UnconstrainedMode &one : result)
      one.motion.compress(VectorOperation::insert);
    return result;
  }



  template class UnsupportedModes<2>;
  template class UnsupportedModes<3>;
} // namespace Signorini
