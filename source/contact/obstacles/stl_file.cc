// SPDX-License-Identifier: Apache-2.0
#include "contact/obstacles/triangle_surface.h"
#include <signorini/base/text.h>
#include <signorini/parameters/raw.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    constexpr std::size_t header_size = 84, facet_size = 50; // of binary files, in bytes



    /// Reads a file into memory and parses it, as text or binary. Throws SceneError with the name
    /// of the file.
    class Reader
    {
    public:
      explicit Reader(const std::string &file_name)
        : file_name(file_name)
      {
        if (is_directory(file_name))
          fail("is a directory");
        std::ifstream in(file_name, std::ios::binary);
        if (!in)
          fail("cannot be opened");
        text.assign(std::istreambuf_iterator<char>(in), {});
      }

      Triangles
      read()
      {
        // Binary files may begin with the word `solid`, too; their length is determined by the
        // number of facets.
        if (text.size() >= header_size &&
            text.size() == header_size + facet_size * number<std::uint32_t>(header_size - 4))
          read_binary();
        else if (text.compare(0, 5, "solid") == 0)
          read_text();
        else
          fail("is no STL file, or ends too early");
        return std::move(triangles);
      }

    private:
      [[noreturn]] void
      fail(const std::string &what) const
      {
        throw SceneError("STL file '" + file_name + "' " + what);
      }

      /// A number of a binary file at a position in bytes.
      template <typename T>
      T
      number(const std::size_t at) const
      {
        T value;
        std::memcpy(&value, text.data() + at, sizeof(T));
        return value;
      }

      /// Add a vertex of the next triangle; equal vertices get one number.
      void
      add(const Point<3> &p)
      {
        if (!std::isfinite(p.norm()))
          fail("has a vertex that is no number");
        // Files list the three vertices of each triangle, so that each vertex occurs about six
        // times, with the same digits. Only equal vertices connect triangles.
        const unsigned int n       = triangles.vertices.size();
        const auto [entry, is_new] = index_of.insert({{{p[0], p[1], p[2]}}, n});
        if (is_new)
          triangles.vertices.push_back(p);
        if (n_corners % 3 == 0)
          triangles.corners.emplace_back();
        triangles.corners.back()[n_corners++ % 3] = entry->second;
      }

      /// Binary: after the header, each facet has a normal and three vertices in single precision,
      /// and two unused bytes.
      void
      read_binary()
      {
        for (std::size_t facet = header_size; facet < text.size(); facet += facet_size)
          // Vector 0 of a facet is its normal, which is ignored: it follows from the order of the
          // vertices.
          for (unsigned int v = 1; v < 4; ++v)
            {
              Point<3> p;
              for (unsigned int d = 0; d < 3; ++d)
                p[d] = number<float>(facet + 4 * (3 * v + d));
              add(p);
            }
      }

      /// Text: only the words `vertex` and `endfacet` are interpreted.
      void
      read_text()
      {
        std::istringstream words(text);
        for (std::string word; words >> word;)
          if (word == "vertex")
            {
              Point<3> p;
              if (!(words >> p[0] >> p[1] >> p[2]))
                fail("has a vertex without three coordinates");
              add(p);
            }
          else if (word == "endfacet" && n_corners % 3 != 0)
            fail("has a facet without three vertices");
        if (n_corners % 3 != 0)
          fail("ends within a facet");
      }

      const std::string                             file_name;
      std::string                                   text;
      Triangles                                     triangles;
      std::map<std::array<double, 3>, unsigned int> index_of; ///< of vertices
      std::size_t                                   n_corners = 0;
    };
  } // namespace



  Triangles
  read_stl(const std::string &file_name)
  {
    return Reader(file_name).read();
  }
} // namespace Signorini
