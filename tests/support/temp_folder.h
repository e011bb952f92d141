// A folder of its own for one test, removed with all it holds at the end.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace glint::test {

class TempFolder {
  public:
    TempFolder();
    ~TempFolder();
    TempFolder(const TempFolder&) = delete;
    TempFolder& operator=(const TempFolder&) = delete;

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] std::filesystem::path operator/(std::string_view name) const {
        return path_ / name;
    }
    /// Writes a file in it and gives its path.
    std::filesystem::path write(std::string_view name, std::string_view content) const;
    /// Files and folders in it, hidden ones too.
    [[nodiscard]] std::size_t count() const;

  private:
    std::filesystem::path path_;
};

[[nodiscard]] std::string fileContent(const std::filesystem::path& path);

}  // namespace glint::test
