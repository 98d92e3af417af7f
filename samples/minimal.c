/* SPDX-FileCopyrightText: 2026 The Tyndall authors
 * SPDX-License-Identifier: Apache-2.0
 *
 * The smallest program that walks light through an object: light shines on a cube of skin from all
 * around, and the program says how much of it comes out again, in red, green and blue.
 *
 *   cc -std=c99 minimal.c -o minimal $(pkg-config --cflags --libs tyndall) -lm && ./minimal
 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <tyndall/tyndall.h>

enum { PATHS = 100000 };

/* Edge 2. Triangles wind counter-clockwise seen from outside. */
static const float corners[8][3] = {{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1},
                                    {-1, -1, 1},  {1, -1, 1},  {-1, 1, 1},  {1, 1, 1}};
static const uint32_t triangles[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                                          {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};

/* Every call answers with a status; the context keeps the reason of the last failure. */
static void check(TynStatus status, const TynContext *context) {
  if (status == TYN_OK)
    return;
  fprintf(stderr, "minimal: %s: %s\n", tyn_status_string(status), tyn_context_message(context));
  exit(EXIT_FAILURE);
}

/* A path enters at a point of the surface, in a cosine-distributed direction that the walk draws.
 * The points are a low-discrepancy sequence (R2), which no two triangles have in common. */
static TynWalkEntry entry(int i) {
  double u = fmod(i * 0.7548776662466927, 1.0), v = fmod(i * 0.5698402909980532, 1.0);
  if (u + v > 1.0)
    u = 1.0 - u, v = 1.0 - v; /* the other half of the parallelogram */
  const uint32_t *corner = triangles[i % 12];
  TynWalkEntry result = {.kind = TYN_ENTRY_COSINE, .weight = {1, 1, 1}, .medium = TYN_NONE};
  for (int axis = 0; axis < 3; ++axis)
    result.position[axis] =
        (float)((1.0 - u - v) * corners[corner[0]][axis] + u * corners[corner[1]][axis] + v * corners[corner[2]][axis]);
  result.triangle = (uint32_t)(i % 12);
  result.albedo[0] = result.sigma_t[0] = -1.0f; /* negative: as the medium has them */
  return result;
}

/* Mean weight that escaped in one channel, and the standard error of that mean. */
static double escaped(const TynWalkExit *exits, int channel, double *error) {
  double sum = 0.0, squares = 0.0;
  for (int i = 0; i < PATHS; ++i) {
    double weight = exits[i].status == TYN_WALK_ESCAPED ? exits[i].weight[channel] : 0.0;
    sum += weight, squares += weight * weight;
  }
  double mean = sum / PATHS;
  *error = sqrt((squares / PATHS - mean * mean) / (PATHS - 1));
  return mean;
}

int main(void) {
  TynContext *context = NULL; /* on the first OpenCL device */
  check(tyn_context_create(NULL, &context), context);

  TynSceneOptions options = tyn_scene_options();
  options.metres_per_unit = 0.005; /* the cube is 1 cm wide */
  TynScene *scene = NULL;
  check(tyn_scene_create(context, &options, &scene), context);

  TynMedium skin = tyn_medium(); /* as measured, in 1/scene unit */
  check(tyn_medium_preset("skin1", options.metres_per_unit, &skin), context);
  TynMesh cube = tyn_mesh();
  cube.positions = corners[0], cube.vertex_count = 8;
  cube.indices = triangles[0], cube.triangle_count = 12;
  check(tyn_scene_add_medium(scene, &skin, &cube.medium), context);
  check(tyn_scene_add_mesh(scene, &cube, NULL), context); /* the first mesh has index 0 */
  check(tyn_scene_commit(scene), context);

  static TynWalkEntry entries[PATHS];
  static TynWalkExit exits[PATHS];
  for (int i = 0; i < PATHS; ++i)
    entries[i] = entry(i);
  TynLedger ledger;
  check(tyn_walk(scene, NULL, entries, PATHS, exits, &ledger), context);

  for (int c = 0; c < 3; ++c) {
    double error = 0.0, mean = escaped(exits, c, &error);
    printf("%c: escaped %.4f +- %.4f, absorbed %.4f, balance %+.4f\n", "RGB"[c], mean, error,
           ledger.absorbed[c] / PATHS, ledger.balance[c] / PATHS);
  }
  printf("%.0f scatterings; walks leaked %.0f, lost %.0f\n", (double)ledger.scatterings, (double)ledger.leaked_walks,
         (double)ledger.lost_walks);
  tyn_scene_release(scene); /* in any order: a scene keeps its context alive */
  tyn_context_release(context);
  return ledger.leaked_walks || ledger.lost_walks ? EXIT_FAILURE : EXIT_SUCCESS;
}
