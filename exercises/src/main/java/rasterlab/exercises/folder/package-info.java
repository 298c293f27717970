/**
 * Checks an instructor's exercise folder before anybody sees it, and makes a new one to begin with.
 *
 * <p>Start with {@link rasterlab.exercises.folder.FolderCheck}.
 */
package rasterlab.exercises.folder;
