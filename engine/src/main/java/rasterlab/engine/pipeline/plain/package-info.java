/**
 * The pipeline on one page, for a lecture: each stage a few lines, in the order in which a triangle
 * passes them.
 *
 * <p>Spaces: model, world, eye (x right, y up, z forward), clip (−w ≤ x, y, z ≤ w), ndc, screen
 * (whole numbers at pixel centres, y down). What makes it fast stands apart, in {@code fast}. Start
 * with {@link rasterlab.engine.pipeline.plain.PlainPipeline}.
 */
package rasterlab.engine.pipeline.plain;
