#include <amontons/algebra/mumps.h>

#include <Epetra_MpiComm.h>
#include <dmumps_c.h>

namespace Amontons
{
  namespace
  {
    enum Job
    {
      begin     = -1,
      end       = -2,
      analysis  = 1,
      factorise = 2,
      solution  = 3
    };

    // Of this rank, row by row: (row, column, value), numbered from 0.
    template <typename Visit>
    void
    for_each_entry(const Epetra_CrsMatrix &matrix, const bool lower_triangle, const Visit &visit)
    {
      for (int i = 0; i < matrix.NumMyRows(); ++i)
        {
          double *value;
          int     n, *column;
          matrix.ExtractMyRowView(i, n, value, column);
          const int row = matrix.GRID(i);
          for (int k = 0; k < n; ++k)
            if (const int other = matrix.GCID(column[k]); !lower_triangle || other <= row)
              visit(row, other, value[k]);
        }
    }
  } // namespace

  // The parameters of the manual count from 1.
  struct Mumps::Instance
  {
    DMUMPS_STRUC_C data{};
    int &
    icntl(const int i)
    {
      return data.icntl[i - 1];
    }
    int
    infog(const int i) const
    {
      return data.infog[i - 1];
    }
  };

  Mumps::Mumps(const Epetra_CrsMatrix &matrix, const bool symmetric, const bool by_fill)
      : matrix(matrix), instance(std::make_unique<Instance>()), symmetric(symmetric),
        on_first(matrix.NumGlobalRows(),
                 matrix.Comm().MyPID() == 0 ? matrix.NumGlobalRows() : 0,
                 0,
                 matrix.Comm()),
        to_first(on_first, matrix.RowMap())
  {
    auto &data        = instance->data;
    data.comm_fortran = MPI_Comm_c2f(dynamic_cast<const Epetra_MpiComm &>(matrix.Comm()).Comm());
    data.par          = 1; // rank 0 works, too
    data.sym          = symmetric ? 1 : 0;
    run(Job::begin);
    for (const int output : {1, 2, 3})
      instance->icntl(output) = -1;
    instance->icntl(4) = 0; // no words
    if (matrix.Comm().NumProc() > 1)
      instance->icntl(18) = 3; // entries by rank
    if (by_fill)
      instance->icntl(7) = 2;
  }

  Mumps::~Mumps() { run(Job::end); }

  int
  Mumps::run(const int job)
  {
    instance->data.job = job;
    dmumps_c(&instance->data);
    return instance->infog(1);
  }

  int
  Mumps::analyse(const int workspace)
  {
    rows.clear();
    columns.clear();
    for_each_entry(matrix, symmetric, [&](const int row, const int column, const double) {
      rows.push_back(row + 1);
      columns.push_back(column + 1);
    });
    values.assign(rows.size(), 0.);
    auto &data          = instance->data;
    data.n              = matrix.NumGlobalRows();
    instance->icntl(14) = workspace;
    if (matrix.Comm().NumProc() > 1)
      {
        data.nnz_loc = rows.size();
        data.irn_loc = rows.data();
        data.jcn_loc = columns.data();
        data.a_loc   = values.data();
      }
    else
      {
        data.nnz = rows.size();
        data.irn = rows.data();
        data.jcn = columns.data();
        data.a   = values.data();
      }
    return run(Job::analysis);
  }

  int
  Mumps::factorise()
  {
    auto place = values.begin();
    for_each_entry(matrix, symmetric, [&](const int, const int, const double value) { *place++ = value; });
    return run(Job::factorise);
  }

  void
  Mumps::solve(Epetra_MultiVector &columns_of_all)
  {
    Epetra_MultiVector columns_on_first(on_first, columns_of_all.NumVectors());
    columns_on_first.Import(columns_of_all, to_first, Insert);
    auto &data = instance->data;
    data.rhs   = columns_on_first.Values();
    data.nrhs  = columns_of_all.NumVectors();
    data.lrhs  = columns_on_first.Stride();
    run(Job::solution);
    columns_of_all.Export(columns_on_first, to_first, Insert);
  }

  double
  Mumps::n_operations() const
  {
    return instance->data.rinfog[0];
  }
} // namespace Amontons
