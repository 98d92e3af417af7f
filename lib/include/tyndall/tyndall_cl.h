/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Tyndall inside a program that already uses OpenCL: the caller's context, queue and buffers. OpenCL 1.2.
 */
#ifndef TYNDALL_CL_H
#define TYNDALL_CL_H

#ifndef CL_TARGET_OPENCL_VERSION
#define CL_TARGET_OPENCL_VERSION 120
#endif
#include <CL/cl.h>

#include "tyndall.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Creates a context on the caller's cl_context and in-order cl_command_queue, both retained. Its device is the queue's.
 * `options`: NULL for defaults; `device` is ignored. An out-of-order queue is INVALID_ARGUMENT. Made with
 * CL_QUEUE_PROFILING_ENABLE, as the library makes its own, it lets TynRenderStats say where a render's time went. */
TYN_API TynStatus tyn_context_create_cl(const TynContextOptions *options, cl_context cl, cl_command_queue queue,
                                        TynContext **context);

/* The cl_context, queue and device that a context uses (not retained); each pointer may be NULL. */
TYN_API TynStatus tyn_context_cl(const TynContext *context, cl_context *cl, cl_command_queue *queue,
                                 cl_device_id *device);

/* tyn_intersect on buffers: `rays` holds `count` TynRay, `hits` receives `count` TynHit. Enqueued on the context's queue;
 * does not wait. The contents are not checked. */
TYN_API TynStatus tyn_intersect_cl(TynScene *scene, uint32_t mesh, cl_mem rays, size_t count, cl_mem hits);
/* tyn_occluded on buffers: `occluded` receives `count` uint32_t. */
TYN_API TynStatus tyn_occluded_cl(TynScene *scene, uint32_t mesh, cl_mem rays, size_t count, cl_mem occluded);

/* tyn_walk on buffers: `entries` holds `count` TynWalkEntry, `exits` receives `count` TynWalkExit. The contents are not
 * checked, except that an index out of range ends its walk as TYN_WALK_LOST. With `ledger` NULL the call only enqueues;
 * otherwise it waits and fills the ledger. Progress is not reported. */
TYN_API TynStatus tyn_walk_cl(TynScene *scene, const TynWalkOptions *options, cl_mem entries, size_t count,
                              cl_mem exits, TynLedger *ledger);

/* tyn_bssrdf_profile, _pdf and _sample on buffers of float. Enqueued on the context's queue; they do not wait. A radius that is
 * not finite and > 0 gives 0. `weights`: NULL for none. */
TYN_API TynStatus tyn_bssrdf_profile_cl(TynBssrdf *bssrdf, cl_mem radii, size_t count, cl_mem profile);
TYN_API TynStatus tyn_bssrdf_pdf_cl(TynBssrdf *bssrdf, cl_mem radii, size_t count, cl_mem pdf);
TYN_API TynStatus tyn_bssrdf_sample_cl(TynBssrdf *bssrdf, uint64_t seed, uint64_t first, size_t count, cl_mem radii,
                                       cl_mem pdf, cl_mem weights);
/* tyn_bssrdf_evaluate on buffers: `paths` holds `count` TynBssrdfPath, `values` receives channel_count x count floats.
 * Enqueued on the context's queue; does not wait. The contents are not checked: a path that is not finite, or whose normals
 * and directions are not unit vectors, gives some number. */
TYN_API TynStatus tyn_bssrdf_evaluate_cl(TynBssrdf *bssrdf, cl_mem paths, size_t count, cl_mem values);

/* tyn_bssrdf_sample_exits on buffers: `entries` holds `count` TynBssrdfEntry, at most 2^32 - 1 of them, `exits` receives
 * `count` TynBssrdfExit, `weights` channel_count x count floats or is NULL. Enqueued on the context's queue; does not wait.
 * The contents are not checked, except that an index out of range or a number that is not finite ends as
 * TYN_BSSRDF_EXIT_LOST. */
TYN_API TynStatus tyn_bssrdf_sample_exits_cl(TynBssrdf *bssrdf, TynScene *scene, uint64_t seed, uint64_t first,
                                             cl_mem entries, size_t count, cl_mem exits, cl_mem weights);

#ifdef __cplusplus
}
#endif

#endif
