/**
 * The fast pipeline: a triangle mesh onto a picture with depth, on all cores.
 *
 * <p>Stages: vertices (world → eye → clip → pixels in 1/256, and their light), binning (clip, cull,
 * bands of rows), bands (exact edge functions, perspective-correct attributes, depth). Spaces: eye
 * looks along −z, y up; clip is −w ≤ x, y, z ≤ w; pixels have y down and whole numbers at centres;
 * depth is 0 at the near plane and 1 at the far plane. The picture is the same bit for bit whatever
 * the number of threads. Start with {@link rasterlab.engine.pipeline.fast.TrianglePipeline}. A
 * reader of the course need not: {@code plain} draws the same; engine/fast-pipeline.md tells what
 * each trick gains.
 */
package rasterlab.engine.pipeline.fast;
