/**
 * Numbers at which arithmetic changes its ways, for inputs that are drawn to make methods fail.
 *
 * <p>Start with {@link rasterlab.engine.border.BorderNumbers}.
 */
package rasterlab.engine.border;
