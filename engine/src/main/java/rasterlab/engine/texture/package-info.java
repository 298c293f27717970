/**
 * Pictures laid on surfaces: levels of detail, filters, wrapping, mixing with the surface's colour.
 *
 * <p>s grows to the right and t up, both 0 to 1 over the picture, (0, 0) at its bottom left corner;
 * texel (i, j) has its centre at ((i + ½)/width, (j + ½)/height). Colours are 0xAARRGGBB. Start
 * with {@link rasterlab.engine.texture.Texture} and {@link
 * rasterlab.engine.texture.TextureSampler}.
 */
package rasterlab.engine.texture;
