package rasterlab.app.spline;

import java.text.MessageFormat;
import java.text.ParseException;
import rasterlab.app.language.Texts;

/** What methods say when they refuse, in the window's language. */
final class Refusals {
    private Refusals() {}

    /**
     * @param translations texts {@code refusal.1.en}, the English with its numbers left open, and
     *     {@code refusal.1}, the same in the window's language; then 2 and so on
     * @return the message itself where there is no translation
     */
    static String said(Texts translations, String message) {
        for (int i = 1; translations.has("refusal." + i + ".en"); i++) {
            try {
                Object[] numbers =
                        new MessageFormat(translations.text("refusal." + i + ".en")).parse(message);
                return MessageFormat.format(translations.text("refusal." + i), numbers);
            } catch (ParseException another) {
                continue;
            }
        }
        return message;
    }
}
