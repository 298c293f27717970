/**
 * Sheets of questions on the next step of a method, drawn by a seed, and the answers to them.
 *
 * <p>Questions come from the steps that a method records: a step has fields, some of which are told
 * and some asked for, as the data of the exercise says. Start with {@link
 * rasterlab.exercises.predicting.Sheet}.
 */
package rasterlab.exercises.predicting;
