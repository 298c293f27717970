/**
 * A drawing surface: brushes that fill with hatches and patterns, pens with width and dashes.
 *
 * <p>Pixel coordinates: whole numbers name pixel centres, x grows to the right, y grows down. Start
 * with {@link rasterlab.engine.surface.DrawingSurface}.
 */
package rasterlab.engine.surface;
