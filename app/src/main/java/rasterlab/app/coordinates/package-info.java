/**
 * The tab of coordinates: views and projections, lists of transformations, OpenGL's stacks of
 * matrices, rotations by many small turns, and a line that meets a plane; each a lab of its own in
 * a package below.
 *
 * <p>{@link rasterlab.app.coordinates.CoordinatesLabModel} knows no Swing; {@link
 * rasterlab.app.coordinates.CoordinatesPanel} shows it. Start with {@link
 * rasterlab.app.coordinates.view.ViewLabModel}.
 */
package rasterlab.app.coordinates;
