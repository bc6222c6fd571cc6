#include <signorini/parameters/section.h>
#include <signorini/parameters/text.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iomanip>
#include <ostream>
#include <set>
#include <sstream>
#include <type_traits>

namespace Signorini
{
  using namespace dealii;

  namespace
  {
    std::string
    number_text(const double x)
    {
      // The shortest text that reads back as the same number.
      for (int digits = 6; digits <= 17; ++digits)
        {
          std::ostringstream text;
          text << std::setprecision(digits) << x;
          if (std::stod(text.str()) == x)
            return text.str();
        }
      return "nan";
    }

    std::string
    to_text(const double value)
    {
      return std::isfinite(value) ? number_text(value) : (value > 0 ? "infinity" : "-infinity");
    }

    std::string
    to_text(const unsigned int value)
    {
      return std::to_string(value);
    }

    std::string
    to_text(const bool value)
    {
      return value ? "yes" : "no";
    }

    std::string
    to_text(const std::string &value)
    {
      return value;
    }

    std::string
    to_text(const Formula &value)
    {
      return value.text;
    }

    template <typename T>
    std::string
    to_text(const std::vector<T> &values)
    {
      std::vector<std::string> words;
      for (const T &value : values)
        words.push_back(to_text(value));
      return join(words);
    }

    template <int dim>
    std::string
    to_text(const Point<dim> &p)
    {
      std::vector<double> coordinates(dim);
      for (unsigned int d = 0; d < dim; ++d)
        coordinates[d] = p[d];
      return to_text(coordinates);
    }

    template <int dim>
    std::string
    to_text(const Expression<dim> &value)
    {
      return value.formula();
    }

    template <int dim, int n_components>
    std::string
    to_text(const VectorExpression<dim, n_components> &value)
    {
      return value.text();
    }

    /// Of which the formula that it came from is more than its value.
    template <typename T>
    constexpr bool
    is_number(const T &)
    {
      return !(std::is_same_v<T, bool> || std::is_same_v<T, std::string> ||
               std::is_same_v<T, std::vector<std::string>>);
    }

    /// What the user writes for a value of that type, for the reference.
    std::string
    type_name(const double)
    {
      return "number";
    }

    std::string
    type_name(const unsigned int)
    {
      return "whole number";
    }

    std::string
    type_name(const bool)
    {
      return "yes or no";
    }

    std::string
    type_name(const std::string &)
    {
      return "text";
    }

    std::string
    type_name(const Formula &)
    {
      return "text or formula";
    }

    std::string
    type_name(const std::vector<std::string> &)
    {
      return "names";
    }

    template <typename T>
    std::string
    type_name(const std::vector<T> &)
    {
      return type_name(T()) + "s";
    }

    template <int dim>
    std::string
    type_name(const Point<dim> &)
    {
      return std::to_string(dim) + " numbers";
    }

    template <int dim>
    std::string
    type_name(const Expression<dim> &)
    {
      return "formula";
    }

    template <int dim, int n_components>
    std::string
    type_name(const VectorExpression<dim, n_components> &)
    {
      return n_components == 1 ? "formula" : std::to_string(n_components) + " formulas";
    }

    template <typename T>
    void
    check_range(const T &, const Range &)
    {}

    void
    check_range(const double value, const Range &range)
    {
      if (!range.contains(value))
        throw SceneError("must be " + range.text());
    }

    void
    check_range(const unsigned int value, const Range &range)
    {
      check_range(static_cast<double>(value), range);
    }

    void
    check_range(const std::vector<double> &values, const Range &range)
    {
      for (const double value : values)
        check_range(value, range);
    }

    void
    check_range(const std::vector<unsigned int> &values, const Range &range)
    {
      for (const unsigned int value : values)
        check_range(value, range);
    }

    /// "did you mean X? valid: A, B"
    std::string
    hint(const std::string &word, const std::vector<std::string> &valid)
    {
      const std::string close = nearest(word, valid);
      return (close.empty() ? "." : "; did you mean '" + close + "'?") +
             (valid.empty() ? "" : " Valid here: " + join(valid) + ".");
    }
  } // namespace



  bool
  Range::contains(const double x) const
  {
    return (low_is_allowed ? x >= low : x > low) && (high_is_allowed ? x <= high : x < high);
  }



  std::string
  Range::text() const
  {
    std::vector<std::string> parts;
    if (std::isfinite(low))
      parts.push_back((low_is_allowed ? ">= " : "> ") + number_text(low));
    if (std::isfinite(high))
      parts.push_back((high_is_allowed ? "<= " : "< ") + number_text(high));
    return join(parts, " and ");
  }



  Section::Section(RawSection &raw, const std::string &path)
    : raw(&raw)
    , my_path(path)
  {
    raw.used = true;
  }



  Section::Section(std::ostream      &out,
                   const bool         comments,
                   const unsigned int indentation,
                   const RawSection  *given)
    : out(&out)
    , given(given)
    , comments(comments)
    , indentation(indentation)
  {}



  template <typename T>
  void
  Section::add(const std::string &key, T &value, const std::string &help, const Range &range)
  {
    if (description)
      return description->keys.push_back(
        {key, type_name(value), to_text(value), help, range.text(), {}, false});
    if (!reading())
      return write(key, is_number(value) ? as_given(key, to_text(value)) : to_text(value), help);
    known_keys.push_back(key);
    if (RawSection::Value *entry = raw->find_value(key))
      {
        entry->used = true;
        try
          {
            from_text(Formula(entry->text, definitions), value);
            check_range(value, range);
          }
        catch (const SceneError &error)
          {
            fail(key, std::string(error.what()) + " (" + help + ")");
          }
      }
  }



  void
  Section::add_choice(const std::string              &key,
                      std::string                    &value,
                      const std::vector<std::string> &choices,
                      const std::string              &help)
  {
    if (description)
      {
        description->keys.push_back({key, "", value, help, "", choices, false});
        return;
      }
    add(key, value, help + ": " + join(choices, " | "));
    if (reading() && std::find(choices.begin(), choices.end(), value) == choices.end())
      fail(key, "is not one of the choices" + hint(value, choices));
  }



  void
  Section::add_definitions(const std::string &name, Definitions &value, const std::string &help)
  {
    add_section(name, help, [&](Section &section) {
      if (description)
        return;
      if (!reading())
        {
          for (const auto &[key, formula] : value.all())
            section.write(key, formula, "");
          return;
        }
      for (RawSection::Value &entry : section.raw->values)
        {
          entry.used = true;
          try
            {
              value.add(entry.key, entry.text);
            }
          catch (const SceneError &error)
            {
              section.fail(entry.key, error.what());
            }
        }
    });
    definitions = std::make_shared<Definitions>(value);
  }



  bool
  Section::defines(const std::string &name) const
  {
    return definitions->knows(name);
  }



  std::string
  Section::place_of(const std::string &key) const
  {
    const RawSection::Value *entry = raw ? raw->find_value(key) : nullptr;
    if (entry)
      return entry->where + ": " + path_of(key) + " = " + shortened(entry->text);
    return (raw && !raw->where.empty() ? raw->where + ": " : "") + path_of(key) + " (not set)";
  }



  void
  Section::fail(const std::string &key, const std::string &what) const
  {
    // What is missing may be there, misspelt: that is what the user wants to know.
    if (raw && !is_set(key))
      for (const RawSection::Value &value : raw->values)
        if (!value.used && nearest(value.key, {key}) == key)
          throw SceneError(value.where + ": unknown key '" + path_of(shortened(value.key)) +
                           "' = '" + shortened(value.text) + "'" + hint(value.key, {key}));
    throw SceneError(place_of(key) + ": " + what);
  }



  void
  Section::close()
  {
    for (const RawSection::Value &value : raw->values)
      if (!value.used)
        throw SceneError(value.where + ": unknown key '" + path_of(shortened(value.key)) + "' = '" +
                         shortened(value.text) + "'" + hint(value.key, known_keys));
    const RawSection::Value *names     = raw->find_value("Names");
    const bool               is_list   = names && names->used;
    const bool               is_chosen = is_list && names->where.find("--set") == 0;
    for (const RawSection &section : raw->sections)
      if (!section.used && !is_chosen) // else left out on the command line
        throw SceneError(section.where + ": unknown subsection '" +
                         path_of(shortened(section.name)) + "'" +
                         (is_list ? ", which is not among the Names there" : "") +
                         hint(section.name, known_sections));
  }



  std::string
  Section::path_of(const std::string &name) const
  {
    return my_path.empty() ? name : my_path + "/" + name;
  }



  RawSection *
  Section::open(const std::string &name)
  {
    known_sections.push_back(name);
    return raw->find_section(name);
  }



  Section
  Section::begin(const std::string &name, const std::string &help)
  {
    const std::string indent(2 * indentation, ' ');
    if (comments && !help.empty())
      *out << '\n' << indent << "# " << help << '\n';
    *out << indent << "subsection " << name << '\n';
    return Section(*out, comments, indentation + 1, given ? given->find_section(name) : nullptr);
  }



  void
  Section::end()
  {
    *out << std::string(2 * indentation, ' ') << "end\n";
  }



  void
  Section::check_names(const std::vector<std::string> &names) const
  {
    std::set<std::string> seen;
    for (const std::string &name : names)
      {
        if (name.empty() || name.find_first_of("./=;:") != std::string::npos)
          fail("Names",
               "'" + name + "' is not a name: it must not be empty or contain any of . / = ; :");
        if (!seen.insert(name).second)
          fail("Names", "'" + name + "' is there twice");
      }
  }



  std::string
  Section::as_given(const std::string &key, const std::string &otherwise) const
  {
    const RawSection::Value *entry = given ? given->find_value(key) : nullptr;
    return entry ? entry->text : otherwise;
  }



  void
  Section::write(const std::string &key, const std::string &value, const std::string &help)
  {
    const std::string assignment = std::string(2 * indentation, ' ') + "set " + key + " = " + value;
    *out << assignment;
    if (comments && !help.empty())
      *out << std::string(assignment.size() < 44 ? 44 - assignment.size() : 1, ' ') << "# " << help;
    *out << '\n';
  }



  void
  from_text(const Formula &text, double &value)
  {
    if (text.text == "infinity" || text.text == "-infinity")
      value = (text.text[0] == '-' ? -1 : 1) * std::numeric_limits<double>::infinity();
    else
      value = evaluate(text, {});
    if (!std::isfinite(value) && text.text != "infinity" && text.text != "-infinity")
      throw SceneError("is not a finite number");
  }



  void
  from_text(const Formula &text, unsigned int &value)
  {
    double number;
    from_text(text, number);
    const double whole = std::round(number); // b/0.1 may be a little beside it
    if (whole < 0 || std::abs(number - whole) > 1e-9 * std::max(1., whole) || whole > 4e9)
      throw SceneError("is " + number_text(number) +
                       ", but must be a whole number that is not negative");
    value = static_cast<unsigned int>(whole);
  }



  void
  from_text(const Formula &text, bool &value)
  {
    if (text.text != "yes" && text.text != "no")
      throw SceneError("must be yes or no");
    value = text.text == "yes";
  }



  void
  from_text(const Formula &text, std::string &value)
  {
    value = text.text;
  }



  void
  from_text(const Formula &text, Formula &value)
  {
    value = text;
  }



  void
  from_text(const Formula &text, std::vector<std::string> &value)
  {
    value = split(text.text, ',');
  }



  namespace
  {
    template <typename T>
    void
    list_from_text(const Formula &text, std::vector<T> &value)
    {
      value.clear();
      for (const std::string &part : split(text.text, ','))
        {
          value.emplace_back();
          from_text({part, text.definitions}, value.back());
        }
    }
  } // namespace



  void
  from_text(const Formula &text, std::vector<double> &value)
  {
    list_from_text(text, value);
  }



  void
  from_text(const Formula &text, std::vector<unsigned int> &value)
  {
    list_from_text(text, value);
  }



  template <int dim>
  void
  from_text(const Formula &text, Point<dim> &value)
  {
    std::vector<double> coordinates;
    from_text(text, coordinates);
    if (coordinates.size() != dim)
      throw SceneError("must have " + std::to_string(dim) + " coordinates, separated by commas");
    for (unsigned int d = 0; d < dim; ++d)
      value[d] = coordinates[d];
  }



  template <int dim>
  void
  from_text(const Formula &text, Expression<dim> &value)
  {
    value = Expression<dim>(text);
  }



  template <int dim, int n_components>
  void
  from_text(const Formula &text, VectorExpression<dim, n_components> &value)
  {
    value = VectorExpression<dim, n_components>(text);
  }



#define INSTANTIATE(T)                                                                             \
  template void Section::add(const std::string &, T &, const std::string &, const Range &);
  INSTANTIATE(double)
  INSTANTIATE(unsigned int)
  INSTANTIATE(bool)
  INSTANTIATE(std::string)
  INSTANTIATE(Formula)
  INSTANTIATE(std::vector<std::string>)
  INSTANTIATE(std::vector<double>)
  INSTANTIATE(std::vector<unsigned int>)
  INSTANTIATE(Point<2>)
  INSTANTIATE(Point<3>)
  INSTANTIATE(Expression<2>)
  INSTANTIATE(Expression<3>)
  INSTANTIATE(VectorExpression<2>)
  using OneComponent = VectorExpression<2, 1>;
  INSTANTIATE(OneComponent)
  INSTANTIATE(VectorExpression<3>)
#undef INSTANTIATE
} // namespace Signorini
