// SPDX-License-Identifier: Apache-2.0
#include "checkpoint/sealed_file.h"

#include "output/directory.h"

#include <fcntl.h>
#include <unistd.h>
#include <zlib.h>

#include <cerrno>
#include <fstream>
#include <sstream>

namespace Signorini
{
  namespace
  {
    /// The first words of sealed files. The number is the version of their contents; files of other
    /// versions are rejected.
    const std::string mark = "Signorini checkpoint 5";

    /// @return whether all of a text could be written.
    bool
    write_all(const int file, const std::string &text)
    {
      for (std::size_t done = 0; done < text.size();)
        {
          const ssize_t n = write(file, text.data() + done, text.size() - done);
          if (n < 0 && errno == EINTR)
            continue;
          if (n <= 0)
            return false;
          done += n;
        }
      return true;
    }

    /// @return whether a file is on the disk.
    bool
    sync(const int file)
    {
      // Some file systems do not support fsync for folders.
      return fsync(file) == 0 || errno == EINVAL || errno == EROFS || errno == ENOTSUP;
    }
  } // namespace



  std::uint32_t
  checksum(const std::string &content)
  {
    return crc32_z(0, reinterpret_cast<const Bytef *>(content.data()), content.size());
  }



  void
  write_sealed(const std::string &path, const std::string &content)
  {
    std::ostringstream head;
    head << mark << ' ' << content.size() << ' ' << checksum(content) << '\n';
    const int  file = open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    const bool done =
      file >= 0 && write_all(file, head.str()) && write_all(file, content) && sync(file);
    // Some file systems report only here that they are full.
    if ((file >= 0 && close(file) != 0) || !done)
      throw OutputError(path, false);
  }



  // First line: mark, length, checksum. Then the content, and nothing behind it.
  std::string
  read_sealed(const std::string &path)
  {
    std::ifstream in(path, std::ios::binary);
    std::string   line;
    if (!in)
      throw Damaged(path + " cannot be opened");
    if (!std::getline(in, line) || line.compare(0, mark.size() + 1, mark + " ") != 0)
      throw Damaged(path + " does not begin with '" + mark +
                    "': it is damaged, or of another version of the program");
    std::size_t        size = 0;
    std::uint32_t      sum  = 0;
    std::istringstream numbers(line.substr(mark.size()));
    numbers >> size >> sum;
    const auto start = in.tellg();
    in.seekg(0, std::ios::end);
    if (!numbers || static_cast<std::size_t>(in.tellg() - start) != size)
      throw Damaged(path +
                    " does not have the length that it records: it was truncated or changed");
    std::string content(size, ' ');
    in.seekg(start);
    in.read(content.data(), size);
    if (!in || checksum(content) != sum)
      throw Damaged(path + " does not have the checksum that it records: it was changed");
    return content;
  }



  void
  sync_folder(const std::string &path)
  {
    const int folder = open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder < 0)
      throw OutputError(path, false);
    const bool done = sync(folder);
    close(folder);
    if (!done)
      throw OutputError(path, false);
  }
} // namespace Signorini
