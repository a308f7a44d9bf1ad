// SPDX-License-Identifier: BSD-3-Clause
// Reference integrator for small stiff systems: CVODE of SUNDIALS (Hindmarsh et al., ACM Trans. Math. Software 31
// (2005) 363).
#pragma once

#include <functional>
#include <span>
#include <stdexcept>
#include <vector>

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

namespace tiretherm::support {

/// dy/dt = f(t, y), smooth over the interval of integration.
using RightHandSide = std::function<void(double t, std::span<const double> y, std::span<double> rate)>;

/// Integrates a small stiff system with CVODE of SUNDIALS (BDF, Newton, dense difference Jacobian): an integrator that
/// nobody of this project wrote.   Hindmarsh et al., ACM Trans. Math. Software 31 (2005) 363-396
/// @param y in: state at t0; out: state at t1
inline void integrate_by_cvode(const RightHandSide& f, double t0, double t1, std::span<double> y,
                               double relative = 1e-11, double absolute = 1e-9) {
    const auto check = [](bool holds) {
        if (!holds) {
            throw std::runtime_error("CVODE failed");
        }
    };
    const auto n = static_cast<sunindextype>(y.size());
    SUNContext context = nullptr;
    check(SUNContext_Create(nullptr, &context) == 0);
    N_Vector state = N_VMake_Serial(n, y.data(), context);
    SUNMatrix jacobian = SUNDenseMatrix(n, n, context);
    SUNLinearSolver linear = SUNLinSol_Dense(state, jacobian, context);
    void* memory = CVodeCreate(CV_BDF, context);
    check(state != nullptr && jacobian != nullptr && linear != nullptr && memory != nullptr);

    const CVRhsFn call = [](realtype t, N_Vector at, N_Vector rate, void* user) {
        const auto size = static_cast<std::size_t>(N_VGetLength_Serial(at));
        (*static_cast<const RightHandSide*>(user))(t, {N_VGetArrayPointer(at), size}, {N_VGetArrayPointer(rate), size});
        return 0;
    };
    check(CVodeInit(memory, call, t0, state) == CV_SUCCESS);
    check(CVodeSetUserData(memory, const_cast<RightHandSide*>(&f)) == CV_SUCCESS);
    check(CVodeSStolerances(memory, relative, absolute) == CV_SUCCESS);
    check(CVodeSetLinearSolver(memory, linear, jacobian) == CV_SUCCESS);
    check(CVodeSetMaxNumSteps(memory, 1000000) == CV_SUCCESS);
    check(CVodeSetStopTime(memory, t1) == CV_SUCCESS);
    double reached = t0;
    check(CVode(memory, t1, state, &reached, CV_NORMAL) >= 0);

    CVodeFree(&memory);
    SUNLinSolFree(linear);
    SUNMatDestroy(jacobian);
    N_VDestroy(state);
    SUNContext_Free(&context);
}

}  // namespace tiretherm::support
