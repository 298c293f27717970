package rasterlab.exercises.score;

import java.text.MessageFormat;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Puts a place in an answer into words: {@code segments[0][1]} is y of the start of segment 1. */
final class AnswerPlace {
    private static final Pattern PATH =
            Pattern.compile("([a-z-]+)\\[(\\d{1,9})](?:\\[(\\d{1,9})])?");

    private AnswerPlace() {}

    /**
     * The place in words; the path itself where there are none.
     *
     * @param topic whose answer it is
     * @param path as in the answer's JSON
     */
    static String in(ReportTexts texts, String topic, String path) {
        Matcher parts = PATH.matcher(path);
        if (!parts.matches()) return path;
        String field = "place." + topic + "." + parts.group(1);
        String key = parts.group(3) == null ? field : field + "." + parts.group(3);
        if (!texts.has(key)) return path;
        int place = 1 + Integer.parseInt(parts.group(2));
        return new MessageFormat(texts.text(key), Locale.ROOT)
                .format(new Object[] {String.valueOf(place)});
    }
}
