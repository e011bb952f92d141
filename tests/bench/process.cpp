#include "tests/bench/process.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <sstream>

namespace glint::bench {

std::filesystem::path findProgram(const std::string& program) {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');) {
        const auto file = std::filesystem::path(folder.empty() ? "." : folder) / program;
        if (access(file.c_str(), X_OK) == 0) return file;
    }
    return {};
}

Result<Process> Process::start(const std::vector<std::string>& arguments) {
    const auto failed = [&] {
        return Error{
            "cannot start " + arguments[0] + ": " + std::strerror(errno), {}, 0, 0, {}, {}};
    };
    std::signal(SIGPIPE, SIG_IGN);  // A child that ends early is an error to report, not our end.
    std::array<int, 2> input{}, output{};
    if (pipe2(input.data(), O_CLOEXEC) != 0) return failed();
    if (pipe2(output.data(), O_CLOEXEC) != 0) {
        close(input[0]);
        close(input[1]);
        return failed();
    }
    std::vector<char*> argv;
    for (const std::string& argument : arguments)
        argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    const pid_t child = fork();
    if (child == 0) {
        dup2(input[0], STDIN_FILENO);
        dup2(output[1], STDOUT_FILENO);
        dup2(output[1], STDERR_FILENO);
        std::signal(SIGPIPE, SIG_DFL);
        execvp(argv[0], argv.data());
        _exit(127);
    }
    close(input[0]);
    close(output[1]);
    if (child < 0) {
        close(input[1]);
        close(output[0]);
        return failed();
    }
    return Process(child, input[1], output[0]);
}

Process::Process(Process&& other) noexcept
    : child_(std::exchange(other.child_, -1)),
      input_(std::exchange(other.input_, -1)),
      output_(std::exchange(other.output_, -1)),
      pending_(std::move(other.pending_)) {}

Process::~Process() {
    closeInput();
    if (child_ > 0) {
        kill(child_, SIGTERM);
        wait();
    }
    if (output_ >= 0) close(output_);
}

void Process::closeInput() {
    if (input_ >= 0) close(std::exchange(input_, -1));
}

bool Process::writeLine(const std::string& line) {
    const std::string text = line + '\n';
    for (std::size_t done = 0; done < text.size();) {
        const ssize_t count = write(input_, text.data() + done, text.size() - done);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return false;
        done += static_cast<std::size_t>(count);
    }
    return true;
}

bool Process::readLine(std::string& line) {
    for (;;) {
        if (const std::size_t end = pending_.find('\n'); end != std::string::npos) {
            line = pending_.substr(0, end);
            pending_.erase(0, end + 1);
            return true;
        }
        std::array<char, 65536> buffer{};
        const ssize_t count = read(output_, buffer.data(), buffer.size());
        if (count < 0 && errno == EINTR) continue;
        if (count > 0) {
            pending_.append(buffer.data(), static_cast<std::size_t>(count));
        } else if (pending_.empty()) {
            return false;
        } else {
            pending_ += '\n';
        }
    }
}

int Process::wait() {
    closeInput();
    int status = 0;
    while (waitpid(child_, &status, 0) < 0 && errno == EINTR) {
    }
    child_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

Result<Finished> runProgram(const std::vector<std::string>& arguments) {
    Result<Process> started = Process::start(arguments);
    if (!started) return started.error();
    Process process = std::move(started).value();
    Finished out;
    for (std::string line; process.readLine(line);) out.output += line + '\n';
    out.exitCode = process.wait();
    return out;
}

}  // namespace glint::bench
