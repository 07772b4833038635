#include "verification/exact/numerics.hpp"

#include <cvode/cvode.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_multiroots.h>
#include <gsl/gsl_roots.h>
#include <nvector/nvector_serial.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <memory>
#include <string>

namespace g27 {
namespace {

template <auto Free>
struct Deleter {
  template <class T>
  void operator()(T* p) const {
    Free(p);
  }
};

/// GSL's default handler aborts; the return codes are enough. Restored on exit: the handler is global.
struct QuietGsl {
  gsl_error_handler_t* previous = gsl_set_error_handler_off();
  QuietGsl() = default;
  QuietGsl(QuietGsl const&) = delete;
  QuietGsl& operator=(QuietGsl const&) = delete;
  ~QuietGsl() { gsl_set_error_handler(previous); }
};

/// Carries an exception of the user's function across C code, which it must not unwind through.
struct Guarded {
  ScalarFunction const& f;
  std::exception_ptr thrown;
  static double call(double x, void* self) {
    auto& guarded = *static_cast<Guarded*>(self);
    if (guarded.thrown) return 0;
    try {
      return guarded.f(x);
    } catch (...) {
      guarded.thrown = std::current_exception();
      return 0;
    }
  }
  void rethrow() const {
    if (thrown) std::rethrow_exception(thrown);
  }
};

struct GuardedSystem {
  VectorFunction const& f;
  std::exception_ptr thrown;
  static int call(gsl_vector const* x, void* self, gsl_vector* y) {
    auto& guarded = *static_cast<GuardedSystem*>(self);
    try {
      guarded.f(x->data, y->data);  // vectors of the solver are contiguous
      for (std::size_t i = 0; i < y->size; ++i) {
        if (!std::isfinite(y->data[i])) return GSL_EBADFUNC;
      }
      return GSL_SUCCESS;
    } catch (...) {
      guarded.thrown = std::current_exception();
      return GSL_EBADFUNC;
    }
  }
};

struct Ode {
  OdeSlope const& f;
  std::exception_ptr thrown;
  static int call(realtype x, N_Vector y, N_Vector slope, void* self) {
    auto& ode = *static_cast<Ode*>(self);
    try {
      ode.f(x, N_VGetArrayPointer(y), N_VGetArrayPointer(slope));
      return 0;
    } catch (...) {
      ode.thrown = std::current_exception();
      return -1;
    }
  }
};

void silent(int, char const*, char const*, char*, void*) {}

}  // namespace

double find_root(ScalarFunction const& f, double lo, double hi) {
  double const f_lo = f(lo), f_hi = f(hi);
  if (f_lo == 0) return lo;
  if (f_hi == 0) return hi;
  if (!(f_lo * f_hi < 0))
    throw NumericsError("root not bracketed in [" + std::to_string(lo) + ", " + std::to_string(hi) + "]");
  QuietGsl const quiet;
  std::unique_ptr<gsl_root_fsolver, Deleter<gsl_root_fsolver_free>> solver(
      gsl_root_fsolver_alloc(gsl_root_fsolver_brent));
  Guarded guarded{f, {}};
  gsl_function function{&Guarded::call, &guarded};
  gsl_root_fsolver_set(solver.get(), &function, std::min(lo, hi), std::max(lo, hi));
  guarded.rethrow();
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  for (int i = 0; i < 300; ++i) {
    int const status = gsl_root_fsolver_iterate(solver.get());
    guarded.rethrow();
    if (status != GSL_SUCCESS) throw NumericsError("root finder: a value is not finite");
    double const a = gsl_root_fsolver_x_lower(solver.get()), b = gsl_root_fsolver_x_upper(solver.get());
    if (std::fabs(b - a) <= 2 * epsilon * std::min(std::fabs(a), std::fabs(b))) break;
    if (std::fabs(b - a) <= std::numeric_limits<double>::min()) break;
  }
  return gsl_root_fsolver_root(solver.get());
}

std::optional<std::vector<double>> find_roots(VectorFunction const& f, std::vector<double> const& start,
                                              double tolerance) {
  QuietGsl const quiet;
  std::size_t const n = start.size();
  std::unique_ptr<gsl_multiroot_fsolver, Deleter<gsl_multiroot_fsolver_free>> solver(
      gsl_multiroot_fsolver_alloc(gsl_multiroot_fsolver_hybrids, n));
  std::unique_ptr<gsl_vector, Deleter<gsl_vector_free>> x(gsl_vector_alloc(n));
  std::copy(start.begin(), start.end(), x->data);
  GuardedSystem guarded{f, {}};
  gsl_multiroot_function function{&GuardedSystem::call, n, &guarded};
  int status = gsl_multiroot_fsolver_set(solver.get(), &function, x.get());
  auto const largest = [&] {
    double worst = 0;
    for (std::size_t i = 0; i < n; ++i) worst = std::max(worst, std::fabs(solver->f->data[i]));
    return worst;
  };
  for (int i = 0; i < 200 && status == GSL_SUCCESS && !(largest() <= tolerance); ++i) {
    status = gsl_multiroot_fsolver_iterate(solver.get());
  }
  if (guarded.thrown) std::rethrow_exception(guarded.thrown);
  if (!(largest() <= tolerance)) return std::nullopt;
  return std::vector<double>(solver->x->data, solver->x->data + n);
}

double integrate(ScalarFunction const& f, double a, double b, double tolerance, double scale) {
  if (a == b) return 0;
  QuietGsl const quiet;
  constexpr std::size_t intervals = 2000;
  // One workspace a nesting depth: an integrand may itself integrate.
  static thread_local std::vector<std::unique_ptr<gsl_integration_workspace, Deleter<gsl_integration_workspace_free>>>
      free_list;
  auto workspace = [&] {
    if (free_list.empty()) free_list.emplace_back(gsl_integration_workspace_alloc(intervals));
    auto last = std::move(free_list.back());
    free_list.pop_back();
    return last;
  }();
  Guarded guarded{f, {}};
  gsl_function function{&Guarded::call, &guarded};
  double value = 0, error = 0;
  int const status = gsl_integration_qag(&function, a, b, tolerance * scale, tolerance, intervals, GSL_INTEG_GAUSS31,
                                         workspace.get(), &value, &error);
  free_list.push_back(std::move(workspace));
  guarded.rethrow();
  // Round-off is reached before 1e-13 now and then: accept what is still a thousand times better than the checks.
  if (status != GSL_SUCCESS && !(error <= 1e-10 * std::max(std::fabs(value), scale)))
    throw NumericsError(std::string("quadrature: ") + gsl_strerror(status));
  return value;
}

std::vector<std::vector<double>> solve_ode(OdeSlope const& f, std::vector<double> start,
                                           std::vector<double> const& nodes, double relative, double absolute) {
  auto check = [](int flag, char const* what) {
    if (flag < 0) throw NumericsError(std::string("CVODE: ") + what + " failed with " + std::to_string(flag));
  };
  SUNContext raw = nullptr;
  check(SUNContext_Create(nullptr, &raw), "context");
  auto free_context = [](SUNContext c) { SUNContext_Free(&c); };
  std::unique_ptr<std::remove_pointer_t<SUNContext>, decltype(free_context)> context(raw, free_context);
  auto const n = static_cast<sunindextype>(start.size());
  std::unique_ptr<_generic_N_Vector, Deleter<N_VDestroy>> y(N_VMake_Serial(n, start.data(), context.get()));
  std::unique_ptr<_generic_SUNNonlinearSolver, Deleter<SUNNonlinSolFree>> iteration(
      SUNNonlinSol_FixedPoint(y.get(), 0, context.get()));
  auto free_cvode = [](void* p) { CVodeFree(&p); };
  std::unique_ptr<void, decltype(free_cvode)> cvode(CVodeCreate(CV_ADAMS, context.get()), free_cvode);
  Ode ode{f, {}};
  check(CVodeSetErrHandlerFn(cvode.get(), silent, nullptr), "error handler");
  check(CVodeInit(cvode.get(), &Ode::call, nodes.at(0), y.get()), "start");
  check(CVodeSStolerances(cvode.get(), relative, absolute), "tolerances");
  check(CVodeSetUserData(cvode.get(), &ode), "data");
  check(CVodeSetNonlinearSolver(cvode.get(), iteration.get()), "iteration");
  check(CVodeSetMaxNumSteps(cvode.get(), 1000000), "step limit");
  // Values between steps are interpolated, which in long steps at high order errs by more than the tolerance.
  check(CVodeSetMaxStep(cvode.get(), std::fabs(nodes.back() - nodes.front()) / 500), "step size");
  std::vector<std::vector<double>> out{start};
  out.reserve(nodes.size());
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    double x = 0;
    int const flag = CVode(cvode.get(), nodes[i], y.get(), &x, CV_NORMAL);
    if (ode.thrown) std::rethrow_exception(ode.thrown);
    check(flag, "step");
    double const* value = N_VGetArrayPointer(y.get());
    out.emplace_back(value, value + start.size());
  }
  return out;
}

}  // namespace g27
