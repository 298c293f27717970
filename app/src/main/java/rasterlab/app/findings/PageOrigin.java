package rasterlab.app.findings;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import rasterlab.app.tour.Html;

/**
 * The run that a page is of, as the page's head tells it to later runs.
 *
 * @param settings all that another run must share for its pages to stand beside this one
 * @param begun when the topic's study began, as people read it
 */
record PageOrigin(String settings, String begun) {
    private static final Pattern TOLD =
            Pattern.compile(
                    "<meta name=\"rasterlab-run\" content=\"([^\"]*)\" data-begun=\"([^\"]*)\">");

    /** The line for the head of the page. */
    String html() {
        return "<meta name=\"rasterlab-run\" content=\"%s\" data-begun=\"%s\">\n"
                .formatted(Html.escaped(settings), Html.escaped(begun));
    }

    /**
     * The moment at which the study of a page began.
     *
     * @return empty where the page is missing, cannot be read or is of a run with other settings
     */
    static Optional<String> begun(Path page, String settings) {
        try {
            if (!Files.isRegularFile(page)) return Optional.empty();
            Matcher told = TOLD.matcher(Files.readString(page, StandardCharsets.ISO_8859_1));
            byte[] wanted = Html.escaped(settings).getBytes(StandardCharsets.UTF_8);
            return told.find()
                            && told.group(1).equals(new String(wanted, StandardCharsets.ISO_8859_1))
                    ? Optional.of(told.group(2))
                    : Optional.empty();
        } catch (IOException unreadable) {
            return Optional.empty();
        }
    }
}
