// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/decks/deck_model.h"

#include <signorini/parameters/raw.h>

#include <algorithm>

namespace Signorini
{
  namespace
  {
    /// @return the kind of what was skipped (see SkippedItem), by the longest keyword with which
    /// the text begins; "keyword" if there is none.
    std::string
    kind_of(const std::string &what)
    {
      static const std::map<std::string, std::vector<std::string>> keywords = {
        {"load",
         {"AMPLITUDE",
          "CLOAD",
          "DLOAD",
          "DSLOAD",
          "INITIAL CONDITIONS",
          "PRE-TENSION SECTION",
          "TEMPERATURE"}},
        {"support",
         {"BOUNDARY",
          "CONNECTOR",
          "COUPLING",
          "CYCLIC SYMMETRY MODEL",
          "DISTRIBUTING",
          "DISTRIBUTING COUPLING",
          "EMBEDDED ELEMENT",
          "EQUATION",
          "KINEMATIC",
          "KINEMATIC COUPLING",
          "MPC",
          "RIGID BODY",
          "SPRING",
          "TIE",
          "TRANSFORM"}},
        {"motion", {"BASE MOTION"}},
        {"pair",
         {"CHANGE FRICTION",
          "CHANGE SURFACE BEHAVIOR",
          "CLEARANCE",
          "CONTACT PAIR",
          "CONTACT",
          "CONTACT INCLUSIONS",
          "FRICTION",
          "MODEL CHANGE"}},
        {"body", {"BEAM SECTION", "MEMBRANE SECTION", "SHELL SECTION"}},
        {"material",
         {"CREEP",
          "CYCLIC HARDENING",
          "ELASTIC",
          "EXPANSION",
          "HYPERELASTIC",
          "ORIENTATION",
          "PLASTIC",
          "SURFACE BEHAVIOR"}},
        {"model",
         {"BOUNDARY of rotations",
          "COMPLEX FREQUENCY",
          "BUCKLE",
          "CONTACT DAMPING",
          "CONTACT PROPERTY ASSIGNMENT",
          "COUPLED TEMPERATURE-DISPLACEMENT",
          "DAMPING",
          "DEPVAR",
          "DYNAMIC",
          "FREQUENCY",
          "GAP CONDUCTANCE",
          "GREEN",
          "HEAT TRANSFER",
          "MASS",
          "MODAL DYNAMIC",
          "SENSITIVITY",
          "SOLID SECTION",
          "STATIC",
          "STEADY STATE DYNAMICS",
          "STEP",
          "SURFACE INTERACTION",
          "UNCOUPLED TEMPERATURE-DISPLACEMENT",
          "VISCO"}}};
      std::string kind = "keyword", longest;
      for (const auto &[one, names] : keywords)
        for (const std::string &name : names)
          if (what.compare(0, name.size() + 1, "*" + name) == 0 && name.size() > longest.size())
            {
              kind    = one;
              longest = name;
            }
      return kind;
    }
  } // namespace



  // The same item at several positions of the file is one entry.
  void
  DeckModel::skip_item(const std::string &what, const std::string &place, const std::string &kind)
  {
    const auto found = std::find_if(skipped_items.begin(),
                                    skipped_items.end(),
                                    [&](const Omission &one) { return one.what == what; });
    if (found == skipped_items.end())
      skipped_items.push_back({kind.empty() ? kind_of(what) : kind, what, {place}});
    else if (found->places.back() != place)
      found->places.push_back(place);
  }



  namespace
  {
    /// Append a point to a polygon. Times must increase: a jump takes a small part of the period, a
    /// point that repeats the last one is dropped.
    void
    add(DeckModel::Points &points, double t, const double value, const double period)
    {
      if (!points.empty() && t <= points.back().first)
        {
          if (points.back().second == value)
            return;
          t = points.back().first + 1e-9 * period;
        }
      points.emplace_back(t, value);
    }



    /// @return the polygon at time t, constant before its first and behind its last point; 1 if it
    /// has no points.
    double
    value_at(const DeckModel::Points &points, const double t)
    {
      if (points.empty())
        return 1;
      if (t <= points.front().first)
        return points.front().second;
      for (unsigned int i = 1; i < points.size(); ++i)
        if (t <= points[i].first)
          {
            const auto &[t0, y0] = points[i - 1];
            const auto &[t1, y1] = points[i];
            return t1 > t0 ? y0 + (y1 - y0) * (t - t0) / (t1 - t0) : y1;
          }
      return points.back().second;
    }
  } // namespace



  namespace
  {
    using Model = DeckModel;
    using Kind  = Model::Change::Kind;

    /// @return a curve whose value of step 0 (the model before all steps) is reached in step 1,
    /// unless step 1 has one of its own.
    Model::Curve
    from_first_step(Model::Curve curve)
    {
      if (curve.size() > 1 && curve[0].step == 0 && curve[1].step == 1)
        curve.erase(curve.begin());
      if (!curve.empty() && curve[0].step == 0)
        curve[0].step = 1;
      return curve;
    }



    /// Append one step of a value that an amplitude scales.
    /// @return the value at the end of the step
    double
    add_amplitude(Model::Points          &result,
                  const Model::Amplitude &amplitude,
                  const Model::Step      &step,
                  const double            size)
    {
      const double start = amplitude.is_total ? step.begin : 0, period = step.end - step.begin;
      const auto at = [&](const double t) { return size * value_at(amplitude.points, start + t); };
      add(result, step.begin, at(0), period);
      for (const auto &[t, y] : amplitude.points)
        if (t > start && t < start + period)
          add(result, step.begin + t - start, size * y, period);
      add(result, step.end, at(period), period);
      return at(period);
    }
  } // namespace



  // Step by step: `last` is the valid change, `value` the value at the end of the step. Without
  // amplitude the value is ramped, or constant from the beginning of the step (AMPLITUDE=STEP);
  // with one it follows its points. Spans of time in which the value is prescribed are joined.
  DeckModel::History
  DeckModel::history(const Curve &given, const bool is_initial) const
  {
    const Curve   curve = is_initial ? given : from_first_step(given);
    History       result;
    double        value = is_initial && !curve.empty() && curve[0].step == 0 ? curve[0].value : 0;
    const Change *last  = nullptr;
    add(result.points, 0, value, 1);
    for (unsigned int s = 1; s <= steps.size(); ++s)
      {
        // Find the change of this step, if there is one.
        const Step  &step   = steps[s - 1];
        const double period = step.end - step.begin, before = value;
        bool         is_new = false;
        for (const Change &change : curve)
          if (change.step == s)
            {
              last   = &change;
              is_new = true;
            }
        // An amplitude in step time holds in its own step only; one in total time in later steps
        // too.
        const auto amplitude =
          last && last->kind == Kind::value ? amplitudes.find(last->amplitude) : amplitudes.end();
        if (amplitude != amplitudes.end() && (is_new || amplitude->second.is_total))
          value = add_amplitude(result.points, amplitude->second, step, last->value);
        else
          {
            if (is_new)
              value = last->kind == Kind::value ? last->value : 0;
            if (last && last->kind == Kind::velocity)
              value = before + last->value * period;
            const bool is_jump = is_new && (last->kind == Kind::removed || step.is_constant);
            add(result.points, step.begin, is_jump ? value : before, period);
            add(result.points, step.end, value, period);
          }
        if (last && last->kind != Kind::removed)
          {
            // The value is prescribed in this step: extend the last span, or begin a new one.
            if (result.spans.empty() || result.spans.back().second != step.begin)
              result.spans.emplace_back(step.begin, step.end);
            result.spans.back().second = step.end;
          }
      }
    if (steps.empty() && !curve.empty())
      result.points[0].second = curve.back().value;
    return result;
  }



  bool
  DeckModel::is_reference(const unsigned int node) const
  {
    return std::any_of(couplings.begin(),
                       couplings.end(),
                       [&](const Coupling &one) {
                         return one.reference == node || one.rotation == node;
                       }) ||
           std::any_of(pretensions.begin(), pretensions.end(), [&](const PretensionSection &one) {
             return one.reference == node;
           });
  }



  std::vector<unsigned int>
  DeckModel::nodes_of(const Coupling &coupling) const
  {
    std::vector<unsigned int> result = coupling.nodes;
    if (coupling.is_surface)
      for (const Face &face : faces_of(coupling.name))
        result.insert(result.end(), face.begin(), face.end());
    return result;
  }



  std::set<DeckModel::Face>
  DeckModel::faces_of(const std::string &surface) const
  {
    std::set<Face> faces;
    for (const auto &group : deck.mesh.groups)
      if (upper_case(group.name) == upper_case(surface))
        for (Face face : group.faces)
          {
            std::sort(face.begin(), face.end());
            faces.insert(face);
          }
    return faces;
  }
} // namespace Signorini
