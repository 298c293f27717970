/**
 * The scenes that can be named, each made to show something: a shape, a way to go wrong, a texture.
 *
 * <p>World space, z up, lengths in world units; a spherical view looks at the origin. Start with
 * {@link rasterlab.engine.scene.catalogue.Scenes}.
 */
package rasterlab.engine.scene.catalogue;
