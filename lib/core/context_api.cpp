// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// The C calls on devices and contexts.
#include <algorithm>
#include <cstring>

#include "core/context.hpp"
#include "core/device.hpp"

namespace {

// What a caller compiled against an older or a newer header passed, over the defaults.
TynContextOptions complete(const TynContextOptions *options) {
  TynContextOptions result = tyn_context_options();
  if (!options)
    return result;
  if (options->size < sizeof options->size)
    tyn::fail(TYN_ERROR_INVALID_ARGUMENT, "TynContextOptions::size is %zu; start from tyn_context_options()",
              options->size);
  std::memcpy(&result, options, std::min(options->size, sizeof result));
  result.size = sizeof result;
  return result;
}

void hand_out(const TynContextOptions &options, const char *text) {
  if (!options.message || options.message_capacity == 0)
    return;
  const size_t length = std::min(std::strlen(text), options.message_capacity - 1);
  std::memcpy(options.message, text, length);
  options.message[length] = '\0';
}

// Where there is no context to keep a message, the caller's buffer gets it.
template <class Make>
TynStatus create(const TynContextOptions *given, TynContext **context, Make &&make) {
  if (!context)
    return TYN_ERROR_INVALID_ARGUMENT;
  *context = nullptr;
  TynContextOptions options = tyn_context_options();
  return tyn::guarded(nullptr, [&] {
    options = complete(given);
    try {
      *context = make(options);
    } catch (const std::bad_alloc &) {
      hand_out(options, "out of host memory");
      throw;
    } catch (const std::exception &error) {
      hand_out(options, error.what());
      throw;
    }
  });
}

} // namespace

TynStatus tyn_device_count(uint32_t *count) {
  if (!count)
    return TYN_ERROR_INVALID_ARGUMENT;
  return tyn::guarded(nullptr, [&] { *count = static_cast<uint32_t>(tyn::list_devices().size()); });
}

TynStatus tyn_device_info(uint32_t index, TynDeviceInfo *info) {
  if (!info)
    return TYN_ERROR_INVALID_ARGUMENT;
  return tyn::guarded(nullptr, [&] {
    const std::vector<tyn::Device> devices = tyn::list_devices();
    if (index >= devices.size())
      tyn::fail(TYN_ERROR_INVALID_ARGUMENT, "device %u of %zu", index, devices.size());
    *info = devices[index].info;
  });
}

TynStatus tyn_context_create(const TynContextOptions *options, TynContext **context) {
  return create(options, context, [](const TynContextOptions &complete) { return TynContext::create(complete); });
}

TynStatus tyn_context_create_cl(const TynContextOptions *options, cl_context cl, cl_command_queue queue,
                                TynContext **context) {
  return create(options, context,
                [&](const TynContextOptions &complete) { return TynContext::create(complete, cl, queue); });
}

void tyn_context_retain(TynContext *context) {
  if (context)
    context->retain();
}

void tyn_context_release(TynContext *context) {
  if (context)
    context->release();
}

const char *tyn_context_message(const TynContext *context) { return context ? context->message.c_str() : ""; }

TynStatus tyn_context_device(const TynContext *context, TynDeviceInfo *info) {
  if (!context || !info)
    return TYN_ERROR_INVALID_ARGUMENT;
  *info = context->device_info;
  return TYN_OK;
}

TynStatus tyn_context_fail(TynContext *context, TynStatus status, const char *message) {
  if (!context)
    return TYN_ERROR_INVALID_ARGUMENT;
  context->set_message(message ? message : "");
  return status;
}

TynStatus tyn_context_cl(const TynContext *context, cl_context *cl, cl_command_queue *queue, cl_device_id *device) {
  if (!context)
    return TYN_ERROR_INVALID_ARGUMENT;
  if (cl)
    *cl = context->cl;
  if (queue)
    *queue = context->queue;
  if (device)
    *device = context->device;
  return TYN_OK;
}
