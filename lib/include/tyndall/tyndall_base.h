/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Tyndall: versions, statuses, devices and contexts. Included by every other header; tyndall.h says what holds for all.
 */
#ifndef TYNDALL_BASE_H
#define TYNDALL_BASE_H

#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#if defined(_WIN32) && defined(TYN_BUILDING)
#define TYN_API __declspec(dllexport)
#elif defined(__GNUC__)
#define TYN_API __attribute__((visibility("default")))
#else
#define TYN_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Version and status ------------------------------------------------------------------------------------------- */

#define TYN_VERSION_MAJOR 0
#define TYN_VERSION_MINOR 1
#define TYN_VERSION_PATCH 0
#define TYN_VERSION (10000 * TYN_VERSION_MAJOR + 100 * TYN_VERSION_MINOR + TYN_VERSION_PATCH)

/* The result of a call: one of TYN_OK and TYN_ERROR_*. */
typedef int32_t TynStatus;
enum {
  TYN_OK = 0,
  TYN_ERROR_INVALID_ARGUMENT = 1,  /* a parameter is outside its documented range */
  TYN_ERROR_INVALID_OPERATION = 2, /* the object is in the wrong state, e.g. a scene that is not committed */
  TYN_ERROR_OUT_OF_MEMORY = 3,     /* host or device memory, or the context's memory_limit */
  TYN_ERROR_NO_DEVICE = 4,         /* no OpenCL device, or none that matches */
  TYN_ERROR_KERNEL_BUILD = 5,      /* a kernel did not compile; the message holds the build log */
  TYN_ERROR_DEVICE = 6,            /* an OpenCL call failed; the message names it and its code */
  TYN_ERROR_CANCELLED = 7,         /* the progress callback asked for it; what was done so far is valid */
  TYN_ERROR_FILE = 8,              /* a file could not be opened, read or written */
  TYN_ERROR_FORMAT = 9,            /* a file's contents are wrong */
  TYN_ERROR_INTERNAL = 10          /* a defect of this library */
};

/* Returns TYN_VERSION of the library that is loaded. Never fails. */
TYN_API uint32_t tyn_version(void);

/* Returns the name of a status, such as "invalid argument"; "unknown status" for any other number. Static storage. */
TYN_API const char *tyn_status_string(TynStatus status);

/* Called during long calls with the fraction done in [0, 1]. Returns 0 to go on, anything else to cancel. */
typedef int32_t (*TynProgress)(void *user, double fraction);

/* ---- Devices and contexts ------------------------------------------------------------------------------------------ */

typedef struct TynContext TynContext;

/* One OpenCL device. */
typedef struct TynDeviceInfo {
  char name[128];
  char platform[128];
  char driver[64];
  uint32_t is_gpu; /* 1 or 0 */
  uint32_t compute_units;
  uint64_t memory;     /* bytes of global memory */
  uint32_t lane_width; /* lanes that the kernels use on it by default: 16, 8 or 4 on a CPU, 1 on a GPU */
} TynDeviceInfo;

/* Stores the number of OpenCL devices, which may be 0. `count`: not NULL. */
TYN_API TynStatus tyn_device_count(uint32_t *count);

/* Describes device `index` (0 .. count-1). GPUs come first, then CPUs, each in the order of their platforms. */
TYN_API TynStatus tyn_device_info(uint32_t index, TynDeviceInfo *info);

typedef struct TynContextOptions {
  size_t size;        /* sizeof(TynContextOptions) */
  const char *device; /* device index or part of its name (case ignored); NULL: TYNDALL_DEVICE, else device 0 */
  const char *cache_directory; /* folder for compiled kernels and tables; NULL: see Environment; "": no cache */
  uint64_t memory_limit;   /* bytes of device memory that may be in use; 0: the device's own. Batches shrink to fit. */
  uint32_t lane_width;     /* 1, 4, 8 or 16 lanes; 0: by device. Results do not depend on it. */
  char *message;           /* where a failing tyn_context_create says why; may be NULL */
  size_t message_capacity; /* bytes of `message`, the terminating 0 included */
} TynContextOptions;

static inline TynContextOptions tyn_context_options(void) {
  TynContextOptions options;
  memset(&options, 0, sizeof options);
  options.size = sizeof options;
  return options;
}

/* Creates a context on a device. `options`: NULL for defaults. `context`: set to NULL on failure.
 * Errors: NO_DEVICE, INVALID_ARGUMENT, OUT_OF_MEMORY, DEVICE. Kernels are compiled when first needed. */
TYN_API TynStatus tyn_context_create(const TynContextOptions *options, TynContext **context);
TYN_API void tyn_context_retain(TynContext *context);
TYN_API void tyn_context_release(TynContext *context);

/* Returns the message of the last call on this context, or on an object made from it, that failed; "" if none did.
 * The text stays valid until the next call on the context. Kernel build failures include the build log. */
TYN_API const char *tyn_context_message(const TynContext *context);

/* Describes the context's device; lane_width is the one in use. */
TYN_API TynStatus tyn_context_device(const TynContext *context, TynDeviceInfo *info);

/* Records `message` as the context's last message and returns `status`: for libraries built on this one. */
TYN_API TynStatus tyn_context_fail(TynContext *context, TynStatus status, const char *message);

#ifdef __cplusplus
}
#endif

#endif
