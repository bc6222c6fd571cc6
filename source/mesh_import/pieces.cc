// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/pieces.h"

#include "geometry/connected.h"
#include "mesh_import/division/cell_shape.h"
#include "mesh_import/division/centers.h"
#include "mesh_import/division/chosen_cells.h"

#include <algorithm>
#include <map>
#include <sstream>
#include <unordered_set>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    /// Name the pieces: by the group whose cells are just those of the piece, otherwise piece1,
    /// piece2, ...
    void
    name(std::vector<Piece> &pieces, const MeshFile &file, const unsigned int dim)
    {
      std::map<std::vector<unsigned int>, std::string> names;
      for (const auto &group : file.groups)
        {
          std::vector<unsigned int> cells;
          for (const unsigned int e : group.elements)
            if (dimension_of(file.elements[e].shape) == dim)
              cells.push_back(e);
          std::sort(cells.begin(), cells.end());
          cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
          names.insert({cells, group.name});
        }
      for (unsigned int i = 0; i < pieces.size(); ++i)
        {
          const auto found   = names.find(pieces[i].elements);
          pieces[i].is_named = found != names.end();
          pieces[i].name     = pieces[i].is_named ? found->second : "piece" + std::to_string(i + 1);
        }
    }
  } // namespace



  std::string
  description(const Piece &piece)
  {
    const auto &[low, high] = piece.box.get_boundary_points();
    std::ostringstream text;
    text << piece.name << " (" << piece.elements.size()
         << (piece.elements.size() == 1 ? " cell" : " cells") << " from (" << low << ") to ("
         << high << "))";
    return text.str();
  }



  std::vector<Piece>
  pieces_of(const MeshFile &file, const unsigned int dim, const std::vector<bool> &wanted)
  {
    // Elements that share a node are connected, by union-find over the nodes. Pieces are numbered
    // in the order of their first elements.
    const auto is_cell = [&](const unsigned int e) {
      return (wanted.empty() || wanted[e]) && dimension_of(file.elements[e].shape) == dim;
    };
    Connected nodes(file.nodes.size());
    for (unsigned int e = 0; e < file.elements.size(); ++e)
      if (is_cell(e))
        for (const unsigned int node : file.elements[e].nodes)
          nodes.connect(file.elements[e].nodes[0], node);

    std::vector<Piece>                   pieces;
    std::map<unsigned int, unsigned int> piece_of; // by the first node
    for (unsigned int e = 0; e < file.elements.size(); ++e)
      if (is_cell(e))
        {
          const MeshFile::Nodes &members = file.elements[e].nodes;
          const auto [entry, is_new] = piece_of.insert({nodes.first_of(members[0]), pieces.size()});
          const Point<3> &first      = file.nodes[members[0]];
          if (is_new)
            pieces.push_back({"", false, {}, BoundingBox<3>({first, first})});
          Piece &piece = pieces[entry->second];
          piece.elements.push_back(e);
          for (const unsigned int node : members)
            piece.box.merge_with(BoundingBox<3>({file.nodes[node], file.nodes[node]}));
        }
    name(pieces, file, dim);
    return pieces;
  }



  void
  add_pieces(MeshFile &file, const unsigned int dim)
  {
    const std::vector<Piece> pieces = pieces_of(file, dim);
    if (pieces.size() > 1)
      for (const Piece &piece : pieces)
        if (!piece.is_named)
          file.group(piece.name).elements = piece.elements;
  }



  std::vector<std::string>
  neighbours_of(const MeshFile &file, const unsigned int dim, const std::string &part)
  {
    if (part.empty())
      return {};
    std::vector<bool> is_own(file.elements.size());
    for (const unsigned int e : cells_of_part(file, dim, part))
      is_own[e] = true;
    const auto keys_of = [&](const MeshFile::Element &cell) {
      std::vector<Centers::Key> keys;
      for (const MeshFile::Nodes &places : CellShape::of(cell.shape).faces)
        keys.push_back(Centers::key(nodes_at(cell, places)));
      return keys;
    };
    std::unordered_set<Centers::Key, Centers::Hash> faces;
    for (unsigned int e = 0; e < is_own.size(); ++e)
      if (is_own[e])
        for (const Centers::Key &key : keys_of(file.elements[e]))
          faces.insert(key);
    // A cell may be in several groups, but is compared once.
    std::vector<bool> is_neighbour(file.elements.size());
    for (const unsigned int e : cells_of_part(file, dim, ""))
      if (!is_own[e])
        for (const Centers::Key &key : keys_of(file.elements[e]))
          is_neighbour[e] = is_neighbour[e] || faces.count(key) > 0;
    std::vector<std::string> result;
    for (const auto &group : file.groups)
      if (std::any_of(group.elements.begin(), group.elements.end(), [&](const unsigned int e) {
            return is_neighbour[e];
          }))
        result.push_back(group.name);
    return result;
  }



  template <int dim>
  std::vector<unsigned int>
  pieces_of(const std::vector<CellData<dim>> &cells, const unsigned int n_vertices)
  {
    Connected vertices(n_vertices);
    for (const auto &cell : cells)
      for (const unsigned int vertex : cell.vertices)
        vertices.connect(cell.vertices[0], vertex);
    std::map<unsigned int, unsigned int> number_of;
    std::vector<unsigned int>            result;
    for (const auto &cell : cells)
      result.push_back(
        number_of.insert({vertices.first_of(cell.vertices[0]), number_of.size()}).first->second);
    return result;
  }



  template std::vector<unsigned int>
  pieces_of(const std::vector<CellData<2>> &, unsigned int);
  template std::vector<unsigned int>
  pieces_of(const std::vector<CellData<3>> &, unsigned int);
} // namespace Signorini
