#include <amontons/contact/surface_fields.h>
#include <amontons/contact/surface_order.h>
#include <amontons/friction/shear_law.h>
#include <amontons/output/contact_csv.h>
#include <amontons/output/files.h>
#include <amontons/output/json.h>

#include <algorithm>
#include <cmath>

namespace Amontons
{
  namespace
  {
    template <int dim, typename TensorType>
    void
    copy(const Tensor<1, dim> &from, TensorType &to)
    {
      for (unsigned int d = 0; d < dim; ++d)
        to[d] = from[d];
    }

    template <int dim>
    ContactNode
    make_node(const ContactInterface<dim> &interface,
              const SurfaceFields<dim>    &fields,
              const unsigned int           i,
              const double                 t)
    {
      ContactNode node;
      node.pair = interface.pair->name;
      copy<dim>(interface.slave->nodes[i].X, node.X);
      copy<dim>(interface.slave->nodes[i].X + fields.displacement[i], node.x);
      copy(fields.normal[i], node.normal);
      copy(shown_traction(fields, i), node.traction);
      copy(fields.force[i], node.force);
      copy(fields.slip[i], node.slip);
      node.area     = fields.area[i];
      node.pressure = shown_pressure(fields, i);
      node.gap      = fields.gap[i];
      node.state    = fields.state[i];
      node.bound    = interface.pair->has_friction()
                          ? shear_bound(*interface.pair, node.X, t, fields.pressure[i]).value
                          : std::nan("");
      return node;
    }

    template <typename TensorType>
    std::string
    triple(const TensorType &v)
    {
      return number_text(v[0]) + "," + number_text(v[1]) + "," + number_text(v[2]);
    }
  } // namespace

  template <int dim>
  std::vector<ContactNode>
  contact_table(const std::vector<ContactInterface<dim>> &interfaces,
                const std::vector<SurfaceFields<dim>>    &fields,
                const double                              t)
  {
    std::vector<ContactNode> table;
    for (unsigned int p = 0; p < interfaces.size(); ++p)
      {
        std::vector<Point<dim>>                nodes;
        std::vector<std::vector<unsigned int>> faces;
        for (const auto &node : interfaces[p].slave->nodes)
          nodes.push_back(node.X);
        for (const auto &face : interfaces[p].slave->faces)
          faces.push_back(face.nodes);

        const std::size_t first = table.size();
        for (const unsigned int i : order_along_surface(nodes, faces))
          {
            table.push_back(make_node(interfaces[p], fields[p], i, t));
            if (dim == 2 && table.size() > first + 1)
              table.back().arc =
                  table[table.size() - 2].arc + table.back().X.distance(table[table.size() - 2].X);
          }
      }
    return table;
  }

  std::string
  state_name(const ContactStatus state)
  {
    return state == ContactStatus::open ? "open" : state == ContactStatus::slip ? "slip" : "stick";
  }

  void
  write_contact_csv(const std::string &file, const std::vector<ContactNode> &table)
  {
    std::string text =
        "pair,X,Y,Z,x,y,z,nx,ny,nz,area,pressure,tx,ty,tz,gap,slip_x,slip_y,slip_z,state,fx,fy,fz\n";
    for (const ContactNode &node : table)
      text += csv_field(node.pair) + "," + triple(node.X) + "," + triple(node.x) + "," + triple(node.normal) +
              "," + number_text(node.area) + "," + number_text(node.pressure) + "," + triple(node.traction) +
              "," + number_text(node.gap) + "," + triple(node.slip) + "," + state_name(node.state) + "," +
              triple(node.force) + "\n";
    write_file(file, text);
  }

  template std::vector<ContactNode>
  contact_table(const std::vector<ContactInterface<2>> &,
                const std::vector<SurfaceFields<2>> &,
                const double);
  template std::vector<ContactNode>
  contact_table(const std::vector<ContactInterface<3>> &,
                const std::vector<SurfaceFields<3>> &,
                const double);
} // namespace Amontons
