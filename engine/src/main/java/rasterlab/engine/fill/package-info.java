/**
 * Filling a region of one colour from a pixel inside it: topic {@code fill}.
 *
 * <p>Pixel coordinates: columns grow to the right, rows grow down. Source: A. R. Smith, Tint fill,
 * SIGGRAPH 1979, pp. 276–283. Start with {@link rasterlab.engine.fill.SpanFill}.
 */
package rasterlab.engine.fill;
