// SPDX-License-Identifier: BSD-3-Clause
// What an FMU has instead of shared libraries. The archives of Debian that hold CHOLMOD refer to more than a session needs; these
// definitions come before theirs, and keep METIS, the BLAS, OpenMP and messages on the terminal out of the shared object.
//
// - One thread: an FMU computes in the thread that calls it. Results do not hang on the number of threads.
// - CHOLMOD without METIS and without its supernodal module, which it is asked for on large meshes only: the fill-reducing order
//   is then AMD's, and the factor simplicial (CholeskyFactor falls back on it).

#include <cholmod.h>
#include <fmt/format-inl.h>

// What the shared library of fmt holds of its templates.
FMT_BEGIN_NAMESPACE
namespace detail {
template auto thousands_sep_impl<char>(locale_ref) -> thousands_sep_result<char>;
template auto decimal_point_impl<char>(locale_ref) -> char;
}  // namespace detail
FMT_END_NAMESPACE

namespace {

int not_installed(cholmod_common* common) {
    common->status = CHOLMOD_NOT_INSTALLED;
    return 0;
}

}  // namespace

extern "C" {

int omp_get_max_threads() { return 1; }
int omp_get_num_threads() { return 1; }
int omp_get_thread_num() { return 0; }
int omp_in_parallel() { return 0; }
void omp_set_num_threads(int /*n*/) {}
void GOMP_parallel(void (*work)(void*), void* data, unsigned /*threads*/, unsigned /*flags*/) { work(data); }
bool GOMP_single_start() { return true; }
void GOMP_barrier() {}
void GOMP_taskgroup_start() {}
void GOMP_taskgroup_end() {}
void GOMP_task(void (*work)(void*), void* data, void (* /*copy*/)(void*, void*), long /*size*/, long /*alignment*/,
               bool /*deferred*/, unsigned /*flags*/, void** /*depend*/, int /*priority*/, void* /*detach*/) {
    work(data);  // of one thread there is none
}
void GOMP_critical_name_start(void** /*name*/) {}
void GOMP_critical_name_end(void** /*name*/) {}

int cholmod_error(int status, const char* /*file*/, int /*line*/, const char* /*message*/, cholmod_common* common) {
    common->status = status;
    return 1;
}
int cholmod_metis(cholmod_sparse*, int*, size_t, int, int*, cholmod_common* common) { return not_installed(common); }
SuiteSparse_long cholmod_nested_dissection(cholmod_sparse*, int*, size_t, int*, int*, int*, cholmod_common* common) {
    return not_installed(common) - 1;
}
int cholmod_super_symbolic2(int, cholmod_sparse*, cholmod_sparse*, int*, cholmod_factor*, cholmod_common* common) {
    return not_installed(common);
}
int cholmod_super_numeric(cholmod_sparse*, cholmod_sparse*, double*, cholmod_factor*, cholmod_common* common) {
    return not_installed(common);
}
int cholmod_super_lsolve(cholmod_factor*, cholmod_dense*, cholmod_dense*, cholmod_common* common) {
    return not_installed(common);
}
int cholmod_super_ltsolve(cholmod_factor*, cholmod_dense*, cholmod_dense*, cholmod_common* common) {
    return not_installed(common);
}

}  // extern "C"
