/**
 * Finds the order in which to paint polygons, the farthest first: topic {@code depth-order}.
 *
 * <p>Spaces: world, any unit; seen, which is world less the eye, by a power of two near 1, so that
 * the eye is at the origin; z is depth along the look from the eye to the middle of the box round
 * all polygons. Each method is a walk of paintings, moves and cuts: start with {@link
 * rasterlab.engine.visibility.order.MeanZ}, then {@link rasterlab.engine.visibility.order.Newell};
 * {@link rasterlab.engine.visibility.order.DepthOrderTopic} lists everything.
 */
package rasterlab.engine.visibility.order;
