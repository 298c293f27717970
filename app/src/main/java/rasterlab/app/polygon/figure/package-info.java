/**
 * The figures that the lab of polygons works on in each of its modes, with points that can be
 * moved, in the plane with y up or in pixels with y down. Start reading at {@link PolygonFigure}.
 */
package rasterlab.app.polygon.figure;
