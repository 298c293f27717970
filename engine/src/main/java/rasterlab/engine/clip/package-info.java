/**
 * Clipping: what is left of segments in a rectangle, of polygons in a convex window, of segments in
 * the view volume.
 *
 * <p>Plane coordinates: x grows to the right, y grows up, any unit. Eye coordinates: x right, y up,
 * z away from the eye. A segment is p(t) = p0 + t·(p1 − p0), 0 ≤ t ≤ 1; {@code enter} and {@code
 * leave} are the t of what is left. Methods compute in doubles and know where those cannot decide;
 * there they hand over to {@link rasterlab.engine.clip.UnroundedInterval}. Start with {@link
 * rasterlab.engine.clip.LiangBarsky}.
 */
package rasterlab.engine.clip;
