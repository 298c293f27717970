/**
 * Reads exercise folders, those of the program and an instructor's own.
 *
 * <p>Start with {@link rasterlab.exercises.catalogue.Catalogue}.
 */
package rasterlab.exercises.catalogue;
