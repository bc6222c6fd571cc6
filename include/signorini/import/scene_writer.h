#pragma once

#include <signorini/import/deck_model.h>
#include <signorini/mesh/pieces.h>

#include <iosfwd>

namespace Signorini
{
  /// Writes the scene of a deck's model, section by section; the bodies are found
  /// in deck_bodies.cc.
  class SceneWriter
  {
  public:
    SceneWriter(DeckModel model, const std::string &file);

    /// Throws SceneError if no elastic solid is left.
    void
    write(std::ostream &scene);

    /// What was left out, one line each.
    std::vector<std::string>
    left_out() const;

  private:
    struct Body
    {
      std::string           name, part, material;
      std::vector<bool>     has_node, has_element;
      std::set<std::string> boundaries; ///< names of surfaces and sets with faces of it
      double                thickness           = 1;
      bool                  is_quadratic        = false;
      double                initial_temperature = 0;
      DeckModel::Curve      temperature; ///< empty without thermal strain
    };

    /// Without what the scene file has a meaning for.
    static std::string
    as_name(std::string name);

    void
    make_bodies();
    void
    give_material(Body &body, const Piece &piece);
    void
    give_temperature(Body &body);
    std::set<std::string>
    boundaries_of(const Piece &piece) const;

    std::string
    bodies() const;
    std::string
    supports();
    std::string
    loads();
    std::string
    pairs();
    std::string
    steps() const;
    std::string
    method();
    std::string
    free_motions() const;

    std::string
    targets(const DeckModel::AtNodes &at, const std::string &what);
    std::string
    surfaces(const std::string &surface, const std::string &what);
    std::string
    forces(const DeckModel::AtNodes &at) const;
    std::string
    formula(const DeckModel::Curve &curve, double factor = 1) const;
    std::string
    vector_formula(const std::array<DeckModel::Curve, 3> &components,
                   const std::string                     &otherwise,
                   double                                 factor = 1) const;

    DeckModel         model;
    const std::string file;
    unsigned int      dim = 3;
    std::string       kind; ///< of 2D: plane strain, ...
    std::vector<Body> all;
  };
} // namespace Signorini
