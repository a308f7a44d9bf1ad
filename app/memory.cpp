// SPDX-License-Identifier: BSD-3-Clause
// What jemalloc asks at the start of the program: memory in pages of 2 MB where the system has them. Fields and factors are touched from end
// to end, and in pages of 4 kB the system's work on them takes up to a third of a run on a virtual machine.

extern "C" {
extern const char* malloc_conf;
const char* malloc_conf = "thp:always,metadata_thp:auto";
}
