#include "problems/io/hdf5/corpus.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "problems/features.h"
#include "problems/io/errors.h"
#include "problems/io/hdf5/fclib_local.h"
#include "problems/io/hdf5/values.h"
#include "problems/io/limits.h"
#include "problems/io/replace_file.h"
#include "solvers/errors.h"

namespace lcp {

namespace {

using hdf5::GroupReader;

constexpr Index corpus_version = 1;

// --- writing ---

void require_storable_name(const std::string& file, const std::string& name) {
  std::size_t begin = 0;
  bool storable = name.find('#') == std::string::npos;
  while (storable && begin <= name.size()) {
    const std::size_t end = std::min(name.find('/', begin), name.size());
    const std::string part = name.substr(begin, end - begin);
    storable = !part.empty() && part != "." && part != "..";
    begin = end + 1;
  }
  if (!storable)
    throw UnwritableOutput(
        "{}: cannot hold an instance called '{}', expected a name like family/0042", file, name);
}

void require_separate_names(const std::string& file, const std::vector<Instance>& instances) {
  // With the trailing '/', a name sorts right before the names inside it.
  std::vector<std::string> names;
  for (const Instance& instance : instances) {
    require_storable_name(file, instance.name);
    names.push_back(instance.name + "/");
  }
  std::sort(names.begin(), names.end());
  for (std::size_t i = 1; i < names.size(); ++i)
    if (names[i].starts_with(names[i - 1]))
      throw UnwritableOutput(
          "{}: cannot hold '{}' inside '{}', expected instances of "
          "different names side by side",
          file, names[i], names[i - 1]);
}

void write_features(H5::Group& group, const Problem& problem) {
  const Features found = features(problem);
  hdf5::write_attribute(group, "n", found.n);
  hdf5::write_attribute(group, "contacts", found.contacts);
  hdf5::write_attribute(group, "asymmetry", found.asymmetry);
  hdf5::write_attribute(group, "density", found.density);
  hdf5::write_attribute(group, "tied_q", found.tied_q);
  if (found.rank) hdf5::write_attribute(group, "rank", *found.rank);
  if (found.condition) hdf5::write_attribute(group, "condition", *found.condition);
}

void write_friction(H5::Group& group, const FrictionBlocks& blocks) {
  write_fclib_local(group, blocks);
  H5::Group layout = group.createGroup("layout");
  hdf5::write(layout, "directions", blocks.directions);
  hdf5::write(layout, "normal_row", blocks.normal_row);
  hdf5::write(layout, "friction_row", blocks.friction_row);
  hdf5::write(layout, "cone_row", blocks.cone_row);
  hdf5::write_attribute(layout, "directions_per_contact", blocks.directions_per_contact);
}

void write_previous(H5::Group& group, const Instance& instance) {
  hdf5::write(group, "previous_alpha", instance.previous->alpha);
  if (instance.previous->z.size() > 0) hdf5::write(group, "previous_z", instance.previous->z);
  hdf5::write_attribute(group, "previous_sha256", hash_with_previous(instance));
}

void write_instance(H5::Group& group, const Instance& instance) {
  const Problem& problem = instance.problem;
  hdf5::write(group, "M", problem.M);
  hdf5::write(group, "q", problem.q);
  hdf5::write(group, "s_z", problem.s_z);
  hdf5::write(group, "s_w", problem.s_w);
  if (problem.c.size() > 0) hdf5::write(group, "c", problem.c);
  if (instance.known_solution) hdf5::write(group, "known_solution", *instance.known_solution);
  if (instance.previous) write_previous(group, instance);
  if (problem.friction) write_friction(group, *problem.friction);
  hdf5::write_attribute(group, "sha256", content_hash(problem));
  hdf5::write_attribute(group, "pivot_limit", problem.pivot_limit);
  if (instance.active_contacts)
    hdf5::write_attribute(group, "active_contacts", *instance.active_contacts);
  write_features(group, problem);
  H5::Group provenance = group.createGroup("provenance");
  for (const auto& [key, text] : instance.provenance) hdf5::write_attribute(provenance, key, text);
}

void write_instances(H5::H5File& file, const std::vector<Instance>& instances) {
  H5::Group root = file.openGroup("/");
  hdf5::write_attribute(root, "corpus_version", corpus_version);
  if (instances.size() == 1) {
    hdf5::write_attribute(root, "name", instances.front().name);
    write_instance(root, instances.front());
    return;
  }
  H5::LinkCreatPropList with_parents;
  with_parents.setCreateIntermediateGroup(true);
  for (const Instance& instance : instances) {
    H5::Group group = file.createGroup(instance.name, with_parents);
    write_instance(group, instance);
  }
}

/// The bytes of a corpus. HDF5 works in memory only: a full disk is then met by replace_file, which
/// knows how to clean up, and not inside the library, which does not.
std::string corpus_image(const std::string& path, const std::vector<Instance>& instances) {
  constexpr std::size_t growth = 1 << 20;
  H5::FileAccPropList in_memory;
  in_memory.setCore(growth, false);
  H5::H5File file(path, H5F_ACC_TRUNC, H5::FileCreatPropList::DEFAULT, in_memory);
  write_instances(file, instances);
  file.flush(H5F_SCOPE_GLOBAL);
  const ssize_t size = H5Fget_file_image(file.getId(), nullptr, 0);
  std::string image(size > 0 ? static_cast<std::size_t>(size) : 0, '\0');
  if (H5Fget_file_image(file.getId(), image.data(), image.size()) < 0)
    throw H5::FileIException("H5Fget_file_image", "no image of the file");
  return image;
}

// --- reading ---

FrictionBlocks read_friction(const GroupReader& group, Index n) {
  LocalContacts local = read_fclib_local(group, n).contacts;  // Every contact has a row of its own.
  if (local.dimension != 3)
    group.group("fclib_local").fail("spacedim", "is 2, expected 3 beside M and q");
  const GroupReader layout = group.group("layout");
  const Index count = local.mu.size();
  FrictionBlocks blocks;
  blocks.directions_per_contact = layout.integer_attribute("directions_per_contact");
  if (blocks.directions_per_contact < 0 || blocks.directions_per_contact > largest_rows)
    layout.fail("directions_per_contact", "is {}, expected 0 ... {}", blocks.directions_per_contact,
                largest_rows);
  blocks.directions = layout.matrix("directions", 2, count * blocks.directions_per_contact);
  blocks.normal_row = layout.integers("normal_row", count);
  blocks.friction_row = layout.integers("friction_row", count);
  blocks.cone_row = layout.integers("cone_row", count);
  blocks.W = std::move(local.W);
  blocks.vbar = std::move(local.q);
  blocks.mu = std::move(local.mu);
  return blocks;
}

Problem read_problem(const GroupReader& group) {
  Problem problem;
  problem.q = group.vector("q");
  const Index n = problem.q.size();
  problem.M = group.matrix("M", n, n);
  set_plain_scales(problem);
  if (group.has("s_z")) problem.s_z = group.vector("s_z", n);
  if (group.has("s_w")) problem.s_w = group.vector("s_w", n);
  if (group.has("c")) problem.c = group.vector("c", n);
  if (group.has_attribute("pivot_limit"))
    problem.pivot_limit = group.integer_attribute("pivot_limit");
  if (group.has("fclib_local")) problem.friction = read_friction(group, n);
  return problem;
}

VectorXd read_known_solution(const GroupReader& group, Index n) {
  VectorXd z = group.vector("known_solution", n);
  if (!z.allFinite()) group.fail("known_solution", "is not finite, expected finite numbers");
  return z;
}

Index read_active_contacts(const GroupReader& group, Index contacts) {
  const Index active = group.integer_attribute("active_contacts");
  if (active < 0 || active > contacts)
    group.fail("active_contacts", "is {}, expected 0 ... {}", active, contacts);
  return active;
}

std::map<std::string, std::string> read_provenance(const GroupReader& group) {
  if (!group.has_group("provenance")) return {};
  return group.group("provenance").printed_attributes();
}

/// `found` is the hash of what was read, `name` the attribute that may hold it.
void require_hash(const GroupReader& group, const char* name, const std::string& found) {
  if (!group.has_attribute(name)) return;
  const std::string stored = group.text_attribute(name);
  if (stored != found) group.fail(name, "is {}, but the content has {}", stored, found);
}

void read_previous(const GroupReader& group, Instance& instance) {
  Start& previous = instance.previous.emplace();
  previous.alpha = group.integers_up_to("previous_alpha", instance.problem.size());
  if (group.has("previous_z")) previous.z = group.vector("previous_z");
  try {
    check(previous, instance.problem.size(), "previous solution");
  } catch (const std::invalid_argument& error) {
    group.fail("", error.what());
  }
  require_hash(group, "previous_sha256", hash_with_previous(instance));
}

/// An instance whose group holds M and q.
Instance read_stored_lcp(const GroupReader& group, const std::string& name) {
  Instance instance;
  try {
    instance = make_instance(name, read_problem(group), read_provenance(group));
  } catch (const std::invalid_argument& error) {
    group.fail("", error.what());
  }
  require_hash(group, "sha256", instance.sha256);
  const Problem& problem = instance.problem;
  if (group.has("known_solution"))
    instance.known_solution = read_known_solution(group, problem.size());
  if (group.has_attribute("active_contacts"))
    instance.active_contacts =
        read_active_contacts(group, problem.friction ? problem.friction->contacts() : 0);
  if (group.has("previous_alpha")) read_previous(group, instance);
  return instance;
}

/// An instance whose group holds contacts alone: a file of FCLIB, or a group copied from one.
Instance read_contacts(const GroupReader& group, const std::string& name,
                       const ReadOptions& options) {
  const GroupReader problem = group.group("fclib_local");
  const Index dimension = problem.integer("spacedim");
  const Index contacts = problem.group("vectors").vector("mu").size();
  require_readable_size(contacts, dimension, options, problem.place());
  FclibLocal local = read_fclib_local(group, contacts);
  std::map<std::string, std::string> provenance = read_provenance(group);
  provenance["format"] = "FCLIB local problem";
  provenance["storage"] = local.storage;
  if (problem.has_group("info")) {
    const GroupReader info = problem.group("info");
    for (const char* key : {"title", "description"})
      if (const std::string text = info.text(key); !text.empty()) provenance[key] = text;
  }
  Instance instance = contact_instance(name, std::move(local.contacts), options,
                                       std::move(provenance), problem.place());
  require_hash(group, "sha256", instance.sha256);
  return instance;
}

/// Whether a group is an instance: it says so by its hash, or holds a matrix M or contacts.
bool is_instance(const GroupReader& group) {
  return group.has_attribute("sha256") || group.has_dataset("M") || group.has_group("fclib_local");
}

Instance read_instance(const GroupReader& group, const std::string& name,
                       const ReadOptions& options) {
  const bool contacts_alone = group.has_group("fclib_local") && !group.has("M") && !group.has("q");
  return contacts_alone ? read_contacts(group, name, options) : read_stored_lcp(group, name);
}

/// A file that holds a version has to hold ours; a file that another program wrote holds no version.
void require_our_version(const GroupReader& root) {
  if (!root.has_attribute("corpus_version")) return;
  const Index version = root.integer_attribute("corpus_version");
  if (version != corpus_version)
    root.fail("corpus_version", "is {}, expected {}", version, corpus_version);
}

}  // namespace

void write_corpus(const std::string& path, const std::vector<Instance>& instances) {
  if (instances.empty())
    throw InvalidArgument("{}: no instance to write, expected at least 1", path);
  require_separate_names(path, instances);
  H5::Exception::dontPrint();
  std::string image;
  try {
    image = corpus_image(path, instances);
  } catch (const H5::Exception& error) {
    throw UnwritableOutput("{}: the HDF5 library refuses the instances: {} ({})", path,
                           error.getDetailMsg(), error.getFuncName());
  }
  replace_file(path, image);
}

std::vector<Instance> read_corpus(const std::string& path, const std::string& name,
                                  const ReadOptions& options, const std::string& unnamed) {
  const GroupReader root(path);
  require_our_version(root);
  if (root.has("fclib_global"))
    root.fail("fclib_global", "is a global problem, expected a local one (fclib_local)");
  std::vector<Instance> instances;
  const auto take = [&](const GroupReader& group, const std::string& found) {
    if (name.empty() || name == found) instances.push_back(read_instance(group, found, options));
  };
  if (is_instance(root))
    take(root, root.has_attribute("name") ? root.text_attribute("name") : unnamed);
  for (const std::string& inner : root.groups_below())
    if (const GroupReader group = root.group(inner); is_instance(group)) take(group, inner);
  if (instances.empty())
    throw UnreadableInput(
        name.empty() ? fmt::format("{}: holds no instance, expected a group with M and q or with "
                                   "fclib_local",
                                   path)
                     : fmt::format("{}: holds no instance called '{}'", path, name));
  return instances;
}

}  // namespace lcp
