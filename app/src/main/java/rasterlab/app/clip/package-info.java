/**
 * The lab of the topics {@code clip-segment}, {@code clip-polygon} and {@code clip-volume}: what a
 * window or a view volume leaves of segments and polygons, beside the exact answer.
 *
 * <p>Names carry the space: {@code plane} coordinates grow to the right and up; {@code space} is
 * the normalised view volume's, x right, y up, z away from the eye; a picture of space is in plane
 * coordinates again ({@link rasterlab.app.clip.scene.VolumeViewpoint}). {@link
 * rasterlab.app.clip.ClipLabModel} knows no Swing; {@link rasterlab.app.clip.ClipPanel} shows it.
 */
package rasterlab.app.clip;
