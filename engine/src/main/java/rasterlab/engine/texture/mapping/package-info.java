/**
 * Topic {@code texture-mapping}: texture coordinates along a row of pixels, with and without
 * perspective. Start with {@link rasterlab.engine.texture.mapping.PerspectiveMapper}.
 */
package rasterlab.engine.texture.mapping;
