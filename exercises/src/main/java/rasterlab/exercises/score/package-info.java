/**
 * What a student is told: verdict, points with the reason for each lost one, pictures, diagnostics.
 *
 * <p>Start with {@link rasterlab.exercises.score.Report}.
 */
package rasterlab.exercises.score;
