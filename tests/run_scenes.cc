// SPDX-License-Identifier: Apache-2.0
// Solves one scene after the other in the same process, as tests/worker.py asks: reads lines of
// JSON on standard input,
//   {"scene": FILE, "set": ["Section/Key=value", ...], "check": false}
// and answers each by a line on standard output, after ANSWER,
//   {"code": exit code, "out": TEXT, "err": TEXT}

#include <signorini/driver/run_scene.h>

#include <deal.II/base/mpi.h>

#include <nlohmann/json.hpp>

#include <chrono>
#include <iostream>
#include <sstream>
#include <thread>

using namespace Signorini;

namespace
{
  const std::string answer = "\x1e"
                             "answer ";

  /// The line that the first rank reads, on all ranks; empty at the end. The others sleep until it
  /// is there: ranks that poll would take the time of the tests beside this one.
  std::string
  next_line(const MPI_Comm comm, const bool first_rank)
  {
    std::string line;
    if (first_rank && !std::getline(std::cin, line))
      line.clear();
    const auto share = [&](void *data, const int n, const MPI_Datatype type) {
      MPI_Request request;
      MPI_Ibcast(data, n, type, 0, comm, &request);
      for (int done = 0; !done;)
        {
          MPI_Test(&request, &done, MPI_STATUS_IGNORE);
          if (!done)
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
    };
    int size = line.size();
    share(&size, 1, MPI_INT);
    line.resize(size);
    share(line.data(), size, MPI_CHAR);
    return line;
  }

  void
  serve(const MPI_Comm comm)
  {
    const bool first_rank = dealii::Utilities::MPI::this_mpi_process(comm) == 0;
    for (std::string line; !(line = next_line(comm, first_rank)).empty();)
      {
        const auto         request = nlohmann::json::parse(line);
        std::ostringstream out, err;
        const int          code =
          run_scene({request["scene"], request["set"], request["check"]}, comm, out, err);
        if (first_rank)
          std::cout << answer
                    << nlohmann::json({{"code", code}, {"out", out.str()}, {"err", err.str()}})
                    << std::endl;
      }
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  serve(MPI_COMM_WORLD);
}
