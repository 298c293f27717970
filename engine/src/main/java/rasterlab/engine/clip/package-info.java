/**
 * Clipping: what is left of segments in a rectangle ({@code segment}), of polygons in a convex
 * window ({@code polygon}), of segments in the view volume ({@code volume}); the right answers in
 * {@code exact}.
 *
 * <p>A segment is p(t) = p0 + t·(p1 − p0), 0 ≤ t ≤ 1; {@code enter} and {@code leave} are the t of
 * what is left. Methods compute in doubles and know where those cannot decide; there they hand over
 * to {@link rasterlab.engine.clip.UnroundedInterval}.
 */
package rasterlab.engine.clip;
