/**
 * Which face is seen at each pixel: painters, a z-buffer and an exact ray caster.
 *
 * <p>Every method gets the same viewed mesh and one colour per face, so two pictures differ only
 * where the methods disagree on what is visible. Spaces: eye (x right, y up, z forward), picture
 * plane (y up), pixels (y down, whole numbers name centres). A pixel belongs to a face whose
 * interior holds its centre; a centre on an edge belongs to the face on its right, then below.
 * Start with {@link rasterlab.engine.visibility.Visibility}.
 */
package rasterlab.engine.visibility;
