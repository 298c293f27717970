package rasterlab.app.shell.settings;

import java.util.List;
import rasterlab.app.language.Complaints;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;

/**
 * A fault of a user's file, told in any language.
 *
 * @param key of a text of this package
 * @param arguments of that text; a problem among them, and what readers of files say, is told in
 *     the same language
 */
public record Problem(String key, List<Object> arguments) {
    public Problem {
        arguments = List.copyOf(arguments);
    }

    public static Problem of(String key, Object... arguments) {
        return new Problem(key, List.of(arguments));
    }

    /** One line. */
    public String in(Language language) {
        Object[] said = arguments.stream().map(each -> argumentText(each, language)).toArray();
        return Texts.of("shell", language).text(key, said);
    }

    private static Object argumentText(Object argument, Language language) {
        if (argument instanceof Problem reason) return reason.in(language);
        return argument instanceof String text ? Complaints.translated(language, text) : argument;
    }

    /** One line in English. */
    @Override
    public String toString() {
        return in(Language.ENGLISH);
    }
}
