/**
 * What is looked at: meshes of flat convex faces, and scenes with colours and a default view.
 *
 * <p>World space is right-handed with z up; faces are listed counter-clockwise seen from outside.
 * Start with {@link rasterlab.engine.scene.catalogue.Scenes}; the worked scenes are {@link
 * rasterlab.engine.scene.Vase} and {@link rasterlab.engine.scene.House}.
 */
package rasterlab.engine.scene;
