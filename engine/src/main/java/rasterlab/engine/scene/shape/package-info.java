/**
 * Curved and flat surfaces by formulas: exact normals, meshes as fine as wanted, exact meetings
 * with rays.
 *
 * <p>World space, z up, lengths in world units, angles in radians; normals point outwards. Start
 * with {@link rasterlab.engine.scene.shape.SceneShape} and {@link
 * rasterlab.engine.scene.shape.Sphere}; {@link rasterlab.engine.scene.shape.Polynomial} finds where
 * rays meet what has no closed form.
 */
package rasterlab.engine.scene.shape;
