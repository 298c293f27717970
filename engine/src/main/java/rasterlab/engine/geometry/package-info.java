/**
 * The plane and space of school geometry, and the one question that everything about polygons rests
 * on: on which side of a line does a point lie?
 *
 * <p>Mathematical axes: x grows to the right, y up, z towards the reader; a positive turn goes
 * counter-clockwise. Start with {@link rasterlab.engine.geometry.Orientation}, which answers that
 * question without error; {@link rasterlab.engine.geometry.Vector}, {@link
 * rasterlab.engine.geometry.Line} and {@link rasterlab.engine.geometry.Plane} are the course's
 * first chapter in plain doubles.
 */
package rasterlab.engine.geometry;
