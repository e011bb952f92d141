#include "tracer/io/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <memory>
#include <system_error>

namespace glint {

namespace fs = std::filesystem;

namespace {

std::string remedyFor(int code) {
    switch (code) {
        case ENOSPC:
        case EDQUOT:
        case EFBIG:
            return "free some space, or write elsewhere";
        case EACCES:
        case EPERM:
        case EROFS:
            return "write elsewhere, or change the permissions";
        case ENOENT:
        case ENOTDIR:
            return "check the path";
        default:
            return "";
    }
}

Error fileError(const fs::path& path, const std::string& what, int code) {
    return {.message = what + ": " + std::generic_category().message(code),
            .file = path.string(),
            .remedy = remedyFor(code)};
}

/// What the file is named in the end, links followed, so that a link stays one.
fs::path resolved(const fs::path& path) {
    std::error_code ignored;
    const fs::path real = fs::weakly_canonical(path, ignored);
    return real.empty() ? path : real;
}

/// The mode of the file that is replaced, or that of a new one.
mode_t modeFor(const fs::path& target) {
    struct stat status {};
    if (::stat(target.c_str(), &status) == 0) return status.st_mode & 07777U;
    const mode_t mask = ::umask(0);
    ::umask(mask);
    return 0666U & ~mask;
}

}  // namespace

SiblingFile::SiblingFile(fs::path shown, fs::path target, fs::path sibling, std::FILE* stream)
    : shown_(std::move(shown)),
      target_(std::move(target)),
      sibling_(std::move(sibling)),
      stream_(stream) {}

SiblingFile::SiblingFile(SiblingFile&& other) noexcept
    : shown_(std::move(other.shown_)),
      target_(std::move(other.target_)),
      sibling_(std::move(other.sibling_)),
      stream_(std::exchange(other.stream_, nullptr)) {}

SiblingFile::~SiblingFile() {
    if (!stream_) return;
    std::fclose(stream_);
    ::unlink(sibling_.c_str());
}

Result<SiblingFile> SiblingFile::create(const fs::path& path) {
    const fs::path target = resolved(path);
    std::error_code ignored;
    const fs::file_status status = fs::status(target, ignored);
    if (fs::exists(status) && !fs::is_regular_file(status))
        return Error{.message = fs::is_directory(status) ? "is a folder" : "is not a file",
                     .file = path.string(),
                     .remedy = "choose another name"};
    if (fs::exists(status) && ::access(target.c_str(), W_OK) != 0)
        return fileError(path, "cannot be written", errno);

    std::string name =
        (target.parent_path() / ("." + target.filename().string() + ".XXXXXX")).string();
    const int descriptor = ::mkostemp(name.data(), O_CLOEXEC);
    if (descriptor < 0) return fileError(path, "cannot be written", errno);
    ::fchmod(descriptor, modeFor(target));
    std::FILE* stream = ::fdopen(descriptor, "wb");
    if (!stream) {
        const int code = errno;
        ::close(descriptor);
        ::unlink(name.c_str());
        return fileError(path, "cannot be written", code);
    }
    return SiblingFile(path, target, name, stream);
}

Status SiblingFile::commit() {
    errno = 0;
    bool good =
        !std::ferror(stream_) && std::fflush(stream_) == 0 && ::fsync(::fileno(stream_)) == 0;
    int code = errno;
    good = std::fclose(std::exchange(stream_, nullptr)) == 0 && good;
    if (good && ::rename(sibling_.c_str(), target_.c_str()) == 0) return Done{};
    if (code == 0) code = errno ? errno : EIO;
    ::unlink(sibling_.c_str());
    return fileError(shown_, "could not be written", code);
}

Status writeWhole(const fs::path& path, std::string_view bytes) {
    auto created = SiblingFile::create(path);
    if (!created) return created.error();
    SiblingFile file = std::move(created).value();
    const std::size_t written = std::fwrite(bytes.data(), 1, bytes.size(), file.stream());
    if (written != bytes.size()) return fileError(path, "could not be written", errno);
    return file.commit();
}

Status checkWritable(const fs::path& path) {
    auto created = SiblingFile::create(path);
    if (!created) return created.error();
    return Done{};
}

Result<std::string> readWhole(const fs::path& path, std::size_t limit) {
    std::error_code code;
    if (fs::is_directory(path, code))
        return Error{
            .message = "is a folder", .file = path.string(), .remedy = "name a file in it"};
    if (fs::is_character_file(path, code) || fs::is_block_file(path, code))
        return Error{.message = "is a device", .file = path.string(), .remedy = "name a file"};
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(std::fopen(path.c_str(), "rb"),
                                                                 std::fclose);
    if (!stream) return fileError(path, "cannot be read", errno);
    std::string out;
    if (const auto size = fs::file_size(path, code); !code && size <= limit) out.reserve(size);
    std::array<char, 65536> block{};
    while (const std::size_t got = std::fread(block.data(), 1, block.size(), stream.get())) {
        if (out.size() + got > limit)
            return Error{.message = "is larger than " + std::to_string(limit >> 20U) + " MiB",
                         .file = path.string(),
                         .remedy = "split it up"};
        out.append(block.data(), got);
    }
    if (std::ferror(stream.get())) return fileError(path, "cannot be read", errno);
    return out;
}

}  // namespace glint
