// Copyright (c) 2026 The CGAL_ext authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../../include/square_map/write_glb.h"
#include "../../include/square_map/Output_target.h"

#include <tiny_gltf.h>

#include <Eigen/Geometry>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace square_map {

namespace {

/// builds the one buffer of a glTF file, with a view for each of its parts
class Buffer_builder
{
public:
  explicit Buffer_builder(tinygltf::Model& model) : m_model(model) { m_model.buffers.emplace_back(); }

  /// appends bytes, at a multiple of four, and returns the number of their view
  /// \param target what vertices and indices are for; 0 for a picture
  int add_view(const void* bytes, std::size_t size, int target)
  {
    std::vector<unsigned char>& data = m_model.buffers[0].data;
    data.resize((data.size() + 3) / 4 * 4, 0);
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = data.size();
    view.byteLength = size;
    view.target = target;
    const auto* const first = static_cast<const unsigned char*>(bytes);
    data.insert(data.end(), first, first + size);
    m_model.bufferViews.push_back(view);
    return static_cast<int>(m_model.bufferViews.size()) - 1;
  }

  /// appends numbers and returns the number of their accessor
  template <class Number>
  int add_numbers(const std::vector<Number>& numbers, int numbers_of_element, int component, int type, int target)
  {
    tinygltf::Accessor accessor;
    accessor.bufferView = add_view(numbers.data(), numbers.size() * sizeof(Number), target);
    accessor.componentType = component;
    accessor.type = type;
    accessor.count = numbers.size() / static_cast<std::size_t>(numbers_of_element);
    m_model.accessors.push_back(accessor);
    return static_cast<int>(m_model.accessors.size()) - 1;
  }

private:
  tinygltf::Model& m_model;
};

std::vector<float> numbers_of(const std::vector<Eigen::Vector3d>& vectors, const Eigen::Vector3d& origin)
{
  std::vector<float> numbers;
  for(const Eigen::Vector3d& p : vectors)
    for(int c = 0; c < 3; ++c)
      numbers.push_back(static_cast<float>(p[c] - origin[c]));
  return numbers;
}

/// glTF wants normals of length 1: an arbitrary one where the surface has none
std::vector<float> numbers_of_normals(const std::vector<Eigen::Vector3d>& normals)
{
  std::vector<Eigen::Vector3d> unit(normals);
  for(Eigen::Vector3d& normal : unit)
    if(normal.isZero(0))
      normal = Eigen::Vector3d::UnitZ();
  return numbers_of(unit, Eigen::Vector3d::Zero());
}

/// the extent that glTF demands of positions, as the rounded numbers have it
void set_extent(const std::vector<float>& numbers, tinygltf::Accessor& accessor)
{
  accessor.minValues.assign(3, std::numeric_limits<double>::infinity());
  accessor.maxValues.assign(3, -std::numeric_limits<double>::infinity());
  for(std::size_t k = 0; k < numbers.size(); ++k) {
    double &low = accessor.minValues[k % 3], &high = accessor.maxValues[k % 3];
    low = (std::min)(low, static_cast<double>(numbers[k]));
    high = (std::max)(high, static_cast<double>(numbers[k]));
  }
}

/// a rough material that shows the texture from both sides
void add_material(const std::string& png, Buffer_builder& buffer, tinygltf::Model& model)
{
  tinygltf::Image image;
  image.mimeType = "image/png";
  image.bufferView = buffer.add_view(png.data(), png.size(), 0);
  model.images.push_back(image);
  tinygltf::Sampler sampler;
  sampler.magFilter = TINYGLTF_TEXTURE_FILTER_LINEAR;
  sampler.minFilter = TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR;
  sampler.wrapS = sampler.wrapT = TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE;
  model.samplers.push_back(sampler);
  tinygltf::Texture texture;
  texture.sampler = texture.source = 0;
  model.textures.push_back(texture);
  tinygltf::Material material;
  material.pbrMetallicRoughness.baseColorTexture.index = 0;
  material.pbrMetallicRoughness.metallicFactor = 0;
  material.pbrMetallicRoughness.roughnessFactor = 0.9;
  material.doubleSided = true;
  model.materials.push_back(material);
}

} // namespace

void write_glb(std::ostream& stream, const std::vector<Eigen::Vector3d>& points,
               const std::vector<Eigen::Vector3d>& normals,
               const Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>& uv,
               const std::vector<std::array<int, 3>>& triangles, const std::string& png)
{
  Eigen::AlignedBox3d box;
  for(const Eigen::Vector3d& p : points)
    box.extend(p);
  constexpr double LARGEST = std::numeric_limits<float>::max();
  if(!(box.min().cwiseAbs().maxCoeff() <= LARGEST && box.max().cwiseAbs().maxCoeff() <= LARGEST))
    throw Output_error("glTF has no number as large as the coordinates of this surface");
  const Eigen::Vector3d center = box.min() / 2 + box.max() / 2;

  tinygltf::Model model;
  model.asset.version = "2.0";
  model.asset.generator = "square_map";
  Buffer_builder buffer(model);
  tinygltf::Primitive primitive;
  primitive.mode = TINYGLTF_MODE_TRIANGLES;
  const std::vector<float> positions = numbers_of(points, center);
  primitive.attributes["POSITION"] =
      buffer.add_numbers(positions, 3, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3, TINYGLTF_TARGET_ARRAY_BUFFER);
  set_extent(positions, model.accessors.back());
  primitive.attributes["NORMAL"] = buffer.add_numbers(numbers_of_normals(normals), 3, TINYGLTF_COMPONENT_TYPE_FLOAT,
                                                      TINYGLTF_TYPE_VEC3, TINYGLTF_TARGET_ARRAY_BUFFER);
  std::vector<float> texture_coordinates;
  for(Eigen::Index v = 0; v < uv.rows(); ++v) {
    texture_coordinates.push_back(static_cast<float>(uv(v, 0)));
    texture_coordinates.push_back(static_cast<float>(1 - uv(v, 1))); // glTF has the origin at the top
  }
  primitive.attributes["TEXCOORD_0"] = buffer.add_numbers(texture_coordinates, 2, TINYGLTF_COMPONENT_TYPE_FLOAT,
                                                          TINYGLTF_TYPE_VEC2, TINYGLTF_TARGET_ARRAY_BUFFER);
  std::vector<std::uint32_t> indices;
  for(const auto& t : triangles)
    for(int v : t)
      indices.push_back(static_cast<std::uint32_t>(v));
  primitive.indices = buffer.add_numbers(indices, 1, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR,
                                         TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
  add_material(png, buffer, model);
  primitive.material = 0;
  tinygltf::Mesh mesh;
  mesh.primitives.push_back(primitive);
  model.meshes.push_back(mesh);
  tinygltf::Node node;
  node.mesh = 0;
  node.translation = {center.x(), center.y(), center.z()};
  model.nodes.push_back(node);
  tinygltf::Scene scene;
  scene.nodes.push_back(0);
  model.scenes.push_back(scene);
  model.defaultScene = 0;
  tinygltf::TinyGLTF().WriteGltfSceneToStream(&model, stream, false, true);
}

} // namespace square_map
