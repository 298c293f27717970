/**
 * The parts of segments in an upright rectangle, or in any convex window.
 *
 * <p>Plane coordinates: x grows to the right, y grows up, any unit. Start with {@link
 * rasterlab.engine.clip.segment.FourLines}, the definition, then {@link
 * rasterlab.engine.clip.segment.CohenSutherland} and {@link
 * rasterlab.engine.clip.segment.LiangBarsky}, which save its divisions.
 */
package rasterlab.engine.clip.segment;
