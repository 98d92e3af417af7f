// SPDX-FileCopyrightText: 2026 The Tyndall authors
// SPDX-License-Identifier: Apache-2.0
#include "slab/layer_options.hpp"

#include <CLI/CLI.hpp>

namespace slab {

void add_layer_options(CLI::App &app, LayerText &text) {
  app.add_option("--sigma-a", text.sigma_a, "absorption coefficient, 1/length, one a channel")->type_name("A[,A...]");
  app.add_option("--sigma-s", text.sigma_s, "scattering coefficient, 1/length, one a channel")->type_name("S[,S...]");
  app.add_option("--g", text.g, "mean cosine of scattering, between -1 and 1 (0)")->type_name("G");
  app.add_option("--ior", text.ior, "refractive index, 1 to 4 (1)")->type_name("N");
  app.add_option("--thickness", text.thickness, "thickness, or inf (inf)")->type_name("LENGTH");
  app.add_option(
         "--layer", text.layers,
         "a layer, from the top (repeatable); thickness inf in the\nlast only; several channels: 0.1/0.2/0.3,...")
      ->type_name("A,S,G,N,LENGTH")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  app.add_option("--medium", text.medium,
                 "a measured medium, in 1/mm, channels R G B\n(tyndall-info --media); --g, --ior as above override")
      ->type_name("NAME");
}

void add_phase_option(CLI::App &app, LayerText &text) {
  app.add_option("--phase", text.phase,
                 "phase function: isotropic, rayleigh, hg,\ntwo-lobe:G1,G2,WEIGHT, draine:G,ALPHA or\n"
                 "mie:SIZE,N,K (size parameter, relative index) (hg)")
      ->type_name("KIND");
}

} // namespace slab
