/**
 * The answer of a check or a server to one source: verdict and points, each case with its reason
 * and pictures, and sentences that are told in the window's language. Pictures are in pixels of
 * their raster. Start reading at {@link Outcome}.
 */
package rasterlab.app.exercise.outcome;
