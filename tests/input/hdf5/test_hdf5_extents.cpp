// SPDX-License-Identifier: BSD-3-Clause
// HDF5 files whose shapes announce values that are not there: refused before memory is taken for them.

#include <cstdlib>
#include <fstream>
#include <functional>
#include <sstream>

#include <gtest/gtest.h>
#include <hdf5.h>
#include <sys/resource.h>
#include <unistd.h>

#include "input/cameras/camera_bench.hpp"
#include "support/written.hpp"

namespace tiretherm::input {

namespace {

using Shape = std::vector<hsize_t>;

/// How a dataset is stored.
struct Storage {
    Shape block{};          // empty: in one piece
    bool filled = false;    // with a fill value of its own
    std::string outside{};  // name of the file that holds the values
    double value = 1.0;
    bool is_written = true;
};

/// A file of datasets, by the library itself.
class Hdf5 {
public:
    explicit Hdf5(const std::filesystem::path& path)
        : file_(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT)) {}
    ~Hdf5() { H5Fclose(file_); }
    Hdf5(const Hdf5&) = delete;
    Hdf5& operator=(const Hdf5&) = delete;

    void add(const std::string& name, const Shape& shape, const std::string& unit, const Storage& how = {}) const {
        const hid_t space = H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr);
        const hid_t list = H5Pcreate(H5P_DATASET_CREATE);
        if (!how.block.empty()) {
            H5Pset_chunk(list, static_cast<int>(how.block.size()), how.block.data());
        }
        if (how.filled) {
            H5Pset_fill_value(list, H5T_NATIVE_DOUBLE, &how.value);
        }
        if (!how.outside.empty()) {
            H5Pset_external(list, how.outside.c_str(), 0, H5F_UNLIMITED);
        }
        const hid_t set = H5Dcreate2(file_, name.c_str(), H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, list, H5P_DEFAULT);
        EXPECT_GE(set, 0) << name;
        if (how.is_written) {
            hsize_t size = 1;
            for (const hsize_t extent : shape) {
                size *= extent;
            }
            std::vector<double> values(size);
            for (std::size_t i = 0; i < values.size(); ++i) {
                values[i] = how.value + static_cast<double>(i);
            }
            H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
        }
        const hid_t type = H5Tcopy(H5T_C_S1);
        H5Tset_size(type, unit.size());
        const hid_t one = H5Screate(H5S_SCALAR);
        const hid_t attribute = H5Acreate2(set, "units", type, one, H5P_DEFAULT, H5P_DEFAULT);
        H5Awrite(attribute, type, unit.data());
        H5Aclose(attribute);
        H5Sclose(one);
        H5Tclose(type);
        H5Dclose(set);
        H5Pclose(list);
        H5Sclose(space);
    }

private:
    hid_t file_;
};

std::string bytes_of(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

/// Address space of this process, in bytes.
rlim_t memory_in_use() {
    rlim_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<rlim_t>(::sysconf(_SC_PAGESIZE));
}

using Write = std::function<void(const Hdf5&)>;

std::string said(const ExperimentReading& reading, const Written& written) {
    return replaced(error_report(reading), written.folder().generic_string() + "/", "");
}

/// What a user reads of a run with this file of columns.
std::string said_of_run(const Write& write) {
    const Written written;
    { write(Hdf5(written.folder() / "run.h5")); }
    return said(read_experiment(written.add("case.toml", std::string(bench) + "[[run]]\nfile = \"run.h5\"\n")),
                written);
}

/// What a user reads of a run with this file of frames.
std::string said_of_frames(const Write& write) {
    const Written written;
    { write(Hdf5(written.folder() / "frames.h5")); }
    return said(read_experiment(written.add("case.toml", std::string(camera_bench) + std::string(one_camera) +
                                                             "[[run]]\nname = \"heating\"\nframes = \"frames.h5\"\n")),
                written);
}

constexpr hsize_t hundred_billion = 100'000'000'000;

}  // namespace

// 1e11 numbers are 800 GB; the file has some kilobytes. In blocks of 1024 none of which was ever written.
TEST(Hdf5Extents, AColumnThatNoMemoryHoldsIsRefused) {
    EXPECT_EQ(
        said_of_run(
            [](const Hdf5& file) { file.add("time", {hundred_billion}, "s", {.block = {1024}, .is_written = false}); }),
        "run.h5: the dataset time has a shape of 100000000000 values in blocks of 1024, and at most 134217728 are "
        "read at once: it is too large, or the file is damaged\n"
        "    remedy: export a part of it, or copy the file again\n");
}

// Zeros that nobody measured would stand for what was never written: the library gives them without a word.
TEST(Hdf5Extents, ValuesThatWereNeverWrittenAreNotInvented) {
    const std::string none = said_of_run([](const Hdf5& file) {
        file.add("time", {5}, "s");
        file.add("speed", {5}, "km/h", {.block = {4}, .is_written = false});
    });
    EXPECT_EQ(none,
              "run.h5: the dataset speed has a shape of 5 values, and none was ever written\n"
              "    remedy: copy the file or export it again\n");
}

// A block of 4 written, then the shape set to 4000 values: one block of a thousand is there.
TEST(Hdf5Extents, AShapeThatIsLargerThanWhatIsStoredIsDamage) {
    const Written written;
    const std::filesystem::path path = written.folder() / "run.h5";
    {
        const hid_t file = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
        const hsize_t size = 4;
        const hsize_t most = H5S_UNLIMITED;
        const hsize_t larger = 4000;
        const hid_t space = H5Screate_simple(1, &size, &most);
        const hid_t list = H5Pcreate(H5P_DATASET_CREATE);
        H5Pset_chunk(list, 1, &size);
        const hid_t set = H5Dcreate2(file, "time", H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, list, H5P_DEFAULT);
        const std::vector<double> values{0.0, 1.0, 2.0, 3.0};
        H5Dwrite(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
        H5Dset_extent(set, &larger);
        H5Dclose(set);
        H5Pclose(list);
        H5Sclose(space);
        H5Fclose(file);
    }
    EXPECT_EQ(
        said(read_experiment(written.add("case.toml", std::string(bench) + "[[run]]\nfile = \"run.h5\"\n")), written),
        "run.h5: the dataset time has a shape of 4000 values, and the file does not hold them all: it is damaged, "
        "cut off or not yet written to its end\n"
        "    remedy: copy the file or export it again\n");
}

// The bytes of the shape in the file's header, 5 as eight bytes, become 2^62 + 5 and 2^27; the size of what is stored is
// the shape's in the first format, so the file's own size tells.
TEST(Hdf5Extents, AnOverwrittenShapeIsDamage) {
    for (const std::uint64_t shape : {(std::uint64_t{1} << 62U) + 5, std::uint64_t{1} << 27U}) {
        const Written written;
        const std::filesystem::path path = written.folder() / "run.h5";
        { Hdf5(path).add("time", {5}, "s"); }
        std::string bytes = bytes_of(path);
        const std::string five("\5\0\0\0\0\0\0\0", 8);
        const std::string other(reinterpret_cast<const char*>(&shape), 8);
        bytes = replaced(bytes, five + five, other + other);  // the shape and the largest shape
        std::ofstream(path, std::ios::binary) << bytes;
        const std::string found = said(
            read_experiment(written.add("case.toml", std::string(bench) + "[[run]]\nfile = \"run.h5\"\n")), written);
        EXPECT_TRUE(found.starts_with("run.h5: the dataset time has a shape of " + std::to_string(shape))) << found;
        EXPECT_NE(found.find("damaged"), std::string::npos) << found;
    }
}

#ifdef TIRETHERM_SANITIZED
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif

// The type says that a value has 8 bytes: 17 (version and class: a real), three bytes of bits, the size in four. With other
// sizes the library itself would read beyond the block in memory.
TEST(Hdf5Extents, ASizeOfAValueThatTheBlocksDoNotHaveIsDamage) {
    for (const char size : {'\4', '\x10', '\x7F'}) {
        const Written written;
        const std::filesystem::path path = written.folder() / "run.h5";
        { Hdf5(path).add("time", {5}, "s", {.block = {4}}); }
        std::string bytes = bytes_of(path);
        const std::string real("\x11\x20\x3F\0\10\0\0\0", 8);
        ASSERT_NE(bytes.find(real), std::string::npos);
        bytes[bytes.find(real) + 4] = size;
        std::ofstream(path, std::ios::binary) << bytes;
        const std::string found = said(
            read_experiment(written.add("case.toml", std::string(bench) + "[[run]]\nfile = \"run.h5\"\n")), written);
        // The address sanitizer ends the process in which the library is tried, where it reads beside its block.
        const bool fails = found.find("damaged: the HDF5 library fails over it") != std::string::npos;
        EXPECT_TRUE((sanitized && fails) ||
                    found.find("the dataset time has a shape of 5 values, and the file does not hold them all") !=
                        std::string::npos)
            << found;
    }
}

TEST(Hdf5Extents, ValuesInOtherFilesAreCalledThat) {
    EXPECT_EQ(said_of_run([](const Hdf5& file) {
                  file.add("time", {5}, "s", {.outside = "elsewhere.bin", .is_written = false});
              }),
              "run.h5: the dataset time keeps its values in other files (external storage)\n"
              "    remedy: export it with its values inside the file\n");
}

// 16 datasets of 1e7 values that one fill value stands for: 1.3 GB from a file of kilobytes.
TEST(Hdf5Extents, AllDatasetsTogetherHaveALimit) {
    const std::string found = said_of_run([](const Hdf5& file) {
        for (int i = 0; i < 16; ++i) {
            file.add("x" + std::to_string(i), {10'000'000}, "s",
                     {.block = {1'000'000}, .filled = true, .is_written = false});
        }
    });
    EXPECT_NE(found.find("values, and at most 134217728 are read\n    remedy: export fewer of them"), std::string::npos)
        << found.substr(0, 300);
}

// Images of 1e11 values, of 2^40 rows, none written, in another file; and moments of which there are 1e11.
TEST(Hdf5Extents, FramesThatNoMemoryHoldsAreRefused) {
    const auto moments = [](const Hdf5& file) { file.add("time", {2}, "s"); };
    const std::string large = said_of_frames([&](const Hdf5& file) {
        moments(file);
        file.add("frames", {2, 1'000'000, 100'000}, "degC", {.block = {1, 100, 100}, .is_written = false});
    });
    EXPECT_TRUE(large.starts_with("frames.h5: the dataset frames has a shape of 2 x 1000000 x 100000 values in blocks"))
        << large;
    const std::string wide = said_of_frames([&](const Hdf5& file) {
        moments(file);
        file.add("frames", {2, 1, 200'000}, "degC");
    });
    EXPECT_TRUE(wide.starts_with("frames.h5: an image has 1 x 200000 pixels, and at most")) << wide;
    const std::string none = said_of_frames([&](const Hdf5& file) {
        moments(file);
        file.add("frames", {2, 3, 4}, "degC", {.block = {1, 3, 4}, .is_written = false});
    });
    EXPECT_TRUE(none.starts_with("frames.h5: the dataset frames has a shape of 2 x 3 x 4 values, and none was ever"))
        << none;
    const std::string outside = said_of_frames([&](const Hdf5& file) {
        moments(file);
        file.add("frames", {2, 3, 4}, "degC", {.outside = "frames.bin", .is_written = false});
    });
    EXPECT_TRUE(outside.starts_with("frames.h5: the dataset frames keeps its values in other files")) << outside;
    const std::string clocks = said_of_frames([&](const Hdf5& file) {
        file.add("time", {hundred_billion}, "s", {.block = {1024}, .is_written = false});
        file.add("frames", {2, 3, 4}, "degC", {.value = 20.0});
    });
    EXPECT_TRUE(clocks.starts_with("frames.h5: the dataset time has a shape of 100000000000 values")) << clocks;
}

// Sound ones in one piece, in blocks whose last is not full, and sparse with a fill value.
TEST(Hdf5Extents, SoundFramesOfEveryLayoutAreRead) {
    for (const Storage& how : {Storage{.value = 20.0}, Storage{.block = {2, 2, 3}, .value = 20.0},
                               Storage{.block = {1, 3, 4}, .filled = true, .value = 20.0, .is_written = false}}) {
        EXPECT_EQ(said_of_frames([&](const Hdf5& file) {
                      file.add("time", {3}, "s");
                      file.add("frames", {3, 3, 4}, "degC", how);
                  }),
                  "");
    }
}

// An image of 99 999 x 99 999 pixels is 80 GB; its table has one of them.
TEST(CsvFrames, APixelFarOutIsNoReasonToTakeMemory) {
    const Written written;
    written.add("frames.csv", "time [s],r0c0 [degC],r99998c99998 [degC]\n0,20,20\n");
    const std::string found =
        said(read_experiment(
                 written.add("case.toml", std::string(camera_bench) + std::string(one_camera) + std::string(one_run))),
             written);
    EXPECT_EQ(found,
              "frames.csv: 99999 x 99999 pixels need 9999800001 columns, and there are 2: r0c1 is missing\n"
              "    remedy: give every pixel of the image one column\n");
}

// With 300 MB more than the process has, a log of 400 MB cannot be read; that is said of it, and nothing else happens.
TEST(Memory, ThatDoesNotSufficeForAFileIsAMistakeOfTheCaseWithItsPlace) {
    if (sanitized) {
        GTEST_SKIP() << "the sanitizer's own tables do not fit into the limit, and it ends the process itself";
    }
    const Written written;
    const std::filesystem::path log = written.add("run.csv", "time [s],speed [km/h]\n");
    std::filesystem::resize_file(log, std::uintmax_t{400} << 20U);
    const std::filesystem::path file = written.add("case.toml", std::string(bench) + "[[run]]\nfile = \"run.csv\"\n");
    EXPECT_EXIT(
        {
            rlimit limit{};
            limit.rlim_cur = limit.rlim_max = memory_in_use() + (rlim_t{300} << 20U);
            setrlimit(RLIMIT_AS, &limit);
            std::fputs(error_report(read_experiment(file)).c_str(), stderr);
            std::_Exit(7);
        },
        testing::ExitedWithCode(7), "case.toml:[0-9]+:8: there is not enough memory for the file .*run.csv");
}

}  // namespace tiretherm::input
