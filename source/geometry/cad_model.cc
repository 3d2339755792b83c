#include <amontons/geometry/cad_model.h>
#include <amontons/geometry/mesh_file.h>

#include <deal.II/base/numbers.h>

#include <deal.II/opencascade/utilities.h>

#include <BRepBuilderAPI_Transform.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Standard_Failure.hxx>
#include <gp_Ax1.hxx>
#include <gp_Trsf.hxx>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <limits>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace Amontons
{
  using namespace dealii;

  namespace
  {
    // A point of a surface or curve, and its parameters; of curves only the first.
    struct Sample
    {
      Point<3>     x;
      Tensor<1, 2> parameters;
    };

    // The start of a Newton iteration. It does not depend on what was asked before, so that all ranks agree.
    Tensor<1, 2>
    nearest_parameters(const std::vector<Sample> &samples, const Point<3> &p)
    {
      return std::min_element(samples.begin(),
                              samples.end(),
                              [&](const Sample &a, const Sample &b) {
                                return (a.x - p).norm_square() < (b.x - p).norm_square();
                              })
          ->parameters;
    }

    BoundingBox<3>
    box_of(const std::vector<Sample> &samples)
    {
      std::vector<Point<3>> points;
      points.reserve(samples.size());
      for (const Sample &sample : samples)
        points.push_back(sample.x);
      return BoundingBox<3>(points);
    }

    double
    diameter(const BoundingBox<3> &box)
    {
      return box.get_boundary_points().first.distance(box.get_boundary_points().second);
    }

    // Newton's method for stationary points of |S(u, v) - p|^2 / 2. Where its matrix is not positive definite
    // (poles) or it does not converge, OpenCASCADE searches, which takes some hundred times longer.
    CadShape
    make_face(const TopoDS_Face &face)
    {
      const unsigned int n               = 24;
      const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
      double u_0, u_1, v_0, v_1;
      BRepTools::UVBounds(face, u_0, u_1, v_0, v_1);
      std::vector<Sample> samples;
      for (unsigned int i = 0; i <= n; ++i)
        for (unsigned int j = 0; j <= n; ++j)
          {
            const Tensor<1, 2> uv({u_0 + i * (u_1 - u_0) / n, v_0 + j * (v_1 - v_0) / n});
            samples.push_back({OpenCASCADE::point<3>(surface->Value(uv[0], uv[1])), uv});
          }
      const BoundingBox<3> box     = box_of(samples);
      const double         size    = diameter(box);
      const auto           closest = [=](const Point<3> &p) {
        Tensor<1, 2> uv = nearest_parameters(samples, p);
        for (unsigned int i = 0; i < 20; ++i)
          {
            gp_Pnt x;
            gp_Vec x_u, x_v, x_uu, x_vv, x_uv;
            surface->D2(uv[0], uv[1], x, x_u, x_v, x_uu, x_vv, x_uv);
            const gp_Vec r(OpenCASCADE::point(p), x);
            Tensor<2, 2> H;
            H[0][0] = x_u * x_u + r * x_uu;
            H[1][1] = x_v * x_v + r * x_vv;
            H[0][1] = H[1][0] = x_u * x_v + r * x_uv;
            if (!(H[0][0] > 0 && determinant(H) > 1e-12 * H[0][0] * H[1][1]))
              break;
            const Tensor<1, 2> step = -1. * (invert(H) * Tensor<1, 2>({r * x_u, r * x_v}));
            uv += step;
            if ((step[0] * x_u + step[1] * x_v).Magnitude() < 1e-9 * size)
              return OpenCASCADE::point<3>(surface->Value(uv[0], uv[1]));
          }
        return OpenCASCADE::closest_point<3>(face, p);
      };
      return {box, closest};
    }

    // The same for curves.
    CadShape
    make_edge(const TopoDS_Edge &edge)
    {
      const unsigned int n = 200;
      double             s_0, s_1;
      const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, s_0, s_1);
      std::vector<Sample> samples;
      for (unsigned int i = 0; i <= n; ++i)
        {
          const double s = s_0 + i * (s_1 - s_0) / n;
          samples.push_back({OpenCASCADE::point<3>(curve->Value(s)), Tensor<1, 2>({s, 0})});
        }
      const BoundingBox<3> box     = box_of(samples);
      const double         size    = diameter(box);
      const auto           closest = [=](const Point<3> &p) {
        double s = nearest_parameters(samples, p)[0];
        for (unsigned int i = 0; i < 20; ++i)
          {
            gp_Pnt x;
            gp_Vec x_s, x_ss;
            curve->D2(s, x, x_s, x_ss);
            const gp_Vec r(OpenCASCADE::point(p), x);
            const double h = x_s * x_s + r * x_ss;
            if (!(h > 0))
              break;
            const double step = -(r * x_s) / h;
            s += step;
            if (std::abs(step) * x_s.Magnitude() < 1e-9 * size)
              return OpenCASCADE::point<3>(curve->Value(s));
          }
        return OpenCASCADE::closest_point<3>(edge, p);
      };
      return {box, closest};
    }

    // A copy at its place: what shares its geometry with other places confuses deal.II, which does not look
    // at the locations of edges.
    TopoDS_Shape
    place(const TopoDS_Shape &shape, const BodyData &body)
    {
      gp_Trsf shift, rotation;
      shift.SetTranslation(gp_Vec(body.shift[0], body.shift[1], body.shift[2]));
      if (body.rotation_angle != 0)
        rotation.SetRotation(
            gp_Ax1(OpenCASCADE::point(body.rotation_centre),
                   gp_Dir(body.rotation_axis[0], body.rotation_axis[1], body.rotation_axis[2])),
            body.rotation_angle * numbers::PI / 180);
      return BRepBuilderAPI_Transform(shape, shift * rotation, true).Shape();
    }

    InputError
    unreadable(const TrueGeometry &geometry, const SourceLocation &where)
    {
      return {where,
              "OpenCASCADE cannot read '" + geometry.file + "'",
              "a file in STEP or IGES format (as its name says) that is not damaged"};
    }

    TopoDS_Shape
    read_shape(const TrueGeometry &geometry)
    {
      Message::DefaultMessenger()->ChangePrinters().Clear();
      const std::string ending = file_ending(geometry.file);
      return ending == ".step" || ending == ".stp" ? OpenCASCADE::read_STEP(geometry.file, geometry.scale)
                                                   : OpenCASCADE::read_IGES(geometry.file, geometry.scale);
    }

    // Exceptions of OpenCASCADE are none of std.
    CadShape
    with_refusals(const CadShape &shape, const TrueGeometry &geometry, const SourceLocation &where)
    {
      return {shape.box, [=](const Point<3> &p) {
                try
                  {
                    return shape.closest_point(p);
                  }
                catch (const Standard_Failure &)
                  {
                    throw unreadable(geometry, where);
                  }
              }};
    }
  } // namespace

  double
  CadShape::largest_distance(const std::vector<Point<3>> &points, const double tolerance) const
  {
    BoundingBox<3> larger_box = box;
    larger_box.extend(tolerance);
    double largest = 0;
    for (const Point<3> &p : points)
      if (larger_box.point_inside(p))
        largest = std::max(largest, p.distance(closest_point(p)));
      else
        return std::numeric_limits<double>::infinity();
    return largest;
  }

  namespace
  {
    CadModel
    make_cad_model(const TrueGeometry &geometry, const BodyData &body)
    {
      const TopoDS_Shape shape = read_shape(geometry);
      if (shape.IsNull())
        throw unreadable(geometry, body.where);
      std::vector<TopoDS_Face>   faces;
      std::vector<TopoDS_Edge>   edges;
      std::vector<TopoDS_Vertex> vertices;
      OpenCASCADE::extract_geometrical_shapes(place(shape, body), faces, edges, vertices);
      if (faces.empty())
        throw InputError(body.where, "'" + geometry.file + "' has no surfaces", "a CAD file with faces");

      CadModel model;
      for (const TopoDS_Face &face : faces)
        model.faces.push_back(with_refusals(make_face(face), geometry, body.where));
      for (const TopoDS_Edge &edge : edges)
        if (!BRep_Tool::Degenerated(edge))
          model.edges.push_back(with_refusals(make_edge(edge), geometry, body.where));
      return model;
    }

    // Damaged files make OpenCASCADE end in a signal, or search for ever: a child process tries first.
    void
    refuse_deadly(const TrueGeometry &geometry, const BodyData &body)
    {
      // Sound files take less than a second for each megabyte.
      std::error_code    error;
      const auto         size    = std::filesystem::file_size(geometry.file, error);
      const unsigned int seconds = 8 + (error ? 0 : std::min<std::uintmax_t>(size / 50000, 600));
      const pid_t        child   = fork();
      if (child == 0)
        {
          const struct rlimit no_core = {};
          setrlimit(RLIMIT_CORE, &no_core);
          for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL, SIGALRM})
            std::signal(signal, SIG_DFL);
          alarm(seconds);
          try
            {
              make_cad_model(geometry, body);
            }
          catch (...) // the parent meets it, too
            {
            }
          _exit(0);
        }
      int status = 0;
      if (child > 0 && waitpid(child, &status, 0) == child && WIFSIGNALED(status))
        throw InputError(body.where,
                         "OpenCASCADE cannot read '" + geometry.file + "': " +
                             (WTERMSIG(status) == SIGALRM
                                  ? "it takes more than " + std::to_string(seconds) + " seconds"
                                  : "it breaks down (signal " + std::to_string(WTERMSIG(status)) + ")"),
                         "a file that is not damaged");
    }
  } // namespace

  CadModel
  read_cad_model(const TrueGeometry &geometry, const BodyData &body)
  {
    refuse_deadly(geometry, body);
    // Whatever OpenCASCADE has to say ends in one message.
    try
      {
        return make_cad_model(geometry, body);
      }
    catch (const ExceptionBase &)
      {
        throw unreadable(geometry, body.where);
      }
    catch (const Standard_Failure &)
      {
        throw unreadable(geometry, body.where);
      }
  }
} // namespace Amontons
