// A child program that is spoken to line by line: how the bench drives the renderers it measures.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tracer/base/result.h"

namespace glint::bench {

/// The full path of `program` as the shell would find it; empty where it is not installed.
[[nodiscard]] std::filesystem::path findProgram(const std::string& program);

/// A running program with its input, and its output and errors as one stream, in our hands. Ended
/// with this object.
class Process {
  public:
    /// Starts `arguments[0]`. Fails where the system cannot.
    [[nodiscard]] static Result<Process> start(const std::vector<std::string>& arguments);
    ~Process();
    Process(Process&& other) noexcept;
    Process& operator=(Process&&) = delete;
    Process(const Process&) = delete;

    /// False once the program has ended.
    bool writeLine(const std::string& line);
    /// The next line without its end; false at the end of the output.
    bool readLine(std::string& line);
    /// Waits for the end. The program's exit code, or 128 + the signal that ended it.
    int wait();

  private:
    Process(pid_t child, int input, int output) : child_(child), input_(input), output_(output) {}
    void closeInput();

    pid_t child_ = -1;
    int input_ = -1, output_ = -1;
    std::string pending_;  ///< read but not yet asked for
};

/// Runs a program to its end. Its whole output and errors; `exitCode` as by Process::wait().
struct Finished {
    int exitCode = 0;
    std::string output;
};
[[nodiscard]] Result<Finished> runProgram(const std::vector<std::string>& arguments);

}  // namespace glint::bench
