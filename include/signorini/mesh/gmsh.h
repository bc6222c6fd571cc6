#pragma once

#include <deal.II/base/point.h>

#include <array>
#include <map>
#include <string>
#include <vector>

namespace Signorini
{
  /// What an ASCII mesh file of Gmsh (format 2.2 or 4.1) says. Own reader, because GridIn::read_msh
  /// drops the names, cannot take one part out of a file, and gives up on named interior faces.
  struct GmshFile
  {
    /// Physical names, by dimension and then by tag.
    using Groups = std::array<std::map<int, std::string>, 4>;

    struct Element
    {
      unsigned int              dimension, type; ///< type as Gmsh numbers it: 1 line, 3 quad, 5 hex
      int                       group;           ///< physical tag, 0 if none
      std::vector<unsigned int> nodes;           ///< indices into `nodes`, in Gmsh's order
    };

    Groups                        groups;
    std::vector<dealii::Point<3>> nodes;
    std::vector<Element>          elements;
  };

  /// Throws SceneError with the name of the file if it is not such a file.
  GmshFile
  read_gmsh(const std::string &file_name);

  /// The names alone: reads no further than they go.
  GmshFile::Groups
  read_gmsh_groups(const std::string &file_name);
} // namespace Signorini
