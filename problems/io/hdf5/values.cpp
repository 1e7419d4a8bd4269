#include "problems/io/hdf5/values.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "problems/io/errors.h"

namespace lcp::hdf5 {

namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Numbers below which compression costs more bytes than it saves.
constexpr Index smallest_compressed = 512;
/// zlib's own compromise between speed and size.
constexpr int compression_level = 6;

std::string extents_text(const std::vector<hsize_t>& extents) {
  return extents.empty() ? "one value" : fmt::format("{}", fmt::join(extents, " x "));
}

std::vector<hsize_t> extents_of(const H5::DataSpace& space) {
  std::vector<hsize_t> extents(static_cast<std::size_t>(space.getSimpleExtentNdims()));
  if (!extents.empty()) space.getSimpleExtentDims(extents.data());
  return extents;
}

const char* kind_name(H5T_class_t kind) {
  switch (kind) {
    case H5T_INTEGER:
      return "integers";
    case H5T_FLOAT:
      return "floating-point numbers";
    case H5T_STRING:
      return "text";
    default:
      return "of another type";
  }
}

/// Datasets carry no time of writing, so that the same instances give the same bytes.
H5::DataSet create(H5::Group& group, const std::string& name, const H5::DataType& type,
                   const std::vector<hsize_t>& extents) {
  H5::DSetCreatPropList settings;
  H5Pset_obj_track_times(settings.getId(), false);
  hsize_t numbers = 1;
  for (const hsize_t extent : extents) numbers *= extent;
  if (numbers >= smallest_compressed) {
    settings.setChunk(static_cast<int>(extents.size()), extents.data());
    settings.setShuffle();
    settings.setDeflate(compression_level);
  }
  const H5::DataSpace space(static_cast<int>(extents.size()), extents.data());
  return group.createDataSet(name, type, space, settings);
}

}  // namespace

GroupReader::GroupReader(const std::string& file) : file_(file) {
  H5::Exception::dontPrint();
  try {
    group_ = H5::H5File(file, H5F_ACC_RDONLY).openGroup("/");
  } catch (const H5::Exception&) {
    throw UnreadableInput("{}: the HDF5 library cannot open it, expected a complete HDF5 file",
                          file);
  }
}

GroupReader::GroupReader(std::string file, std::string path, H5::Group group)
    : file_(std::move(file)), path_(std::move(path)), group_(std::move(group)) {}

void GroupReader::fail(const std::string& name, const std::string& what) const {
  const std::string place = name.empty() && !path_.empty() ? path_ : path_ + "/" + name;
  throw UnreadableInput("{}: {}: {}", file_, place, what);
}

bool GroupReader::has(const std::string& name) const {
  return guard(name, [&] { return group_.nameExists(name); });
}

bool GroupReader::holds(const std::string& name, H5O_type_t type) const {
  return guard(name, [&] { return group_.nameExists(name) && group_.childObjType(name) == type; });
}

bool GroupReader::has_group(const std::string& name) const { return holds(name, H5O_TYPE_GROUP); }

bool GroupReader::has_dataset(const std::string& name) const {
  return holds(name, H5O_TYPE_DATASET);
}

GroupReader GroupReader::group(const std::string& name) const {
  return guard(name, [&] {
    if (!group_.nameExists(name)) fail(name, "is missing, expected a group");
    return GroupReader(file_, path_ + "/" + name, group_.openGroup(name));
  });
}

std::vector<std::string> GroupReader::groups_below() const {
  const auto collect = [](H5::H5Object&, const H5std_string name, const H5O_info_t* info,
                          void* names) {
    if (info->type == H5O_TYPE_GROUP && name != ".")
      static_cast<std::vector<std::string>*>(names)->push_back(name);
    return 0;
  };
  return guard("", [&] {
    std::vector<std::string> found;
    H5::Group(group_).visit(H5_INDEX_NAME, H5_ITER_INC, collect, &found, H5O_INFO_BASIC);
    return found;
  });
}

H5::DataSet GroupReader::existing(const std::string& name, const char* expected) const {
  if (!group_.nameExists(name)) fail(name, "is missing, expected {}", expected);
  return group_.openDataSet(name);
}

H5::DataSet GroupReader::open(const std::string& name, bool real,
                              const std::vector<Index>& expected) const {
  H5::DataSet data = existing(name, "a dataset");
  const H5T_class_t kind = data.getTypeClass();
  if (kind != H5T_INTEGER && !(real && kind == H5T_FLOAT))
    fail(name, "is {}, expected {}", kind_name(kind), real ? "real numbers" : "integers");
  const std::vector<hsize_t> extents = extents_of(data.getSpace());
  const std::vector<hsize_t> wanted(expected.begin(), expected.end());
  if (extents != wanted)
    fail(name, "is {}, expected {}", extents_text(extents), extents_text(wanted));
  return data;
}

VectorXd GroupReader::vector(const std::string& name, Index size) const {
  return guard(name, [&] {
    const H5::DataSet data = open(name, true, {size});
    VectorXd numbers(size);
    data.read(numbers.data(), H5::PredType::NATIVE_DOUBLE);
    return numbers;
  });
}

VectorXd GroupReader::vector(const std::string& name) const {
  return vector_up_to(name, largest_rows);
}

Index GroupReader::size_of(const std::string& name, Index most) const {
  const auto extents =
      guard(name, [&] { return extents_of(existing(name, "a vector").getSpace()); });
  if (extents.size() != 1 || extents[0] > static_cast<hsize_t>(most))
    fail(name, "is {}, expected a vector of at most {} numbers", extents_text(extents), most);
  return static_cast<Index>(extents[0]);
}

VectorXd GroupReader::vector_up_to(const std::string& name, Index most) const {
  return vector(name, size_of(name, most));
}

std::vector<Index> GroupReader::integers_up_to(const std::string& name, Index most) const {
  return integers(name, size_of(name, most));
}

MatrixXd GroupReader::matrix(const std::string& name, Index rows, Index columns) const {
  return guard(name, [&] {
    const H5::DataSet data = open(name, true, {rows, columns});
    RowMajor numbers(rows, columns);
    data.read(numbers.data(), H5::PredType::NATIVE_DOUBLE);
    return MatrixXd(numbers);
  });
}

std::vector<Index> GroupReader::integers(const std::string& name, Index size) const {
  return guard(name, [&] {
    const H5::DataSet data = open(name, false, {size});
    std::vector<std::int64_t> numbers(static_cast<std::size_t>(size));
    data.read(numbers.data(), H5::PredType::NATIVE_INT64);
    return std::vector<Index>(numbers.begin(), numbers.end());
  });
}

bool GroupReader::has_attribute(const std::string& name) const {
  return guard(name, [&] { return group_.attrExists(name); });
}

H5::Attribute GroupReader::attribute(const std::string& name, H5T_class_t kind,
                                     const char* expected) const {
  if (!group_.attrExists(name)) fail(name, "is missing, expected {} attribute", expected);
  H5::Attribute found = group_.openAttribute(name);
  if (found.getTypeClass() != kind || found.getSpace().getSimpleExtentNpoints() != 1)
    fail(name, "is another attribute, expected one {}", kind == H5T_STRING ? "text" : "integer");
  return found;
}

Index GroupReader::integer_attribute(const std::string& name) const {
  return guard(name, [&] {
    std::int64_t value = 0;
    attribute(name, H5T_INTEGER, "an integer").read(H5::PredType::NATIVE_INT64, &value);
    return static_cast<Index>(value);
  });
}

std::string GroupReader::text_attribute(const std::string& name) const {
  return guard(name, [&] {
    const H5::Attribute found = attribute(name, H5T_STRING, "a text");
    const H5::StrType type = found.getStrType();
    const auto require_short = [&](std::size_t bytes) {
      if (bytes > longest_text)
        fail(name, "is a text of {} bytes, expected at most {}", bytes, longest_text);
    };
    if (!type.isVariableStr()) require_short(type.getSize());
    std::string text;
    found.read(type, text);
    text = text.c_str();  // without the zeros that pad a fixed length
    require_short(text.size());
    return text;
  });
}

std::string GroupReader::printed_attribute(const std::string& name) const {
  return guard(name, [&]() -> std::string {
    const H5::Attribute found = group_.openAttribute(name);
    const bool one = found.getSpace().getSimpleExtentNpoints() == 1;
    const H5T_class_t kind = one ? found.getTypeClass() : H5T_NO_CLASS;
    if (kind == H5T_STRING) return text_attribute(name);
    if (kind == H5T_INTEGER) return fmt::format("{}", integer_attribute(name));
    if (kind != H5T_FLOAT) fail(name, "is another attribute, expected one text or number");
    double number = 0;
    found.read(H5::PredType::NATIVE_DOUBLE, &number);
    return fmt::format("{}", number);
  });
}

std::map<std::string, std::string> GroupReader::printed_attributes() const {
  return guard("", [&] {
    std::map<std::string, std::string> texts;
    for (int i = 0; i < group_.getNumAttrs(); ++i) {
      const std::string name = group_.openAttribute(static_cast<unsigned>(i)).getName();
      texts[name] = printed_attribute(name);
    }
    return texts;
  });
}

std::string GroupReader::text(const std::string& name) const {
  return guard(name, [&]() -> std::string {
    if (!group_.nameExists(name)) return "";
    const H5::DataSet data = group_.openDataSet(name);
    if (data.getTypeClass() != H5T_STRING || data.getSpace().getSimpleExtentNpoints() != 1)
      return "";
    const H5::StrType type = data.getStrType();
    if (type.isVariableStr() || type.getSize() > longest_text) return "";
    std::vector<char> bytes(type.getSize() + 1, '\0');
    data.read(bytes.data(), type);
    return bytes.data();
  });
}

void write(H5::Group& group, const std::string& name, const VectorXd& numbers) {
  create(group, name, H5::PredType::IEEE_F64LE, {static_cast<hsize_t>(numbers.size())})
      .write(numbers.data(), H5::PredType::NATIVE_DOUBLE);
}

void write(H5::Group& group, const std::string& name, const MatrixXd& numbers) {
  const RowMajor rows = numbers;
  create(group, name, H5::PredType::IEEE_F64LE,
         {static_cast<hsize_t>(rows.rows()), static_cast<hsize_t>(rows.cols())})
      .write(rows.data(), H5::PredType::NATIVE_DOUBLE);
}

void write(H5::Group& group, const std::string& name, const std::vector<int>& numbers) {
  create(group, name, H5::PredType::STD_I32LE, {numbers.size()})
      .write(numbers.data(), H5::PredType::NATIVE_INT);
}

void write(H5::Group& group, const std::string& name, const std::vector<Index>& numbers) {
  const std::vector<std::int64_t> wide(numbers.begin(), numbers.end());
  create(group, name, H5::PredType::STD_I64LE, {wide.size()})
      .write(wide.data(), H5::PredType::NATIVE_INT64);
}

void write_attribute(H5::Group& group, const std::string& name, Index value) {
  const std::int64_t wide = value;
  group.createAttribute(name, H5::PredType::STD_I64LE, H5::DataSpace(H5S_SCALAR))
      .write(H5::PredType::NATIVE_INT64, &wide);
}

void write_attribute(H5::Group& group, const std::string& name, double value) {
  group.createAttribute(name, H5::PredType::IEEE_F64LE, H5::DataSpace(H5S_SCALAR))
      .write(H5::PredType::NATIVE_DOUBLE, &value);
}

void write_attribute(H5::Group& group, const std::string& name, const std::string& text) {
  // Null-terminated, so that the empty text has a length that HDF5 accepts.
  H5::StrType type(H5::PredType::C_S1, text.size() + 1);
  type.setCset(H5T_CSET_UTF8);
  group.createAttribute(name, type, H5::DataSpace(H5S_SCALAR)).write(type, text.c_str());
}

}  // namespace lcp::hdf5
