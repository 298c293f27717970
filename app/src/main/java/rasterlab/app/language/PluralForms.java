package rasterlab.app.language;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Forms that go with a number in patterns of texts, which {@link java.text.MessageFormat} has not:
 * {@code {0,plural,one#{0} piece|other#{0} pieces}}.
 *
 * <p>A form's name is an answer of {@link Language#plural}. Russian may leave out {@code other},
 * that of broken numbers, where it is the same as {@code few}.
 */
final class PluralForms {
    private static final Pattern BEGIN = Pattern.compile("\\{(\\d+),plural,");

    private PluralForms() {}

    /**
     * The pattern with one of the forms in the place of each choice.
     *
     * @throws IllegalArgumentException if there is no form for the number
     */
    static String chosen(String pattern, Object[] arguments, Language language) {
        var chosen = new StringBuilder();
        int at = 0;
        Matcher begin = BEGIN.matcher(pattern);
        while (begin.find(at)) {
            int end = end(pattern, begin.end());
            var number = (Number) arguments[Integer.parseInt(begin.group(1))];
            String form = language.plural(number.doubleValue());
            chosen.append(pattern, at, begin.start());
            chosen.append(form(pattern.substring(begin.end(), end), form));
            at = end + 1;
        }
        return chosen.append(pattern, at, pattern.length()).toString();
    }

    /** Where the brace stands that closes the one before {@code from}. */
    private static int end(String pattern, int from) {
        int depth = 1;
        for (int i = from; i < pattern.length(); i++) {
            if (pattern.charAt(i) == '{') depth++;
            if (pattern.charAt(i) == '}' && --depth == 0) return i;
        }
        throw new IllegalArgumentException("a plural has no closing brace in '" + pattern + "'");
    }

    private static String form(String forms, String name) {
        List<String> names = new ArrayList<>(List.of(name));
        if (name.equals("other")) names.add("few");
        for (String each : names)
            for (String form : forms.split("\\|"))
                if (form.startsWith(each + "#")) return form.substring(each.length() + 1);
        throw new IllegalArgumentException("no form '" + name + "' among '" + forms + "'");
    }
}
