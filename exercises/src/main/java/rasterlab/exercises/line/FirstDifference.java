package rasterlab.exercises.line;

import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import rasterlab.engine.study.Deviation;
import rasterlab.exercises.score.Message;

/** The engine's English words on the first wrong pixel, as a message in any language. */
final class FirstDifference {
    private static final String PIXEL = "(\\(-?\\d+, -?\\d+\\))";

    private static final Map<String, Pattern> FORMS =
            Map.of(
                    "pixel.missing", Pattern.compile("pixel " + PIXEL + " is missing"),
                    "pixel.instead",
                            Pattern.compile(
                                    "pixel " + PIXEL + " is missing, " + PIXEL + " is drawn"),
                    "pixel.extra", Pattern.compile("pixel " + PIXEL + " is extra"),
                    "pixel.again", Pattern.compile("pixel " + PIXEL + " is drawn again"),
                    "pixel.order", Pattern.compile("pixel " + PIXEL + " comes out of order"));

    private FirstDifference() {}

    /**
     * @param first as {@link Deviation#first} says it; quoted where its form is not known
     */
    static Message told(String first) {
        for (Map.Entry<String, Pattern> form : FORMS.entrySet()) {
            Matcher matcher = form.getValue().matcher(first);
            if (matcher.matches())
                return matcher.groupCount() == 1
                        ? Message.of(form.getKey(), matcher.group(1))
                        : Message.of(form.getKey(), matcher.group(1), matcher.group(2));
        }
        return Message.quoted(first);
    }
}
