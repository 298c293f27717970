package rasterlab.engine.scene.obj;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * The words of one line, divided by blanks, with readers for numbers and names.
 *
 * <p>A word that begins with # begins a comment, except in names, where {@link #name} and {@link
 * #names} have it both ways.
 */
final class Words {
    private final TextLines lines;
    private final Notes notes;
    private int[] begin = new int[16];
    private int[] end = new int[16];
    private int count;
    private int countInNames;

    Words(TextLines lines, Notes notes) {
        this.lines = lines;
        this.notes = notes;
    }

    /** Divides the line that {@code lines} is at. */
    void divide() {
        CharSequence text = lines.text();
        int length = text.length();
        count = -1;
        countInNames = 0;
        int at = 0;
        while (true) {
            while (at < length && isBlank(text.charAt(at))) at++;
            if (at == length) break;
            int from = at;
            if (count < 0 && text.charAt(at) == '#') count = countInNames;
            while (at < length && !isBlank(text.charAt(at))) at++;
            add(from, at);
        }
        if (count < 0) count = countInNames;
    }

    private void add(int from, int to) {
        if (countInNames == begin.length) {
            begin = Arrays.copyOf(begin, 2 * countInNames);
            end = Arrays.copyOf(end, 2 * countInNames);
        }
        begin[countInNames] = from;
        end[countInNames++] = to;
    }

    private static boolean isBlank(char c) {
        return c <= ' ' || c == '\u00A0';
    }

    /** The keyword included; a comment is none. */
    int count() {
        return count;
    }

    String get(int word) {
        return lines.text().subSequence(begin[word], end[word]).toString();
    }

    int begin(int word) {
        return begin[word];
    }

    int end(int word) {
        return end[word];
    }

    /**
     * Everything from a word on, with what may be a comment, without blanks around it; a hard blank
     * belongs to a name.
     */
    String name(int from) {
        return name(from, lines.text().length());
    }

    private String name(int from, int to) {
        CharSequence text = lines.text();
        int first = end[from - 1];
        int last = to;
        while (first < last && text.charAt(first) <= ' ') first++;
        while (first < last && text.charAt(last - 1) <= ' ') last--;
        return text.subSequence(first, last).toString();
    }

    /**
     * The name from a word on in all ways that it can be meant: whole, and cut at each word that
     * begins with #, the longest first.
     */
    List<String> names(int from) {
        List<String> names = new ArrayList<>();
        names.add(name(from));
        for (int word = countInNames - 1; word > from; word--)
            if (lines.text().charAt(begin[word]) == '#') names.add(name(from, begin[word]));
        return names;
    }

    /** Passes if at least so many numbers follow the keyword. */
    void requireNumbers(int least) throws BrokenFileException {
        for (int word = 1; word < count && word <= least; word++)
            if (hasComma(word)) throw refusal(word, ReadingRules.POSITION);
        if (count - 1 < least)
            throw lines.broken(
                    "'%s' needs at least %d numbers, got %d".formatted(get(0), least, count - 1));
    }

    /** The number at a word, by a rule of which numbers are taken; a missing word has none. */
    double number(int word, Rule rule) throws BrokenFileException {
        double value = value(word);
        if (value >= rule.least() && value <= rule.most()) return value;
        if (rule.treatment() == Rule.Treatment.REQUIRED) throw refusal(word, rule);
        if (Double.isNaN(value)) {
            noteUnread(word, rule);
            return rule.numberInstead();
        }
        notes.count(List.of(rule, "cut"), () -> cut(word, rule), lines);
        return Math.max(rule.least(), Math.min(rule.most(), value));
    }

    private String cut(int word, Rule rule) {
        return "'%s' of %s was cut to its range, %s to %s"
                .formatted(
                        rule.keyword(),
                        shown(get(word)),
                        Rule.number(rule.least()),
                        Rule.number(rule.most()));
    }

    /** Counts a number that is missing or none, for which something else stands. */
    void noteUnread(int word, Rule rule) {
        notes.count(List.of(rule, "unread"), () -> unread(word, rule), lines);
    }

    private String unread(int word, Rule rule) {
        if (word >= count)
            return "'%s' has too few numbers; %s is used instead"
                    .formatted(rule.keyword(), rule.instead());
        String what = hasComma(word) ? "a decimal comma in" : "no number in";
        return "'%s' has %s '%s'; %s is used instead"
                .formatted(rule.keyword(), what, shown(get(word)), rule.instead());
    }

    private boolean hasComma(int word) {
        return get(word).matches("[+-]?\\d*,\\d+");
    }

    /** Whether a word is a number, or what other programs write in the place of one. */
    boolean isMeantAsNumber(int word) {
        return !Double.isNaN(value(word))
                || hasComma(word)
                || get(word).matches("(?i)[+-]?(nan|inf|infinity|\\d*\\.?#\\w+)");
    }

    private BrokenFileException refusal(int word, Rule rule) {
        String text = shown(get(word));
        if (hasComma(word))
            return lines.broken(
                    "'%s' has a decimal comma in number %d, '%s'; decimals are written with a point"
                            .formatted(rule.keyword(), word, text));
        return lines.broken(
                "'%s' needs a number in ±%s as number %d, got '%s'"
                        .formatted(rule.keyword(), rule.most(), word, text));
    }

    /** A finite or infinite decimal number; NaN where a word is none or missing. */
    double value(int word) {
        if (word >= count) return Double.NaN;
        double easy = Decimal.easy(lines.text(), begin[word], end[word]);
        if (!Double.isNaN(easy)) return easy;
        String text = get(word);
        return isDecimal(text) ? parse(text) : Double.NaN;
    }

    /**
     * Java's parser also takes names, hexadecimal digits and suffixes, which these files have not.
     */
    private static boolean isDecimal(String text) {
        for (int i = 0; i < text.length(); i++)
            if ("0123456789.+-eE".indexOf(text.charAt(i)) < 0) return false;
        return true;
    }

    private static double parse(String text) {
        try {
            return Double.parseDouble(text);
        } catch (NumberFormatException e) {
            return Double.NaN;
        }
    }

    /** Text from a file, cut short for a message. */
    static String shown(String text) {
        return text.length() <= 40 ? text : text.substring(0, 40) + "…";
    }
}
