// SPDX-License-Identifier: BSD-3-Clause
// Calls minizip, which writes to a stream in memory. The only file that includes it.

#include "post/fmu/zip_archive.hpp"

#include <cstdio>
#include <cstdlib>
#include <memory>
#include <new>

#include <minizip/zip.h>

namespace tiretherm::post {

namespace {

/// A stream that grows in memory. Closed, it has its bytes.
struct MemoryStream {
    char* bytes = nullptr;
    std::size_t size = 0;
    std::FILE* file = open_memstream(&bytes, &size);

    MemoryStream() = default;
    MemoryStream(const MemoryStream&) = delete;
    MemoryStream& operator=(const MemoryStream&) = delete;
    ~MemoryStream() { std::free(bytes); }
};

/// @returns whether all went well
bool write_to(zipFile archive, const std::vector<ArchivedFile>& files) {
    for (const auto& [path, content] : files) {
        zip_fileinfo information{};
        information.dosDate = 1UL << 21U | 1UL << 16U;  // 1980-01-01: a date of zero is none
        if (zipOpenNewFileInZip(archive, path.c_str(), &information, nullptr, 0, nullptr, 0, nullptr, Z_DEFLATED,
                                Z_DEFAULT_COMPRESSION) != ZIP_OK ||
            zipWriteInFileInZip(archive, content.data(), static_cast<unsigned>(content.size())) != ZIP_OK ||
            zipCloseFileInZip(archive) != ZIP_OK) {
            return false;
        }
    }
    return true;
}

}  // namespace

std::string zip(const std::vector<ArchivedFile>& files) {
    MemoryStream stream;
    if (stream.file == nullptr) {
        throw std::bad_alloc();
    }
    zlib_filefunc64_def functions;
    fill_fopen64_filefunc(&functions);
    functions.opaque = stream.file;
    functions.zopen64_file = [](void* opaque, const void* /*name*/, int /*mode*/) { return opaque; };
    zipFile archive = zipOpen2_64("", APPEND_STATUS_CREATE, nullptr, &functions);
    if (archive == nullptr) {
        std::fclose(stream.file);
        throw std::bad_alloc();
    }
    const bool written = write_to(archive, files);
    const bool closed = zipClose(archive, nullptr) == ZIP_OK;  // and with it the stream
    if (!written || !closed) {
        throw std::bad_alloc();
    }
    return {stream.bytes, stream.size};
}

}  // namespace tiretherm::post
