#include <signorini/import/deck_model.h>

#include <algorithm>

namespace Signorini
{
  void
  DeckModel::leave_out(const std::string &what, const std::string &place)
  {
    const auto found = std::find_if(left_out.begin(), left_out.end(), [&](const auto &one) {
      return one.first == what;
    });
    if (found == left_out.end())
      left_out.push_back({what, {place}});
    else if (found->second.back() != place)
      found->second.push_back(place);
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



  // Without amplitude, a static step goes from the last value to the new one along a line.
  DeckModel::Points
  DeckModel::history(const Curve &curve) const
  {
    Points result;
    double value = 0;
    for (const Change &change : curve)
      if (change.step == 0)
        value = change.value;
    add(result, 0, value, 1);
    for (unsigned int s = 1; s <= steps.size(); ++s)
      {
        const Step   step   = steps[s - 1];
        const double period = step.end - step.begin;
        for (const Change &change : curve)
          if (change.step == s)
            {
              const auto amplitude = amplitudes.find(change.amplitude);
              if (amplitude == amplitudes.end())
                add(result, step.begin, value, period);
              else
                {
                  const Points &points = amplitude->second;
                  add(result, step.begin, change.value * value_at(points, 0), period);
                  for (const auto &[t, y] : points)
                    if (t > 0 && t < period)
                      add(result, step.begin + t, change.value * y, period);
                }
              value = change.value *
                      (amplitude == amplitudes.end() ? 1. : value_at(amplitude->second, period));
            }
        add(result, step.end, value, period);
      }
    return result;
  }
} // namespace Signorini
