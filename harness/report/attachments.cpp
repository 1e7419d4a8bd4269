#include "harness/report/attachments.h"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "problems/io/errors.h"

namespace lcp {

namespace {

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(file), {}};
  if (!file) throw UnreadableInput(fmt::format("{}: cannot be read", path.string()));
  return bytes;
}

std::vector<Attachments::File> files_ending_in(const std::filesystem::path& directory,
                                               const std::string& ending) {
  std::vector<Attachments::File> files;
  for (const std::filesystem::directory_entry& entry :
       std::filesystem::directory_iterator(directory))
    if (entry.is_regular_file() && entry.path().extension() == ending)
      files.push_back({entry.path().filename().string(), bytes_of(entry.path())});
  std::sort(files.begin(), files.end(),
            [](const auto& a, const auto& b) { return a.name < b.name; });
  return files;
}

}  // namespace

Attachments read_attachments(const std::filesystem::path& directory) {
  if (!std::filesystem::is_directory(directory))
    throw UnreadableInput(fmt::format("{}: no such directory", directory.string()));
  Attachments attachments{directory.string(), files_ending_in(directory, ".svg"),
                          files_ending_in(directory, ".txt")};
  if (attachments.pictures.empty() && attachments.texts.empty())
    throw UnreadableInput(
        fmt::format("{}: holds no picture (*.svg) and no table (*.txt)", directory.string()));
  return attachments;
}

std::string base64(const std::string& bytes) {
  std::string out(4 * ((bytes.size() + 2) / 3) + 1, '\0');  // EVP ends it with a NUL.
  const int written = EVP_EncodeBlock(reinterpret_cast<unsigned char*>(out.data()),
                                      reinterpret_cast<const unsigned char*>(bytes.data()),
                                      static_cast<int>(bytes.size()));
  out.resize(static_cast<std::size_t>(written));
  return out;
}

}  // namespace lcp
