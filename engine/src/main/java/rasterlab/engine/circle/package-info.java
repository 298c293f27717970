/**
 * Circles and ellipses about pixel centres: topics {@code circle} and {@code ellipse}.
 *
 * <p>Methods work in (u, v), counted in pixels from the centre, in one quadrant or octant, and
 * mirror. Sources: J. E. Bresenham, A linear algorithm for incremental digital display of circular
 * arcs, Communications of the ACM 20(2), 1977; M. L. V. Pitteway, Computer Journal 10(3), 1967.
 * Start with {@link rasterlab.engine.circle.MidpointCircle}.
 */
package rasterlab.engine.circle;
