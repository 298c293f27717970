/**
 * What methods make of a figure of the lab of polygons, step by step, beside the exact answer.
 * Coordinates are the figure's. Start reading at {@link PolygonResults}.
 */
package rasterlab.app.polygon.outcome;
