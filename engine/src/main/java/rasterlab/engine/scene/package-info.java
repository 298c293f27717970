/**
 * The things that are looked at: meshes of flat convex faces, and scenes with finishes, light and a
 * default view.
 *
 * <p>World space is right-handed with z up; faces are listed counter-clockwise seen from outside.
 * Below: {@code catalogue} names scenes, {@code shape} has curved surfaces, {@code obj} reads
 * files. Start with {@link rasterlab.engine.scene.Scene}; the worked scenes are {@link
 * rasterlab.engine.scene.Vase} and {@link rasterlab.engine.scene.House}.
 */
package rasterlab.engine.scene;
