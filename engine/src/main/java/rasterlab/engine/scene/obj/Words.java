package rasterlab.engine.scene.obj;

import java.util.Arrays;

/** The words of one line, divided by blanks, with readers for numbers. */
final class Words {
    /** Magnitudes beyond this leave no room for squares in computing with floats. */
    static final double LARGEST = 1e18;

    private final TextLines lines;
    private int[] begin = new int[16];
    private int[] end = new int[16];
    private int count;

    Words(TextLines lines) {
        this.lines = lines;
    }

    /** Divides the line that {@code lines} is at. */
    void divide() {
        CharSequence text = lines.text();
        count = 0;
        int at = 0;
        while (at < text.length()) {
            while (at < text.length() && isBlank(text.charAt(at))) at++;
            if (at == text.length()) return;
            int from = at;
            while (at < text.length() && !isBlank(text.charAt(at))) at++;
            add(from, at);
        }
    }

    private void add(int from, int to) {
        if (count == begin.length) {
            begin = Arrays.copyOf(begin, 2 * count);
            end = Arrays.copyOf(end, 2 * count);
        }
        begin[count] = from;
        end[count++] = to;
    }

    private static boolean isBlank(char c) {
        return c <= ' ' || c == '\u00A0';
    }

    /** The keyword included. */
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

    /** Everything after the keyword, without blanks around it. */
    String rest() {
        return count < 2 ? "" : lines.text().subSequence(begin[1], end[count - 1]).toString();
    }

    /** The name that follows the keyword. */
    String name() throws BrokenFileException {
        if (count < 2) throw lines.broken("'" + get(0) + "' needs a name");
        return rest();
    }

    /** Passes if there are {@code least} to {@code most} words after the keyword. */
    void requireArguments(int least, int most) throws BrokenFileException {
        int arguments = count - 1;
        if (arguments < least || arguments > most)
            throw lines.broken(
                    "'%s' needs %s numbers, got %d"
                            .formatted(
                                    get(0),
                                    least == most ? least : least + " to " + most,
                                    arguments));
    }

    /** A finite decimal number in ±{@link #LARGEST}. */
    double number(int word) throws BrokenFileException {
        String text = get(word);
        double value = isDecimal(text) ? parse(text) : Double.NaN;
        if (!(Math.abs(value) <= LARGEST))
            throw lines.broken(
                    "'%s' needs a number in ±%s as number %d, got '%s'"
                            .formatted(get(0), LARGEST, word, shown(text)));
        return value;
    }

    /** A number from 0 to {@code most}. */
    double number(int word, double most) throws BrokenFileException {
        double value = number(word);
        if (value < 0 || value > most)
            throw lines.broken(
                    "'%s' needs a number from 0 to %s as number %d, got '%s'"
                            .formatted(get(0), most, word, shown(get(word))));
        return value;
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
