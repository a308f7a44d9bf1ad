// SPDX-License-Identifier: BSD-3-Clause
// Trials of HDF5 files: beside a thread that is inside the library, and of a file over which the library loops.

#include <atomic>
#include <chrono>
#include <fstream>
#include <thread>

#include <gtest/gtest.h>
#include <hdf5.h>

#include "input/tables/hdf5_datasets.hpp"
#include "post/fields/hdf5_file.hpp"
#include "support/written.hpp"

namespace tiretherm::input {

namespace {

std::filesystem::path hdf5_of_zeros(const Written& written, const std::string& name, std::size_t count) {
    const std::filesystem::path path = written.folder() / name;
    post::Hdf5File file(path);
    file.write("/T", std::vector<double>(count), 0,
               {.units = "degC", .long_name = "T", .source = "made up", .coordinates = ""});
    file.close();
    return path;
}

/// Groups in a chain, each under two names in the one before it, which do not know that they have two: 2^40 ways lead to
/// the last of them.
std::filesystem::path hdf5_of_many_ways(const Written& written) {
    const std::filesystem::path path = written.folder() / "ways.h5";
    std::vector<haddr_t> headers;
    const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    std::string name;
    for (int i = 0; i < 40; ++i) {
        name += "/x";
        H5Gclose(H5Gcreate2(file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
        H5Lcreate_hard(file, name.c_str(), file, (name.substr(0, name.size() - 1) + "y").c_str(), H5P_DEFAULT,
                       H5P_DEFAULT);
        H5O_info_t about{};
        H5Oget_info_by_name2(file, name.c_str(), &about, H5O_INFO_BASIC, H5P_DEFAULT);
        headers.push_back(about.addr);
    }
    H5Fclose(file);
    std::fstream bytes(path, std::ios::in | std::ios::out | std::ios::binary);
    for (const haddr_t header : headers) {
        // An object's header: version, a byte of nothing, two of the number of messages, four of the number of its names.
        bytes.seekp(static_cast<std::streamoff>(header) + 4);
        bytes.put(1);
    }
    return path;
}

double seconds_since(std::chrono::steady_clock::time_point begin) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

// A child that was made while the other thread is inside the library would wait for its lock until the trial's end, 40 s,
// and the sound file would be called damaged.
TEST(Hdf5Trial, ASoundFileIsSoundBesideAThreadThatReadsAnother) {
    const Written written;
    const std::filesystem::path large = hdf5_of_zeros(written, "large.h5", 2'000'000);
    ASSERT_EQ(hdf5_defect(large).what, "");
    std::atomic<bool> done = false;
    std::thread other([&] {
        while (!done) {
            InputErrors errors;
            EXPECT_EQ(read_hdf5_columns(large, errors).value().columns.size(), 1U);
            std::this_thread::sleep_for(std::chrono::milliseconds(1));  // a mutex may go to the same thread again
        }
    });
    for (int i = 0; i < 20; ++i) {
        const std::string what = hdf5_defect(hdf5_of_zeros(written, std::to_string(i) + ".h5", 10)).what;
        EXPECT_EQ(what, "");
        if (!what.empty()) {
            break;
        }
    }
    done = true;
    other.join();
}

// The trial has 10 s of CPU, and at most 40 s of time.
TEST(Hdf5TrialLong, AFileOverWhichTheLibraryLoopsIsRefused) {
    const Written written;
    const std::filesystem::path path = hdf5_of_many_ways(written);
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_EQ(hdf5_defect(path).what, "is HDF5, but damaged: the HDF5 library fails over it");
    EXPECT_LT(seconds_since(begin), 45.0);
    EXPECT_GT(seconds_since(begin), 5.0);  // it did not fail, it went on
}

}  // namespace tiretherm::input
