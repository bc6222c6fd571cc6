// SPDX-License-Identifier: Apache-2.0
#include "mesh_import/decks/deck_model.h"

#include <signorini/parameters/raw.h>

#include <algorithm>

namespace Signorini
{
  namespace
  {
    /// What a keyword stands for, or a longer text that begins with it.
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
          "EMBEDDED ELEMENT",
          "EQUATION",
          "KINEMATIC",
          "MPC",
          "RIGID BODY",
          "SPRING",
          "TIE",
          "TRANSFORM"}},
        {"motion", {"BASE MOTION"}},
        {"pair", {"CLEARANCE", "CONTACT PAIR", "CONTACT", "CONTACT INCLUSIONS", "MODEL CHANGE"}},
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
          "CHANGE FRICTION",
          "COMPLEX FREQUENCY",
          "BUCKLE",
          "CONTACT DAMPING",
          "CONTACT PROPERTY ASSIGNMENT",
          "COUPLED TEMPERATURE-DISPLACEMENT",
          "DAMPING",
          "DEPVAR",
          "DYNAMIC",
          "FREQUENCY",
          "FRICTION",
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
    /// Points must not have the same time: a jump takes a small part of the step.
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

    /// Step 0 is reached in step 1, if that says nothing else.
    Model::Curve
    from_first_step(Model::Curve curve)
    {
      if (curve.size() > 1 && curve[0].step == 0 && curve[1].step == 1)
        curve.erase(curve.begin());
      if (!curve.empty() && curve[0].step == 0)
        curve[0].step = 1;
      return curve;
    }



    /// One step of a value that an amplitude scales. Returns its end.
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
        const Step  &step   = steps[s - 1];
        const double period = step.end - step.begin, before = value;
        bool         is_new = false;
        for (const Change &change : curve)
          if (change.step == s)
            {
              last   = &change;
              is_new = true;
            }
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
            if (result.spans.empty() || result.spans.back().second != step.begin)
              result.spans.emplace_back(step.begin, step.end);
            result.spans.back().second = step.end;
          }
      }
    if (steps.empty() && !curve.empty())
      result.points[0].second = curve.back().value;
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
