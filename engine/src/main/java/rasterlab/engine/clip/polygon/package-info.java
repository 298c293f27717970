/**
 * The parts of simple polygons in a convex window.
 *
 * <p>Plane coordinates: x grows to the right, y grows up, any unit; rings are counter-clockwise.
 * Start with {@link rasterlab.engine.clip.polygon.SutherlandHodgman}, which leaves one ring, then
 * {@link rasterlab.engine.clip.polygon.WeilerAtherton}, which leaves a ring for each piece.
 */
package rasterlab.engine.clip.polygon;
