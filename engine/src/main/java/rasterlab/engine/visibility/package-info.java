/**
 * Which face is seen at each pixel: by lists, windows, scan lines, depth buffers and rays.
 *
 * <p>Every method gets the same viewed mesh and one paint, so two pictures differ only where the
 * methods disagree on what is visible. Spaces: eye (x right, y up, z forward), picture plane (y
 * up), pixels (y down, whole numbers name centres). A pixel belongs to a face whose interior holds
 * its centre; a centre on an edge belongs to the face on its right, then below. Start with {@link
 * rasterlab.engine.visibility.Visibility}, then {@link
 * rasterlab.engine.visibility.hidden.Visibilities}; they are held against {@link
 * rasterlab.engine.visibility.exact.ExactVisibility}.
 */
package rasterlab.engine.visibility;
