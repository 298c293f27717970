/**
 * The languages of the window and the texts in them.
 *
 * <p>Each package of the app keeps its texts in {@code messages.properties} (English) and {@code
 * messages_ru.properties} beside it, in UTF-8. Start at {@link rasterlab.app.language.Texts}.
 */
package rasterlab.app.language;
