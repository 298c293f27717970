/**
 * Takes the world to the picture: named matrices, the view by spherical coordinates, projection and
 * the fit to the picture's size.
 *
 * <p>Spaces in this order: world (right-handed, z up), eye (left-handed: x right, y up, z forward
 * from the eye), picture plane (world units, y up), pixels (y down). A textbook writes a point as a
 * row, {@code [x y z 1] · M}; JOML stores the textbook's rows as its columns, so a constructor call
 * in the textbook's reading order is the same transformation. Start with {@link
 * rasterlab.engine.transform.SphericalView}.
 */
package rasterlab.engine.transform;
