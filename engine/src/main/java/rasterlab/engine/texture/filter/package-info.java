/**
 * Topic {@code texture-filter}: the colour of a pixel that shows a picture made smaller or larger,
 * against the picture's mean over the pixel's footprint. Start with {@link
 * rasterlab.engine.texture.filter.FilterMethods}' list; {@link
 * rasterlab.engine.texture.TextureSampler} does the work.
 */
package rasterlab.engine.texture.filter;
