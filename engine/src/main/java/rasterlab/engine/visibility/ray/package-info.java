/**
 * Faces met by rays from the eye through the pixels' centres, and where faces cross each other.
 *
 * <p>Space: eye. A tree of boxes keeps a ray or an edge from being tried with every face. Start
 * with {@link rasterlab.engine.visibility.ray.RayCast}, then {@link
 * rasterlab.engine.visibility.ray.BoxTree} and {@link
 * rasterlab.engine.visibility.ray.FaceCrossings}.
 */
package rasterlab.engine.visibility.ray;
