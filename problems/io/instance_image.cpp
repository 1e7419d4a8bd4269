#include "problems/io/instance_image.h"

#include <cstring>
#include <stdexcept>

namespace lcp {

namespace {

/// Both directions take the same fields in the same order: `pass(image, x)` appends x or reads it.
class Writer {
 public:
  void bytes(const void* data, std::size_t size) {
    image.append(static_cast<const char*>(data), size);
  }
  std::size_t size(std::size_t size, std::size_t) {
    bytes(&size, sizeof size);
    return size;
  }

  std::string image;
};

class Reader {
 public:
  explicit Reader(std::string_view image) : left_(image) {}
  void bytes(void* data, std::size_t size) {
    if (size > left_.size()) throw std::invalid_argument("the image of instances ends too early");
    if (size > 0) std::memcpy(data, left_.data(), size);
    left_.remove_prefix(size);
  }
  /// A count of things of at least `each` bytes, which have to be there.
  std::size_t size(std::size_t, std::size_t each) {
    std::size_t size = 0;
    bytes(&size, sizeof size);
    if (size > left_.size() / each)
      throw std::invalid_argument("the image of instances ends too early");
    return size;
  }

 private:
  std::string_view left_;
};

template <class Image>
void pass(Image& image, Index& number) {
  image.bytes(&number, sizeof number);
}

template <class Image>
void pass(Image& image, std::string& text) {
  text.resize(image.size(text.size(), 1));
  image.bytes(text.data(), text.size());
}

template <class Image, int Columns>
void pass(Image& image, Eigen::Matrix<double, Eigen::Dynamic, Columns>& numbers) {
  Index rows = numbers.rows(), columns = numbers.cols();
  pass(image, rows);
  pass(image, columns);
  const std::size_t size = image.size(static_cast<std::size_t>(numbers.size()), sizeof(double));
  if (rows < 0 || columns < 0 || static_cast<std::size_t>(rows * columns) != size)
    throw std::invalid_argument("the image of instances holds a matrix of another size");
  numbers.resize(rows, columns);
  image.bytes(numbers.data(), size * sizeof(double));
}

template <class Image>
void pass(Image& image, std::vector<Index>& numbers) {
  numbers.resize(image.size(numbers.size(), sizeof(Index)));
  image.bytes(numbers.data(), numbers.size() * sizeof(Index));
}

template <class Image, class Value>
void pass(Image& image, std::optional<Value>& value) {
  Index present = value.has_value();
  pass(image, present);
  if (present == 0) return;
  if (!value) value.emplace();
  pass(image, *value);
}

template <class Image>
void pass(Image& image, std::map<std::string, std::string>& texts) {
  std::vector<std::pair<std::string, std::string>> pairs(texts.begin(), texts.end());
  pairs.resize(image.size(pairs.size(), 1));
  for (auto& [key, text] : pairs) {
    pass(image, key);
    pass(image, text);
  }
  texts = {pairs.begin(), pairs.end()};
}

template <class Image>
void pass(Image& image, FrictionBlocks& blocks) {
  each_field(blocks, [&](const char*, auto& field) { pass(image, field); });
}

template <class Image>
void pass(Image& image, Start& start) {
  pass(image, start.alpha);
  pass(image, start.z);
}

template <class Image>
void pass(Image& image, Instance& instance) {
  pass(image, instance.name);
  pass(image, instance.problem.M);
  pass(image, instance.problem.q);
  pass(image, instance.problem.s_z);
  pass(image, instance.problem.s_w);
  pass(image, instance.problem.c);
  pass(image, instance.problem.pivot_limit);
  pass(image, instance.problem.friction);
  pass(image, instance.provenance);
  pass(image, instance.known_solution);
  pass(image, instance.active_contacts);
  pass(image, instance.previous);
}

}  // namespace

std::string to_image(const std::vector<Instance>& instances) {
  Writer image;
  for (const Instance& instance : instances) {
    image.size(1, 1);
    pass(image, const_cast<Instance&>(instance));  // which the writer does not change
  }
  image.size(0, 1);  // no further one
  return std::move(image.image);
}

std::vector<Instance> from_image(std::string_view image) {
  Reader reader(image);
  std::vector<Instance> instances;
  while (reader.size(0, 1) == 1) {
    Instance read;
    pass(reader, read);
    Instance checked = make_instance(read.name, std::move(read.problem), read.provenance);
    checked.known_solution = std::move(read.known_solution);
    checked.active_contacts = read.active_contacts;
    checked.previous = std::move(read.previous);
    if (checked.previous)
      check(*checked.previous, checked.problem.size(), checked.name + ": previous solution");
    instances.push_back(std::move(checked));
  }
  return instances;
}

}  // namespace lcp
