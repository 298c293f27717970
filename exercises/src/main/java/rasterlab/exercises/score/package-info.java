/**
 * The report that a student gets: verdict, points with the reason for each lost one, pictures,
 * diagnostics.
 *
 * <p>Start with {@link rasterlab.exercises.score.Report}.
 */
package rasterlab.exercises.score;
