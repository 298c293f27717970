package rasterlab.exercises.words;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Forms that go with a number in patterns of texts, which {@link java.text.MessageFormat} has not:
 * {@code {0,plural,one#{0} piece|other#{0} pieces}}.
 *
 * <p>A form's name is an answer of {@link #name}. Russian may leave out {@code other}, that of
 * broken numbers, where it is the same as {@code few}.
 */
public final class PluralForms {
    private static final Pattern BEGIN = Pattern.compile("\\{(\\d+),plural,");
    private static final Pattern NUMBER = Pattern.compile("[-−]?\\d+(\\.\\d+)?");

    private PluralForms() {}

    /**
     * The name of the form that goes with a number.
     *
     * <p>Source: Unicode CLDR, Language Plural Rules, cardinal numbers of English and Russian.
     *
     * @return {@code one}, {@code few}, {@code many} or {@code other}; English has one and other
     */
    public static String name(double number, Locale language) {
        double size = Math.abs(number);
        if (!isRussian(language)) return size == 1 ? "one" : "other";
        if (size != Math.rint(size)) return "other";
        double last = size % 10;
        boolean teen = size % 100 >= 11 && size % 100 <= 14;
        if (last == 1 && !teen) return "one";
        return last >= 2 && last <= 4 && !teen ? "few" : "many";
    }

    private static boolean isRussian(Locale language) {
        return language.getLanguage().equals("ru");
    }

    /**
     * The pattern with one of the forms in the place of each choice.
     *
     * @param arguments numbers, or texts that are numbers, where there is a choice
     * @throws IllegalArgumentException if there is no form for the number
     */
    public static String chosen(String pattern, Object[] arguments, Locale language) {
        var chosen = new StringBuilder();
        int at = 0;
        Matcher begin = BEGIN.matcher(pattern);
        while (begin.find(at)) {
            int end = end(pattern, begin.end());
            String name = name(arguments[Integer.parseInt(begin.group(1))], language);
            chosen.append(pattern, at, begin.start());
            chosen.append(form(pattern.substring(begin.end(), end), name));
            at = end + 1;
        }
        return chosen.append(pattern, at, pattern.length()).toString();
    }

    /** A text that is no number, such as a range, takes the form of many. */
    private static String name(Object argument, Locale language) {
        if (argument instanceof Number number) return name(number.doubleValue(), language);
        String text = String.valueOf(argument);
        return NUMBER.matcher(text).matches()
                ? name(Double.parseDouble(text.replace('−', '-')), language)
                : isRussian(language) ? "many" : "other";
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
