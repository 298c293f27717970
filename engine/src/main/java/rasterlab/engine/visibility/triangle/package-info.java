/**
 * Topic {@code depth-triangle}: triangles filled one after another into a depth buffer, with depths
 * that are stepped along rows.
 *
 * <p>Coordinates are those of the screen: whole ones are pixel centres, y grows down, depth 0 is at
 * the near plane and 1 at the far one. Start with {@link
 * rasterlab.engine.visibility.triangle.RowsTriangle}.
 */
package rasterlab.engine.visibility.triangle;
