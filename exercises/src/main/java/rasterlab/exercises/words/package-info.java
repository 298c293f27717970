/**
 * The words about topics: a pair of files a topic stands beside this class, {@code line.properties}
 * (English) and {@code line_ru.properties}, with all that the window, the command line and the
 * server say of it.
 *
 * <p>{@code METHOD.formula} and so on explain methods, {@code label.HAZARD} and {@code
 * hazard.HAZARD} name and explain hazards. A checksum above a Russian text is that of the English
 * it was made for. Start at {@link rasterlab.exercises.words.TopicWords}.
 */
package rasterlab.exercises.words;
