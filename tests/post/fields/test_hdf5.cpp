// SPDX-License-Identifier: BSD-3-Clause
// results.h5 is read back with the C library: values, units and labels; a killed writer leaves a readable file.

#include <sys/wait.h>

#include <csignal>

#include <gtest/gtest.h>
#include <hdf5.h>

#include "post/fields/hdf5_writer.hpp"
#include "post/report/file.hpp"
#include "tests/post/sample.hpp"

namespace tiretherm::post {
namespace {

const Provenance provenance{.version = "9.9", .case_file = "spot.toml", .case_text = "title = \"A warm spot\"\n"};

/// A results file, read with the C library itself.
class Results {
public:
    explicit Results(const std::filesystem::path& path) : file_(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT)) {}
    ~Results() {
        if (file_ >= 0) {
            H5Fclose(file_);
        }
    }
    Results(const Results&) = delete;
    Results& operator=(const Results&) = delete;

    [[nodiscard]] bool opened() const { return file_ >= 0; }
    [[nodiscard]] hid_t file() const { return file_; }

    struct Table {
        std::vector<hsize_t> size;
        std::vector<double> values;
    };
    [[nodiscard]] Table table(const std::string& path) const {
        const hid_t dataset = H5Dopen2(file_, path.c_str(), H5P_DEFAULT);
        EXPECT_GE(dataset, 0) << "no dataset " << path;
        const hid_t space = H5Dget_space(dataset);
        Table table;
        table.size.resize(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
        H5Sget_simple_extent_dims(space, table.size.data(), nullptr);
        table.values.resize(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
        EXPECT_GE(H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, table.values.data()), 0) << path;
        H5Sclose(space);
        H5Dclose(dataset);
        return table;
    }
    /// A text attribute, or "(absent)".
    [[nodiscard]] std::string attribute(const std::string& path, const std::string& name) const {
        const hid_t object = H5Oopen(file_, path.c_str(), H5P_DEFAULT);
        std::string value = "(absent)";
        if (H5Aexists(object, name.c_str()) > 0) {
            const hid_t attribute = H5Aopen(object, name.c_str(), H5P_DEFAULT);
            const hid_t type = H5Aget_type(attribute);
            char* text = nullptr;
            H5Aread(attribute, type, &text);
            value = text;
            H5free_memory(text);
            H5Tclose(type);
            H5Aclose(attribute);
        }
        H5Oclose(object);
        return value;
    }
    /// A dataset of texts.
    [[nodiscard]] std::vector<std::string> words(const std::string& path) const {
        const hid_t dataset = H5Dopen2(file_, path.c_str(), H5P_DEFAULT);
        const hid_t space = H5Dget_space(dataset);
        const hid_t type = H5Dget_type(dataset);
        std::vector<char*> texts(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
        EXPECT_GE(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, texts.data()), 0) << path;
        const std::vector<std::string> read(texts.begin(), texts.end());
        H5Dvlen_reclaim(type, space, H5P_DEFAULT, texts.data());
        H5Tclose(type);
        H5Sclose(space);
        H5Dclose(dataset);
        return read;
    }
    [[nodiscard]] std::vector<std::string> datasets() const {
        std::vector<std::string> names;
        H5Ovisit2(
            file_, H5_INDEX_NAME, H5_ITER_INC,
            [](hid_t, const char* name, const H5O_info_t* info, void* to) {
                if (info->type == H5O_TYPE_DATASET) {
                    static_cast<std::vector<std::string>*>(to)->push_back(std::string("/") + name);
                }
                return 0;
            },
            &names, H5O_INFO_BASIC);
        return names;
    }

private:
    hid_t file_;
};

TEST(Hdf5, FieldIsReadBackWithItsTimes) {
    const sample::Scratch scratch;
    const solver::Problem problem = sample::problem();
    {
        Hdf5Writer writer(scratch / "results.h5", problem, provenance);
        writer.take(sample::Moment(problem, 0.0, {296.15, 296.15}, true).snapshot);
        writer.take(sample::Moment(problem, 30.0, {353.15, 303.15}, false).snapshot);
        writer.take(sample::Moment(problem, 60.0, {370.65, 313.15}, true).snapshot);
        writer.finish();
    }
    const Results results(scratch / "results.h5");
    const auto n = static_cast<std::size_t>(problem.mesh.n_nodes);
    EXPECT_EQ(results.table("/field/time").values, (std::vector<double>{0.0, 60.0}));
    const Results::Table field = results.table("/field/temperature");
    ASSERT_EQ(field.size, (std::vector<hsize_t>{2, n}));
    for (std::size_t node = 0; node < n; ++node) {
        const double depth = problem.mesh.centre[node][2];
        EXPECT_EQ(field.values[node], sample::warmth(depth, 0.0));
        EXPECT_EQ(field.values[n + node], sample::warmth(depth, 60.0));
    }
}

TEST(Hdf5, ChannelsHaveARowAtEveryOutputTime) {
    const sample::Scratch scratch;
    const solver::Problem problem = sample::problem();
    {
        Hdf5Writer writer(scratch / "results.h5", problem, provenance);
        writer.take(sample::Moment(problem, 0.0, {296.15, 296.15}, true).snapshot);
        writer.take(sample::Moment(problem, 30.0, {353.15, 303.15}, false).snapshot);
        writer.finish();
    }
    const Results results(scratch / "results.h5");
    EXPECT_EQ(results.table("/channels/time").values, (std::vector<double>{0.0, 30.0}));
    EXPECT_EQ(results.table("/channels/spot").values, (std::vector<double>{296.15, 353.15}));
    EXPECT_EQ(results.table("/channels/liner").values, (std::vector<double>{296.15, 303.15}));
    EXPECT_EQ(results.attribute("/channels/spot", "units"), "K");
    EXPECT_EQ(results.attribute("/channels/spot", "long_name"), "outer surface, mean over the spot");
    EXPECT_EQ(results.attribute("/channels/spot", "coordinates"), "/channels/time");
}

TEST(Hdf5, HeatBudgetCallsEffectsOfTheUsersOwnByTheirNames) {
    const sample::Scratch scratch;
    solver::Problem problem = sample::problem();
    problem.effects[1] = physics::activate(*physics::find_effect("own_source"), problem.mesh);
    problem.effects[1].name = "throttle_heat";
    {
        Hdf5Writer writer(scratch / "results.h5", problem, provenance);
        writer.take(sample::Moment(problem, 10.0, {300.0, 300.0}, true).snapshot);
    }
    for (const char* name : {"/heat_budget/effect", "/ledger/effect"}) {  // the name of now, and that before 0.3
        EXPECT_EQ(Results(scratch / "results.h5").words(name),
                  (std::vector<std::string>{"conduction", "throttle_heat", "still_air"}));
    }
}

TEST(Hdf5, HeatBudgetIsOfTheWholeSpecimen) {
    // A quarter of the specimen is computed: 1 W of laser into the mesh is 4 W into the specimen.
    const sample::Scratch scratch;
    solver::Problem problem = sample::problem();
    problem.symmetry = 4.0;
    {
        Hdf5Writer writer(scratch / "results.h5", problem, provenance);
        writer.take(sample::Moment(problem, 10.0, {300.0, 300.0}, true).snapshot);
    }
    const Results results(scratch / "results.h5");
    EXPECT_EQ(results.table("/heat_budget/watts").size, (std::vector<hsize_t>{1, 3}));
    EXPECT_EQ(results.table("/heat_budget/watts").values, (std::vector<double>{0.0, 4.0, -1.0}));
    EXPECT_EQ(results.table("/heat_budget/joules").values, (std::vector<double>{0.0, 40.0, -4.0}));
    EXPECT_EQ(results.table("/heat_budget/stored").values, (std::vector<double>{36.0}));
}

TEST(Hdf5, EveryDatasetSaysItsUnitsMeaningAndSource) {
    const sample::Scratch scratch;
    const solver::Problem problem = sample::problem();
    { const Hdf5Writer writer(scratch / "results.h5", problem, provenance); }
    const Results results(scratch / "results.h5");
    const std::vector<std::string> datasets = results.datasets();
    EXPECT_EQ(datasets.size(), 21u);
    for (const std::string& path : datasets) {
        EXPECT_NE(results.attribute(path, "units"), "(absent)") << path;
        EXPECT_GT(results.attribute(path, "long_name").size(), 3u) << path;
        EXPECT_EQ(results.attribute(path, "source"), "case sample/spot, tiretherm 9.9") << path;
    }
}

TEST(Hdf5, MeshIsReadBackInMetres) {
    const sample::Scratch scratch;
    const solver::Problem problem = sample::problem();
    { const Hdf5Writer writer(scratch / "results.h5", problem, provenance); }
    const Results results(scratch / "results.h5");
    EXPECT_EQ(results.table("/mesh/volume").values, problem.mesh.volume);
    const Results::Table corners = results.table("/mesh/corners");
    EXPECT_EQ(corners.size, (std::vector<hsize_t>{24, 4}));
    EXPECT_EQ(corners.values[5], problem.mesh.drawing.corners[5]);
    EXPECT_EQ(results.attribute("/mesh", "metric"), "axisymmetric");
    EXPECT_EQ(results.attribute("/mesh/centre", "units"), "m");
}

TEST(Hdf5, KilledWriterLeavesEveryStoredField) {
    // The child dies by SIGKILL with the file open: no destructor runs, nothing is closed.
    const sample::Scratch scratch;
    const solver::Problem problem = sample::problem();
    const pid_t child = fork();
    if (child == 0) {
        Hdf5Writer writer(scratch / "results.h5", problem, provenance);
        for (int i = 0; i < 5; ++i) {
            writer.take(sample::Moment(problem, 10.0 * i, {300.0 + i, 300.0}, true).snapshot);
        }
        raise(SIGKILL);
    }
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status));
    const Results results(scratch / "results.h5");
    ASSERT_TRUE(results.opened());
    EXPECT_EQ(results.table("/field/time").values, (std::vector<double>{0.0, 10.0, 20.0, 30.0, 40.0}));
    EXPECT_EQ(results.table("/field/temperature").values.back(), sample::warmth(problem.mesh.centre.back()[2], 40.0));
    EXPECT_EQ(results.table("/channels/spot").values, (std::vector<double>{300.0, 301.0, 302.0, 303.0, 304.0}));
}

TEST(Hdf5, LargeFieldsAreCompressed) {
    const sample::Scratch scratch;
    const solver::Problem problem = sample::problem(mesh::build(mesh::Axisymmetric{
        .radius = {{.to = 0.02, .cells = 100}}, .stack = {{.name = "tread", .thickness = 0.008, .cells = 50}}}));
    {
        Hdf5Writer writer(scratch / "results.h5", problem, provenance);
        writer.take(sample::Moment(problem, 0.0, {300.0, 300.0}, true).snapshot);
    }
    const Results results(scratch / "results.h5");
    const hid_t dataset = H5Dopen2(results.file(), "/field/temperature", H5P_DEFAULT);
    const hsize_t raw = static_cast<hsize_t>(problem.mesh.n_nodes) * sizeof(double);
    EXPECT_LT(H5Dget_storage_size(dataset), raw / 4);
    H5Dclose(dataset);
}

TEST(Hdf5, FailureNamesTheFileAndTheReasonOfTheSystem) {
    const sample::Scratch scratch;
    const solver::Problem problem = sample::problem();
    replace_file(scratch / "file", "not a directory");
    try {
        const Hdf5Writer writer(scratch / "file/results.h5", problem, provenance);
        FAIL() << "a file below a file was created";
    } catch (const FileError& error) {
        EXPECT_EQ(error.what(),
                  fmt::format("cannot create {}: Not a directory", (scratch / "file/results.h5").string()));
    }
}

}  // namespace
}  // namespace tiretherm::post
