// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/decks/deck_reader.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

// The part of the reader for *MPC: nonlinear equations between displacements, which are linearised
// about the undeformed bodies, as CalculiX does in linear steps.

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// The sum over entries, each the number of a node in the list times a vector of factors, is
    /// zero.
    using Sum    = std::vector<std::pair<unsigned int, Tensor<1, 3>>>;
    using Places = std::vector<Point<3>>;

    /// Nodes further from the line or plane that they are to stay on are put there by CalculiX, in
    /// units of the distance of two nodes.
    constexpr double off = 1e-4;

    /// @return the direction from the first node to the second.
    Tensor<1, 3>
    first_direction(const Places &at)
    {
      const Tensor<1, 3> way = at[1] - at[0];
      if (way.norm() == 0)
        throw SceneError("its first two nodes coincide");
      return way / way.norm();
    }

    /// BEAM: the distance of two nodes remains.
    std::vector<Sum>
    keep_distance(const Places &at)
    {
      const Tensor<1, 3> along = first_direction(at);
      return {{{1, along}, {0, -along}}};
    }

    /// STRAIGHT: nodes stay on the line through the first two.
    std::vector<Sum>
    keep_on_line(const Places &at)
    {
      const Tensor<1, 3> along = first_direction(at);
      const double       size  = at[0].distance(at[1]);
      // Two directions across the line: one across the axis that is least along it, and the third.
      unsigned int least = 0;
      for (unsigned int d = 1; d < 3; ++d)
        if (std::abs(along[d]) < std::abs(along[least]))
          least = d;
      Tensor<1, 3> axis;
      axis[least]       = 1;
      Tensor<1, 3> side = cross_product_3d(along, axis);
      side /= side.norm();
      std::vector<Sum> result;
      for (unsigned int i = 2; i < at.size(); ++i)
        {
          const Tensor<1, 3> x     = at[i] - at[0];
          const double       share = x * along / size;
          if (cross_product_3d(along, x).norm() > off * size)
            throw SceneError("its nodes are not on one line");
          for (const Tensor<1, 3> &across : {side, cross_product_3d(along, side)})
            result.push_back({{i, across}, {0, -(1 - share) * across}, {1, -share * across}});
        }
      return result;
    }

    /// PLANE: nodes stay in a plane, that of the first two and of another one that is not on a line
    /// with these.
    std::vector<Sum>
    keep_in_plane(const Places &at)
    {
      const Tensor<1, 3> a     = at[1] - at[0];
      const auto         third = std::find_if(at.begin() + 2, at.end(), [&](const auto &x) {
        return cross_product_3d(a, x - at[0]).norm() > 1e-3 * a.norm() * (x - at[0]).norm();
      });
      if (third == at.end())
        throw SceneError("its nodes are on one line");
      const unsigned int k = third - at.begin();
      const Tensor<1, 3> b = *third - at[0], normal = cross_product_3d(a, b);
      const double       square = normal.norm_square();
      const Tensor<1, 3> n      = normal / normal.norm();
      std::vector<Sum>   result;
      for (unsigned int i = 2; i < at.size(); ++i)
        {
          if (i == k)
            continue;
          // Areas of triangles are the shares of the three nodes.
          const Tensor<1, 3> x = at[i] - at[0];
          if (std::abs(x * n) > off * a.norm())
            throw SceneError("its nodes are not in one plane");
          const double of_a = cross_product_3d(x, b) * normal / square,
                       of_b = cross_product_3d(a, x) * normal / square;
          result.push_back({{i, n}, {0, -(1 - of_a - of_b) * n}, {1, -of_a * n}, {k, -of_b * n}});
        }
      return result;
    }

    /// MEANROT: the mean of the rotations of nodes, each of which is listed three times, about the
    /// axis through their centre that is the position of the last node, is that node's first
    /// component.
    std::vector<Sum>
    give_mean_rotation(const Places &at)
    {
      const unsigned int n = (at.size() - 1) / 3;
      if (n == 0 || at.size() != 3 * n + 1)
        throw SceneError("each node has to be listed three times, and one more as axis");
      Tensor<1, 3> axis = at.back();
      if (axis.norm() == 0)
        throw SceneError("the position of its last node, which is the axis, is zero");
      axis /= axis.norm();
      Point<3> centre;
      for (unsigned int i = 0; i < n; ++i)
        centre += at[3 * i] / double(n);
      double size = 0;
      for (unsigned int i = 0; i < n; ++i)
        size = std::max(size, at[3 * i].distance(centre));
      std::vector<Tensor<1, 3>> factors(n);
      Tensor<1, 3>              mean;
      for (unsigned int i = 0; i < n; ++i)
        {
          Tensor<1, 3> arm = at[3 * i] - centre;
          arm -= (arm * axis) * axis;
          // Nodes on the axis have no rotation.
          if (arm.norm() > 1e-5 * size)
            factors[i] = cross_product_3d(axis, arm) / arm.norm_square();
          mean += factors[i] / double(n);
        }
      Sum sum;
      for (unsigned int i = 0; i < n; ++i)
        sum.emplace_back(3 * i, factors[i] - mean);
      Tensor<1, 3> first;
      first[0] = -double(n);
      sum.emplace_back(at.size() - 1, first);
      return {sum};
    }
  } // namespace



  // Data lines: the kind, then nodes or sets of nodes; 0 instead of the kind continues the line
  // before.
  void
  DeckReader::read_mpcs()
  {
    std::string               kind;
    std::vector<unsigned int> nodes;
    for (Words words; in.next_line(words);)
      {
        if (words[0] != "0" && !words[0].empty())
          {
            add_mpc(kind, nodes);
            nodes.clear();
            kind = upper_case(words[0]);
          }
        for (unsigned int i = 1; i < words.size(); ++i)
          if (!words[i].empty())
            {
              const std::vector<unsigned int> more = nodes_of(words[i]);
              nodes.insert(nodes.end(), more.begin(), more.end());
            }
      }
    add_mpc(kind, nodes);
  }



  // What is not known here, or would move nodes, is left out.
  void
  DeckReader::add_mpc(const std::string &kind, const std::vector<unsigned int> &nodes)
  {
    static const std::map<std::string, std::vector<Sum> (*)(const Places &)> kinds = {
      {"BEAM", keep_distance},
      {"STRAIGHT", keep_on_line},
      {"PLANE", keep_in_plane},
      {"MEANROT", give_mean_rotation}};
    if (kind.empty())
      return;
    const auto  linearised = kinds.find(kind);
    std::string why        = linearised == kinds.end() ? "is not known here" :
                             nodes.size() < 2          ? "it has fewer than two nodes" :
                                                         "";
    Places      at;
    for (const unsigned int node : nodes)
      at.push_back(model.deck.mesh.nodes[node]);
    if (why.empty())
      try
        {
          for (const Sum &sum : linearised->second(at))
            {
              DeckModel::Equation equation;
              for (const auto &[i, factors] : sum)
                for (unsigned int d = 0; d < 3; ++d)
                  if (factors[d] != 0)
                    equation.push_back({nodes[i], d, factors[d]});
              model.equations.push_back(equation);
            }
          model.has_linearised_equations = true;
          return;
        }
      catch (const SceneError &error)
        {
          why = error.what();
        }
    skip_item(kind + ": " + why);
    model.lacks_supports = true;
  }
} // namespace Signorini
