// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
// Light that is never scattered: reflected between the interfaces any number of times, attenuated in the layers.
#include <cmath>

#include "slab/adding_doubling.hpp"
#include "slab/interface.hpp"
#include "slab/nodes.hpp"

namespace tyn {
namespace {

// An interface over what lies below: the geometric series of reflections between the two.
Unscattered put_on(const Interface &top, const Unscattered &below) {
  const double rounds = 1 - top.up * below.reflectance;
  const double into = rounds > 0 ? top.through / rounds : 0;
  return {top.down + top.through * into * below.reflectance, into * below.transmittance};
}

Unscattered along(const Slab &slab, uint32_t channel, const Direction &direction) {
  Unscattered stack{0, 1};
  double below = slab.ior_below;
  for (size_t i = slab.layers.size(); i-- > 0;) {
    const SlabLayer &layer = slab.layers[i];
    if (std::isinf(layer.thickness)) {
      stack = {0, 0};
    } else {
      stack = put_on(interface_between(direction, layer.ior, below), stack);
      const double mu = cosine_in(direction, layer.ior);
      const double tau = (layer.sigma_a[channel] + layer.sigma_s[channel]) * layer.thickness;
      const double attenuation = mu > 0 ? std::exp(-tau / mu) : 0;
      stack = {stack.reflectance * attenuation * attenuation, stack.transmittance * attenuation};
    }
    below = layer.ior;
  }
  return put_on(interface_between(direction, slab.ior_above, below), stack);
}

} // namespace

Unscattered unscattered(const Slab &slab, uint32_t channel, const Light &light) {
  const double n = slab.ior_above;
  if (!light.diffuse)
    return along(slab, channel, {n, light.mu});
  const Nodes nodes = make_nodes(media_of(slab), 256);
  Unscattered mean{0, 0};
  for (size_t i = 0; i < nodes.quadrature(); i++) {
    if (!(cosine_in(nodes.directions[i], n) > 0))
      continue;
    const Unscattered part = along(slab, channel, nodes.directions[i]);
    mean.reflectance += nodes.c[i] * part.reflectance / (n * n);
    mean.transmittance += nodes.c[i] * part.transmittance / (n * n);
  }
  return mean;
}

} // namespace tyn
