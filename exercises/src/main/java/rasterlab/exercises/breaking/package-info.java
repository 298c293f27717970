/**
 * The process that tries a topic's methods on inputs which a student handed in to break them.
 *
 * <p>Start with {@link rasterlab.exercises.breaking.BreakMain}.
 */
package rasterlab.exercises.breaking;
