/**
 * The figures that the lab of clipping clips: segments or a polygon in a window of the plane,
 * segments in a view volume. Names carry the space: {@code plane} is x right and y up, {@code
 * space} the normalised view volume's. Start reading at {@link ClipScene}.
 */
package rasterlab.app.clip.scene;
