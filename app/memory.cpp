// SPDX-License-Identifier: BSD-3-Clause
// Settings that jemalloc reads when the program starts: memory in pages of 2 MB where the system offers them. On a virtual machine the
// system's work on pages of 4 kB took up to a third of a run.

extern "C" {
extern const char* malloc_conf;
const char* malloc_conf = "thp:always,metadata_thp:auto";
}
