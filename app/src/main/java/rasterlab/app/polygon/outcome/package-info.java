/**
 * The answers of methods for a figure of the lab of polygons, step by step, beside the exact one.
 * Coordinates are the figure's. Start reading at {@link PolygonResults}.
 */
package rasterlab.app.polygon.outcome;
