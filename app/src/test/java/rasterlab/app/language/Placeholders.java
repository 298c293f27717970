package rasterlab.app.language;

import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** The places of a text that are filled when it is shown. */
final class Placeholders {
    /** {@code {0}} of a MessageFormat and {@code %d} of a Formatter, whose order counts. */
    private static final Pattern PLACEHOLDER =
            Pattern.compile("\\{(\\d+)|%[-#+0,(]*\\d*(?:\\.\\d+)?([a-zA-Z])");

    private Placeholders() {}

    /**
     * The placeholders: those with numbers once each, in the order of their numbers; then the
     * others as they come.
     */
    static List<String> of(String text) {
        var numbered = new TreeSet<String>();
        var inOrder = new ArrayList<String>();
        var matcher = PLACEHOLDER.matcher(text);
        while (matcher.find()) {
            if (matcher.group(1) != null) numbered.add(matcher.group(1));
            else inOrder.add(matcher.group());
        }
        return Stream.concat(numbered.stream(), inOrder.stream()).toList();
    }
}
