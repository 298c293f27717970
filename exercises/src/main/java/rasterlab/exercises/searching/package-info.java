/**
 * The search for inputs on which a method fails: drawn from the topic's description of its inputs
 * and from those of its study, changed towards the borders of arithmetic, and made simpler once one
 * is found.
 *
 * <p>Inputs are JSON trees as {@code ./lab run} takes them. Start with {@link
 * rasterlab.exercises.searching.HazardSearch}.
 */
package rasterlab.exercises.searching;
