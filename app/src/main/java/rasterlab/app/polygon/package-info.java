/**
 * The lab of polygons: point inside, triangulation, filling, seed fill.
 *
 * <p>Coordinates: where a point is inside and what is triangulated, the plane with y up; what is
 * filled, pixels with y down, whole numbers being centres. Start with {@link
 * rasterlab.app.polygon.PolygonLabModel}, which knows no Swing.
 */
package rasterlab.app.polygon;
