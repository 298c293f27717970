/**
 * How values refuse numbers outside of their range.
 *
 * <p>Start with {@link rasterlab.engine.range.Bounds}.
 */
package rasterlab.engine.range;
