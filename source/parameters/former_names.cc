// SPDX-License-Identifier: Apache-2.0
#include <signorini/parameters/section.h>

#include <algorithm>

namespace Signorini
{
  namespace
  {
    constexpr char still_accepted[] = "; the former name is accepted until the next release";

    /// Throw SceneError: a former and its present name are both set.
    [[noreturn]] void
    refuse_both(const std::string &what,
                const std::string &former,
                const std::string &where,
                const std::string &now,
                const std::string &where_now)
    {
      throw SceneError(where + ": '" + former + "' is the former name of the " + what + " '" + now +
                       "', which is set at " + where_now + " too; keep '" + now + "' alone");
    }

    /// Move values and subsections of one section to another one, where they override existing
    /// ones.
    void
    merge(const RawSection &from, RawSection &to)
    {
      for (const RawSection::Value &value : from.values)
        to.set_value(value.key, value.text, value.where);
      for (const RawSection &section : from.sections)
        merge(section, to.get_section(section.name, section.where));
    }

    /// Remove an element of a list, given by reference.
    template <typename List, typename Item>
    void
    erase(List &list, const Item &item)
    {
      list.erase(
        std::find_if(list.begin(), list.end(), [&](const auto &one) { return &one == &item; }));
    }
  } // namespace



  // Messages that differ in their position only are reported once.
  void
  Section::add_note(const std::string &where, const std::string &text)
  {
    const auto same = [&](const std::string &note) {
      return note.size() >= text.size() &&
             note.compare(note.size() - text.size(), text.size(), text) == 0;
    };
    if (std::none_of(my_notes->begin(), my_notes->end(), same))
      my_notes->push_back(where + ": " + text);
  }



  // Report that a default is used.
  void
  Section::note_default(const std::string &key, const std::string &value)
  {
    const std::string text =
      "'" + path_of(key) + "' is not set; the default '" + value + "' is used";
    if (raw->where.empty())
      my_notes->push_back(text);
    else
      add_note(raw->where, text);
  }



  // A value on the command line overrides one in the file, whichever name each of them has.
  void
  Section::rename_key(const std::string &former, const std::string &key)
  {
    if (description)
      description->former_names.push_back({FormerName::Kind::key, former, key, ""});
    RawSection::Value *const old = raw ? raw->find_value(former) : nullptr;
    if (!old)
      return;
    add_note(old->where, "'" + former + "' is now called '" + key + "'" + still_accepted);
    RawSection::Value *const now = raw->find_value(key);
    if (!now)
      {
        old->key = key;
        return;
      }
    if (is_override(old->where) == is_override(now->where))
      refuse_both("key", former, old->where, key, now->where);
    if (is_override(old->where))
      raw->set_value(key, old->text, old->where);
    erase(raw->values, *old);
  }



  // Sections of both names are merged if one of them comes from the command line.
  void
  Section::rename_section(const std::string &former, const std::string &name)
  {
    if (description)
      description->former_names.push_back({FormerName::Kind::section, former, name, ""});
    RawSection *const old = raw ? raw->find_section(former) : nullptr;
    if (!old)
      return;
    add_note(old->where, "'" + former + "' is now called '" + name + "'" + still_accepted);
    RawSection *const now = raw->find_section(name);
    if (!now)
      {
        old->name = name;
        return;
      }
    if (is_override(old->where) == is_override(now->where))
      refuse_both("section", former, old->where, name, now->where);
    RawSection merged = is_override(old->where) ? *now : *old;
    merge(is_override(old->where) ? *old : *now, merged);
    merged.name = name;
    *now        = merged;
    erase(raw->sections, *old);
  }



  void
  Section::rename_choice(const std::string &key,
                         const std::string &former,
                         const std::string &choice)
  {
    if (description)
      description->former_names.push_back({FormerName::Kind::choice, former, choice, key});
    RawSection::Value *const value = raw ? raw->find_value(key) : nullptr;
    if (!value || value->text != former)
      return;
    add_note(value->where,
             "'" + key + " = " + former + "' is now called '" + key + " = " + choice + "'" +
               still_accepted);
    value->text = choice;
  }
} // namespace Signorini
