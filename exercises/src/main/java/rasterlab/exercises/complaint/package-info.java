/**
 * The sentences that the engine, readers of files and the server say in English, in the language of
 * whoever reads them: on a page, in the window, on a terminal.
 *
 * <p>Start with {@link rasterlab.exercises.complaint.ComplaintTexts}.
 */
package rasterlab.exercises.complaint;
