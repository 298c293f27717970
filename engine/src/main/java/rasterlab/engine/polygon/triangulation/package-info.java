/**
 * Cutting a polygon into triangles: the fan for convex ones, the course's shortest diagonal as
 * printed and mended, and ear clipping.
 *
 * <p>Any unit, x to the right, y up, so counter-clockwise is positive. Corners are named by their
 * numbers in the input. Each method is a walk that cuts one triangle per step: start with {@link
 * rasterlab.engine.polygon.triangulation.EarRing} and {@link
 * rasterlab.engine.polygon.triangulation.EarClipping}; {@link
 * rasterlab.engine.polygon.triangulation.TriangulateTopic} lists everything.
 */
package rasterlab.engine.polygon.triangulation;
