/**
 * Numbers at the borders of doubles, and every method that promises to be right held against them.
 *
 * <p>{@link rasterlab.engine.border.Borders} lists how each topic's input is made of such numbers;
 * {@link rasterlab.engine.border.BorderTrial} tries methods on it and shrinks what is found. A new
 * topic needs one line in {@code Borders}: {@code BorderTest} says which one is missing.
 */
package rasterlab.engine.border;
