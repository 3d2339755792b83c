#include <amontons/contact/surface_fields.h>
#include <amontons/output/json.h>
#include <amontons/output/vtu_output.h>

#include <deal.II/base/utilities.h>

#include <cstdint>
#include <cstring>

namespace Amontons
{
  namespace
  {
    // ASCII arrays of all pairs, one after another; gaps may be NaN, which VTK cannot read in ASCII.
    struct SurfaceArrays
    {
      std::vector<double> gap;
      std::string         points, connectivity, offsets, types;
      std::string         pressure, traction, state, slip, normal, displacement, pair;
      unsigned int        n_points = 0, n_cells = 0;
    };

    std::string
    number(const double value)
    {
      return number_text(value) + " ";
    }

    template <int dim>
    std::string
    vector(const Tensor<1, dim> &v)
    {
      std::string text;
      for (unsigned int d = 0; d < 3; ++d)
        text += number(d < dim ? v[d] : 0.);
      return text + "\n";
    }

    template <int dim>
    void
    add_nodes(SurfaceArrays             &arrays,
              const ContactSurface<dim> &surface,
              const SurfaceFields<dim>  &fields,
              const unsigned int         pair)
    {
      for (unsigned int i = 0; i < surface.nodes.size(); ++i)
        {
          arrays.points += vector<dim>(surface.nodes[i].X);
          arrays.pressure += number(shown_pressure(fields, i));
          arrays.traction += vector(shown_traction(fields, i));
          arrays.gap.push_back(fields.gap[i]);
          arrays.state += std::to_string(static_cast<int>(fields.state[i])) + " ";
          arrays.slip += vector(fields.slip[i]);
          arrays.normal += vector(fields.normal[i]);
          arrays.displacement += vector(fields.displacement[i]);
          arrays.pair += std::to_string(pair) + " ";
        }
    }

    // Corners of one piece of a face, in VTK's order; i, j: its place among degree^(dim-1) pieces.
    template <int dim>
    std::vector<unsigned int>
    corners(const SurfaceFace<dim> &face,
            const unsigned int      degree,
            const unsigned int      i,
            const unsigned int      j)
    {
      if (dim == 2)
        return {face.nodes[i], face.nodes[i + 1]};
      const unsigned int n = degree + 1, first = j * n + i;
      return {face.nodes[first], face.nodes[first + 1], face.nodes[first + n + 1], face.nodes[first + n]};
    }

    template <int dim>
    void
    add_faces(SurfaceArrays &arrays, const ContactSurface<dim> &surface)
    {
      const std::string type = dim == 2 ? "3 " : "9 "; // VTK_LINE, VTK_QUAD
      for (const SurfaceFace<dim> &face : surface.faces)
        for (unsigned int j = 0; j < (dim == 2 ? 1 : surface.degree); ++j)
          for (unsigned int i = 0; i < surface.degree; ++i)
            {
              for (const unsigned int node : corners(face, surface.degree, i, j))
                arrays.connectivity += std::to_string(arrays.n_points + node) + " ";
              arrays.connectivity += "\n";
              arrays.offsets += std::to_string(++arrays.n_cells * (dim == 2 ? 2 : 4)) + " ";
              arrays.types += type;
            }
    }

    std::string
    data_array(const std::string &name,
               const std::string &type,
               const unsigned int n,
               const std::string &data)
    {
      return "<DataArray type=\"" + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" +
             std::to_string(n) + "\" format=\"ascii\">\n" + data + "\n</DataArray>\n";
    }

    // Base64 of the number of bytes and the bytes.
    std::string
    binary_array(const std::string &name, const std::vector<double> &data)
    {
      const std::uint32_t        n_bytes = data.size() * sizeof(double);
      std::vector<unsigned char> bytes(sizeof(n_bytes) + n_bytes);
      std::memcpy(bytes.data(), &n_bytes, sizeof(n_bytes));
      if (n_bytes > 0)
        std::memcpy(bytes.data() + sizeof(n_bytes), data.data(), n_bytes);
      return "<DataArray type=\"Float64\" Name=\"" + name + "\" format=\"binary\">\n" +
             Utilities::encode_base64(bytes) + "\n</DataArray>\n";
    }

    std::string
    vtu_text(const SurfaceArrays &arrays)
    {
      const std::string real = "Float64", integer = "Int32";
      return "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
             "byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n"
             "<Piece NumberOfPoints=\"" +
             std::to_string(arrays.n_points) + "\" NumberOfCells=\"" + std::to_string(arrays.n_cells) +
             "\">\n<Points>\n" + data_array("Points", real, 3, arrays.points) + "</Points>\n<Cells>\n" +
             data_array("connectivity", integer, 1, arrays.connectivity) +
             data_array("offsets", integer, 1, arrays.offsets) +
             data_array("types", "UInt8", 1, arrays.types) + "</Cells>\n<PointData>\n" +
             data_array("pressure", real, 1, arrays.pressure) +
             data_array("traction", real, 3, arrays.traction) + binary_array("gap", arrays.gap) +
             data_array("state", integer, 1, arrays.state) + data_array("slip", real, 3, arrays.slip) +
             data_array("normal", real, 3, arrays.normal) +
             data_array("displacement", real, 3, arrays.displacement) +
             data_array("pair", integer, 1, arrays.pair) +
             "</PointData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
    }
  } // namespace

  template <int dim>
  std::string
  contact_vtu(const std::vector<ContactInterface<dim>> &interfaces,
              const std::vector<SurfaceFields<dim>>    &fields)
  {
    SurfaceArrays arrays;
    for (unsigned int p = 0; p < interfaces.size(); ++p)
      {
        add_nodes(arrays, *interfaces[p].slave, fields[p], p);
        add_faces(arrays, *interfaces[p].slave);
        arrays.n_points += interfaces[p].slave->nodes.size();
      }
    return vtu_text(arrays);
  }

  template std::string
  contact_vtu(const std::vector<ContactInterface<2>> &, const std::vector<SurfaceFields<2>> &);
  template std::string
  contact_vtu(const std::vector<ContactInterface<3>> &, const std::vector<SurfaceFields<3>> &);
} // namespace Amontons
